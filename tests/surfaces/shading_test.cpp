// Shading interpolation, and the figures of the notes that its problems are shown by.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <set>

#include "pipeline/programs/surface.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/lit_triangle.hpp"
#include "tests/support/shapes.hpp"

namespace tuberia {

namespace {

using test::Mesh;

constexpr int kPictureSize = 97;  // odd: one pixel's centre is the middle

/// Looking along -z, parallel; the eye is far away on +z.
PipelineState from_front() {
  PipelineState state;
  state.transform.clip_from_world = scaling({1, 1, -0.5});
  return state;
}

constexpr glm::vec3 kFarEye{0, 0, 1e6f};

Image<Rgba32F> drawn(const Mesh& mesh, const FragmentProgram& program, const PipelineState& state, InstructionSet set, Precision precision = Precision::exact) {
  return test::render(mesh, program, state, {.width = kPictureSize, .height = kPictureSize, .colour = ColourFormat::rgba32f, .background = {-1, -1, -1, 0},
                                             .options = {.threads = 1, .instruction_set = set, .precision = precision}}).linear;
}

Lighting shiny() {
  Lighting light{.ambient = glm::vec3(0.08f), .diffuse = glm::vec3(0.4f), .specular = glm::vec3(0.5f), .shininess = 30, .halfway = false, .eye = kFarEye};
  light.lights[0].towards = {0.36f, 0.48f, 0.8f};
  return light;
}

/// What a unit sphere sends to the eye at a pixel of the disc, in double; nothing outside it.
std::optional<double> analytic(const Lighting& light, int x, int y) {
  const double px = (x + 0.5) * 2 / kPictureSize - 1, py = 1 - (y + 0.5) * 2 / kPictureSize, rest = 1 - px * px - py * py;
  if (rest < 0.1) return {};  // the polygons' own outline is not round
  const LitPoint at{{px, py, std::sqrt(rest)}, normalized_or(glm::dvec3(light.lights[0].towards), {}), {0, 0, 1}};
  return static_cast<double>(light.ambient.r) + static_cast<double>(light.diffuse.r) * diffuse_share(at) +
         static_cast<double>(light.specular.r) * phong_share(at, static_cast<double>(light.shininess));
}

enum class Shading { flat, gouraud, cosines, phong };

Image<Rgba32F> shaded(const Mesh& mesh, const Lighting& light, Shading shading, InstructionSet set, Precision precision = Precision::exact) {
  PipelineState state = from_front();
  if (shading == Shading::phong) return drawn(mesh, phong(light), state, set, precision);
  if (shading == Shading::cosines) {
    state.transform.vertex_cosines = light;
    return drawn(mesh, dot_product(light), state, set, precision);
  }
  state.transform.vertex_lighting = light;
  state.rasterization.flat_shading = shading == Shading::flat;
  return drawn(mesh, gouraud(), state, set, precision);
}

/// Root mean square difference to the analytic sphere.
double error_of(const Image<Rgba32F>& picture, const Lighting& light) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < kPictureSize; ++y)
    for (int x = 0; x < kPictureSize; ++x)
      if (const auto right = analytic(light, x, y)) sum += std::pow(static_cast<double>(picture.at(x, y).r) - *right, 2), ++count;
  return std::sqrt(sum / count);
}

Mesh white_sphere(int rings) {
  Mesh mesh = test::sphere(rings);
  mesh.colours.clear();
  return mesh;
}

/// The intensities of a row, where the sphere is.
std::vector<double> scan_line(const Image<Rgba32F>& picture, int y) {
  std::vector<double> row;
  for (const Rgba32F& pixel : picture.row(y))
    if (pixel.r >= 0) row.push_back(static_cast<double>(pixel.r));
  return row;
}

double largest_step(const std::vector<double>& row) {
  double largest = 0;
  for (std::size_t i = 1; i < row.size(); ++i) largest = std::max(largest, std::abs(row[i] - row[i - 1]));
  return largest;
}

double largest_bend(const std::vector<double>& row) {
  double largest = 0;
  for (std::size_t i = 1; i + 1 < row.size(); ++i) largest = std::max(largest, std::abs(row[i + 1] - 2 * row[i] + row[i - 1]));
  return largest;
}

/// A sphere under one light from the eye, with Phong's highlight, by the surface program; its middle faces the light.
Image<Rgba32F> figure_sphere(float kd, float ambient, float ks, float n, InstructionSet set, glm::vec3 towards = {0, 0, 1}) {
  SurfaceUniforms uniforms{.reflection = {.ambient = glm::vec3(kd), .diffuse = glm::vec3(kd), .specular = glm::vec3(ks), .exponent = n}, .ambient_light = glm::vec3(ambient), .eye = kFarEye};
  uniforms.lights.push_back({.light = {.towards = towards}});
  return drawn(white_sphere(32), surface(uniforms), from_front(), set);
}

}  // namespace

