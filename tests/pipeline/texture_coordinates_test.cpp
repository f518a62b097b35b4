#include "pipeline/texture_coordinates.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <limits>

#include "math/transforms.hpp"
#include "tests/support/random.hpp"

namespace tuberia {
namespace {

using Source = TexCoordSource;

/// Unit 1's coordinates of a mesh's first vertex.
glm::vec4 unit_1_of_first(const MeshView& mesh, const TransformState& state) {
  const Attributes wanted = Attributes::colour | Attributes::unit1;
  VertexBatch batch;
  batch.stride = vertex_stride(wanted);
  batch.attributes.resize(3 * static_cast<std::size_t>(batch.stride), -1.0f);
  const std::array<std::uint32_t, 1> slots{2}, sources{0};
  REQUIRE(!check_texture_coordinates(mesh, state, wanted));
  write_texture_coordinates(mesh, state, wanted, slots, sources, batch);
  const float* record = batch.attributes.data() + 2 * batch.stride;
  CHECK(record[0] == -1.0f);  // the other attributes stay
  return {record[4], record[5], record[6], record[7]};
}

struct OneVertex {
  glm::vec3 position{0, 0, -5}, normal{0, 0, 1};
  glm::vec2 texcoord{0.25f, 0.75f};
  MeshView view() const { return {.positions = {&position, 1}, .normals = {&normal, 1}, .texcoords = {&texcoord, 1}, .colours = {}, .custom = {}, .indices = {}}; }
};

TransformState unit_1_from(std::array<Source, 4> source, std::array<glm::vec4, 4> plane = {}) {
  TransformState state;
  state.texture_units[1] = {.source = source, .plane = plane};
  return state;
}

constexpr std::array<Source, 4> kSphere{Source::sphere_map, Source::sphere_map, Source::vertex, Source::vertex};
constexpr std::array<Source, 4> kReflection{Source::reflection_map, Source::reflection_map, Source::reflection_map, Source::vertex};

void check_close(const glm::vec4& found, const glm::vec4& right, float margin = 1e-5f) {
  for (int i = 0; i < 4; ++i) {
    INFO("coordinate " << "strq"[i]);
    CHECK(found[i] == Approx(right[i]).margin(static_cast<double>(margin)));
  }
}

}  // namespace

TEST_CASE("texture coordinates: the mesh's own come as they are", "[pipeline]") {
  const OneVertex vertex;
  const glm::vec4 own{1, -0.0f, 3, 4};
  MeshView mesh = vertex.view();
  CHECK(unit_1_of_first(mesh, {}) == glm::vec4(0.25f, 0.75f, 0, 1));
  mesh.unit_texcoords[1] = {&own, 1};
  const glm::vec4 found = unit_1_of_first(mesh, {});
  CHECK(found == own);
  CHECK(std::signbit(found.y));
}

// notes 15.15, 15.20
TEST_CASE("texture coordinates: maps by hand", "[pipeline][case-53]") {
  check_close(unit_1_of_first(OneVertex{}.view(), unit_1_from(kSphere)), {0.5f, 0.5f, 0, 1});
  check_close(unit_1_of_first(OneVertex{}.view(), unit_1_from(kReflection)), {0, 0, 1, 1});
  // Seen edge on, the reflection goes on straight away from the eye, where m is 0.
  OneVertex vertex{.normal = {1, 0, 0}};
  CHECK(unit_1_of_first(vertex.view(), unit_1_from(kSphere)) == glm::vec4(0.5f, 0.5f, 0, 1));
  // N = +z, towards the eye (0.5, 0, 0.866): reflected (-0.5, 0, 0.866); the same with N turned round.
  for (const float side : {1.0f, -1.0f}) {
    vertex = {.position = glm::vec3(-0.5f, 0, -0.866025404f) * 3.0f, .normal = {0, 0, 7 * side}};
    check_close(unit_1_of_first(vertex.view(), unit_1_from(kReflection)), {-0.5f, 0, 0.866025f, 1});
    check_close(unit_1_of_first(vertex.view(), unit_1_from({Source::normal_map, Source::normal_map, Source::normal_map, Source::vertex})), {0, 0, side, 1});
  }
  // A vertex in the eye, a normal of length 0, and sizes whose squares leave the floats.
  for (const glm::vec3& odd : {glm::vec3(0), glm::vec3(1e-30f, 0, -1e-30f), glm::vec3(1e30f, 1e30f, -1e30f), glm::vec3(1e-42f, 0, 0)})
    for (const auto& source : {kSphere, kReflection}) {
      const OneVertex strange{.position = odd, .normal = odd};
      const glm::vec4 found = unit_1_of_first(strange.view(), unit_1_from(source));
      for (int i = 0; i < 4; ++i) CHECK(std::abs(found[i]) <= 1.0001f);
    }
}

TEST_CASE("texture coordinates: every source against its formula in doubles", "[pipeline]") {
  test::Random random(201);
  const auto vector = [&] { return glm::vec4(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)); };
  for (int round = 0; round < 200; ++round) {
    INFO("seed 201, round " << round);
    const OneVertex vertex{.position = glm::vec3(vector()) + glm::vec3(0, 0, 3), .normal = glm::normalize(glm::vec3(vector()))};
    TransformState state;
    state.world_from_object = glm::mat4(vector(), vector(), vector(), glm::vec4(glm::vec3(vector()), 1));
    for (int i = 0; i < 3; ++i) state.world_from_object[i].w = 0;
    const glm::dvec3 eye{vector().x, vector().y, 7};
    state.view_from_world = view_from_world(*camera_basis(eye, {0, 0, 0}, {0, 1, 0}), eye);
    TexCoordUnit& unit = state.texture_units[1];
    for (std::size_t i = 0; i < 4; ++i) unit.source[i] = static_cast<Source>(random.below(i < 2 ? 6 : 3));
    for (std::size_t i = 2; i < 4; ++i)
      if (unit.source[i] == Source::sphere_map) unit.source[i] = Source::vertex;
    for (glm::vec4& plane : unit.plane) plane = vector();
    if (round % 2 == 0) unit.matrix = glm::mat4(vector(), vector(), vector(), vector());

    const glm::dmat4 view_from_object = glm::dmat4(state.view_from_world) * glm::dmat4(state.world_from_object);
    if (std::abs(glm::determinant(glm::dmat3(view_from_object))) < 0.2) continue;
    const glm::dvec4 object(vertex.position, 1), view = view_from_object * object;
    const glm::dvec3 normal = glm::normalize(glm::inverseTranspose(glm::dmat3(view_from_object)) * glm::dvec3(vertex.normal));
    const glm::dvec3 u = glm::normalize(glm::dvec3(view)), r = u - 2 * glm::dot(normal, u) * normal;
    const double m = 2 * glm::length(r + glm::dvec3(0, 0, 1));
    if (m < 0.05) continue;
    glm::dvec4 right;
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const int axis = std::min(i, 2);
      const glm::dvec4 given(vertex.texcoord, 0, 1);
      const double values[6] = {given[i], glm::dot(glm::dvec4(unit.plane[at]), object), glm::dot(glm::dvec4(unit.plane[at]), view), r[axis] / m + 0.5, r[axis], normal[axis]};
      right[i] = values[static_cast<std::size_t>(unit.source[at])];
    }
    check_close(unit_1_of_first(vertex.view(), state), glm::vec4(glm::dmat4(unit.matrix) * right), 2e-3f);
  }
}

