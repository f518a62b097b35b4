// Lights and backgrounds of traced scenes, against closed forms.

#include <cmath>
#include <numbers>

#include "math/reflection.hpp"
#include "tests/ray_tracer/traced_scene_support.hpp"

namespace tuberia::tracer::traced_test {
namespace {

constexpr double kTracedPi = std::numbers::pi;

std::vector<TracedLight> lights_at(const TracedScene& scene, const glm::dvec3& point) {
  std::vector<TracedLight> lights;
  scene.lights(point, lights);
  return lights;
}

TracedLight only_light_at(const std::string& light, const glm::dvec3& point, const std::string& more = "") {
  const auto lights = lights_at(traced(std::string(R"({"lights": [{)").append(light).append("}]").append(more).append("}")), point);
  REQUIRE(lights.size() == 1);
  return lights[0];
}

}  // namespace

TEST_CASE("traced scene: a directional light is the same everywhere", "[ray_tracer][traced_scene]") {
  const TracedLight light = only_light_at(R"("type": "directional", "towards": [0, 3, 4], "intensity": [1, 2, 3], "shadow": {})", {7, 8, 9});
  CHECK(largest_difference(light.to_light, {0, 0.6, 0.8}) < 1e-15);
  CHECK(light.distance == kInfinity);
  CHECK(light.intensity == glm::dvec3(1, 2, 3));
  CHECK(light.casts_shadows);
}

TEST_CASE("traced scene: points lose light by the notes' two laws", "[ray_tracer][traced_scene]") {
  // 13 units away.
  const TracedLight even = only_light_at(R"("type": "point", "position": [3, 5, 12])", {0, 1, 0});
  CHECK(even.distance == 13);
  CHECK(largest_difference(even.to_light, glm::dvec3(3, 4, 12) / 13.0) < 1e-15);
  CHECK(even.intensity == glm::dvec3(1));
  CHECK_FALSE(even.casts_shadows);
  const TracedLight linear = only_light_at(R"("type": "point", "position": [3, 5, 12], "falloff": "linear", "falloff_distance": 2, "intensity": 30)", {0, 1, 0});
  CHECK(linear.intensity.x == Approx(30 * linear_falloff(13, 2)).epsilon(1e-14));
  CHECK(linear.intensity.x == Approx(2).epsilon(1e-14));
  const TracedLight square = only_light_at(R"("type": "point", "position": [3, 5, 12], "falloff": "inverse-square")", {0, 1, 0});
  CHECK(square.intensity.x == Approx(1 / (4 * kTracedPi * 169)).epsilon(1e-14));
}

TEST_CASE("traced scene: at a light itself there is no direction, and nothing is infinite", "[ray_tracer][traced_scene][bad]") {
  const TracedLight light = only_light_at(R"("type": "point", "position": [0, 1, 0], "falloff": "inverse-square")", {0, 1, 0});
  CHECK(light.to_light == glm::dvec3(0));
  CHECK(light.intensity.x == Approx(inverse_square_falloff(1e-6)).epsilon(1e-14));
}

TEST_CASE("traced scene: a spot's cone has a smooth edge", "[ray_tracer][traced_scene]") {
  const std::string spot = R"("type": "spot", "position": [0, 2, 0], "look_at": [0, 0, 0], "cone_degrees": 40, "full_cone_degrees": 20)";
  const auto intensity = [&](double degrees) { return only_light_at(spot, {2 * std::tan(degrees * kTracedPi / 180), 0, 0}).intensity.x; };
  CHECK(intensity(0) == 1);
  CHECK(intensity(19.9) == 1);
  CHECK(intensity(40.1) == 0);
  // Halfway between the cosines 3 t^2 - 2 t^3 is a half; a quarter of the way in it is 10/64.
  const double outer = std::cos(40 * kTracedPi / 180), inner = std::cos(20 * kTracedPi / 180);
  CHECK(intensity(std::acos((inner + outer) / 2) * 180 / kTracedPi) == Approx(0.5).epsilon(1e-12));
  CHECK(intensity(std::acos(outer + (inner - outer) / 4) * 180 / kTracedPi) == Approx(10.0 / 64).epsilon(1e-12));
}

TEST_CASE("traced scene: a spot without a soft edge is either all or nothing", "[ray_tracer][traced_scene]") {
  const std::string spot = R"("type": "spot", "position": [0, 2, 0], "look_at": [0, 0, 0], "cone_degrees": 45, "full_cone_degrees": 45)";
  CHECK(only_light_at(spot, {1.999, 0, 0}).intensity.x == 1);
  CHECK(only_light_at(spot, {2.001, 0, 0}).intensity.x == 0);
}

TEST_CASE("traced scene: an area is points in the middles of equal parts", "[ray_tracer][traced_scene]") {
  const auto lights = lights_at(traced(R"({"lights": [{"type": "area", "position": [0, 4, 0], "edge_u": [4, 0, 0], "edge_v": [0, 0, 2], "samples": 2, "intensity": 8, "shadow": {}}]})"),
                                {0, 0, 0});
  REQUIRE(lights.size() == 4);
  const std::vector<glm::dvec3> points{{-1, 4, -0.5}, {1, 4, -0.5}, {-1, 4, 0.5}, {1, 4, 0.5}};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(largest_difference(lights[i].to_light * lights[i].distance, points[i]) < 1e-14);
    CHECK(lights[i].intensity == glm::dvec3(2));
    CHECK(lights[i].casts_shadows);
  }
}

