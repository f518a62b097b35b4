#include <catch2/catch.hpp>

#include <algorithm>

#include "reference/ray_tracer/shapes/polygon.hpp"
#include "reference/ray_tracer/shapes/polyhedron.hpp"
#include "reference/ray_tracer/shapes/quadric.hpp"
#include "tests/ray_tracer/shapes_support.hpp"

namespace tuberia::tracer::shapes_test {
namespace {

const double kNoNumber = NAN;

/// How often the rings wind around a point, by the sum of angles: counter-clockwise +1.
int winding(const std::vector<Ring>& rings, const glm::dvec2& point) {
  double angle = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const glm::dvec2 a = ring[i] - point, b = ring[(i + 1) % ring.size()] - point;
      angle += std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
    }
  return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
}

/// Simple, mostly concave: its corners lie around the origin in order.
Ring star(Random& random, int corners, double from, double to) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, radius = uniform(random, from, to);
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return ring;
}

}  // namespace

TEST_CASE("shapes: points in polygons by Jordan's theorem are where the rings wind around", "[ray_tracer][B62]") {
  Random random(62);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const int corners = 3 + static_cast<int>(random.below(12));
    std::vector<Ring> rings{star(random, corners, 0.5, 1)};
    if (i % 2 == 0) {  // a hole runs the other way
      rings.push_back(star(random, 5, 0.05, 0.15));
      std::reverse(rings[1].begin(), rings[1].end());
    }
    for (int k = 0; k < 100; ++k) {
      glm::dvec2 point(uniform(random, -1, 1), uniform(random, -1, 1));
      // Every other ray runs through a corner.
      if (k % 2 == 0) point.y = rings[0][static_cast<std::size_t>(random.below(corners))].y;
      const int turns = winding(rings, point);
      CHECK(is_inside(rings, point) == (turns != 0));
      inside += turns != 0 ? 1 : 0;
    }
  }
  CHECK(inside > 20000);
}

