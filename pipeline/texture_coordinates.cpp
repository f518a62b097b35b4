#include "pipeline/texture_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/mat3x3.hpp>
#include <string>

#include "math/transforms.hpp"
#include "pipeline/refusal.hpp"

namespace tuberia {
namespace {

constexpr Attributes attribute_of_unit(int unit) {
  return static_cast<Attributes>(static_cast<std::uint32_t>(Attributes::unit0) << unit);
}

bool is_linear(TexCoordSource source) { return source == TexCoordSource::object_linear || source == TexCoordSource::eye_linear; }

bool uses(const TexCoordUnit& unit, TexCoordSource source) {
  return std::find(unit.source.begin(), unit.source.end(), source) != unit.source.end();
}
bool needs_normals(const TexCoordUnit& unit) {
  return uses(unit, TexCoordSource::sphere_map) || uses(unit, TexCoordSource::reflection_map) || uses(unit, TexCoordSource::normal_map);
}
bool is_in_view_space(const TexCoordUnit& unit) { return needs_normals(unit) || uses(unit, TexCoordSource::eye_linear); }
bool generates(const TexCoordUnit& unit) { return is_in_view_space(unit) || uses(unit, TexCoordSource::object_linear); }
bool takes_all_from_mesh(const TexCoordUnit& unit) {
  return std::all_of(unit.source.begin(), unit.source.end(), [](TexCoordSource s) { return s == TexCoordSource::vertex; });
}

/// The value of (p, 1) on a plane, or a row of a matrix times (p, 1); always summed in this order.
float product(const glm::vec4& row, const glm::vec3& p) { return ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w; }

float dot(const glm::vec3& a, const glm::vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

/// Unit length; the zero vector stays zero. Very short and very long ones are scaled first. [rules S1]
glm::vec3 unit_vector(glm::vec3 v) {
  float squared = dot(v, v);
  if (!(squared > 1e-30f && squared < 1e30f)) {
    const float largest = std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
    if (!(largest > 0)) return glm::vec3(0);
    const float shift = largest < 1e-20f ? 1e30f : 1.0f;  // the reciprocal of a denormal number overflows
    v = {v.x * shift / (largest * shift), v.y * shift / (largest * shift), v.z * shift / (largest * shift)};
    squared = dot(v, v);
  }
  const float scale = 1.0f / std::sqrt(squared);
  return {v.x * scale, v.y * scale, v.z * scale};
}

/// One vertex, as the sources of generated coordinates see it.
struct SourceVertex {
  glm::vec4 given{0, 0, 0, 1};
  glm::vec3 object{0}, view{0}, normal{0}, reflection{0};
};

/// A reflection's place on a sphere map; straight back from the eye's side, where the formula divides
/// by 0, the middle.                                                                    [rules 53]
float on_sphere_map(float component, const glm::vec3& r) {
  const glm::vec3 raised{r.x, r.y, r.z + 1.0f};
  const float m = 2.0f * std::sqrt(dot(raised, raised));
  return m > 0 ? component / m + 0.5f : 0.5f;
}

float coordinate(const TexCoordUnit& unit, int i, const SourceVertex& vertex) {
  const auto at = static_cast<std::size_t>(i);
  const int axis = std::min(i, 2);  // the maps never make q
  switch (unit.source[at]) {
    case TexCoordSource::vertex: break;
    case TexCoordSource::object_linear: return product(unit.plane[at], vertex.object);
    case TexCoordSource::eye_linear: return product(unit.plane[at], vertex.view);
    case TexCoordSource::sphere_map: return on_sphere_map(vertex.reflection[axis], vertex.reflection);
    case TexCoordSource::reflection_map: return vertex.reflection[axis];
    case TexCoordSource::normal_map: return vertex.normal[axis];
  }
  return vertex.given[i];
}

/// Computes one unit's coordinates of a mesh's vertices.
class UnitCoordinates {
 public:
  UnitCoordinates(const MeshView& mesh, const TransformState& state, int number)
      : mesh_(mesh), unit_(state.texture_units[static_cast<std::size_t>(number)]), given_(mesh.unit_texcoords[static_cast<std::size_t>(number)]),
        view_from_object_(compose(state.view_from_world, state.world_from_object)),
        view_normal_from_object_(normal_matrix(view_from_object_)), transforms_(unit_.matrix != glm::mat4(1.0f)) {}

  glm::vec4 operator()(std::uint32_t number) const {
    const SourceVertex vertex = source_vertex(number);
    glm::vec4 made;
    for (int i = 0; i < 4; ++i) made[i] = coordinate(unit_, i, vertex);
    if (!transforms_) return made;
    glm::vec4 moved;
    const glm::mat4& m = unit_.matrix;
    for (int i = 0; i < 4; ++i) moved[i] = ((m[0][i] * made.x + m[1][i] * made.y) + m[2][i] * made.z) + m[3][i] * made.w;
    return moved;
  }

 private:
  SourceVertex source_vertex(std::uint32_t number) const {
    SourceVertex vertex;
    if (!given_.empty()) vertex.given = given_[number];
    else if (!mesh_.texcoords.empty()) vertex.given = {mesh_.texcoords[number].x, mesh_.texcoords[number].y, 0, 1};
    if (!generates(unit_)) return vertex;

    vertex.object = mesh_.positions[number];
    if (!is_in_view_space(unit_)) return vertex;
    const glm::mat4& m = view_from_object_;
    for (int i = 0; i < 3; ++i) vertex.view[i] = product({m[0][i], m[1][i], m[2][i], m[3][i]}, vertex.object);
    if (!needs_normals(unit_)) return vertex;

    glm::vec3 normal;
    const glm::mat3& n = view_normal_from_object_;
    for (int i = 0; i < 3; ++i) normal[i] = dot({n[0][i], n[1][i], n[2][i]}, mesh_.normals[number]);
    vertex.normal = unit_vector(normal);
    const glm::vec3 u = unit_vector(vertex.view);
    const float twice = 2.0f * dot(vertex.normal, u);
    vertex.reflection = {u.x - vertex.normal.x * twice, u.y - vertex.normal.y * twice, u.z - vertex.normal.z * twice};
    return vertex;
  }

  const MeshView& mesh_;
  TexCoordUnit unit_;
  std::span<const glm::vec4> given_;
  glm::mat4 view_from_object_;
  glm::mat3 view_normal_from_object_;
  bool transforms_;
};

Refusal check_numbers(const std::string& name, const glm::vec4& numbers) {
  for (int i = 0; i < 4; ++i)
    if (auto refusal = check_finite(name + ", number " + std::to_string(i), numbers[i])) return refusal;
  return {};
}

Refusal check_sources(const TexCoordUnit& unit, const std::string& name) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string coordinate = name + "'s " + "strq"[i];
    const TexCoordSource source = unit.source[i];
    if (source == TexCoordSource::sphere_map && i > 1) return Error{coordinate + " cannot come from a sphere map, which gives s and t"};
    if ((source == TexCoordSource::reflection_map || source == TexCoordSource::normal_map) && i > 2)
      return Error{coordinate + " cannot come from a reflection or normal map, which give s, t and r"};
    if (is_linear(source))
      if (auto refusal = check_numbers(coordinate + "'s plane", unit.plane[i])) return refusal;
  }
  for (int column = 0; column < 4; ++column)
    if (auto refusal = check_numbers(name + "'s matrix, column " + std::to_string(column), unit.matrix[column])) return refusal;
  return {};
}

Refusal check_unit(const MeshView& mesh, const TransformState& state, int number) {
  const auto at = static_cast<std::size_t>(number);
  const TexCoordUnit& unit = state.texture_units[at];
  const std::string name = "texture unit " + std::to_string(number);
  if (auto refusal = check_sources(unit, name)) return refusal;
  if (takes_all_from_mesh(unit) && mesh.unit_texcoords[at].empty() && mesh.texcoords.empty() && mesh.vertex_count() > 0)
    return Error{name + " has no texture coordinates: the mesh has none, and none are generated"};
  if (generates(unit) && mesh.positions.empty() && mesh.vertex_count() > 0)
    return Error{name + " generates texture coordinates from object positions, which the mesh does not have"};
  if (needs_normals(unit) && mesh.normals.empty() && mesh.vertex_count() > 0)
    return Error{name + " generates texture coordinates from normals, which the mesh does not have"};
  return {};
}

}  // namespace

std::optional<Error> check_texture_coordinates(const MeshView& mesh, const TransformState& state, Attributes wanted) {
  for (int unit = 0; unit < kTextureUnits; ++unit) {
    if (!contains(wanted, attribute_of_unit(unit))) continue;
    if (auto refusal = check_unit(mesh, state, unit)) return refusal;
  }
  return {};
}

void write_texture_coordinates(const MeshView& mesh, const TransformState& state, Attributes wanted,
                               std::span<const std::uint32_t> slots, std::span<const std::uint32_t> sources, VertexBatch& batch) {
  for (int unit = 0; unit < kTextureUnits; ++unit) {
    if (!contains(wanted, attribute_of_unit(unit))) continue;
    const UnitCoordinates coordinates(mesh, state, unit);
    float* first = batch.attributes.data() + scalar_offset(wanted, attribute_of_unit(unit));
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const glm::vec4 strq = coordinates(sources[i]);
      std::memcpy(first + slots[i] * static_cast<std::size_t>(batch.stride), &strq[0], sizeof strq);
    }
  }
}

}  // namespace tuberia
