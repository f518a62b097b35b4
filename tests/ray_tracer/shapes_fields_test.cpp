// Each shape against a function of space that is 0 on it.
#include <catch2/catch.hpp>

#include "tests/ray_tracer/shapes_witnesses.hpp"

namespace tuberia::tracer::shapes_test {
namespace {

/// A shape may find what the walk stepped over: then the field has to change its sign there, or to have its turning point.
bool is_on(const Witness& witness, const Ray& ray, double t, double near) {
  const double before = witness.field(ray.at(t - near)), after = witness.field(ray.at(t + near));
  return (before < 0) != (after < 0) && witness.margin(ray.at(t)) > -1e-9;
}

void compare(const Witness& witness, double scale, int rays) {
  const std::shared_ptr<const Shape> shape = witness.shape(scale);
  Random random(42);
  int met = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = some_ray(random, i);
    // As the shape sees it: larger, and with a direction of some other length.
    const double stretch = uniform(random, 0.1, 10);
    const std::optional<ShapeHit> hit = shape->intersect({.origin = scale * ray.origin, .direction = stretch * ray.direction});
    const double t = hit ? hit->t * stretch / scale : kInfinity;
    const Walk expected = walk(witness, ray, 9);
    if (expected.is_doubtful || t > 9) continue;
    if (expected.t && std::abs(t - *expected.t) < 1e-9) {
      ++met;
      continue;
    }
    INFO("ray " << i << " from " << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << ", t " << t << ", walked " << expected.t.value_or(-1));
    // Only what lies before the walk's find, in a gap between two of its steps, may differ from it.
    CHECK((!hit && !expected.t ? true : hit && t < expected.t.value_or(9) && is_on(witness, ray, t, 1e-7)));
  }
  CHECK(met > rays / 30);
}

}  // namespace

TEST_CASE("shapes: rays meet every shape where its function is 0", "[ray_tracer][A42][C42][B61]") {
  for (const Witness& witness : witnesses())
    for (const double scale : kScales) {
      INFO(witness.name << " at the scale " << scale);
      compare(witness, scale, 4000);
    }
}

TEST_CASE("shapes: points of every shape are on it, in its box, with the function's normal", "[ray_tracer][A42][C42]") {
  for (const Witness& witness : witnesses())
    for (const double scale : kScales) {
      INFO(witness.name << " at the scale " << scale);
      const std::shared_ptr<const Shape> shape = witness.shape(scale);
      const Box box = shape->bounds();
      Random random(43);
      for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 eye = in_box(random, 3 * scale);
        const Ray ray{.origin = eye, .direction = glm::normalize(in_box(random, 0.9 * scale) - eye)};
        const std::optional<ShapeHit> hit = shape->intersect(ray);
        if (!hit) continue;
        const SurfacePoint point = shape->surface(ray, *hit);
        const glm::dvec3 at = point.position / scale;
        CHECK(std::abs(witness.field(at)) < 1e-14);
        CHECK(point.magnitude >= 0.3 * glm::length(point.position));
        CHECK(glm::length(point.position - ray.at(hit->t)) < 1e-11 * scale);
        for (int axis = 0; axis < 3; ++axis) {
          CHECK(point.position[axis] >= box.lower[axis] - 1e-12 * scale);
          CHECK(point.position[axis] <= box.upper[axis] + 1e-12 * scale);
        }
        // The function's slopes. At edges and tips of solids it has none.
        glm::dvec3 slope(0);
        const double step = 1e-6;
        for (int axis = 0; axis < 3; ++axis) {
          glm::dvec3 e(0);
          e[axis] = step;
          slope[axis] = (witness.field(at + e) - witness.field(at - e)) / (2 * step);
        }
        CHECK(glm::length(point.normal) == Approx(1).epsilon(1e-14));
        CHECK(point.normal == point.geometric_normal);
        const double near_edge = std::abs(witness.field(at + 1e-4 * point.normal) / 1e-4 - glm::length(slope));
        if (near_edge < 1e-3 && glm::length(slope) > 0.05) CHECK(glm::length(glm::normalize(slope) - point.normal) < 1e-4);
      }
    }
}

}  // namespace tuberia::tracer::shapes_test