TEST_CASE("shapes: the notes' L, and corners on the axis", "[ray_tracer][B62]") {
  const Ring l{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  const auto inside = [&](double u, double v) { return is_inside(std::vector<Ring>{l}, {u, v}); };
  CHECK(inside(2, 0.5));     // 1 crossing
  CHECK(inside(0.5, 2));
  CHECK(!inside(2, 2));      // 0
  CHECK(!inside(-1, 0.5));   // 2
  CHECK(!inside(-1, 2));
  // Through corners, which count as above the axis: so upper edges belong to the polygon, lower ones to what is below, and
  // left ones do where right ones do not.
  CHECK(inside(0.5, 1));
  CHECK(!inside(-1, 1));
  CHECK(!inside(2, 1.0000001));
  CHECK(inside(2, 1));
  CHECK(!inside(2, 0));
  CHECK(inside(0.5, 3));
  CHECK(inside(0, 0.5));
  CHECK(!inside(3, 0.5));

  const Ring comb{{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const auto in_comb = [&](double u, double v) { return is_inside(std::vector<Ring>{comb}, {u, v}); };
  CHECK(in_comb(2.5, 1.5));  // 3 crossings
  CHECK(in_comb(0.5, 1.5));  // 5
  CHECK(!in_comb(1.5, 1.5)); // 4
  CHECK(!in_comb(3.5, 1.5)); // 2
  CHECK(in_comb(1.5, 1));    // on an edge that runs along the axis
  CHECK(in_comb(0.5, 1));
}

TEST_CASE("shapes: of polygons that share edges exactly one has each point", "[ray_tracer][B62][Y1]") {
  // A square cut in three: whole numbers, so that points of the edges are exactly on them.
  const std::vector<Ring> parts{{{0, 0}, {8, 0}, {4, 4}}, {{0, 0}, {4, 4}, {8, 8}, {0, 8}}, {{4, 4}, {8, 0}, {8, 8}}};
  for (int v = 1; v <= 8; ++v)
    for (int u = 0; u < 8; ++u) {
      int owners = 0;
      for (const Ring& part : parts) owners += is_inside(std::vector<Ring>{part}, {u, v}) ? 1 : 0;
      CHECK(owners == 1);
    }
}

TEST_CASE("shapes: the notes' polygon", "[ray_tracer][B61]") {
  const std::vector<glm::dvec3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto polygon = *Polygon::create(triangle);
  const Ray hitting{.origin = {0.25, 0.25, 1}, .direction = {0, 0, -1}};
  const std::optional<ShapeHit> hit = polygon->intersect(hitting);
  REQUIRE(hit);
  CHECK(hit->t == 1);
  CHECK(polygon->surface(hitting, *hit).normal == glm::dvec3(0, 0, 1));
  CHECK(polygon->surface(hitting, *hit).position == glm::dvec3(0.25, 0.25, 0));
  CHECK(!polygon->intersect({.origin = {0.75, 0.75, 1}, .direction = {0, 0, -1}}));
  CHECK(!polygon->intersect({.origin = {0.25, 0.25, 0}, .direction = {1, 0, 0}}));   // N.D = 0
  CHECK(!polygon->intersect({.origin = {0.25, 0.25, 1}, .direction = {0, 0, 1}}));   // t < 0
  CHECK(!polygon->intersect({.origin = {0.25, 0.25, 0}, .direction = {0, 0, 1}}));   // t = 0
  CHECK(!polygon->intersect({.origin = {0.25, 0.25, 1}, .direction = {0, 0, -1}, .t_min = 0, .t_max = 1}));
}

TEST_CASE("shapes: polygons that are none are refused", "[ray_tracer][B61][B62]") {
  using Corners = std::vector<glm::dvec3>;
  const Corners square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto refusal = [](const Corners& outline, const std::vector<Corners>& holes = {}) {
    const auto polygon = Polygon::create(outline, holes);
    return polygon ? std::string() : polygon.error().message;
  };
  CHECK(refusal(square).empty());
  CHECK(refusal({{0, 0, 0}, {1, 0, 0}}) == "polygon: the outline has 2 corners, but needs at least 3");
  CHECK(refusal(square, {square, {{0, 0, 0}}}) == "polygon: hole 1 has 1 corners, but needs at least 3");
  CHECK(refusal({{0, 0, 0}, {1, 0, 0}, {kNoNumber, 1, 0}}) == "polygon: corner 2 of the outline is not finite");
  CHECK(refusal({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}) == "polygon: the outline has no area");
  CHECK(refusal({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}).find("corner 0 of the outline") == std::string::npos);
  CHECK(refusal({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}).find("away from the plane") != std::string::npos);
  CHECK(refusal(square, {{{0.2, 0.2, 0}, {0.4, 0.2, 0}, {0.4, 0.4, 0.1}}}) == "polygon: corner 2 of hole 0 is 0.100000 away from the plane of the outline");
}

TEST_CASE("shapes: polyhedra and quadrics that are none are refused", "[ray_tracer][C42]") {
  const auto polyhedron = [](const std::vector<glm::dvec4>& planes) {
    const auto shape = Polyhedron::create(planes);
    return shape ? std::string() : shape.error().message;
  };
  const std::vector<glm::dvec4> tetrahedron{{1, 1, 1, -1}, {-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}};
  CHECK(polyhedron(tetrahedron).empty());
  CHECK((*Polyhedron::create(tetrahedron))->bounds().size() == glm::dvec3(1));
  CHECK(polyhedron({}) == "polyhedron: its 0 planes enclose nothing");
  CHECK(polyhedron({{1, 1, 1, -1}, {0, 0, 0, 1}}) == "polyhedron: plane 1 has no direction, or a number that is not finite");
  CHECK(polyhedron({{1, 1, 1, kNoNumber}}) == "polyhedron: plane 0 has no direction, or a number that is not finite");
  CHECK(polyhedron({{1, 1, 1, 1}, {-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}}) == "polyhedron: its 4 planes enclose nothing");
  CHECK(polyhedron({{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}}) == "polyhedron: its 3 planes leave it without an end");
  CHECK(polyhedron(std::vector<glm::dvec4>(300, glm::dvec4(1, 0, 0, 0))) == "polyhedron: 300 planes, but at most 256 are possible");

  const auto quadric = [](const glm::dmat4& q, double lower = -1) {
    const auto shape = Quadric::create(q, glm::dvec3(lower), glm::dvec3(1));
    return shape ? std::string() : shape.error().message;
  };
  glm::dmat4 q(1);
  CHECK(quadric(q).empty());
  CHECK(quadric(q, 2) == "quadric: the box's lower corner is not below its upper one");
  CHECK(quadric(q, kNoNumber) == "quadric: the box's lower corner is not below its upper one");
  CHECK(quadric(glm::dmat4(0)) == "quadric: the matrix is 0");
  q[1][0] = 0.5;
  CHECK(quadric(q).find("is not symmetric: row 0, column 1 is 0.5") != std::string::npos);
  q[1][0] = kNoNumber;
  CHECK(quadric(q) == "quadric: row 0, column 1 is not finite");

  glm::dmat4 bowl(0);
  bowl[0][0] = bowl[2][2] = 1, bowl[1][3] = bowl[3][1] = -0.5;
  CHECK((*Quadric::create(bowl, glm::dvec3(-1), glm::dvec3(1)))->is_convex());
  CHECK(!(*Quadric::create(-bowl, glm::dvec3(-1), glm::dvec3(1)))->is_convex());
  bowl[1][1] = -1;
  CHECK(!(*Quadric::create(bowl, glm::dvec3(-1), glm::dvec3(1)))->is_convex());
}

}  // namespace tuberia::tracer::shapes_test