TEST_CASE("texture coordinates: what cannot be made is refused by name", "[pipeline]") {
  const OneVertex vertex;
  const auto refusal = [&](const MeshView& mesh, const TransformState& state) {
    const auto error = check_texture_coordinates(mesh, state, Attributes::unit1);
    return error ? error->message : std::string();
  };
  const auto names = [](const char* words) { return Catch::Matchers::Contains(words); };
  MeshView bare = vertex.view();
  bare.texcoords = {};
  CHECK_THAT(refusal(bare, {}), names("texture unit 1 has no texture coordinates"));
  CHECK(refusal(bare, unit_1_from(kSphere)).empty());
  CHECK(refusal({}, {}).empty());  // nothing to draw
  CHECK(!check_texture_coordinates(bare, {}, Attributes::colour));  // nobody asks
  bare.normals = {};
  CHECK_THAT(refusal(bare, unit_1_from(kSphere)), names("normals"));
  CHECK_THAT(refusal(vertex.view(), unit_1_from({Source::vertex, Source::vertex, Source::sphere_map, Source::vertex})), names("unit 1's r"));
  CHECK_THAT(refusal(vertex.view(), unit_1_from({Source::vertex, Source::vertex, Source::vertex, Source::normal_map})), names("unit 1's q"));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK_THAT(refusal(vertex.view(), unit_1_from({Source::vertex, Source::eye_linear, Source::vertex, Source::vertex}, {glm::vec4(0), glm::vec4(nan)})), names("unit 1's t"));
  TransformState bad;
  bad.texture_units[1].matrix[2][1] = nan;
  CHECK_THAT(refusal(vertex.view(), bad), names("matrix"));
  const std::array<glm::vec4, 1> clip{};
  MeshView clipped = vertex.view();
  clipped.positions = {};
  clipped.clip_positions = clip;
  CHECK_THAT(refusal(clipped, unit_1_from(kReflection)), names("object positions"));
}

}  // namespace tuberia
