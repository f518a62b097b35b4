// The ingredients of the precision fast, one by one.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {
namespace {

using Catch::Matchers::Contains;

constexpr Precision kIngredients[] = {Precision::fast_reciprocal, Precision::fast_inverse_sqrt, Precision::fused_multiply_add, Precision::fast_power};

Lighting shining(float strength) {
  Lighting lighting;
  lighting.specular = glm::vec3(strength);
  lighting.eye = {0, 0, 4};
  lighting.lights[0].towards = glm::vec3(0.48f, 0.6f, 0.64f);
  return lighting;
}

std::shared_ptr<const Texture> patterned() {
  test::Random random(7);
  Image<Rgba8> image(64, 64);
  for (Rgba8& p : image.pixels()) p = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)), 99, 255};
  return std::make_shared<const Texture>(*Texture::create(image, TextureEncoding::linear));
}

struct View {
  bool has_perspective = true, is_counted = false;
};

Image<Rgba32F> ball(const FragmentProgram& program, InstructionSet set, Precision precision, View view = {}) {
  const test::Mesh mesh = test::sphere(10);
  Pipeline pipeline({.threads = 1, .instruction_set = set, .precision = precision});
  RenderTarget target = *RenderTarget::create(96, 96, ColourFormat::rgba32f);
  pipeline.clear(target, {0, 0, 0, 0});
  DrawCall draw{.mesh = mesh.view(), .program = program, .state = {}, .count_fragments = view.is_counted};
  if (view.has_perspective) draw.state.transform.clip_from_world = {{1.5f, 0, 0, 0}, {0, 1.5f, 0, 0}, {0, 0, -1.5f, -1}, {0, 0, 2, 2}};
  const auto drawn = pipeline.draw(target, draw);
  if (!drawn) FAIL(drawn.error().message);
  return target.linear_image();
}

double largest_change(const Image<Rgba32F>& a, const Image<Rgba32F>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba32F &p = a.pixels()[i], &q = b.pixels()[i];
    for (const float change : {p.r - q.r, p.g - q.g, p.b - q.b, p.a - q.a}) largest = std::max(largest, static_cast<double>(std::abs(change)));
  }
  return largest;
}

std::string refusal_of_draw(const FragmentProgram& program, Precision precision) {
  const test::Mesh mesh = test::sphere(3);
  Pipeline pipeline({.threads = 1, .precision = precision});
  RenderTarget target = *RenderTarget::create(8, 8);
  const auto drawn = pipeline.draw(target, {.mesh = mesh.view(), .program = program, .state = {}});
  return drawn ? "accepted" : drawn.error().message;
}

}  // namespace

TEST_CASE("ingredients: each alone changes what it touches, by no more than all together may", "[pipeline][trade]") {
  const FragmentProgram program = phong(shining(0.5f));
  test::for_every_instruction_set([&](InstructionSet set) {
    const auto exact = ball(program, set, Precision::exact);
    for (const Precision precision : kIngredients) {
      INFO("ingredient " << name_of(precision) << " on " << name_of(set));
      const auto found = ball(program, set, precision);
      CHECK(largest_change(found, exact) < 3e-5);
      const bool cannot_fuse = set == InstructionSet::baseline;  // nor is there then anything in a power that is fast
      if (!cannot_fuse) CHECK(largest_change(found, exact) > 0);
      CHECK(ball(program, set, precision, {.is_counted = true}) == found);
    }
    CHECK(largest_change(ball(program, set, Precision::fast), exact) < 1e-4);
  });
}

TEST_CASE("ingredients: what a draw does not use changes no bit of it", "[pipeline][exact]") {
  const FragmentProgram matt = phong(shining(0)), textured = textured_gouraud({.texture = patterned(), .sampler = {}});
  test::for_every_instruction_set([&](InstructionSet set) {
    CHECK(ball(matt, set, Precision::fast_power) == ball(matt, set, Precision::exact));
    CHECK(ball(textured, set, Precision::fast_inverse_sqrt) == ball(textured, set, Precision::exact));
    const View parallel{.has_perspective = false};
    CHECK(ball(textured, set, Precision::fast_reciprocal, parallel) == ball(textured, set, Precision::exact, parallel));
    CHECK(ball(matt, set, Precision::fast_reciprocal, parallel) == ball(matt, set, Precision::exact, parallel));
    if (set == InstructionSet::baseline) return;  // cannot fuse
    CHECK_FALSE(ball(textured, set, Precision::fused_multiply_add) == ball(textured, set, Precision::exact));
  });
}

TEST_CASE("ingredients: refused where there are no kernels for them", "[pipeline]") {
  const FragmentProgram lit = textured_lit({.texture = patterned(), .sampler = {}, .tint = glm::vec4(1), .lighting = shining(0)});
  for (const Precision precision : kIngredients) {
    CHECK(refusal_of_draw(phong(shining(0)), precision) == "accepted");
    CHECK(refusal_of_draw(lit, precision) == "accepted");
    CHECK_THAT(refusal_of_draw(flat(), precision), Contains("program 'flat'") && Contains(std::string(name_of(precision))));
    CHECK(precision_named(name_of(precision)) == precision);
  }
  CHECK_THAT(refusal_of_draw(phong(shining(0)), static_cast<Precision>(5)), Contains("precision is 5"));
  CHECK(refusal_of_draw(flat(), Precision::fast) == "accepted");
}

}  // namespace tuberia
