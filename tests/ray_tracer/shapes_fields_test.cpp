// Each shape against a function of space that is 0 on it: the ray is walked in small steps, and where the sign changes, halved.
#include <catch2/catch.hpp>

#include <functional>
#include <optional>
#include <string>

#include "reference/ray_tracer/shapes/cuboid.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/polygon.hpp"
#include "reference/ray_tracer/shapes/polyhedron.hpp"
#include "reference/ray_tracer/shapes/quadric.hpp"
#include "reference/ray_tracer/shapes/round_shapes.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"
#include "reference/ray_tracer/shapes/torus.hpp"
#include "tests/ray_tracer/shapes_support.hpp"

namespace tuberia::tracer::shapes_test {
namespace {

using Field = std::function<double(const glm::dvec3&)>;

/// At a size s: the shape, what is 0 on its surface and positive outside, and how far inside the surface's limits a point of it is.
struct Witness {
  std::string name;
  std::function<std::shared_ptr<const Shape>(double s)> shape;
  std::function<double(const glm::dvec3& p)> field;  // at the size 1
  std::function<double(const glm::dvec3& p)> margin = [](const glm::dvec3&) { return 1.0; };
};

double across(const glm::dvec3& p) { return std::hypot(p.x, p.z); }
double box_field(const glm::dvec3& p, const glm::dvec3& half) { return std::max({std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z}); }
double torus_field(const glm::dvec3& p, double ring, double tube) { return std::hypot(across(p) - ring, p.y) - tube; }

glm::dmat4 diagonal(double x, double y, double z, double w) {
  glm::dmat4 m(0);
  m[0][0] = x, m[1][1] = y, m[2][2] = z, m[3][3] = w;
  return m;
}

std::shared_ptr<const Shape> quadric_of(glm::dmat4 q, double s, const glm::dvec3& half) {
  // p'Qp of p / s.
  for (int i = 0; i < 3; ++i) q[3][i] *= s, q[i][3] *= s;
  q[3][3] *= s * s;
  return *Quadric::create(q, -s * half, s * half);
}

Field quadric_field(const glm::dmat4& q) {
  return [q](const glm::dvec3& p) { return glm::dot(glm::dvec4(p, 1), q * glm::dvec4(p, 1)); };
}

const std::vector<glm::dvec3> kArrow{{-1, 0, 0}, {0, 0.2, -1}, {1, 0, 0}, {0.3, 0, 0}, {0.3, -0.2, 1}, {-0.3, -0.2, 1}, {-0.3, 0, 0}};

/// A concave outline in the plane y = -0.2 z, with a square hole, by the sums of angles.
double arrow_margin(const glm::dvec3& p) {
  const std::vector<glm::dvec2> outline{{-1, 0}, {0, -1}, {1, 0}, {0.3, 0}, {0.3, 1}, {-0.3, 1}, {-0.3, 0}};
  double angle = 0, nearest = kInfinity;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i] - glm::dvec2(p.x, p.z), b = outline[(i + 1) % outline.size()] - glm::dvec2(p.x, p.z);
    angle += std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
    const glm::dvec2 edge = b - a;
    nearest = std::min(nearest, glm::length(a + std::clamp(-glm::dot(a, edge) / glm::dot(edge, edge), 0.0, 1.0) * edge));
  }
  const double hole = std::max(std::abs(p.x), std::abs(p.z + 0.4)) - 0.15;
  return std::min(std::abs(angle) > 3 ? nearest : -nearest, hole);
}

std::vector<glm::dvec4> octahedron(double s) {
  std::vector<glm::dvec4> planes;
  for (int i = 0; i < 8; ++i) planes.emplace_back(i & 1 ? 2 : -2, i & 2 ? 2 : -2, i & 4 ? 2 : -2, -2 * s);  // |x| + |y| + |z| = s
  planes.emplace_back(0, 1, 0, -0.5 * s);
  return planes;
}

