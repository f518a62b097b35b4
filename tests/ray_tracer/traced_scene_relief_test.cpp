// Relief of traced scenes, against slopes in closed form.

#include <cmath>
#include <numbers>

#include "math/bump.hpp"
#include "tests/ray_tracer/traced_scene_support.hpp"

namespace tuberia::tracer::traced_test {
namespace {

std::string relief_of(const std::string& shape, const std::string& bump, const std::string& material = "", const std::string& more = "") {
  return std::string(R"({"textures": {"ramp": {"source": "gradient", "size": 256, "first": 0, "second": 1, "filter": "bilinear", "wrap": "clamp"},
    "flat": {"source": "checker", "first": [0.5, 0.5, 1], "second": [0.5, 0.5, 1]}, "studs": {"source": "stud-heights", "squares": 4}},
    "materials": {"m": {"bump": {)").append(bump).append("}").append(material).append(R"(}}, "objects": [{"material": "m", "shape": {)").append(shape).append("}")
      .append(more).append("}]}");
}

glm::dvec3 normal_met(const TracedScene& scene, const glm::dvec3& from, const glm::dvec3& to) { return material_met(scene, from, to).normal; }

}  // namespace

TEST_CASE("traced scene: waves on a plane tilt its normal by their slope", "[A44][ray_tracer][traced_scene][bump]") {
  const double gain = 0.1;
  test::Random random(5);
  for (const SurfaceKind surfaces : {SurfaceKind::exact, SurfaceKind::tessellated}) {
    // x = 4 u - 2 and z = 2 v - 1, where the image is there once each way; then u' = 2 u.
    const TracedScene scene = traced(relief_of(R"("type": "plane", "width": 4, "depth": 2)", R"("type": "waves", "gain": 0.1, "scale": 3)", R"(, "mapping": {"repeat": [2, 1]})"), surfaces);
    for (int i = 0; i < 100; ++i) {
      const double x = number_between(random, -2, 2), z = number_between(random, -1, 1);
      const glm::dvec2 slope = gain * waves({2 * (x / 4 + 0.5), z / 2 + 0.5}, 3).slope;
      // The surface y = h(x, z) has the normal (-dh/dx, 1, -dh/dz).
      const glm::dvec3 wanted = glm::normalize(glm::dvec3(-slope.x * 2 / 4, 1, -slope.y / 2));
      CHECK(largest_difference(normal_met(scene, {x, 3, z}, {x, 0, z}), wanted) < 1e-5);
    }
  }
}

TEST_CASE("traced scene: heights of a picture tilt by its differences", "[A44][ray_tracer][traced_scene][bump]") {
  const TracedScene scene = traced(relief_of(R"("type": "plane")", R"("type": "height-texture", "texture": "ramp", "gain": 0.5)"));
  // A ramp from 0 to 1 along u, two units wide: dh/dx = 1/2 * 1/2.
  for (const double x : {-0.7, 0.0, 0.41}) CHECK(largest_difference(normal_met(scene, {x, 1, 0.3}, {x, 0, 0.3}), glm::normalize(glm::dvec3(-0.25, 1, 0))) < 1e-5);
}

TEST_CASE("traced scene: a picture of straight normals changes nothing", "[A44][ray_tracer][traced_scene][bump]") {
  // No code means exactly 1/2; the nearest one leans by 0.006.
  const TracedScene scene = traced(relief_of(R"("type": "sphere")", R"("type": "normal-map", "texture": "flat")"));
  const glm::dvec3 towards = glm::normalize(glm::dvec3(1, 2, 3));
  CHECK(largest_difference(normal_met(scene, 3.0 * towards, {0, 0, 0}), towards) < 0.01);
}

TEST_CASE("traced scene: relief on a globe's coordinates is that of a fine mesh", "[A44][ray_tracer][traced_scene][bump]") {
  const std::string ball = R"("type": "sphere", "radius": 2, "segments": [256, 128])", mapping = R"(, "mapping": {"type": "sphere", "pole": [0, 0, 1], "equator": [1, 0, 0]})";
  const std::string bump = R"("type": "waves", "gain": 0.05, "scale": 4)";
  const TracedScene exact = traced(relief_of(ball, bump, mapping)), fine = traced(relief_of(ball, bump, mapping), SurfaceKind::tessellated);
  const TracedScene smooth = traced(relief_of(ball, R"("type": "waves", "gain": 0)", mapping));
  test::Random random(6);
  double largest_tilt = 0;
  for (int i = 0; i < 200; ++i) {
    // Away from the poles, where a mesh's coordinates are coarse.
    const glm::dvec3 n = glm::normalize(glm::dvec3(number_between(random, -1, 1), number_between(random, -1, 1), number_between(random, -0.7, 0.7)));
    if (std::abs(n.z) > 0.9) continue;
    const glm::dvec3 relief = normal_met(exact, 4.0 * n, {0, 0, 0});
    CHECK(largest_difference(relief, normal_met(fine, 4.0 * n, {0, 0, 0})) < 0.02);
    CHECK(largest_difference(normal_met(smooth, 4.0 * n, {0, 0, 0}), n) < 1e-12);
    largest_tilt = std::max(largest_tilt, largest_difference(relief, n));
  }
  CHECK(largest_tilt > 0.1);  // else there was nothing to compare
}

TEST_CASE("traced scene: normals that are asked for differ from the surface's own", "[A44][ray_tracer][traced_scene]") {
  const std::string ball = R"({"objects": [{"shape": {"type": "sphere", "segments": [12, 6]}, "normals": )";
  const TracedScene facets = traced(ball + "\"facet\"}]}"), exact = traced(ball + "\"exact\"}]}");
  CHECK(exact.geometry().count() == 1);
  CHECK(facets.geometry().count() > 100);
  const glm::dvec3 from = glm::normalize(glm::dvec3(0.3, 0.5, 0.8));
  const TracedMeeting meeting = met(facets, 3.0 * from, {0, 0, 0});
  CHECK(largest_difference(facets.material(meeting.hit.item, meeting.at).normal, meeting.at.geometric_normal) < 1e-6);
  CHECK(largest_difference(normal_met(exact, 3.0 * from, {0, 0, 0}), from) < 1e-14);
}

}  // namespace tuberia::tracer::traced_test
