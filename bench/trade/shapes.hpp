#pragma once
// What the trade's scenes are made of: formulas, so that every machine draws the same.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "pipeline/draw_call.hpp"

namespace tuberia::bench::trade {

/// Triangles that own their arrays. Counter-clockwise is front. Either positions (object space) or
/// clip_positions; of the others each may be empty.
struct Shape {
  std::vector<glm::vec3> positions{}, normals{};
  std::vector<glm::vec4> clip_positions{};
  std::vector<glm::vec2> texcoords{};
  std::vector<glm::vec4> colours{};  // linear RGBA
  std::vector<std::uint32_t> indices{};

  MeshView view() const noexcept;
};

/// splitmix64, the generator of the public cases.                                     [rules 0]
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() noexcept;
  /// In [low, high).
  double between(double low, double high) noexcept;

 private:
  std::uint64_t state_;
};

/// A sphere of rings x 2 rings quadrilaterals around a centre, with normals and texture coordinates.
void add_sphere(Shape& shape, glm::vec3 centre, float radius, int rings);

/// A tube around a (2, 3) torus knot of about the unit size: along x around quadrilaterals.
Shape knot(int along, int around, float tube_radius);

/// The rectangle a, a + u, a + u + v, a + v with this normal, in cells x cells quadrilaterals; texture
/// coordinates from 0 to `repeats` along both.
void add_rectangle(Shape& shape, glm::vec3 a, glm::vec3 u, glm::vec3 v, glm::vec3 normal, float repeats = 1,
                   int cells = 1);

/// A wavy square [-1, 1]^2 of cells x cells quadrilaterals over z = 0: waves of both diagonals, with their normals.
Shape relief(int cells, float waves, float height);

/// An upright box on y = 0 without its floor.
void add_box(Shape& shape, glm::vec3 middle_of_floor, glm::vec3 size);

/// A rectangle of clip space (w = 1) at one depth and in one colour: for what fills known pixels.
void add_clip_rectangle(Shape& shape, glm::vec2 low, glm::vec2 high, float z, const glm::vec4& colour);

}  // namespace tuberia::bench::trade
