#pragma once
// One triangle over a whole picture of floats, at z = 0, with a normal of its own at each corner: every
// pixel is another place with another normal, and both are known in double.

#include <array>
#include <glm/geometric.hpp>

#include "math/optics.hpp"
#include "math/reflection.hpp"
#include "pipeline/lighting.hpp"
#include "tests/support/render.hpp"

namespace tuberia::test {

struct LitTriangle {
  std::array<glm::vec3, 3> normals{glm::vec3{0, 0, 1}, glm::vec3{0, 0, 1}, glm::vec3{0, 0, 1}};
  int size = 16;  // pixels, each way

  Mesh mesh() const {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
    mesh.normals.assign(normals.begin(), normals.end());
    mesh.texcoords = {{0, 0}, {2, 0}, {0, 2}};
    mesh.indices = {0, 1, 2};
    return mesh;
  }
  Image<Rgba32F> picture(const FragmentProgram& program, InstructionSet set, Precision precision, const PipelineState& state = {}) const {
    const Canvas canvas{.width = size, .height = size, .colour = ColourFormat::rgba32f,
                        .options = {.threads = 1, .instruction_set = set, .precision = precision}};
    return render(mesh(), program, state, canvas).linear;
  }
  /// Of the pixel's centre.
  glm::dvec3 position(int x, int y) const { return {(x + 0.5) * 2 / size - 1, 1 - (y + 0.5) * 2 / size, 0}; }
  /// The unit normals of the corners, interpolated and made unit.
  glm::dvec3 normal(int x, int y) const {
    const glm::dvec3 p = position(x, y);
    const double b = (p.x + 1) / 4, c = (p.y + 1) / 4;
    const auto corner = [&](std::size_t i) { return normalized_or(glm::dvec3(normals[i]), {}); };
    return normalized_or((1 - b - c) * corner(0) + b * corner(1) + c * corner(2), {});
  }
  LitPoint point(int x, int y, const Light& light, const glm::vec3& eye) const {
    const glm::dvec3 at = position(x, y), towards(light.towards);
    return {normal(x, y), light.kind == Light::Kind::directional ? towards : normalized_or(towards - at, {}), normalized_or(glm::dvec3(eye) - at, {})};
  }
};

inline double channel(const Rgba32F& pixel, int i) { return static_cast<double>(i == 0 ? pixel.r : i == 1 ? pixel.g : pixel.b); }

}  // namespace tuberia::test
