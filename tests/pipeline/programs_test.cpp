#include "pipeline/programs/programs.hpp"

#include <catch2/catch.hpp>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

using test::for_every_machine;

namespace {

/// The red of a square at z = 0 that faces +z, lit and seen from the given directions.
double reflected(Lighting light, glm::vec3 towards_light, glm::vec3 towards_eye, InstructionSet set, Precision precision) {
  light.ambient = glm::vec3(0.4f * 0.2f);
  light.diffuse = glm::vec3(0.4f);
  light.specular = glm::vec3(0.5f);
  light.shininess = 10;
  light.lights[0].towards = towards_light;
  light.eye = towards_eye * 1e6f;
  const test::Mesh square = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  const test::Canvas canvas{.width = 8, .height = 8, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set, .precision = precision}};
  return static_cast<double>(test::render(square, phong(light), {}, canvas).linear.at(3, 4).r);
}

}  // namespace

// notes 15.6
TEST_CASE("programs: the local model of the notes", "[pipeline]") {
  const glm::vec3 light{0.6f, 0, 0.8f}, mirror{-0.6f, 0, 0.8f}, above{0, 0, 1};
  for_every_machine([&](InstructionSet set, Precision precision) {
    const auto value = [&](bool halfway, glm::vec3 l, glm::vec3 v) { return reflected({.halfway = halfway}, l, v, set, precision); };
    for (const bool halfway : {false, true}) {
      CHECK(value(halfway, light, mirror) == Approx(0.9).epsilon(1e-5));
      CHECK(value(halfway, {0.6f, 0, -0.8f}, mirror) == Approx(0.08).epsilon(1e-5));
    }
    CHECK(value(false, light, above) == Approx(0.08 + 0.32 + 0.5 * 0.1073741824).epsilon(1e-5));
    // N.H = 1.8 / sqrt(3.6)
    CHECK(value(true, light, above) == Approx(0.08 + 0.32 + 0.5 * std::pow(0.9, 5)).epsilon(1e-5));
  });
}

TEST_CASE("programs: a light at a point shines from there", "[pipeline]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    Lighting light;
    light.lights[0].kind = Light::Kind::point;
    // So far away that its direction is the same everywhere.
    CHECK(reflected(light, {0.6e6f, 0, 0.8e6f}, {0, 0, 1}, set, precision) ==
          Approx(reflected({}, {0.6f, 0, 0.8f}, {0, 0, 1}, set, precision)).epsilon(1e-5));
  });
}

TEST_CASE("programs: lit vertices and lit fragments agree where the light is even", "[pipeline]") {
  const test::Mesh square = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  Lighting light{.diffuse = glm::vec3(0.5f), .eye = {0, 0, 5}};
  light.lights[0].towards = {0.6f, 0, 0.8f};
  for_every_machine([&](InstructionSet set, Precision precision) {
    const test::Canvas canvas{.width = 8, .height = 8, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set, .precision = precision}};
    PipelineState at_vertices;
    at_vertices.transform.vertex_lighting = light;
    const Rgba32F gouraud_pixel = test::render(square, gouraud(), at_vertices, canvas).linear.at(2, 5);
    const Rgba32F phong_pixel = test::render(square, phong(light), {}, canvas).linear.at(2, 5);
    CHECK(gouraud_pixel.g == Approx(0.5).epsilon(1e-6));
    CHECK(phong_pixel.g == Approx(0.5).epsilon(1e-6));
  });
}

TEST_CASE("programs: a discarded fragment leaves neither colour nor depth", "[pipeline]") {
  // The left half of the texture is a hole.
  Image<Rgba8> image(2, 1, {255, 255, 255, 255});
  image.at(0, 0).a = 0;
  const TexturedUniforms uniforms{.texture = test::texture_of(image), .sampler = {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none}, .alpha_cutoff = 0.5f};
  const test::Mesh square = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  for_every_machine([&](InstructionSet set, Precision precision) {
    const test::Canvas canvas{.width = 16, .height = 16, .options = {.threads = 1, .instruction_set = set, .precision = precision}};
    for (const bool cut_out : {false, true}) {
      const test::Picture picture = test::render(square, textured(uniforms, cut_out), {}, canvas);
      CHECK((picture.colour.at(3, 3) == Rgba8{0, 0, 0, 0}) == cut_out);
      CHECK((picture.depth.at(3, 3) == 16777215) == cut_out);
      CHECK(picture.colour.at(12, 3) == Rgba8{255, 255, 255, 255});
      CHECK(picture.depth.at(12, 3) == 8388608);
    }
  });
}

TEST_CASE("programs: the tint multiplies the texture", "[pipeline]") {
  const TexturedUniforms uniforms{.texture = test::texture_of(Image<Rgba8>(1, 1, {255, 51, 0, 255})), .sampler = {}, .tint = {0.5f, 1, 1, 0.25f}};
  const test::Mesh square = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1, {0.5f, 0.5f, 0.5f, 1});
  const test::Canvas canvas{.width = 4, .height = 4, .colour = ColourFormat::rgba32f};
  const Rgba32F tinted = test::render(square, textured(uniforms), {}, canvas).linear.at(1, 1);
  CHECK(tinted.r == Approx(0.5));
  CHECK(tinted.g == Approx(0.2));
  CHECK(tinted.a == Approx(0.25));
  const Rgba32F coloured = test::render(square, textured_gouraud({.texture = uniforms.texture, .sampler = {}}), {}, canvas).linear.at(1, 1);
  CHECK(coloured.r == Approx(0.5));
  CHECK(coloured.g == Approx(0.1));
}

}  // namespace tuberia
