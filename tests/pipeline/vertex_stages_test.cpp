#include <catch2/catch.hpp>

#include <bit>

#include "math/transforms.hpp"
#include "pipeline/vertex_transform.hpp"
#include "tests/support/batches.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

namespace tuberia {

using test::for_every_instruction_set;

namespace {

test::Mesh random_mesh(std::uint64_t seed, int vertices) {
  test::Random random(seed);
  test::Mesh mesh;
  for (int i = 0; i < vertices; ++i) {
    mesh.positions.push_back({random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)});
    mesh.normals.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    mesh.texcoords.push_back({random.between(0, 1), random.between(0, 1)});
  }
  return mesh;
}

VertexBatch batch_of(std::vector<std::uint32_t> source) {
  VertexBatch batch;
  batch.source = std::move(source);
  return batch;
}

std::vector<std::uint32_t> numbers_below(int count) {
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::uint32_t>(i);
  return numbers;
}

}  // namespace

TEST_CASE("vertex fetch: a shared vertex gets one slot", "[pipeline]") {
  test::Mesh mesh = random_mesh(1, 6);
  mesh.indices = {5, 2, 3, 3, 2, 0, 5, 5, 0};
  VertexFetch fetch;
  VertexBatch batch;
  std::vector<std::uint32_t> slots;
  fetch(mesh.view(), Topology::triangles, {0, 3}, batch, slots);
  CHECK(batch.source == std::vector<std::uint32_t>{5, 2, 3, 0});
  CHECK(slots == std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 0, 0, 3});
  fetch(mesh.view(), Topology::triangles, {1, 1}, batch, slots);
  CHECK(batch.source == std::vector<std::uint32_t>{3, 2, 0});
}

TEST_CASE("vertex fetch: a run in the middle of a strip or fan takes what it needs", "[pipeline]") {
  const test::Mesh mesh = random_mesh(1, 8);
  VertexFetch fetch;
  VertexBatch batch;
  std::vector<std::uint32_t> slots;
  fetch(mesh.view(), Topology::triangle_strip, {3, 2}, batch, slots);
  CHECK(batch.source == std::vector<std::uint32_t>{3, 4, 5, 6});
  fetch(mesh.view(), Topology::triangle_fan, {3, 2}, batch, slots);
  CHECK(batch.source == std::vector<std::uint32_t>{0, 4, 5, 6});
}

TEST_CASE("vertex fetch: how many primitives some vertices make", "[pipeline]") {
  CHECK(primitive_count(Topology::triangles, 8) == 2);
  CHECK(primitive_count(Topology::triangle_strip, 8) == 6);
  CHECK(primitive_count(Topology::triangle_fan, 8) == 6);
  for (const Topology topology : {Topology::triangles, Topology::triangle_strip, Topology::triangle_fan})
    for (const std::int64_t elements : {0, 1, 2}) CHECK(primitive_count(topology, elements) == 0);
}

TEST_CASE("vertex transform: clip = matrix * (position, 1), the same bits everywhere", "[pipeline][exact]") {
  const test::Mesh mesh = random_mesh(61, 37);
  TransformState state;
  state.world_from_object = compose(translation({0.3, -0.2, -4}), rotation({1, 2, 3}, 0.7));
  state.clip_from_world = *perspective(1.0, 1.5, 0.5, 20, ClipVolume::minus_w_to_w);
  const glm::mat4 m = compose(state.clip_from_world, state.world_from_object);
  for_every_instruction_set([&](InstructionSet set) {
    const VertexTransform transform(state, {.guard_x = 1, .guard_y = 1, .z_low = -1}, set);
    VertexBatch batch = batch_of(numbers_below(37));
    transform.positions(mesh.view(), batch);
    for (std::size_t i = 0; i < 37; ++i) {
      const glm::vec3 p = mesh.positions[i];
      const auto row = [&](int r) { return ((m[0][r] * p.x + m[1][r] * p.y) + m[2][r] * p.z) + m[3][r]; };
      const bool same = batch.clip_x[i] == row(0) && batch.clip_y[i] == row(1) && batch.clip_z[i] == row(2) && batch.clip_w[i] == row(3);
      CHECK(same);
    }
  });
}

TEST_CASE("vertex transform: outcodes name the planes that a vertex is outside of", "[pipeline]") {
  test::Mesh mesh;
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  mesh.positions = {{0, 0, 0}, {-3, 0, 0}, {3, 0, 0}, {0, -3, 0}, {0, 3, 0}, {0, 0, -1.5f}, {0, 0, 1.5f}, {2, -2, 1},
                    {nan, 0, 0}, {0, inf, 0}, {0, 0, -inf}};
  const std::vector<std::uint32_t> expected{0, outcode::left, outcode::right, outcode::bottom, outcode::top, outcode::near,
                                            outcode::far, 0};
  for_every_instruction_set([&](InstructionSet set) {
    VertexBatch batch = batch_of(numbers_below(11));
    VertexTransform({}, {.guard_x = 2, .guard_y = 2, .z_low = -1}, set).positions(mesh.view(), batch);
    CHECK(std::vector<std::uint32_t>(batch.outcode.begin(), batch.outcode.begin() + 8) == expected);
    for (std::size_t i = 8; i < 11; ++i) CHECK((batch.outcode[i] & outcode::invalid) != 0);
  });
}

