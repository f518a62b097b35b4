// What a light sees, by closed forms.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/shadow_scenes.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

namespace {

Bounds box_of(const glm::vec3& lower, const glm::vec3& upper) { return {lower, upper}; }

/// (s, t, depth, w) in double.
glm::dvec4 on_map(const LightView& view, const glm::dvec3& point) {
  const glm::dvec4 q = glm::dmat4(view.map_from_world) * glm::dvec4(point, 1);
  return {q.x / q.w, q.y / q.w, q.z / q.w, q.w};
}

std::string refusal_of_view(const Light& light, const Bounds& seen) {
  const auto view = light_view(light, seen);
  return view ? "" : view.error().message;
}

}  // namespace

TEST_CASE("light views: a box is seen whole, and fills the picture", "[shadows][A14]") {
  test::Random random(401);
  for (int round = 0; round < 200; ++round) {
    INFO("seed 401, round " << round);
    const auto some = [&](float reach) { return glm::vec3(random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach)); };
    const glm::vec3 corner = some(5), size = glm::abs(some(3)) + 0.01f;
    const Bounds box = box_of(corner, corner + size);
    const bool directional = round % 2 == 0;
    const glm::vec3 direction = round % 10 == 0 ? glm::vec3(0, 1, 0) : glm::normalize(some(1) + glm::vec3(0.01f));
    const Light light{.kind = directional ? Light::Kind::directional : Light::Kind::point,
                      .towards = directional ? direction : box.centre() + direction * (box.radius() * random.between(1.1f, 20))};
    const LightView view = test::value_of(light_view(light, box));
    glm::dvec3 smallest(10), largest(-10);
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 p{i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y, i & 4 ? box.upper.z : box.lower.z};
      const glm::dvec4 q = on_map(view, p);
      smallest = glm::min(smallest, glm::dvec3(q));
      largest = glm::max(largest, glm::dvec3(q));
      // In a perspective view w is the distance along the line of sight.
      const glm::dvec3 line = glm::normalize(view.camera.point_of_interest - view.camera.eye);
      CHECK(q.w == Approx(directional ? 1.0 : glm::dot(p - view.camera.eye, line)).epsilon(1e-5));
    }
    for (int k = 0; k < 2; ++k) {
      CHECK(smallest[k] >= 0.001);
      CHECK(largest[k] <= 0.999);
      // Perspective pictures have the slack of their larger side.
      CHECK(largest[k] - smallest[k] > 0.5);
    }
    CHECK(std::max(largest.x - smallest.x, largest.y - smallest.y) > 0.95);
    CHECK(smallest.z >= 0);
    CHECK(smallest.z < 0.05);
    CHECK(largest.z <= 1);
    CHECK(largest.z > 0.95);
  }
}

TEST_CASE("light views: the picture's sides in the world", "[shadows][A14]") {
  const Bounds box = box_of({-1, 0, -2}, {2, 1, 3});
  for (const Light& light : {test::kSun, test::kLamp}) {
    const LightView view = test::value_of(light_view(light, box));
    const glm::dvec3 middle(0.5, 0.5, 0.5);
    const glm::dvec4 at = on_map(view, middle);
    // A step of a tenth of a side, at the distance where it is made.
    const glm::dvec4 right = on_map(view, middle + glm::dvec3(view.right) * (0.1 * at.w)), down = on_map(view, middle + glm::dvec3(view.down) * (0.1 * at.w));
    CHECK(right.x - at.x == Approx(0.1).epsilon(1e-5));
    CHECK(right.y - at.y == Approx(0).margin(1e-6));
    CHECK(down.y - at.y == Approx(0.1).epsilon(1e-5));
    CHECK(down.x - at.x == Approx(0).margin(1e-6));
    CHECK(right.w == Approx(at.w).epsilon(1e-6));
  }
}

TEST_CASE("light views: points on one ray of light share a texel", "[shadows][A14]") {
  const Bounds box = box_of({-1, -1, -1}, {1, 1, 1});
  test::Random random(402);
  for (const Light& light : {test::kSun, test::kLamp}) {
    const LightView view = test::value_of(light_view(light, box));
    for (int round = 0; round < 50; ++round) {
      const glm::dvec3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      const glm::dvec3 nearer = p + test::to_light(light, p) * 0.1;
      const glm::dvec4 far = on_map(view, p), near = on_map(view, nearer);
      CHECK(near.x == Approx(far.x).margin(1e-6));
      CHECK(near.y == Approx(far.y).margin(1e-6));
      CHECK(near.z < far.z);
    }
  }
}

TEST_CASE("light views: a lamp over a wide floor turns towards the middle of what it sees", "[shadows][A14]") {
  // Seen from 1 above one end of a floor 16 long, its middle is 7 degrees below the horizon: other corners are behind.
  const LightView view = test::value_of(light_view({.kind = Light::Kind::point, .towards = {-8.5f, 1, 0}}, box_of({-8, 0, -8}, {8, 0, 8})));
  for (const double x : {-8.0, 8.0})
    for (const double z : {-8.0, 8.0}) {
      const glm::dvec4 corner = on_map(view, {x, 0, z});
      CHECK(corner.w > 0);
      CHECK((corner.x > 0 && corner.x < 1 && corner.y > 0 && corner.y < 1));
    }
}

