#pragma once
// Each shape beside a function of space that is 0 on it: a ray is walked in small steps, and where the sign changes, halved.

#include <algorithm>
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

using Field = std::function<double(const glm::dvec3&)>;

/// At a size s: the shape, what is 0 on its surface and positive outside, and how far inside the surface's limits a point of it is.
struct Witness {
  std::string name;
  std::function<std::shared_ptr<const Shape>(double s)> shape;
  std::function<double(const glm::dvec3& p)> field;  // at the size 1
  std::function<double(const glm::dvec3& p)> margin = [](const glm::dvec3&) { return 1.0; };
};

inline double across(const glm::dvec3& p) { return std::hypot(p.x, p.z); }
inline double box_field(const glm::dvec3& p, const glm::dvec3& half) { return std::max({std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z}); }
inline double torus_field(const glm::dvec3& p, double ring, double tube) { return std::hypot(across(p) - ring, p.y) - tube; }

inline glm::dmat4 diagonal(double x, double y, double z, double w) {
  glm::dmat4 m(0);
  m[0][0] = x, m[1][1] = y, m[2][2] = z, m[3][3] = w;
  return m;
}

inline std::shared_ptr<const Shape> quadric_of(glm::dmat4 q, double s, const glm::dvec3& half) {
  // p'Qp of p / s.
  for (int i = 0; i < 3; ++i) q[3][i] *= s, q[i][3] *= s;
  q[3][3] *= s * s;
  return *Quadric::create(q, -s * half, s * half);
}

inline Field quadric_field(const glm::dmat4& q) {
  return [q](const glm::dvec3& p) { return glm::dot(glm::dvec4(p, 1), q * glm::dvec4(p, 1)); };
}

inline const std::vector<glm::dvec3> kArrow{{-1, 0, 0}, {0, 0.2, -1}, {1, 0, 0}, {0.3, 0, 0}, {0.3, -0.2, 1}, {-0.3, -0.2, 1}, {-0.3, 0, 0}};

/// A concave outline in the plane y = -0.2 z, with a square hole, by the sums of angles.
inline double arrow_margin(const glm::dvec3& p) {
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

inline std::vector<glm::dvec4> octahedron(double s) {
  std::vector<glm::dvec4> planes;
  for (int i = 0; i < 8; ++i) planes.emplace_back(i & 1 ? 2 : -2, i & 2 ? 2 : -2, i & 4 ? 2 : -2, -2 * s);  // |x| + |y| + |z| = s
  planes.emplace_back(0, 1, 0, -0.5 * s);
  return planes;
}

inline std::vector<Witness> witnesses() {
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

inline Walk walk(const Witness& witness, const Ray& ray, double length) {
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

/// At the size 1: from around the shape or within it, most in any direction, some along axes or in planes of them, where coefficients vanish.
inline Ray some_ray(Random& random, int number) {
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

}  // namespace tuberia::tracer::shapes_test