std::vector<Witness> witnesses() {
  const glm::dvec3 half(1, 0.5, 0.7);
  glm::dmat4 tilted = diagonal(1, 2, 3, -1);
  tilted[0][1] = tilted[1][0] = 0.5, tilted[3][2] = tilted[2][3] = 0.3;
  return {
      {"sphere", [](double s) { return std::make_shared<Sphere>(s); }, [](const glm::dvec3& p) { return glm::length(p) - 1; }},
      {"infinite plane", [](double) { return std::make_shared<InfinitePlane>(); }, [](const glm::dvec3& p) { return p.y; }},
      {"rectangle", [](double s) { return std::make_shared<Rectangle>(2 * s, 1.2 * s); }, [](const glm::dvec3& p) { return p.y; },
       [](const glm::dvec3& p) { return std::min(1 - std::abs(p.x), 0.6 - std::abs(p.z)); }},
      {"disc", [](double s) { return std::make_shared<Disc>(s); }, [](const glm::dvec3& p) { return p.y; }, [](const glm::dvec3& p) { return 1 - across(p); }},
      {"cuboid", [half](double s) { return std::make_shared<Cuboid>(2 * s * half); }, [half](const glm::dvec3& p) { return box_field(p, half); }},
      {"cylinder", [](double s) { return std::make_shared<Cylinder>(s, 1.5 * s); }, [](const glm::dvec3& p) { return std::max(across(p) - 1, std::abs(p.y) - 0.75); }},
      {"tube", [](double s) { return std::make_shared<Cylinder>(s, 1.5 * s, false); }, [](const glm::dvec3& p) { return across(p) - 1; },
       [](const glm::dvec3& p) { return 0.75 - std::abs(p.y); }},
      {"cone", [](double s) { return std::make_shared<Cone>(s, 1.5 * s); },
       [](const glm::dvec3& p) { return std::max(across(p) - (0.75 - p.y) / 1.5, -0.75 - p.y); }},
      {"open cone", [](double s) { return std::make_shared<Cone>(s, 1.5 * s, false); }, [](const glm::dvec3& p) { return across(p) - (0.75 - p.y) / 1.5; },
       [](const glm::dvec3& p) { return 0.75 + p.y; }},
      {"torus", [](double s) { return std::make_shared<Torus>(0.7 * s, 0.3 * s); }, [](const glm::dvec3& p) { return torus_field(p, 0.7, 0.3); }},
      {"thin torus", [](double s) { return std::make_shared<Torus>(0.98 * s, 0.02 * s); }, [](const glm::dvec3& p) { return torus_field(p, 0.98, 0.02); }},
      {"ellipsoid", [tilted](double s) { return quadric_of(tilted, s, glm::dvec3(2)); }, quadric_field(tilted)},
      {"hyperboloid", [](double s) { return quadric_of(diagonal(4, -2, 4, -1), s, glm::dvec3(1, 0.8, 1)); }, quadric_field(diagonal(4, -2, 4, -1)),
       [](const glm::dvec3& p) { return -box_field(p, {1, 0.8, 1}); }},
      {"double cone", [](double s) { return quadric_of(diagonal(1, -1, 1, 0), s, glm::dvec3(2, 0.8, 2)); }, quadric_field(diagonal(1, -1, 1, 0)),
       [](const glm::dvec3& p) { return 0.8 - std::abs(p.y); }},
      {"polyhedron", [](double s) { return *Polyhedron::create(octahedron(s)); },
       [](const glm::dvec3& p) { return std::max(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) - 1, p.y - 0.5); }},
      {"polygon",
       [](double s) {
         std::vector<glm::dvec3> outline = kArrow, hole{{0.15, 0.05, -0.25}, {0.15, 0.11, -0.55}, {-0.15, 0.11, -0.55}, {-0.15, 0.05, -0.25}};
         for (auto* ring : {&outline, &hole})
           for (glm::dvec3& corner : *ring) corner = s * glm::dvec3(corner.x, -0.2 * corner.z, corner.z);
         return *Polygon::create(outline, std::vector<std::vector<glm::dvec3>>{hole});
       },
       [](const glm::dvec3& p) { return p.y + 0.2 * p.z; }, arrow_margin},
  };
}

/// Where the ray first meets the surface; doubtful: rounding decides, because the ray nearly touches a limit or the surface.
struct Walk {
  std::optional<double> t;
  bool is_doubtful = false;
};

