#include <catch2/catch.hpp>

#include "reference/ray_tracer/shapes/ball_crossing.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"
#include "tests/ray_tracer/shapes_support.hpp"

namespace tuberia::tracer::shapes_test {
namespace {

std::optional<ShapeHit> meet(const Sphere& sphere, const glm::dvec3& origin, const glm::dvec3& direction) {
  return sphere.intersect({.origin = origin, .direction = direction});
}

BallCrossing<double> roots(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& centre, double radius) {
  const glm::dvec3 to_centre = centre - origin;
  return cross_ball<double, 3>({to_centre.x, to_centre.y, to_centre.z}, {direction.x, direction.y, direction.z}, radius, false);
}

/// A number that counts what is done with it.
struct Counted {
  double value = 0;
  static inline int multiplications = 0, additions = 0, divisions = 0, roots = 0;
  Counted() = default;
  explicit Counted(double v) : value(v) {}
  static void reset() { multiplications = additions = divisions = roots = 0; }
  friend Counted operator*(Counted a, Counted b) { return ++multiplications, Counted(a.value * b.value); }
  friend Counted operator+(Counted a, Counted b) { return ++additions, Counted(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return ++additions, Counted(a.value - b.value); }
  friend Counted operator/(Counted a, Counted b) { return ++divisions, Counted(a.value / b.value); }
  friend Counted sqrt(Counted a) { return ++roots, Counted(std::sqrt(a.value)); }
  auto operator<=>(const Counted&) const = default;
};

BallMeeting counted(const glm::dvec3& to_centre, const glm::dvec3& direction, double radius) {
  Counted::reset();
  const auto components = [](const glm::dvec3& v) { return std::array<Counted, 3>{Counted(v.x), Counted(v.y), Counted(v.z)}; };
  return cross_ball<Counted, 3>(components(to_centre), components(direction), Counted(radius), true).meeting;
}

}  // namespace

TEST_CASE("shapes: a ray's point is O + t D", "[ray_tracer][B51]") {
  const Ray ray{.origin = {1, 2, 3}, .direction = {0.6, 0, -0.8}};
  CHECK(ray.at(0) == glm::dvec3(1, 2, 3));
  CHECK(glm::length(ray.at(5) - glm::dvec3(4, 2, -1)) < 1e-15 * 8);
  CHECK(glm::length(ray.at(5) - ray.origin) == Approx(5).epsilon(1e-15));  // D is unit: t is the distance
}

TEST_CASE("shapes: spheres as the notes meet them", "[ray_tracer][B60]") {
  const Sphere unit;
  CHECK(meet(unit, {0, 0, 5}, {0, 0, -1})->t == 4);
  CHECK(roots({0, 0, 5}, {0, 0, -1}, {0, 0, 0}, 1).second == 6);
  CHECK(meet(unit, {0, 0, 0}, {0, 0, -1})->t == 1);
  CHECK(!meet(unit, {0, 0, 1}, {0, 0, 1}));         // on the sphere, outwards
  CHECK(meet(unit, {0, 0, 1}, {0, 0, -1})->t == 2);  // and inwards
  CHECK(!meet(unit, {0, 2, 5}, {0, 0, -1}));        // gamma = -3
  CHECK(!meet(unit, {0, 1, 5}, {0, 0, -1}));        // gamma = 0
  CHECK(!meet(unit, {0, 0, 5}, {0, 0, 1}));         // looks away
  CHECK(meet(Sphere(2, {1, 0, 0}), {1, 0, 9}, {0, 0, -2})->t == 3.5);  // t counts in the direction's length

  // The limits only accept or refuse.
  CHECK(unit.intersect({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .t_min = 4})->t == 6);
  CHECK(!unit.intersect({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .t_min = 0, .t_max = 4}));
  CHECK(unit.intersect({.origin = {0, 0, 5}, .direction = {0, 0, 1}, .t_min = -7})->t == -6);
}

TEST_CASE("shapes: what a sphere costs", "[ray_tracer][B60]") {
  // T = C - O costs three subtractions before.
  CHECK(counted({0, 0, 5}, {0, 0, -1}, 1) == BallMeeting::behind);
  CHECK(Counted::multiplications == 7);
  CHECK(Counted::additions == 4);
  CHECK(Counted::divisions + Counted::roots == 0);

  CHECK(counted({0, 2, -5}, {0, 0, -1}, 1) == BallMeeting::beside);
  CHECK(Counted::multiplications == 16);
  CHECK(Counted::additions == 12);
  CHECK(Counted::divisions == 1);
  CHECK(Counted::roots == 0);

  CHECK(counted({0, 0.5, -5}, {0, 0, -1}, 1) == BallMeeting::crossing);
  CHECK(Counted::multiplications == 17);
  CHECK(Counted::additions == 14);
  CHECK(Counted::divisions == 3);
  CHECK(Counted::roots == 1);
}

TEST_CASE("shapes: spheres seen from afar keep their digits", "[ray_tracer][B60][case-58][Y4]") {
  const glm::dvec3 forward(0, 0, 1), middle(0);
  const auto check = [&](double y, double z, double first, double second, double tolerance) {
    const BallCrossing<double> ball = roots({0, y, z}, forward, middle, 1);
    CHECK(ball.meeting == BallMeeting::crossing);
    CHECK(std::abs(ball.first - first) < tolerance);
    CHECK(std::abs(ball.second - second) < tolerance);
  };
  check(0, -5, 4, 6, 1e-15);
  check(0.5, -4100, 4099.1339746, 4100.8660254, 1e-7);
  check(0, 0.5, -1.5, 0.5, 1e-15);
  for (const double y : {0.0, 0.5, 0.999})
    for (const double z : {-5.0, -4100.0, -1e5, -1e6}) {
      const double half = std::sqrt(1 - y * y);
      check(y, z, -z - half, -z + half, -z * 3e-16);
    }
  CHECK(meet(Sphere(), {0, 0.5, -1e5}, forward)->t == Approx(99999.1339746).epsilon(1e-12));
  CHECK(meet(Sphere(), {0, 0.999, -1e6}, forward)->t == Approx(999999.95529).epsilon(1e-11));

  // The tangent: its one point is at t = 10, and the notes count it as a miss.
  const BallCrossing<double> tangent = roots({0, 1, -10}, forward, middle, 1);
  CHECK(tangent.meeting == BallMeeting::touching);
  CHECK(tangent.first == 10);
  CHECK(tangent.second == 10);
  CHECK(!meet(Sphere(), {0, 1, -10}, forward));
}

TEST_CASE("shapes: spheres as large as the earth keep their digits", "[ray_tracer][B60][case-59][Y4]") {
  // The case's directions are those of float; t counts in their length. The exact values: 40 digits of c / (b + sqrt(b^2 - a c)).
  const Sphere ground(1e6, {0, -1e6, 0}), earth(6.4e6, {0, -6.4e6, 0});
  CHECK(std::abs(meet(ground, {0, 1, 0}, glm::vec3(0.6f, -0.8f, 0))->t - 1.25000033294) < 1e-10);
  CHECK(std::abs(meet(earth, {0, 1.5, 0}, glm::vec3(0.8f, -0.6f, 0))->t - 2.50000042149) < 1e-9);
  CHECK(meet(ground, {0, 1, 0}, {0.6, -0.8, 0})->t == Approx(1.2500003515626976).epsilon(1e-12));
  CHECK(meet(earth, {0, 1.5, 0}, {0.8, -0.6, 0})->t == Approx(2.5000005208335504).epsilon(1e-12));
}

TEST_CASE("shapes: points of spheres are on them at every scale", "[ray_tracer][B60][Y4]") {
  Random random(60);
  for (const double scale : kScales)
    for (int i = 0; i < 20000; ++i) {
      const double radius = scale * uniform(random, 0.1, 1);
      const glm::dvec3 centre = in_box(random, 10 * scale), eye = in_box(random, 100 * scale);
      const Sphere sphere(radius, centre);
      const glm::dvec3 target = centre + radius * uniform(random, 0, 0.999) * unit_vector(random);
      const Ray ray{.origin = eye, .direction = glm::normalize(target - eye)};
      const std::optional<ShapeHit> hit = sphere.intersect(ray);
      REQUIRE(hit);
      const SurfacePoint point = sphere.surface(ray, *hit);
      CHECK(std::abs(glm::length(point.position - centre) - radius) <= 4e-16 * point.magnitude);
      // And where the ray went, as far as that can be told of a line this long.
      CHECK(glm::length(point.position - ray.at(hit->t)) < 1e-12 * glm::length(target - eye));
    }
}

TEST_CASE("shapes: spheres without a radius and rays that are none", "[ray_tracer][case-65][B60]") {
  for (const double radius : {0.0, -1.0, -0.0, static_cast<double>(NAN)}) CHECK(!meet(Sphere(radius), {0, 0, 5}, {0, 0, -1}));
  const double inf = kInfinity, nan = NAN;
  Geometry geometry;
  geometry.add_shape(std::make_shared<Sphere>(), glm::dmat4(1), 0);
  const auto met = [&](const Ray& ray) { return static_cast<bool>(nearest_hit(geometry, ray)); };
  CHECK(met({.origin = {0, 0, 5}, .direction = {0, 0, -1}}));
  CHECK(!met({.origin = {0, 0, 5}, .direction = {0, 0, 0}}));
  CHECK(!met({.origin = {nan, 0, 5}, .direction = {0, 0, -1}}));
  CHECK(!met({.origin = {0, 0, inf}, .direction = {0, 0, -1}}));
  CHECK(!met({.origin = {0, 0, 5}, .direction = {0, nan, -1}}));
  CHECK(!met({.origin = {0, 0, 5}, .direction = {0, 0, -inf}}));
  CHECK(!met({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .t_min = 7, .t_max = 3}));
  CHECK(!met({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .t_min = nan}));
  CHECK(!met({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .t_min = 0, .t_max = nan}));
}

}  // namespace tuberia::tracer::shapes_test