TEST_CASE("shading: ambient light alone makes a cube one flat colour", "[surfaces][B06]") {
  Mesh cube;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-0.5f, 0.5f}) {
      glm::vec3 normal(0), u(0), v(0), corner(-0.5f);
      normal[axis] = side * 2, u[(axis + 1) % 3] = 1, v[(axis + 2) % 3] = 1, corner[axis] = side;
      const Mesh face = test::rectangle(corner, u, v, normal);
      const auto first = static_cast<std::uint32_t>(cube.positions.size());
      cube.positions.insert(cube.positions.end(), face.positions.begin(), face.positions.end());
      cube.normals.insert(cube.normals.end(), face.normals.begin(), face.normals.end());
      for (const std::uint32_t index : face.indices) cube.indices.push_back(first + index);
    }
  PipelineState state = from_front();
  state.transform.world_from_object = rotation({1, 0.5, 0.2}, 0.7);
  const SurfaceUniforms uniforms{.reflection = {.ambient = {0.4f, 0.5f, 0.6f}}, .ambient_light = glm::vec3(0.5f), .eye = kFarEye};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto picture = drawn(cube, surface(uniforms), state, set, precision);
    int covered = 0;
    for (const Rgba32F& pixel : picture.pixels()) {
      if (pixel.a == 0) continue;
      ++covered;
      CHECK(pixel == Rgba32F{0.2f, 0.25f, 0.3f, 1});
    }
    CHECK(covered > 2000);
  });
}

TEST_CASE("shading: four diffuse spheres are as bright as their kd", "[surfaces][B07]") {
  test::for_every_instruction_set([](InstructionSet set) {
    for (const float kd : {0.1f, 0.4f, 0.7f, 0.95f}) {
      const auto picture = figure_sphere(kd, 0, 0, 1, set);
      CHECK(picture.at(kPictureSize / 2, kPictureSize / 2).r == Approx(kd).epsilon(2e-3));
      // Lambert: 60 degrees to the light there is half of it left.
      const int x = static_cast<int>((1 + std::sin(std::acos(0.5))) / 2 * kPictureSize);
      CHECK(picture.at(x, kPictureSize / 2).r == Approx(kd / 2).epsilon(0.05));
    }
  });
}

TEST_CASE("shading: ambient light is what the far side of a sphere has", "[surfaces][B08]") {
  test::for_every_instruction_set([](InstructionSet set) {
    for (const float ambient : {0.0f, 0.2f, 0.4f, 0.6f}) {
      const auto picture = figure_sphere(0.4f, ambient, 0, 1, set, {0.8f, 0, 0.6f});
      CHECK(picture.at(2, kPictureSize / 2).r == Approx(0.4 * static_cast<double>(ambient)).margin(1e-6));
    }
  });
}

TEST_CASE("shading: six spheres with highlights of two strengths and three widths", "[surfaces][B14]") {
  test::for_every_instruction_set([](InstructionSet set) {
    for (const float ks : {0.25f, 0.5f}) {
      int last = kPictureSize * kPictureSize;
      for (const float n : {3.0f, 10.0f, 100.0f}) {
        const auto picture = figure_sphere(0.4f, 0.2f, ks, n, set), dull = figure_sphere(0.4f, 0.2f, 0, n, set);
        CHECK(picture.at(kPictureSize / 2, kPictureSize / 2).r == Approx(0.08 + 0.4 + static_cast<double>(ks)).epsilon(5e-3));
        int bright = 0;  // where the highlight has half its strength
        for (std::size_t i = 0; i < picture.pixels().size(); ++i)
          if (picture.pixels()[i].a > 0 && picture.pixels()[i].r - dull.pixels()[i].r > ks / 2) ++bright;
        // cos(2a)^n > 1/2, where the normal leans by a: a disc of radius sin(a).
        const double radius = std::sin(std::acos(std::pow(0.5, 1 / static_cast<double>(n))) / 2) * kPictureSize / 2;
        CHECK(bright == Approx(3.14159265 * radius * radius).epsilon(0.08));
        CHECK(bright < last);
        last = bright;
      }
    }
  });
}

// What the eye sees as Mach bands: the steps of constant shading, and the bends that Gouraud's still has.
TEST_CASE("shading: the profile of a scan line has steps, bends, or neither", "[surfaces][B22]") {
  Lighting dull = shiny();
  dull.specular = glm::vec3(0);
  const Mesh sphere = white_sphere(8);
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto profile = [&](Shading shading) {
      std::vector<double> row = scan_line(shaded(sphere, dull, shading, set, precision), kPictureSize / 2);
      row.erase(row.begin(), row.begin() + 20);  // near the outline all are steep
      row.erase(row.end() - 20, row.end());
      return row;
    };
    const std::vector<double> steps = profile(Shading::flat), bends = profile(Shading::gouraud), smooth = profile(Shading::phong);
    CHECK(std::set<double>(steps.begin(), steps.end()).size() <= 16);
    CHECK(largest_step(steps) > 4 * largest_step(bends));
    CHECK(largest_bend(bends) > 2 * largest_bend(smooth));
    CHECK(largest_step(bends) < 0.02);
  });
}