Walk walk(const Witness& witness, const Ray& ray, double length) {
  constexpr int kSteps = 400;
  double from = 0, value_from = witness.field(ray.at(0));
  for (int i = 1; i <= kSteps; ++i) {
    const double to = length * i / kSteps, value_to = witness.field(ray.at(to));
    if ((value_from < 0) != (value_to < 0)) {
      double low = from, high = to;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        ((witness.field(ray.at(middle)) < 0) == (value_from < 0) ? low : high) = middle;
      }
      const double margin = witness.margin(ray.at(high));
      if (std::abs(margin) < 1e-9) return {.t = std::nullopt, .is_doubtful = true};
      if (margin > 0) return {.t = high};
    }
    from = to;
    value_from = value_to;
  }
  return {};
}

/// A shape may find what the walk stepped over: then the field has to change its sign there, or to have its turning point.
bool is_on(const Witness& witness, const Ray& ray, double t, double near) {
  const double before = witness.field(ray.at(t - near)), after = witness.field(ray.at(t + near));
  return (before < 0) != (after < 0) && witness.margin(ray.at(t)) > -1e-9;
}

/// At the size 1: from around the shape or within it, most in any direction, some along axes or in planes of them, where coefficients vanish.
Ray some_ray(Random& random, int number) {
  Ray ray{.origin = in_box(random, number % 3 == 0 ? 0.9 : 3), .direction = glm::dvec3(0)};
  const glm::dvec3 target = in_box(random, 0.9);
  if (number % 7 == 0) ray.origin[random.below(3) == 0 ? 1 : 0] = target[0];
  if (number % 11 == 0) {
    const glm::dvec3 kept = ray.origin;
    const auto axis = static_cast<int>(random.below(3));
    ray.origin = target;
    ray.origin[axis] = kept[axis];
  }
  ray.direction = glm::normalize(target - ray.origin);
  return ray;
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

TEST_CASE("shapes: what is far away is met as exactly as its distance can be told", "[ray_tracer][A42][Y4]") {
  for (const Witness& witness : witnesses()) {
    INFO(witness.name);
    const std::shared_ptr<const Shape> shape = witness.shape(1);
    Random random(44);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
      const Ray near_by = some_ray(random, 3 * i + 1);
      const double distance = std::pow(10, uniform(random, 1, 6));
      const Ray far_away{.origin = near_by.origin - distance * near_by.direction, .direction = near_by.direction};
      const Walk expected = walk(witness, near_by, 9);
      const std::optional<ShapeHit> hit = shape->intersect(far_away), before = shape->intersect(near_by);
      // What lies behind the near ray is before the far one, and what touches may be met by one of them only.
      if (!expected.t || !hit || !before || hit->t < distance) continue;
      const double slope = std::abs(witness.field(near_by.at(*expected.t + 1e-6)) - witness.field(near_by.at(*expected.t - 1e-6))) / 2e-6;
      if (slope < 0.05) continue;
      CHECK(std::abs(hit->t - distance - before->t) < 1e-13 * distance / slope);
      CHECK(std::abs(witness.field(shape->surface(far_away, *hit).position)) < 1e-14);
      ++met;
    }
    CHECK(met > 60);
  }
}

TEST_CASE("shapes: from inside a solid every ray meets it, at edges, rims and tips, too", "[ray_tracer][Y1][C42]") {
  Random random(45);
  for (const double scale : kScales) {
    const std::vector<std::shared_ptr<const Shape>> solids{std::make_shared<Cuboid>(glm::dvec3(2 * scale)), std::make_shared<Cylinder>(scale, 2 * scale),
                                                           std::make_shared<Cone>(scale, 2 * scale), *Polyhedron::create(octahedron(scale))};
    for (std::size_t number = 0; number < solids.size(); ++number)
      for (int i = 0; i < 20000; ++i) {
        // Corners and edges of the cube, rims of the others, tips, and points of the octahedron's edges.
        const double angle = uniform(random, 0, 7), along = uniform(random, -1, 1);
        const glm::dvec3 rim(std::cos(angle), i % 2 == 0 ? -1 : 1, std::sin(angle)), tip(0, 1, 0), edge(along, i % 2 == 0 ? 1 : -1, i % 4 == 0 ? 1 : -1);
        const glm::dvec3 ridge(1 - std::abs(along), 0, along);
        const glm::dvec3 target = number == 0 ? edge : number == 1 ? rim : number == 2 ? (i % 2 == 0 ? rim : tip) : ridge;
        const glm::dvec3 eye = scale * (in_box(random, 0.15) - glm::dvec3(0, 0.2, 0));
        const Ray ray{.origin = eye, .direction = scale * target - eye};
        INFO("solid " << number << " at the scale " << scale << ", ray " << i);
        const std::optional<ShapeHit> hit = solids[number]->intersect(ray);
        REQUIRE(hit);
        CHECK(hit->t == Approx(1).epsilon(1e-12));
      }
  }
}

