// Light, fog and generated coordinates at their limits, through the whole pipeline: cases 50 to 54.

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/programs/fixed_function.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Mesh;
using test::Studio;

namespace {

/// The colour of one pixel that a single vertex lights, in floats.
Rgba32F lit_vertex(const glm::vec3& normal, const Lighting& lighting, InstructionSet set) {
  Mesh point;
  point.positions = {{0, 0, 0}};
  point.normals = {normal};
  PipelineState state;
  state.assembly.topology = Topology::points;
  state.transform.vertex_lighting = lighting;
  Studio studio({.width = 1, .height = 1, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set}});
  studio.draw(point.view(), gouraud(), state);
  return studio.target().linear_image().at(0, 0);
}

/// Nothing but a highlight: light along +z, the eye where it is put.
Lighting highlight(float shininess, bool halfway, const glm::vec3& eye = {0, 0, 1}) {
  return {.ambient = glm::vec3(0), .diffuse = glm::vec3(0), .specular = glm::vec3(1), .shininess = shininess, .halfway = halfway, .eye = eye};
}

/// Red in the middle of a square whose left and right normals lean outwards, lit and seen from straight above.
double middle_of_leaning_normals(double degrees, float shininess, bool at_fragments, InstructionSet set) {
  const auto lean = static_cast<float>(std::tan(degrees * 3.14159265358979323846 / 180));
  Mesh square = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  for (const std::size_t left : {0u, 3u}) square.normals[left] = glm::normalize(glm::vec3(-lean, 0, 1));
  for (const std::size_t right : {1u, 2u}) square.normals[right] = glm::normalize(glm::vec3(lean, 0, 1));
  const Lighting above = highlight(shininess, true, {0, 0, 1e9f});
  PipelineState state;
  if (!at_fragments) state.transform.vertex_lighting = above;
  Studio studio({.width = 65, .height = 65, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set}});
  studio.draw(square.view(), at_fragments ? phong(above) : gouraud(), state);
  return static_cast<double>(studio.target().linear_image().at(32, 32).r);
}

}  // namespace

TEST_CASE("shading: powers of a highlight, the smallest and the undefined ones", "[extremes][S2][case-50]") {
  for_every_instruction_set([](InstructionSet set) {
    // A unit normal whose z is exactly 1 - 2^-10 = .9990234375.
    const float c = 0.9990234375f;
    const glm::vec3 leaning{std::sqrt(1 - c * c), 0, c};
    CHECK(lit_vertex(leaning, highlight(16384, true), set).r == Approx(1.11658850697683e-7).epsilon(1e-4));
    CHECK(lit_vertex({std::sqrt(1 - 0.999f * 0.999f), 0, 0.999f}, highlight(1e5f, true), set).r <= 3.6e-44f);
    CHECK(lit_vertex({0, 0, 1}, highlight(1e5f, true), set).r == 1);
    // The mirrored light goes along +x; seen from +y the base is 0, from -x it is -1 and counts as 0.
    const glm::vec3 slope{0.70710678f, 0, 0.70710678f};
    for (const glm::vec3& eye : {glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0)}) {
      CHECK(lit_vertex(slope, highlight(0, false, eye), set).r == 1);
      CHECK(lit_vertex(slope, highlight(5, false, eye), set).r == 0);
    }
  });
}

TEST_CASE("shading: a normal of any length lights as one of unit length, and none not at all", "[extremes][S1][case-51]") {
  Lighting plain{.ambient = glm::vec3(0), .diffuse = glm::vec3(0.5f)};
  plain.lights[0].towards = {1, 0, 0};
  for_every_instruction_set([&](InstructionSet set) {
    const auto red = [&](const glm::vec3& normal) { return lit_vertex(normal, plain, set).r; };
    const float two_ulp = 2 * 0x1p-24f;
    for (const float size : {1e-25f, 1e-40f, 1e25f, 1e-45f, 3e38f, 1.0f}) CHECK(red({size, 0, 0}) == Approx(0.5).margin(static_cast<double>(two_ulp)));
    CHECK(red({1e25f, 1e25f, 0}) == Approx(0.5 * std::sqrt(0.5)).margin(static_cast<double>(two_ulp)));
    CHECK(red({-1e-40f, 0, 0}) == 0);
    CHECK(red({0, 0, 0}) == 0);
  });
}

