#include "bench/trade/shapes.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace tuberia::bench::trade {
namespace {

std::uint32_t vertex_count(const Shape& shape) { return static_cast<std::uint32_t>(shape.positions.size()); }

void add_vertex(Shape& shape, const glm::vec3& position, const glm::vec3& normal, const glm::vec2& texcoord) {
  shape.positions.push_back(position);
  shape.normals.push_back(normal);
  shape.texcoords.push_back(texcoord);
}

/// Joins the last (columns + 1) x (rows + 1) vertices, which were added row by row; counter-clockwise where
/// columns run right and rows up.
void join_grid(Shape& shape, int columns, int rows) {
  const auto width = static_cast<std::uint32_t>(columns + 1);
  const std::uint32_t first = vertex_count(shape) - width * static_cast<std::uint32_t>(rows + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i) {
      const std::uint32_t a = first + j * width + i, b = a + 1, c = b + width, d = a + width;
      shape.indices.insert(shape.indices.end(), {a, b, c, a, c, d});
    }
}

glm::vec3 knot_point(float t) {
  const float radius = 0.6f + 0.25f * std::cos(3 * t);
  return {radius * std::cos(2 * t), 0.35f * std::sin(3 * t), radius * std::sin(2 * t)};
}

}  // namespace

MeshView Shape::view() const noexcept {
  MeshView mesh;
  mesh.positions = positions;
  mesh.clip_positions = clip_positions;
  mesh.normals = normals;
  mesh.texcoords = texcoords;
  mesh.colours = colours;
  mesh.indices = indices;
  return mesh;
}

std::uint64_t Random::bits() noexcept {
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double Random::between(double low, double high) noexcept {
  return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
}

void add_sphere(Shape& shape, glm::vec3 centre, float radius, int rings) {
  const float step = glm::pi<float>() / static_cast<float>(rings);
  for (int j = 0; j <= rings; ++j)
    for (int i = 0; i <= 2 * rings; ++i) {
      const float polar = step * static_cast<float>(rings - j), azimuth = step * static_cast<float>(i);
      const glm::vec3 n(std::sin(polar) * std::sin(azimuth), std::cos(polar), std::sin(polar) * std::cos(azimuth));
      add_vertex(shape, centre + radius * n, n, {azimuth / glm::pi<float>(), polar / glm::pi<float>()});
    }
  join_grid(shape, 2 * rings, rings);
}

Shape knot(int along, int around, float tube_radius) {
  Shape shape;
  for (int j = 0; j <= along; ++j) {
    const float t = glm::two_pi<float>() * static_cast<float>(j) / static_cast<float>(along);
    const glm::vec3 forwards = glm::normalize(knot_point(t + 1e-3f) - knot_point(t - 1e-3f));
    const glm::vec3 sideways = glm::normalize(glm::cross(forwards, glm::vec3(0, 1, 0)));
    const glm::vec3 upwards = glm::cross(sideways, forwards);
    for (int i = 0; i <= around; ++i) {
      const float turn = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(around);
      const glm::vec3 n = sideways * std::cos(turn) + upwards * std::sin(turn);
      add_vertex(shape, knot_point(t) + tube_radius * n, n, {turn, 8 * t});
    }
  }
  join_grid(shape, around, along);
  return shape;
}

void add_rectangle(Shape& shape, glm::vec3 a, glm::vec3 u, glm::vec3 v, glm::vec3 normal, float repeats, int cells) {
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const glm::vec2 at = glm::vec2(i, j) / static_cast<float>(cells);
      add_vertex(shape, a + u * at.x + v * at.y, normal, repeats * at);
    }
  join_grid(shape, cells, cells);
}

Shape relief(int cells, float waves, float height) {
  Shape shape;
  const float k = glm::pi<float>() * waves;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const glm::vec2 at = 2.0f * glm::vec2(i, j) / static_cast<float>(cells) - 1.0f;
      const float sum = k * (at.x + 0.3f * at.y), difference = k * (0.4f * at.x - at.y);
      const float z = height * (std::sin(sum) + std::sin(difference));
      const float dx = height * k * (std::cos(sum) + 0.4f * std::cos(difference));
      const float dy = height * k * (0.3f * std::cos(sum) - std::cos(difference));
      add_vertex(shape, {at, z}, glm::normalize(glm::vec3(-dx, -dy, 1)), 0.5f * at + 0.5f);
    }
  join_grid(shape, cells, cells);
  return shape;
}

void add_box(Shape& shape, glm::vec3 middle_of_floor, glm::vec3 size) {
  const glm::vec3 a = middle_of_floor - glm::vec3(size.x / 2, 0, size.z / 2);
  const glm::vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  add_rectangle(shape, a + z, x, y, {0, 0, 1});
  add_rectangle(shape, a + x, -x, y, {0, 0, -1});
  add_rectangle(shape, a + x + z, -z, y, {1, 0, 0});
  add_rectangle(shape, a, z, y, {-1, 0, 0});
  add_rectangle(shape, a + y + z, x, -z, {0, 1, 0});
}

void add_clip_rectangle(Shape& shape, glm::vec2 low, glm::vec2 high, float z, const glm::vec4& colour) {
  const auto first = static_cast<std::uint32_t>(shape.clip_positions.size());
  for (const glm::vec2 corner : {low, glm::vec2(high.x, low.y), high, glm::vec2(low.x, high.y)}) {
    shape.clip_positions.emplace_back(corner, z, 1.0f);
    shape.colours.push_back(colour);
  }
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) shape.indices.push_back(first + i);
}

}  // namespace tuberia::bench::trade