TEST_CASE("traced scene: a slide falls upright around where its light looks", "[ray_tracer][traced_scene]") {
  // Four squares of one colour each. Seen from the light, up is -z; so right is +x.
  const std::string textures = R"("textures": {"slide": {"source": "random-squares", "squares": 2, "size": 64, "filter": "nearest"}})", slide = std::string(", ").append(textures);
  const auto square = [&](int x, int y) {
    const auto picture = light_of(*texture_picture({}, described(std::string("{").append(textures).append("}")).textures[0]));
    const Rgba32F& colour = picture.at(16 + 32 * x, 16 + 32 * y);
    return glm::dvec3(colour.r, colour.g, colour.b);
  };
  REQUIRE(square(0, 0) != square(1, 0));
  const auto check = [&](const std::string& light) {
    CHECK(only_light_at(light, {-0.5, 0, -0.5}, slide).intensity == square(0, 0));
    CHECK(only_light_at(light, {0.5, 0, -0.5}, slide).intensity == square(1, 0));
    CHECK(only_light_at(light, {-0.5, 0, 0.5}, slide).intensity == square(0, 1));
    CHECK(only_light_at(light, {0.5, 0, 0.5}, slide).intensity == square(1, 1));
    CHECK(only_light_at(light, {1.01, 0, 0}, slide).intensity == glm::dvec3(0));
    CHECK(only_light_at(light, {0, 0, 1.01}, slide).intensity == glm::dvec3(0));
    CHECK(only_light_at(light, {0.99, 0, 0.99}, slide).intensity == square(1, 1));
  };
  // Two units high where it falls: tan(fovy / 2) = 1 / 4 over four units.
  const std::string fovy = std::to_string(2 * std::atan(0.25) * 180 / kTracedPi);
  check(R"("type": "point", "position": [0, 4, 0], "look_at": [0, 0, 0], "projection": {"texture": "slide", "up": [0, 0, -1], "fovy_degrees": )" + fovy + "}");
  check(R"("type": "directional", "towards": [0, 2, 0], "look_at": [0, 0, 0], "projection": {"texture": "slide", "up": [0, 0, -1], "height": 2})");
  // Nothing is thrown backwards.
  CHECK(only_light_at(R"("type": "point", "position": [0, 4, 0], "look_at": [0, 0, 0], "projection": {"texture": "slide", "up": [0, 0, -1], "fovy_degrees": 90})",
                      {0, 5, 0}, slide).intensity == glm::dvec3(0));
}

TEST_CASE("traced scene: slides are filtered like other textures where the footprint is known", "[ray_tracer][traced_scene]") {
  // 64 texels over two units: a pixel of 1/8 is four texels wide, and level 2 is green.
  const TracedScene scene = traced(R"({"textures": {"slide": {"source": "gradient", "size": 64, "level_colours": true}},
    "lights": [{"type": "directional", "towards": [0, 1, 0], "look_at": [0, 0, 0], "projection": {"texture": "slide", "up": [0, 0, -1], "height": 2}}]})");
  const auto thrown = [&](double pixel) {
    std::vector<TracedLight> lights;
    scene.lights({0.1, 0, 0.2}, lights, {.right = {pixel, 0, 0}, .down = {0, 0, pixel / 2}});
    return lights.at(0).intensity;
  };
  CHECK(thrown(0) == glm::dvec3(1, 0, 0));
  CHECK(largest_difference(thrown(1.0 / 16), {1, 1, 0}) < 1e-12);
  CHECK(largest_difference(thrown(1.0 / 8), {0, 1, 0}) < 1e-12);
}

TEST_CASE("traced scene: where nothing is there is the background, or what surrounds the scene", "[ray_tracer][traced_scene]") {
  const TracedScene empty = traced(R"({"image": {"background": [0.1, 0.2, 0.3]}, "ambient": [0.25, 0.5, 0.75]})");
  CHECK(empty.background({0, 1, 0}, true) == glm::dvec3(glm::vec3(0.1f, 0.2f, 0.3f)));
  CHECK(empty.ambient() == glm::dvec3(0.25, 0.5, 0.75));
  CHECK(empty.geometry().count() == 0);
  CHECK(empty.has_only_opaque_casters());

  // Straight below is four tenths of the ground's colour.
  const glm::dvec3 below(0.2, 0.1, 0.05);
  const std::string sky = R"("environment": {"source": "sky", "sky": {"cloudiness": 0, "ground": [0.5, 0.25, 0.125]})";
  for (const bool is_shown : {true, false}) {
    const std::string flag = is_shown ? R"(, "shown": true}})" : R"(, "shown": false}})";
    const TracedScene scene = traced(std::string(R"({"image": {"background": 0.75}, )").append(sky).append(flag));
    CHECK(largest_difference(scene.background({0, -1, 0}, false), below) < 1e-6);
    CHECK(largest_difference(scene.background({0, -1, 0}, true), is_shown ? below : glm::dvec3(0.75)) < 1e-6);
  }
  // One that is rendered has nothing that the rays do not find themselves.
  const TracedScene rendered = traced(R"({"image": {"background": 0.75}, "environment": {"source": "rendered"}})");
  CHECK(rendered.background({0, 1, 0}, false) == glm::dvec3(0.75));
}

TEST_CASE("traced scene: surroundings turn counter-clockwise, seen from above", "[ray_tracer][traced_scene]") {
  const auto sun_of = [](const std::string& rotation) {
    return traced(R"({"environment": {"source": "sky", "rotation_degrees": )" + rotation + R"(, "sky": {"sun_towards": [1, 1, 0], "sun": 100, "glow": 0, "cloudiness": 0}}})");
  };
  CHECK(sun_of("0").background(glm::normalize(glm::dvec3(1, 1, 0)), true).x > 50);
  CHECK(sun_of("90").background(glm::normalize(glm::dvec3(0, 1, -1)), true).x > 50);
  CHECK(sun_of("90").background(glm::normalize(glm::dvec3(1, 1, 0)), true).x < 2);
}

}  // namespace tuberia::tracer::traced_test