TEST_CASE("shading: fog of seven eighths of a density", "[extremes][case-52]") {
  for_every_instruction_set([](InstructionSet set) {
    for (const auto& [mode, share] : {std::pair{FogMode::exp, .4168620196785084}, {FogMode::exp2, .46504318813405631}}) {
      const std::vector<glm::vec4> corners{{-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1}};
      const std::vector<float> distances(3, 1.75f);
      PipelineState state;
      state.fog = {.mode = mode, .colour = {0, 0, 0, 1}, .density = 0.5f};
      Studio studio({.width = 9, .height = 9, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set}});
      studio.draw({.clip_positions = corners, .fog_coordinates = distances}, gouraud(), state);
      CHECK(studio.target().linear_image().at(4, 4).r == Approx(share).epsilon(1e-6));
    }
  });
}

TEST_CASE("shading: a sphere map where its formula divides by nothing", "[extremes][case-53]") {
  // Seen edge on, the reflection goes on straight away from the eye: r = (0, 0, -1), m = 0.
  const Image<Rgba8> quarters = test::checkerboard(2, 1, {255, 255, 255, 255}, {0, 0, 0, 255});
  FixedFunctionUniforms uniforms;
  uniforms.units[0] = {.texture = test::texture_of(quarters), .sampler = {.mipmaps = MipmapFilter::none}};
  Mesh point;
  point.positions = {{0, 0, -5}};
  point.normals = {{1, 0, 0}};
  PipelineState state;
  state.assembly.topology = Topology::points;
  state.transform.clip_from_world = *perspective(1, 1, 0.1, 100, ClipVolume::minus_w_to_w);
  state.transform.texture_units[0].source = {TexCoordSource::sphere_map, TexCoordSource::sphere_map, TexCoordSource::vertex, TexCoordSource::vertex};
  for_every_instruction_set([&](InstructionSet set) {
    for (const glm::vec3& normal : {glm::vec3(1, 0, 0), glm::vec3(0, 3, 0), glm::vec3(0, 0, 0)}) {
      point.normals = {normal};
      Studio studio({.width = 3, .height = 3, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set}});
      MeshView view = point.view();
      const std::vector<glm::vec4> own(1, {0, 0, 0, 1});
      view.unit_texcoords[0] = own;
      studio.draw(view, fixed_function(uniforms), state);
      // In the middle of the map all four texels have a part.
      CHECK(studio.target().linear_image().at(1, 1).r == Approx(0.5));
    }
  });
}

TEST_CASE("shading: light at the vertices misses a highlight between them, light at fragments does not", "[extremes][case-54]") {
  struct Known {
    double degrees;
    float shininess;
    double at_vertices;
  };
  for_every_instruction_set([](InstructionSet set) {
    for (const Known& k : {Known{10, 20, .736}, {20, 50, .0446}, {30, 10, .237}}) {
      CHECK(middle_of_leaning_normals(k.degrees, k.shininess, false, set) == Approx(k.at_vertices).margin(6e-4));
      CHECK(middle_of_leaning_normals(k.degrees, k.shininess, true, set) == Approx(1).margin(1e-4));
    }
  });
}

TEST_CASE("shading: interpolated normals are short, so that they must be made unit again", "[extremes][P1][case-54]") {
  for (const auto& [degrees, length] : {std::pair{10.0, .98481}, {20, .93969}, {30, .86603}, {45, .70711}}) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    Mesh square = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
    // The normals as colours, shifted so that none is negative.
    for (std::size_t i = 0; i < 4; ++i) square.colours[i] = {(i == 0 || i == 3 ? -1 : 1) * std::sin(angle) + 1, 0, std::cos(angle), 1};
    const Rgba32F middle = test::render(square, gouraud(), {}, {.width = 65, .height = 65, .colour = ColourFormat::rgba32f}).linear.at(32, 32);
    CHECK(std::hypot(middle.r - 1, middle.b) == Approx(length).margin(6e-6));
  }
}

}  // namespace tuberia