TEST_CASE("light views: a spot sees along its axis, its cone or the box, whichever is narrower", "[shadows][A14]") {
  const double angle = 0.5;
  Light spot{.kind = Light::Kind::spot, .towards = {0, 5, 0}, .axis = {0, -1, 0}, .cos_inner = static_cast<float>(std::cos(0.4)), .cos_outer = static_cast<float>(std::cos(angle))};
  const LightView cone = test::value_of(light_view(spot, box_of({-50, 0, -50}, {50, 8, 50})));
  for (int i = 0; i < 16; ++i) {
    const double azimuth = i * 0.3926990816987241, r = 5 * std::tan(angle);
    const glm::dvec4 edge = on_map(cone, {r * std::cos(azimuth), 0, r * std::sin(azimuth)});
    CHECK((edge.x > 0.005 && edge.x < 0.995 && edge.y > 0.005 && edge.y < 0.995 && edge.z > 0.9 && edge.z <= 1));
    CHECK(std::max(std::abs(edge.x - 0.5), std::abs(edge.y - 0.5)) > 0.3);
  }
  const LightView narrow = test::value_of(light_view(spot, box_of({-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f})));
  CHECK(glm::length(narrow.right) < 0.27);
  CHECK(on_map(narrow, {0.5, 1, 0.5}).x < 1);

  const Bounds box = box_of({-1, 0, -1}, {1, 1, 1});
  spot.axis = {0, 1, 0};
  CHECK(refusal_of_view(spot, box) == "what the spot is to see lies behind it");
  spot.axis = {0, 0, 0};
  CHECK(refusal_of_view(spot, box) == "the spot's axis is zero");
  spot.axis = {0, std::numeric_limits<float>::quiet_NaN(), 0};
  CHECK(refusal_of_view(spot, box) == "the spot's axis is not finite");
  spot.axis = {0.8f, -0.6f, 0};
  CHECK(refusal_of_view(spot, box) == "what the spot is to see lies outside of its cone");
  // Half a sphere is more than one picture shows well: as a point.
  spot.axis = {0, 1, 0};
  spot.cos_inner = spot.cos_outer = 0;
  CHECK(refusal_of_view(spot, box) == "");
}

TEST_CASE("light views: what cannot be seen is refused by name", "[shadows]") {
  const Bounds box = box_of({-1, -1, -1}, {1, 1, 1});
  const auto nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const auto sun = [](const glm::vec3& towards) { return Light{.kind = Light::Kind::directional, .towards = towards}; };
  const auto lamp = [](const glm::vec3& at) { return Light{.kind = Light::Kind::point, .towards = at}; };
  CHECK(refusal_of_view(sun({0, 1, 0}), {}) == "the box that the light is to see is empty");
  CHECK(refusal_of_view(sun({0, 1, 0}), box_of({-1, -1, -1}, {1, infinity, 1})) == "the box that the light is to see is not finite");
  CHECK(refusal_of_view(sun({0, nan, 0}), box) == "the light's direction or position is not finite");
  CHECK(refusal_of_view(sun({0, 0, 0}), box) == "the light's direction is zero");
  for (const glm::vec3& inside : {glm::vec3(0), glm::vec3(0.5f), glm::vec3(1, 0, 0), glm::vec3(0.99f, 0.99f, 0.99f)})
    CHECK(refusal_of_view(lamp(inside), box) == "the light lies inside of what it is to see, or too close to it for one picture");
  CHECK(refusal_of_view(lamp({0, 1.5f, 0}), box) == "");
  // A box without extent is a point, or a line, or a plane seen from its edge.
  CHECK(refusal_of_view(sun({0, 1, 0}), box_of({1, 2, 3}, {1, 2, 3})) == "");
  CHECK(refusal_of_view(lamp({0, 1, 0}), box_of({1, 2, 3}, {1, 2, 3})) == "");
  CHECK(refusal_of_view(sun({1, 0, 0}), box_of({-1, 0, -1}, {1, 0, 1})) == "");
  const auto cube_refusal = [&](const Light& light, const Bounds& seen) {
    const auto view = light_cube(light, seen);
    return view ? std::string() : view.error().message;
  };
  CHECK(cube_refusal(lamp({0, 0, 0}), box) == "");
  CHECK(cube_refusal(sun({0, 1, 0}), box) == "a directional light does not shine all around");
  CHECK(cube_refusal(lamp({0, nan, 0}), box) == "the light's direction or position is not finite");
  CHECK(cube_refusal(lamp({0, 0, 0}), {}) == "the box that the light is to see is empty");
  CHECK(cube_refusal(lamp({1, 2, 3}), box_of({1, 2, 3}, {1, 2, 3})) == "there is nothing around the light but its own place");
  Camera reversed = test::value_of(light_camera(test::kSun, box));
  reversed.reversed_depth = true;
  CHECK(light_view(reversed).error().message == "a light's view with reversed depth cannot be compared with");
}

}  // namespace tuberia