TEST_CASE("shading: Gouraud shading loses a highlight inside a triangle", "[surfaces][B28]") {
  const test::LitTriangle big{.size = 32};
  Lighting light = shiny();
  light.eye = {0, 0, 1.5f};
  light.lights[0] = {.kind = Light::Kind::point, .towards = {0, 0, 1.5f}};
  PipelineState lit_vertices;
  lit_vertices.transform.vertex_lighting = light;
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto brightest = [](const Image<Rgba32F>& picture) {
      float most = 0;
      for (const Rgba32F& pixel : picture.pixels()) most = std::max(most, pixel.r);
      return most;
    };
    const float lost = brightest(big.picture(gouraud(), set, precision, lit_vertices)), kept = brightest(big.picture(phong(light), set, precision));
    CHECK(kept > 0.93f);  // of 0.08 + 0.4 + 0.5, half a pixel away from the middle
    CHECK(lost < 0.45f);
  });
}

TEST_CASE("shading: interpolated normals come close to a sphere, the closer the finer the net", "[surfaces][B29]") {
  test::for_every_machine([](InstructionSet set, Precision precision) {
    const auto error = [&](int rings) { return error_of(shaded(white_sphere(rings), shiny(), Shading::phong, set, precision), shiny()); };
    const double coarse = error(8), fine = error(16), finest = error(32);
    CHECK(coarse < 0.04);
    CHECK(fine < coarse / 2.5);  // the second order of the edges' length
    CHECK(finest < fine / 2.5);
  });
}

// Colours are clamped at the vertices, cosines where they are used: it shows where light ends on a sphere.
TEST_CASE("shading: interpolated cosines err less than colours and more than normals", "[surfaces][B30]") {
  Lighting dull = shiny();
  dull.specular = glm::vec3(0);
  dull.lights[0].towards = {0.8f, 0.48f, 0.36f};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const int rings : {8, 16}) {
      const auto error = [&](Shading shading) { return error_of(shaded(white_sphere(rings), dull, shading, set, precision), dull); };
      const double constant = error(Shading::flat), colours = error(Shading::gouraud), cosines = error(Shading::cosines), normals = error(Shading::phong);
      CHECK(colours < constant);
      CHECK(cosines < 0.95 * colours);
      CHECK(normals < 0.95 * cosines);
    }
  });
}

// Of highlights that cannot be said: a cosine between two vertices lies below the arc, and its power below the power of
// both, so that they are always too dark, while interpolated colours err to either side.
TEST_CASE("shading: highlights of interpolated cosines are too dark everywhere", "[surfaces][B30]") {
  test::for_every_machine([](InstructionSet set, Precision precision) {
    const auto cosines = shaded(white_sphere(16), shiny(), Shading::cosines, set, precision), normals = shaded(white_sphere(16), shiny(), Shading::phong, set, precision);
    double darker = 0;
    for (std::size_t i = 0; i < cosines.pixels().size(); ++i) {
      const double difference = static_cast<double>(normals.pixels()[i].r) - static_cast<double>(cosines.pixels()[i].r);
      CHECK(difference > -5e-3);
      darker = std::max(darker, difference);
    }
    CHECK(darker > 0.1);
  });
}

TEST_CASE("shading: interpolated cosines cost more than colours and less than normals", "[surfaces][B30]") {
  const Mesh square = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  PipelineState lit_vertices = from_front(), cosine_state = from_front();
  lit_vertices.transform.vertex_lighting = shiny();
  cosine_state.transform.vertex_cosines = shiny();
  lit_vertices.depth.test = cosine_state.depth.test = Compare::always;
  test::Studio studio({.width = 512, .height = 512});
  const auto seconds = [&](const FragmentProgram& program, const PipelineState& state) {
    const std::clock_t begin = std::clock();
    for (int i = 0; i < 4; ++i) studio.draw(square.view(), program, state);
    return std::clock() - begin;
  };
  // The least of many rounds, in turns: what else the machine does only ever adds.
  std::clock_t colours = 1 << 30, cosines = colours, normals = colours;
  for (int round = 0; round < 9; ++round) {
    colours = std::min(colours, seconds(gouraud(), lit_vertices));
    cosines = std::min(cosines, seconds(dot_product(shiny()), cosine_state));
    normals = std::min(normals, seconds(phong(shiny()), cosine_state));
  }
  CHECK(colours < cosines);
  CHECK(cosines < normals);
}

}  // namespace tuberia
