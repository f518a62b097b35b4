// What is interpolated over a lit surface: colours, cosines, or normals, made unit or not.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {
namespace {

using Catch::Matchers::Contains;

double radians_of(double degrees) { return degrees * 3.14159265358979323846 / 180; }

/// A square that fills the target; its normals lean outwards by so much at the left and at the right.
test::Mesh bent_square(double degrees) {
  test::Mesh square = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  for (std::size_t i = 0; i < square.positions.size(); ++i)
    square.normals[i] = {static_cast<float>(std::sin(radians_of(degrees))) * square.positions[i].x, 0, static_cast<float>(std::cos(radians_of(degrees)))};
  return square;
}

/// Only a highlight, of a light behind the viewer, who looks at it straight.
Lighting highlight_alone(float shininess) {
  Lighting lighting{.ambient = glm::vec3(0), .diffuse = glm::vec3(0), .specular = glm::vec3(1), .shininess = shininess, .eye = {0, 0, 1e6f}};
  lighting.lights[0].towards = {0, 0, 1};
  return lighting;
}

enum class Interpolated { colours, cosines, normals };

struct BentSurface {
  double degrees;
  float shininess;
  InstructionSet set;
  Precision precision;

  double middle(Interpolated what, NormalInterpolation normals = NormalInterpolation::renormalized) const {
    Lighting lighting = highlight_alone(shininess);
    lighting.normals = normals;
    PipelineState state;
    if (what == Interpolated::colours) state.transform.vertex_lighting = lighting;
    if (what == Interpolated::cosines) state.transform.vertex_cosines = lighting;
    const FragmentProgram program = what == Interpolated::colours ? gouraud() : what == Interpolated::cosines ? dot_product(lighting) : phong(lighting);
    const test::Canvas canvas{.width = 65, .height = 9, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set, .precision = precision}};
    return static_cast<double>(test::render(bent_square(degrees), program, state, canvas).linear.at(32, 4).r);
  }
};

std::string refusal_of_square(const FragmentProgram& program, const PipelineState& state = {}) {
  const test::Mesh square = bent_square(0);
  Pipeline pipeline({.threads = 1});
  RenderTarget target = *RenderTarget::create(8, 8);
  const auto drawn = pipeline.draw(target, {.mesh = square.view(), .program = program, .state = state});
  return drawn ? "accepted" : drawn.error().message;
}

}  // namespace

TEST_CASE("normals: interpolated colours and cosines lose the highlight in the middle", "[pipeline][case-54][trade]") {
  struct Known {
    double degrees;
    float shininess;
    double left;
  };
  test::for_every_machine([](InstructionSet set, Precision precision) {
    for (const Known& k : {Known{10, 20, 0.736}, {20, 50, 0.0446}, {30, 10, 0.237}}) {
      const BentSurface surface{k.degrees, k.shininess, set, precision};
      const double exact = std::pow(std::cos(radians_of(k.degrees)), static_cast<double>(k.shininess));
      CHECK(exact == Approx(k.left).epsilon(2e-3));
      CHECK(surface.middle(Interpolated::colours) == Approx(exact).epsilon(1e-4));
      CHECK(surface.middle(Interpolated::cosines) == Approx(exact).epsilon(1e-4));
      CHECK(surface.middle(Interpolated::normals, NormalInterpolation::not_renormalized) == Approx(exact).epsilon(1e-4));
      CHECK(surface.middle(Interpolated::normals) == Approx(1).epsilon(1e-4));
    }
  });
}

TEST_CASE("normals: how long they are after one step of renormalization, and without", "[pipeline][case-54][trade]") {
  struct Known {
    double between, left_alone, one_step;  // degrees; lengths
  };
  test::for_every_machine([](InstructionSet set, Precision precision) {
    for (const Known& k : {Known{10, 0.99619, 0.99998}, {20, 0.98481, 0.9997}, {40, 0.93969, 0.9947}, {60, 0.86603, 0.974}, {90, 0.70711, 0.884}}) {
      const BentSurface surface{k.between / 2, 1, set, precision};
      CHECK(surface.middle(Interpolated::normals, NormalInterpolation::not_renormalized) == Approx(k.left_alone).margin(1e-5));
      CHECK(surface.middle(Interpolated::normals, NormalInterpolation::one_step) == Approx(k.one_step).margin(6e-4));
      const double cosine = std::cos(radians_of(k.between / 2));
      CHECK(surface.middle(Interpolated::normals, NormalInterpolation::one_step) == Approx(cosine * (3 - cosine * cosine) / 2).epsilon(1e-5));
    }
  });
}

TEST_CASE("normals: interpolated cosines light a plane as fragments do", "[pipeline]") {
  Lighting lighting{.specular = glm::vec3(0.5f), .shininess = 8, .eye = {3e5f, 0, 1e6f}, .light_count = 2};
  lighting.lights[0].towards = {0.6f, 0, 0.8f};
  lighting.lights[1] = {Light::Kind::directional, {0, 0.28f, 0.96f}, {0.2f, 0.5f, 0.1f}};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const test::Canvas canvas{.width = 16, .height = 16, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set, .precision = precision}};
    for (const bool halfway : {false, true}) {
      lighting.halfway = halfway;
      PipelineState state;
      state.transform.vertex_cosines = lighting;
      const auto found = test::render(bent_square(0), dot_product(lighting), state, canvas).linear, right = test::render(bent_square(0), phong(lighting), {}, canvas).linear;
      for (std::size_t i = 0; i < found.pixels().size(); ++i) {
        CHECK(found.pixels()[i].r == Approx(right.pixels()[i].r).epsilon(1e-5));
        CHECK(found.pixels()[i].g == Approx(right.pixels()[i].g).epsilon(1e-5));
      }
    }
  });
}

TEST_CASE("normals: what cannot be lit is refused", "[pipeline]") {
  Lighting odd = highlight_alone(3);
  odd.normals = static_cast<NormalInterpolation>(3);
  CHECK_THAT(refusal_of_square(phong(odd)), Contains("normals is 3"));
  Lighting many = highlight_alone(3);
  PipelineState state;
  CHECK_THAT(refusal_of_square(dot_product(many)), Contains("custom attributes"));
  state.transform.vertex_cosines = many;
  CHECK(refusal_of_square(dot_product(many), state) == "accepted");
  many.light_count = 3;
  CHECK_THAT(refusal_of_square(dot_product(many), state), Contains("two lights at most"));
  state.transform.vertex_cosines->shininess = -1;
  many.light_count = 1;
  CHECK_THAT(refusal_of_square(dot_product(many), state), Contains("vertex cosines: shininess"));
}

}  // namespace tuberia
