#include <catch2/catch.hpp>

#include "reference/ray_tracer/shapes/triangle.hpp"
#include "tests/ray_tracer/shapes_support.hpp"

namespace tuberia::tracer::shapes_test {
namespace {

constexpr int kSide = 16;  // quadrilaterals around and from pole to pole

/// A closed net like a sphere whose vertices are 1 to 6 from its middle, by chance. Vertices are shared but at
/// the seam, where they are equal.
Mesh jittered_sphere(std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int row = 0; row <= kSide; ++row) {
    const bool at_pole = row == 0 || row == kSide;
    glm::dvec3 first(0);
    for (int column = 0; column <= kSide; ++column) {
      const double polar = std::numbers::pi * row / kSide, turn = 2 * std::numbers::pi * column / kSide;
      const glm::dvec3 direction(std::sin(polar) * std::cos(turn), std::cos(polar), -std::sin(polar) * std::sin(turn));
      glm::dvec3 position = uniform(random, 1, 6) * direction;
      if (column == 0) first = position;
      if (column == kSide || at_pole) position = first;
      mesh.positions.emplace_back(position);
    }
  }
  const auto number = [](int row, int column) { return static_cast<std::uint32_t>(row * (kSide + 1) + column); };
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      for (const std::uint32_t vertex : {number(row, column), number(row + 1, column), number(row + 1, column + 1), number(row, column),
                                         number(row + 1, column + 1), number(row, column + 1)})
        mesh.indices.push_back(vertex);
  return mesh;
}

bool meets_any(const Geometry& geometry, const Ray& ray, const std::vector<std::int64_t>& likely) {
  const PreparedRay prepared(ray);
  Hit hit;
  for (const std::int64_t item : likely)
    if (geometry.intersect(item, prepared, hit)) return true;
  return static_cast<bool>(nearest_hit(geometry, ray));
}

/// Of rays from inside a closed net to points of its edges, every fourth to a vertex, how many leave it without meeting it.
int misses_at_edges(const glm::dmat4& world_from_object, int rays, std::uint64_t seed) {
  const Mesh mesh = jittered_sphere(seed);
  Geometry geometry;
  geometry.add_mesh(mesh, world_from_object, 0);
  const Placement placement(world_from_object);

  std::vector<std::vector<std::int64_t>> items_at(mesh.positions.size());
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner)
    items_at[mesh.indices[corner]].push_back(static_cast<std::int64_t>(corner / 3));

  Random random(seed + 1);
  int misses = 0;
  for (int i = 0; i < rays; ++i) {
    const auto triangle = static_cast<std::size_t>(random.below(geometry.count()));
    const auto corner = static_cast<std::size_t>(random.below(3));
    const std::uint32_t from = mesh.indices[3 * triangle + corner], to = mesh.indices[3 * triangle + (corner + 1) % 3];
    const glm::dvec3 a = placement.point_to_world(mesh.positions[from]), b = placement.point_to_world(mesh.positions[to]);
    const double along = i % 4 == 0 ? 0 : uniform(random, 0, 1);
    const glm::dvec3 eye = placement.point_to_world(in_box(random, 0.25));
    const Ray ray{.origin = eye, .direction = a + along * (b - a) - eye};
    misses += meets_any(geometry, ray, items_at[from]) ? 0 : 1;
  }
  return misses;
}

int misses_anywhere(const glm::dmat4& world_from_object, int rays, std::uint64_t seed) {
  Geometry geometry;
  geometry.add_mesh(jittered_sphere(seed), world_from_object, 0);
  const Placement placement(world_from_object);
  Random random(seed + 2);
  int misses = 0;
  for (int i = 0; i < rays; ++i) {
    const glm::dvec3 eye = placement.point_to_world(in_box(random, 0.25));
    const Ray ray{.origin = eye, .direction = placement.linear * unit_vector(random)};
    const PreparedRay prepared(ray);
    bool met = false;
    Hit hit;
    for (std::int64_t item = 0; item < geometry.count() && !met; ++item) met = geometry.intersect(item, prepared, hit);
    misses += met ? 0 : 1;
  }
  return misses;
}

}  // namespace