TEST_CASE("vertex transform: attributes follow for the vertices in use", "[pipeline][exact]") {
  const test::Mesh mesh = random_mesh(62, 10);
  TransformState state;
  state.world_from_object = compose(translation({1, 2, 3}), scaling({2, 1, 0.5}));
  constexpr Attributes kWanted = Attributes::position | Attributes::normal | Attributes::texcoord | Attributes::colour;
  for_every_instruction_set([&](InstructionSet set) {
    const VertexTransform transform(state, {}, set);
    VertexBatch batch = batch_of(numbers_below(10));
    transform.positions(mesh.view(), batch);
    TriangleBatch triangles;
    triangles.add(2, 9, 4, 2, 0);
    transform.attributes(mesh.view(), kWanted, triangles, batch);
    CHECK(batch.stride == 12);
    for (const std::size_t slot : {2u, 4u, 9u}) {
      const float* record = batch.attributes.data() + slot * 12;
      const glm::vec3 p = mesh.positions[slot];
      CHECK((record[0] == p.x * 2 + 1 && record[1] == p.y + 2 && record[2] == p.z * 0.5f + 3));
      // Normals take the inverse transpose, and are unit.
      const glm::dvec3 n = glm::dvec3(mesh.normals[slot]) * glm::dvec3(0.5, 1, 2);
      const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
      CHECK(record[3] == Approx(n.x / length).margin(3e-7));
      CHECK(record[4] == Approx(n.y / length).margin(3e-7));
      CHECK(record[5] == Approx(n.z / length).margin(3e-7));
      CHECK((record[6] == mesh.texcoords[slot].x && record[7] == mesh.texcoords[slot].y));
      // The mesh has no colours: white.
      CHECK((record[8] == 1 && record[9] == 1 && record[10] == 1 && record[11] == 1));
    }
  });
}

TEST_CASE("vertex transform: tangents turn with the surface and keep their lengths", "[pipeline][exact][A10]") {
  const test::Mesh mesh = random_mesh(64, 10);
  const std::vector<glm::vec3> tangents(mesh.positions.begin(), mesh.positions.end()), bitangents(mesh.normals.begin(), mesh.normals.end());
  MeshView view = mesh.view();
  view.tangents = tangents, view.bitangents = bitangents;
  TransformState state;
  state.world_from_object = compose(translation({1, 2, 3}), scaling({2, 1, 0.5}));
  for_every_instruction_set([&](InstructionSet set) {
    VertexBatch batch = batch_of(numbers_below(10));
    const VertexTransform transform(state, {}, set);
    transform.positions(view, batch);
    TriangleBatch triangles;
    triangles.add(2, 9, 4, 2, 0);
    transform.attributes(view, Attributes::tangent | Attributes::bitangent, triangles, batch);
    CHECK(batch.stride == 8);
    for (const std::size_t slot : {2u, 4u, 9u}) {
      const float* record = batch.attributes.data() + slot * 8;
      const glm::vec3 t = tangents[slot] * glm::vec3(2, 1, 0.5f), b = bitangents[slot] * glm::vec3(2, 1, 0.5f);
      CHECK((record[0] == t.x && record[1] == t.y && record[2] == t.z));
      CHECK((record[3] == b.x && record[4] == b.y && record[5] == b.z));
    }
    view.tangents = {};
    transform.attributes(view, Attributes::tangent, triangles, batch);  // 0 where there are none
    CHECK(batch.attributes[2 * static_cast<std::size_t>(batch.stride)] == 0);
    view.tangents = tangents;
  });
}

TEST_CASE("vertex transform: a clipped vertex gets the share of its triangle's attributes", "[pipeline]") {
  const test::Mesh mesh = random_mesh(63, 3);
  VertexBatch batch = batch_of({0, 1, 2});
  const VertexTransform transform({}, {}, InstructionSet::baseline);
  transform.positions(mesh.view(), batch);
  batch.clipped.push_back({{0, 1, 2}, {0.25, 0.75, 0}});
  TriangleBatch triangles;
  triangles.add(3, 1, 2, 0, 0);
  transform.attributes(mesh.view(), Attributes::texcoord, triangles, batch);
  const float* record = batch.attributes.data() + 3 * batch.stride;
  CHECK(record[0] == Approx(0.25f * mesh.texcoords[0].x + 0.75f * mesh.texcoords[1].x).epsilon(1e-6));
  CHECK(record[1] == Approx(0.25f * mesh.texcoords[0].y + 0.75f * mesh.texcoords[1].y).epsilon(1e-6));
}

}  // namespace tuberia
