// Shapes far away, at their edges and tips, thin as wires, and of no size at all.
#include <catch2/catch.hpp>

#include "tests/ray_tracer/shapes_witnesses.hpp"

namespace tuberia::tracer::shapes_test {

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
      CHECK(std::abs(hit->t - distance - before->t) < 2e-15 * distance / slope + 1e-12);
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
                                                           std::make_shared<Cone>(scale, 2 * scale), *Polyhedron::create(octahedron(scale)),
                                                           quadric_of(diagonal(1, 1, 1, -1), scale, glm::dvec3(1))};
    for (std::size_t number = 0; number < solids.size(); ++number)
      for (int i = 0; i < 20000; ++i) {
        // Edges of the cube, rims of the others, the tip, edges of the octahedron, and where a ball touches the box that it just fills.
        const double angle = uniform(random, 0, 7), along = uniform(random, -1, 1);
        const glm::dvec3 rim(std::cos(angle), i % 2 == 0 ? -1 : 1, std::sin(angle)), tip(0, 1, 0), edge(along, i % 2 == 0 ? 1 : -1, i % 4 == 0 ? 1 : -1);
        const glm::dvec3 ridge(1 - std::abs(along), 0, along);
        glm::dvec3 pole(0);
        pole[i % 3] = i % 2 == 0 ? 1 : -1;
        const glm::dvec3 target = number == 0 ? edge : number == 1 ? rim : number == 2 ? (i % 2 == 0 ? rim : tip) : number == 3 ? ridge : pole;
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

TEST_CASE("shapes: rays along the side of a cone", "[ray_tracer][A42]") {
  // rho = -y from the tip. Of x^2 + z^2 = y^2 nothing but 2 s (x + y) = y^2 - x^2 - z^2 is left on (x + s, y - s, z).
  const Cone cone(2, 2, false);
  Random random(47);
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec3 from_tip = in_box(random, 3);
    const double s = 0.5 * (from_tip.y * from_tip.y - from_tip.x * from_tip.x - from_tip.z * from_tip.z) / (from_tip.x + from_tip.y);
    const double y = from_tip.y - s;
    if (std::abs(y) < 1e-6 || std::abs(y + 2) < 1e-6) continue;
    for (const double sense : {1.0, -1.0}) {
      const std::optional<ShapeHit> hit = cone.intersect({.origin = from_tip + glm::dvec3(0, 1, 0), .direction = sense * glm::dvec3(1, -1, 0)});
      REQUIRE(hit.has_value() == (sense * s > 0 && y < 0 && y > -2));
      if (!hit) continue;
      CHECK(std::abs(hit->t - sense * s) < 1e-13);
      ++met;
    }
  }
  CHECK(met > 500);
}

TEST_CASE("shapes: wires bent to rings", "[ray_tracer][A42]") {
  for (const double tube : {1e-2, 1e-4}) {
    const Torus torus(1, tube);
    Random random(48);
    int met = 0;
    for (int i = 0; i < 20000; ++i) {
      const double angle = uniform(random, 0, 7);
      const glm::dvec3 target = glm::dvec3(std::cos(angle), 0, std::sin(angle)) + 0.8 * tube * in_box(random, 1), eye = in_box(random, 3);
      const Ray ray{.origin = eye, .direction = glm::normalize(target - eye)};
      const std::optional<ShapeHit> hit = torus.intersect(ray);
      if (!hit) continue;
      CHECK(std::abs(torus_field(ray.at(hit->t), 1, tube)) < 4e-15);
      ++met;
    }
    CHECK(met > 15000);
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