TEST_CASE("shapes: the tip of a cone has no hole", "[ray_tracer][A42]") {
  // From above, steeper than the side, through the tip and past it by anything down to nothing.
  for (const double scale : kScales) {
    const Cone cone(scale, 2 * scale);
    Random random(46);
    for (int i = 0; i < 20000; ++i) {
      const double angle = uniform(random, 0, 7), past = i % 10 == 0 ? 0 : std::pow(10, -uniform(random, 3, 17)), lean = uniform(random, 0, 0.2);
      const glm::dvec3 target = scale * glm::dvec3(past * std::cos(angle), 1, past * std::sin(angle));
      const glm::dvec3 eye = target + scale * glm::dvec3(lean * uniform(random, -1, 1), 1, lean * uniform(random, -1, 1));
      const std::optional<ShapeHit> hit = cone.intersect({.origin = eye, .direction = target - eye});
      REQUIRE(hit);
      CHECK(hit->face == 0);
      CHECK(std::abs(hit->t - 1) < 5 * past + 1e-14);
    }
  }
}

TEST_CASE("shapes: sizes that are none and rays that are none meet nothing", "[ray_tracer][A42][case-65]") {
  const double nan = NAN;
  const std::vector<std::shared_ptr<const Shape>> empty{
      std::make_shared<Rectangle>(0, 1), std::make_shared<Rectangle>(1, nan), std::make_shared<Disc>(0), std::make_shared<Disc>(-1),
      std::make_shared<Cuboid>(glm::dvec3(1, 0, 1)), std::make_shared<Cuboid>(glm::dvec3(1, nan, 1)), std::make_shared<Cylinder>(0, 1),
      std::make_shared<Cylinder>(1, -1), std::make_shared<Cone>(1, nan), std::make_shared<Cone>(0, 1, false), std::make_shared<Torus>(1, 0),
      std::make_shared<Torus>(1, 2), std::make_shared<Torus>(nan, 0.1)};
  Random random(65);
  for (const std::shared_ptr<const Shape>& shape : empty)
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 eye = in_box(random, 3);
      CHECK(!shape->intersect({.origin = eye, .direction = in_box(random, 0.5) - eye}));
    }

  for (const Witness& witness : witnesses()) {
    INFO(witness.name);
    Geometry geometry;
    geometry.add_shape(witness.shape(1), glm::dmat4(1), 0);
    geometry.add_shape(witness.shape(1), glm::dmat4(0), 0);     // flattened to a point
    geometry.add_shape(witness.shape(1), glm::dmat4(nan), 0);
    CHECK(geometry.bounds(1).empty());
    CHECK(geometry.bounds(2).empty());
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 eye = in_box(random, 3), towards = in_box(random, 0.5) - eye;
      CHECK(nearest_hit(geometry, {.origin = eye, .direction = towards}).item <= 0);
      CHECK(!nearest_hit(geometry, {.origin = eye, .direction = glm::dvec3(0)}));
      CHECK(!nearest_hit(geometry, {.origin = eye, .direction = {nan, towards.y, towards.z}}));
      CHECK(!nearest_hit(geometry, {.origin = {eye.x, kInfinity, eye.z}, .direction = towards}));
      CHECK(!nearest_hit(geometry, {.origin = eye, .direction = towards, .t_min = 2, .t_max = 1}));
    }
  }
}

}  // namespace tuberia::tracer::shapes_test