TEST_CASE("shapes: no ray passes between triangles that share an edge or a vertex", "[ray_tracer][Y1][case-62]") {
  const std::uint64_t seed = 62;
  INFO("seed " << seed);
  for (const double scale : kScales) {
    INFO("scale " << scale);
    CHECK(misses_at_edges(scaled(scale), 1'000'000, seed) == 0);
    CHECK(misses_at_edges(scaled(scale) * turned(1, {1, 2, 3}), 100'000, seed) == 0);
  }
  CHECK(misses_at_edges(scaled(1, {148376, 1234, -223423}), 1'000'000, seed) == 0);
  CHECK(misses_anywhere(scaled(1), 100'000, seed) == 0);
  CHECK(misses_anywhere(scaled(1, {148376, 1234, -223423}), 20'000, seed) == 0);
}

TEST_CASE("shapes: rays along the axes meet a net of whole numbers at its edges and vertices", "[ray_tracer][Y1]") {
  // Here sums and products are exact, so that every edge function is 0 on the edges.
  Mesh net;
  for (int z = 0; z <= 4; ++z)
    for (int x = 0; x <= 4; ++x) net.positions.emplace_back(x, 0, z);
  for (std::uint32_t z = 0; z < 4; ++z)
    for (std::uint32_t x = 0; x < 4; ++x) {
      const std::uint32_t a = 5 * z + x;
      for (const std::uint32_t vertex : {a, a + 5, a + 6, a, a + 6, a + 1}) net.indices.push_back(vertex);
    }
  const glm::dmat4 quarter_turn(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, -1, 0, 0), glm::dvec4(0, 0, 0, 1));
  for (const glm::dmat4& matrix : {scaled(1), quarter_turn, scaled(1024, {3, 5, -7})}) {
    Geometry geometry;
    geometry.add_mesh(net, matrix, 0);
    const Placement placement(matrix);
    for (int z = 0; z <= 16; ++z)
      for (int x = 0; x <= 16; ++x)
        for (const double side : {1.0, -1.0}) {
          const glm::dvec3 target(0.25 * x, 0, 0.25 * z);
          const Ray ray{.origin = placement.point_to_world(target + glm::dvec3(0, 2 * side, 0)), .direction = placement.linear * glm::dvec3(0, -side, 0)};
          const Hit hit = nearest_hit(geometry, ray);
          REQUIRE(hit);
          CHECK(hit.t == Approx(2).epsilon(1e-12));
          CHECK(glm::length(geometry.surface(ray, hit).position - placement.point_to_world(target)) < 1e-11 * geometry.surface(ray, hit).magnitude);
        }
  }
}

TEST_CASE("shapes: the sign of an edge function is exact", "[ray_tracer][Y1]") {
  // (1 + e)(1 - e) - 1 = -e^2, all digits of which are lost when the product is rounded.
  const double e = 0x1p-30;
  CHECK(difference_of_products(1 + e, 1 - e, 1, 1) == -e * e);
  CHECK(difference_of_products(1, 1, 1 + e, 1 - e) == e * e);
  CHECK(difference_of_products(3, 5, 5, 3) == 0);
  CHECK(difference_of_products(2, 3, 1, 4) == 2);
}

TEST_CASE("shapes: degenerate triangles are missed", "[ray_tracer][case-63][B61]") {
  Mesh mesh;
  mesh.positions = {{-1113.45459f, -79.049614f, -56.2431908f}, {-1113.45459f, -87.0922699f, -56.2431908f}, {-1113.45459f, -79.2090149f, -56.2431908f},
                    {0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {1, 1, 1}, {NAN, 0, 0}, {INFINITY, 1, 0}};
  mesh.indices = {0, 1, 2, 3, 4, 5, 6, 6, 6, 6, 6, 3, 3, 4, 7, 3, 4, 8};
  for (const glm::dmat4& matrix : {scaled(1), turned(1, {1, 2, 3}), scaled(1e6, {0.1, 0.2, 0.3}) * turned(2, {1, 1, 0})}) {
    Geometry geometry;
    geometry.add_mesh(mesh, matrix, 0);
    REQUIRE(geometry.count() == 6);
    const Placement placement(matrix);
    const auto ray_of = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
      return Ray{.origin = placement.point_to_world(origin), .direction = placement.linear * direction};
    };
    CHECK(!nearest_hit(geometry, ray_of({-1081.47925, 99.9999542, 87.7701111}, {-32.1072998, -183.355865, -144.607635})));
    Random random(63);
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 eye = in_box(random, 5), target = glm::dvec3(mesh.positions[static_cast<std::size_t>(random.below(7))]);
      CHECK(!nearest_hit(geometry, ray_of(eye, target - eye)));
    }
    for (std::int64_t item = 0; item < geometry.count(); ++item) CHECK(geometry.bounds(item).empty());
  }
}

}  // namespace tuberia::tracer::shapes_test
