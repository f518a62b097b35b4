// Bezier patches, and the teapot made of them.

#include "scene/shapes/teapot.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "scene/bounds.hpp"
#include "tests/scene/mesh_measures.hpp"

namespace tuberia {
namespace {

/// The flat unit square, control points a third apart: (s, t) lies at (s, -t).
BezierPatch flat_patch() {
  BezierPatch patch;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      patch.points[static_cast<std::size_t>(4 * row + column)] = {column / 3.0, -row / 3.0, 0};
  return patch;
}

/// How many closed loops some edges make.
int loops(const std::vector<test::Edge>& edges) {
  std::map<glm::vec3, glm::vec3, test::LessByPosition> next;
  for (const test::Edge& edge : edges) next[edge[0]] = edge[1];
  int count = 0;
  while (!next.empty()) {
    ++count;
    for (auto at = next.begin(); at != next.end();) {
      const glm::vec3 to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return count;
}

}  // namespace

TEST_CASE("bezier: a patch of evenly spaced points is the plane", "[B36]") {
  const SurfacePoint point = evaluate(flat_patch(), 0.25, 0.75);
  CHECK(glm::distance(point.position, glm::dvec3(0.25, -0.75, 0)) < 1e-15);
  CHECK(glm::distance(point.tangent, glm::dvec3(1, 0, 0)) < 1e-14);
  CHECK(glm::distance(point.bitangent, glm::dvec3(0, -1, 0)) < 1e-14);
  CHECK(glm::distance(point.normal, glm::dvec3(0, 0, 1)) < 1e-15);
  CHECK(point.texcoord == glm::dvec2(0.25, 0.75));

  BezierPatch half = flat_patch();
  half.texcoord_from = {0.5, 0};
  CHECK(glm::distance(evaluate(half, 0.5, 0.5).tangent, glm::dvec3(2, 0, 0)) < 1e-14);  // half the image over the same length
  CHECK(evaluate(half, 0.5, 0.5).texcoord == glm::dvec2(0.75, 0.5));
}

TEST_CASE("bezier: derivatives are those of the surface, on every patch of the teapot", "[B36]") {
  constexpr double kStep = 1e-5;
  for (const BezierPatch& patch : teapot_patches())
    for (const double s : {0.1, 0.5, 0.83})
      for (const double t : {0.2, 0.5, 0.9}) {
        const SurfacePoint at = evaluate(patch, s, t);
        const glm::dvec2 size = patch.texcoord_to - patch.texcoord_from;
        const glm::dvec3 du = (evaluate(patch, s + kStep, t).position - evaluate(patch, s - kStep, t).position) / (2 * kStep * size.x);
        const glm::dvec3 dv = (evaluate(patch, s, t + kStep).position - evaluate(patch, s, t - kStep).position) / (2 * kStep * size.y);
        CHECK(glm::distance(at.tangent, du) < 1e-7);
        CHECK(glm::distance(at.bitangent, dv) < 1e-7);
        CHECK(std::abs(glm::dot(at.normal, at.tangent)) < 1e-12);
        CHECK(std::abs(glm::dot(at.normal, at.bitangent)) < 1e-12);
      }
}

TEST_CASE("bezier: an edge drawn together to a point has the limit of the normals", "[B36]") {
  const std::vector<BezierPatch> patches = teapot_patches();
  for (std::size_t quarter = 0; quarter < 4; ++quarter)
    for (const double s : {0.0, 0.3, 1.0}) {
      CHECK(glm::distance(evaluate(patches[quarter], s, 0).normal, glm::dvec3(0, 1, 0)) < 1e-14);        // the knob's top
      CHECK(glm::distance(evaluate(patches[20 + quarter], s, 1).normal, glm::dvec3(0, -1, 0)) < 1e-14);  // the middle of the bottom
    }

  BezierPatch pinched = flat_patch();  // two rows in one point: both derivatives vanish there
  for (std::size_t i = 0; i < 8; ++i) pinched.points[i] = {0.5, 0, 0};
  CHECK(glm::distance(evaluate(pinched, 0.5, 0).normal, glm::dvec3(0, 0, 1)) < 1e-9);
  BezierPatch left = flat_patch();  // the left edge in one point
  for (std::size_t row = 0; row < 4; ++row) left.points[4 * row] = {0, -0.5, 0};
  CHECK(glm::distance(evaluate(left, 0, 0.5).normal, glm::dvec3(0, 0, 1)) < 1e-12);
  CHECK(evaluate(BezierPatch{}, 0.3, 0.3).normal == glm::dvec3(0, 1, 0));  // no area at all
}

TEST_CASE("teapot: control points are the published ones", "[B36]") {
  // As printed with z up and y away: (x, y, z) there is (x, z, -y) here.
  const auto patches = teapot_patches();
  REQUIRE(patches.size() == 32);
  std::set<std::array<int, 3>> ours;  // in 1/100000, the finest digit of the published numbers
  for (const BezierPatch& patch : patches)
    for (const glm::dvec3& point : patch.points) {
      const auto digits = [](double value) { return static_cast<int>(std::lround(value * 100000)); };
      ours.insert({digits(point.x), digits(-point.z), digits(point.y)});
    }
  const std::array<double, 3> published[] = {
      {0, 0, 3.15}, {0.8, -0.45, 3.15}, {-0.45, 0.8, 3.15}, {0, 0, 2.85}, {0.112, -0.2, 2.7}, {0.4, -0.224, 2.55},
      {-1.3, 0.728, 2.55}, {0.728, -1.3, 2.4}, {1.4, -0.784, 2.4}, {1.3375, 0.749, 2.53125}, {-0.805, 1.4375, 2.53125},
      {1.5, -0.84, 2.4}, {1.75, -0.98, 1.875}, {2, 1.12, 1.35}, {-1.12, -2, 0.9}, {2, -1.12, 0.45}, {0.84, 1.5, 0.225},
      {1.5, -0.84, 0.15}, {0.84, -1.5, 0.075}, {1.425, -0.798, 0}, {0, 0, 0}, {-1.6, -0.3, 2.025}, {-2.5, 0.3, 2.25},
      {-3, -0.3, 2.25}, {-2.7, 0.3, 1.575}, {-3, 0, 1.35}, {-2.65, -0.3, 0.9375}, {-2, 0, 0.9}, {-1.9, 0.3, 0.6},
      {1.7, -0.66, 1.425}, {3.1, 0.66, 0.825}, {2.4, 0, 2.025}, {3.3, -0.25, 2.4}, {3.525, 0.25, 2.49375},
      {3.45, -0.15, 2.5125}, {2.9, 0, 2.475}, {3.2, 0.15, 2.4}};
  for (const auto& [x, y, z] : published) {
    CAPTURE(x, y, z);
    CHECK(ours.count({static_cast<int>(std::lround(x * 100000)), static_cast<int>(std::lround(y * 100000)),
                      static_cast<int>(std::lround(z * 100000))}) == 1);
  }
  // 17 rings of 12 and 3 points on the axis; 7 rows of 6 for the handle and as many for the spout, of which one point is
  // the body's, too: (-2, 0, 0.9), where the handle's lower end touches it.
  CHECK(ours.size() == 17 * 12 + 3 + 2 * 7 * 6 - 1);
}

TEST_CASE("teapot: it is symmetric, fills its box and is open where the original is", "[B36]") {
  for (const int segments : {2, 3, 8}) {
    CAPTURE(segments);
    const Mesh teapot = *teapot_mesh({.segments = segments});
    CHECK(teapot.triangle_count() == 2 * 32 * segments * segments - 8 * segments);  // 8 patches have a pole

    std::set<glm::vec3, test::LessByPosition> positions(teapot.positions.begin(), teapot.positions.end());
    for (const glm::vec3& p : positions) CHECK(positions.count({p.x, p.y, 0.0f - p.z}) == 1);

    // Open: the body's rim, the lid's, the tip of the spout, and both ends of the handle and the other end of the spout.
    const auto border = test::border_edges(teapot);
    CHECK(border.size() == static_cast<std::size_t>(2 * 4 * segments + 4 * 2 * segments));
    CHECK(loops(border) == 6);
    const Mesh without = *teapot_mesh({.segments = segments, .bottom = false, .lid = false});
    CHECK(loops(test::border_edges(without)) == 6);  // the bottom's rim instead of the lid's
  }

  const Bounds box = bounds(*teapot_mesh({.segments = 32}));
  CHECK(box.lower == glm::vec3(-3, 0, -2));
  CHECK(box.upper.y == 3.15f);
  CHECK(box.upper.z == 2);
  // The tip of the spout is where the outer curve 3.3, 3.525, 3.45, 3.2 reaches furthest: 3.434, by the root of its derivative.
  const double a = 3.2 - 3 * 3.45 + 3 * 3.525 - 3.3, b = 3 * (3.45 - 2 * 3.525 + 3.3), c = 3 * (3.525 - 3.3);
  const double t = (-b - std::sqrt(b * b - 3 * a * c)) / (3 * a);
  CHECK(box.upper.x == Approx(((a * t + b) * t + c) * t + 3.3).margin(1e-3));
}

}  // namespace tuberia
