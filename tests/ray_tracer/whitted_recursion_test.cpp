// Mirrored and refracted rays: how many, how deep, where to, and what they bring.

#include <cmath>

#include "math/optics.hpp"
#include "tests/ray_tracer/whitted_scenes.hpp"

namespace tuberia::tracer {
namespace {

/// All surfaces mirror 0.8 and send 0.1 of their own.
constexpr const char* kMirrorBox = R"({"ambient": 1, "materials": {"mirror": {"diffuse": 0.1, "mirror": 0.8}},
  "objects": [{"shape": {"type": "cube"}, "material": "mirror"}]})";

/// Glass below y = 0, of index 1.5.
TracedScene glass_floor(const char* more = "") {
  return whitted_scene(whitted_text(R"({"image": {"background": [0.5, 0.25, 1]}, "ambient": 0, "materials": {"glass": {"diffuse": 0, "transmission": 0.75, "refractive_index": 1.5)", more,
                                    R"(}}, "objects": [{"shape": {"type": "infinite-plane"}, "material": "glass"}]})"));
}

glm::dvec3 direction_of(const RayTree& tree, const char* name) {
  const TracedRay* ray = whitted_named(tree, name);
  REQUIRE(ray);
  return ray->ray.direction;
}

}  // namespace

TEST_CASE("ray tracer: one bounce adds kr times what is mirrored, once for all lights", "[ray_tracer][B52]") {
  const char* const lights[] = {R"({"type": "directional", "towards": [0, 1, 0], "intensity": 0.5})", R"({"type": "directional", "towards": [0.6, 0.8, 0], "intensity": 0.25})"};
  const auto seen = [&](const std::string& of_lights) {
    const TracedScene scene = whitted_scene(whitted_text(R"({"ambient": [0.2, 0.2, 0.2], "lights": [)", of_lights, R"(],
      "materials": {"floor": {"model": "phong", "diffuse": [0.5, 0.25, 0.1], "specular": 0.3, "exponent": 4, "mirror": [0.4, 0.5, 0.6]}, "wall": {"model": "lambert", "diffuse": [0.9, 0.8, 0.7], "ambient": 0.5}},
      "objects": [{"shape": {"type": "plane"}, "material": "floor"},
                  {"shape": {"type": "plane", "width": 40, "depth": 40}, "material": "wall", "transforms": [{"rotate": 90, "about": [0, 0, 1]}, {"translate": [3, 0, 0]}]}]})"));
    return whitted_ray(scene, whitted_towards({-1, 1, 0}, {0, 0, 0}));
  };
  // The eye ray comes down at 45 degrees and leaves so; the wall at x = 3 faces -x. Neither light is on its side.
  const double h = std::sqrt(0.5);
  const glm::dvec3 wall = 0.5 * glm::dvec3(0.2);
  const double highlight_1 = std::pow(h, 4);                              // R = (0, 1, 0), V = (-h, h, 0)
  const double highlight_2 = std::pow(-h * -0.6 + h * 0.8, 4);            // R = (-.6, .8, 0)
  const glm::dvec3 kd(0.5, 0.25, 0.1), kr(0.4, 0.5, 0.6);
  const glm::dvec3 expected = kd * 0.2 + 0.5 * (kd + 0.3 * highlight_1) + 0.25 * (kd * 0.8 + 0.3 * highlight_2) + kr * wall;
  const WhittedRay both = seen(whitted_text(lights[0], ",", lights[1]));
  CHECK(whitted_is_near(both.light, expected, 1e-6));
  CHECK(both.scratch.reflected_rays == 1);
  CHECK(both.scratch.transmitted_rays == 0);
  // Two lights do not mirror twice [FIX 18].
  const glm::dvec3 one = seen(lights[0]).light, other = seen(lights[1]).light, none = seen("").light;
  CHECK(whitted_is_near(both.light, one + other - none, 1e-9));
}

TEST_CASE("ray tracer: a box of mirrors sums the series of its bounces", "[ray_tracer][case-64][A46]") {
  const TracedScene box = whitted_scene(kMirrorBox);
  struct Depth {
    int most_level;
    double light;
  };
  for (const Depth& depth : {Depth{0, .1}, {1, .18}, {5, .368928}, {10, .45705032704}, {50, .4999942910092292}}) {
    CAPTURE(depth.most_level);
    const WhittedRay seen = whitted_ray(box, whitted_towards({0.1, 0.2, -0.3}, {0.9, 0.4, 0.55}), {.most_level = depth.most_level});
    // Constants are floats: 0.8f is 1.2e-8 more than 0.8.
    CHECK(seen.light.x == Approx(depth.light).epsilon(2e-7));
    CHECK(seen.scratch.reflected_rays == depth.most_level);
    CHECK(seen.scratch.rays_of_this_eye_ray == depth.most_level + 1);
  }
}

TEST_CASE("ray tracer: A's depth 1 is level 0: no secondary rays", "[ray_tracer][A45][A46]") {
  const TracedScene box = whitted_scene(R"({"materials": {"both": {"mirror": 0.5, "transmission": 0.5, "refractive_index": 1.1}}, "lights": [{"type": "directional", "shadow": {}}],
    "objects": [{"shape": {"type": "sphere"}, "material": "both"}]})");
  const Ray ray = whitted_towards({0.2, 0.1, 5}, {0, 0, 0});
  // A ball that does both: each hit is two rays. Those that leave it escape.
  const std::int64_t reflected[] = {0, 1, 2, 3}, transmitted[] = {0, 1, 2, 3};
  for (int level = 0; level < 4; ++level) {
    const WhittedRay seen = whitted_ray(box, ray, {.most_level = level});
    CHECK(seen.scratch.reflected_rays == reflected[level]);
    CHECK(seen.scratch.transmitted_rays == transmitted[level]);
  }
  // Without coefficients there are no rays at any depth.
  const TracedScene dull = whitted_scene(R"({"objects": [{"shape": {"type": "sphere"}}]})");
  const WhittedRay seen = whitted_ray(dull, ray, {.most_level = 1000});
  CHECK(seen.scratch.rays_of_this_eye_ray == 1);
  CHECK(seen.tree.rays().front().end == RayEnd::nothing_to_follow);
  CHECK(whitted_ray(dull, ray, {.most_level = -1}).light == glm::dvec3(0));
}

TEST_CASE("ray tracer: mirrored rays leave by the notes' cosine and sine vectors", "[ray_tracer][B56]") {
  // TV 15.15 with the floor's normal +y in place of +z, seen from above and from below.
  const TracedScene scene = whitted_scene(R"({"materials": {"mirror": {"mirror": 1}}, "objects": [{"shape": {"type": "plane"}, "material": "mirror"}]})");
  const double cosine = std::sqrt(0.75);
  const RayTree above = whitted_ray(scene, {.origin = {0.5, cosine, 0}, .direction = {-0.5, -cosine, 0}}).tree;
  CHECK(whitted_is_near(direction_of(above, "R1"), {-0.5, cosine, 0}, 1e-12));
  const RayTree below = whitted_ray(scene, {.origin = {0.5, -cosine, 0}, .direction = {-0.5, cosine, 0}}).tree;
  CHECK(whitted_is_near(direction_of(below, "R1"), {-0.5, -cosine, 0}, 1e-12));
}

TEST_CASE("ray tracer: rays leave a surface on their own side, whatever its interpolated normals say", "[ray_tracer][B56][B57]") {
  const TracedScene ball = whitted_scene(R"({"materials": {"both": {"mirror": 0.5, "transmission": 0.5, "refractive_index": 1.5}},
    "objects": [{"shape": {"type": "sphere", "segments": [8, 4]}, "material": "both"}]})",
                                         {.surfaces = SurfaceKind::tessellated});
  const RayTracer tracer(ball, {.most_level = 1});
  int turned = 0, turned_away = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Ray ray = whitted_towards({0.1, 0.2, 4}, {-1.031 + 0.02 * (i % 100), -1.017 + 0.02 * (i / 100), 0});
    TraceScratch scratch;
    const Hit hit = tracer.first_hit(ray, scratch);
    if (!hit) continue;
    const SurfacePoint at = ball.geometry().surface(ray, hit);
    RayTree tree;
    tracer.radiance(ray, scratch, &tree);
    const glm::dvec3 facing = glm::dot(at.geometric_normal, ray.direction) < 0 ? at.geometric_normal : -at.geometric_normal;
    turned += glm::dot(reflected(ray.direction, at.normal), facing) < 0;
    CHECK(glm::dot(direction_of(tree, "R1"), facing) >= 0);
    CHECK(glm::dot(direction_of(tree, "T1"), facing) <= 0);
    CHECK(glm::length(direction_of(tree, "R1")) == Approx(1));
    CHECK(glm::length(direction_of(tree, "T1")) == Approx(1));
    // Seen from behind an interpolated normal says nothing: the triangle's own counts.
    if (glm::dot(at.normal, ray.direction) < 0) continue;
    ++turned_away;
    CHECK(whitted_is_near(direction_of(tree, "R1"), reflected(ray.direction, facing)));
    CHECK(whitted_is_near(direction_of(tree, "T1"), *refracted(ray.direction, facing, 1, 1.5)));
  }
  CHECK(turned_away > 0);
  CHECK(turned > 0);  // there was something to keep
}

TEST_CASE("ray tracer: surroundings that are not shown are seen in mirrors, but not by the eye", "[ray_tracer][A46]") {
  const TracedScene scene = whitted_scene(R"({"image": {"background": 0.125}, "environment": {"source": "sky", "resolution": 64, "shown": false}, "ambient": 0,
    "materials": {"mirror": {"diffuse": 0, "mirror": 1}, "veil": {"alpha": 0.5, "diffuse": 0}},
    "objects": [{"shape": {"type": "plane"}, "material": "mirror"}, {"shape": {"type": "plane"}, "material": "veil", "transforms": [{"translate": [9, 0, 0]}]}]})");
  const Ray down{.origin = {0, 2, 0}, .direction = {0, -1, 0}};
  CHECK(whitted_is_near(whitted_ray(scene, down).light, scene.background({0, 1, 0}, false), 1e-12));
  CHECK_FALSE(whitted_is_near(whitted_ray(scene, down).light, glm::dvec3(0.125), 1e-2));
  CHECK(whitted_is_near(whitted_ray(scene, {.origin = {5, 2, 0}, .direction = {0, -1, 0}}).light, glm::dvec3(0.125)));
  // Straight through a veil it is still the eye that looks.
  CHECK(whitted_is_near(whitted_ray(scene, {.origin = {9, 2, 0}, .direction = {0, -1, 0}}).light, glm::dvec3(0.0625)));
}

TEST_CASE("ray tracer: refracted rays are bent as Snell and the notes have it", "[ray_tracer][B57]") {
  const TracedScene glass = glass_floor();
  // TV 15.14: 30 degrees come in at 19.4712; and the way back.
  const double cosine = std::sqrt(0.75);
  const RayTree into = whitted_ray(glass, {.origin = {0.5, cosine, 0}, .direction = {-0.5, -cosine, 0}}).tree;
  CHECK(whitted_is_near(direction_of(into, "T1"), {-1.0 / 3, -std::sqrt(8.0) / 3, 0}, 1e-12));
  CHECK(std::asin(-direction_of(into, "T1").x) * 180 / M_PI == Approx(19.4712).margin(1e-4));
  const RayTree out = whitted_ray(glass, {.origin = {1.0 / 3, -1, 0}, .direction = {-1.0 / 3, std::sqrt(8.0) / 3, 0}}).tree;
  CHECK(whitted_is_near(direction_of(out, "T1"), {-0.5, cosine, 0}, 1e-12));

  // Equals bend nothing.
  const TracedScene air = whitted_scene(R"({"materials": {"air": {"transmission": 1, "refractive_index": 1}}, "objects": [{"shape": {"type": "sphere"}, "material": "air"}]})");
  const Ray ray = whitted_towards({0.3, 0.5, 4}, {0.1, 0.2, 0});
  const RayTree straight = whitted_ray(air, ray).tree;
  CHECK(whitted_is_near(direction_of(straight, "T1"), ray.direction, 1e-12));
  CHECK(whitted_is_near(direction_of(straight, "T2"), ray.direction, 1e-12));
}

TEST_CASE("ray tracer: beyond the critical angle all that would go through is mirrored", "[ray_tracer][B57]") {
  const glm::dvec3 background(0.5, 0.25, 1);
  for (const double degrees : {41.80, 41.82, 45.0, 89.0}) {
    CAPTURE(degrees);
    const double angle = degrees * M_PI / 180;
    const WhittedRay seen = whitted_ray(glass_floor(R"(, "mirror": 0.125)"), {.origin = {0, -1, 0}, .direction = {std::sin(angle), std::cos(angle), 0}});
    // The background is the same above and below: 0.75 goes one way or the other.
    CHECK(whitted_is_near(seen.light, 0.875 * background, 1e-7));
    const bool is_total = degrees > 41.8103;
    CHECK((whitted_named(seen.tree, "T1") == nullptr) == is_total);
    CHECK((seen.tree.rays().front().end == RayEnd::total_reflection) == is_total);
    CHECK(whitted_named(seen.tree, "R1")->weight.x == Approx(is_total ? 0.875 : 0.125));
  }
}

TEST_CASE("ray tracer: a slab with parallel faces lets rays out as they came in", "[ray_tracer][B57]") {
  const TracedScene slab = whitted_scene(R"({"materials": {"glass": {"transmission": 0.9, "refractive_index": 1.7}},
    "objects": [{"shape": {"type": "cube", "size": [20, 0.5, 20]}, "material": "glass", "transforms": [{"rotate": 20, "about": [1, 2, 3]}]}]})");
  for (int i = 0; i < 20; ++i) {
    const Ray ray = whitted_towards({2, 5, 1}, {-3 + 0.3 * i, 0, 0.2 * i - 2});
    const RayTree tree = whitted_ray(slab, ray).tree;
    CHECK(whitted_is_near(direction_of(tree, "T2"), ray.direction, 1e-12));
    CHECK_FALSE(whitted_is_near(direction_of(tree, "T1"), ray.direction, 1e-3));
  }
}

TEST_CASE("ray tracer: a glass ball focuses where it should", "[ray_tracer][case-61][B57]") {
  const TracedScene ball = whitted_scene(R"({"materials": {"glass": {"transmission": 1, "refractive_index": 1.5}}, "objects": [{"shape": {"type": "sphere"}, "material": "glass"}]})");
  struct Focus {
    double height, axis;
  };
  for (const Focus& focus : {Focus{0.1, 1.495827063056069}, {0.5, 1.39157294888931}, {0.9, 1.104445568369265}, {1e-4, 1.5}}) {
    CAPTURE(focus.height);
    const RayTree tree = whitted_ray(ball, {.origin = {-5, focus.height, 0}, .direction = {1, 0, 0}}).tree;
    const TracedRay* out = whitted_named(tree, "T2");
    REQUIRE(out);
    const glm::dvec3 exit = whitted_named(tree, "T1")->point, direction = out->ray.direction;
    // Its origin was moved by 1e-10.
    CHECK(exit.x - exit.y * direction.x / direction.y == Approx(focus.axis).margin(1e-8));
    if (focus.height == 0.1) {
      CHECK(whitted_is_near(exit, {.9994467750408685, .03325874111279136, 0}, 1e-8));
      CHECK(whitted_is_near(direction, {.9977628593336694, -.066852647922878, 0}, 1e-8));
    }
  }
}

TEST_CASE("ray tracer: branches that weigh little are left out", "[ray_tracer][B55]") {
  const TracedScene box = whitted_scene(kMirrorBox);
  const Ray ray = whitted_towards({0.1, 0.2, -0.3}, {0.9, 0.4, 0.55});
  // 0.8^3 = 0.512, 0.8^4 = 0.4096.
  const WhittedRay seen = whitted_ray(box, ray, {.most_level = 1000, .least_weight = 0.5});
  CHECK(seen.scratch.reflected_rays == 3);
  CHECK(seen.tree.rays().back().end == RayEnd::weight);
  CHECK(seen.light.x == Approx(0.1 * (1 + 0.8 + 0.64 + 0.512)).epsilon(1e-6));
}

TEST_CASE("ray tracer: what a surface lets straight through is weighed with the rest of its branch", "[ray_tracer][B55]") {
  const TracedScene scene = whitted_scene(R"({"image": {"background": 1}, "ambient": 0, "materials": {"veil": {"diffuse": 0, "alpha": 0.75, "mirror": 0.5}},
    "objects": [{"shape": {"type": "plane"}, "material": "veil"}]})");
  const Ray ray{.origin = {0.1, 1, 0.1}, .direction = {0, -1, 0}};
  const WhittedRay whole = whitted_ray(scene, ray);
  CHECK(whole.light.x == Approx(0.75 * 0.5 + 0.25));
  CHECK(whitted_named(whole.tree, "R1")->weight.x == Approx(0.375));
  CHECK(whitted_named(whole.tree, "P1")->weight.x == Approx(0.25));
  CHECK(whitted_ray(scene, ray, {.least_weight = 0.3}).light.x == Approx(0.375));
  CHECK(whitted_ray(scene, ray, {.least_weight = 0.4}).light.x == 0);
}

TEST_CASE("ray tracer: light that is traced forwards hardly ever finds the eye", "[ray_tracer][B50]") {
  // From a lamp, mirrored by a ball: of 100,000 rays none goes through the eye, nor through a lens of a hundredth of the eye's
  // distance, as docs/ray_tracer.md has it. A tenth as many rays from the eye make a picture of it.
  const TracedScene scene = whitted_scene(R"({"materials": {"mirror": {"mirror": 1}}, "objects": [{"shape": {"type": "sphere"}, "material": "mirror"}]})");
  const RayTracer tracer(scene, {.most_level = 1});
  const glm::dvec3 lamp(3, 3, 0), eye(0, 0, 5);
  int through_lens = 0, through_eye = 0, met = 0;
  for (int i = 0; i < 100'000; ++i) {
    // Evenly over all directions, along a spiral.
    const double z = 1 - (2 * i + 1) / 100'000.0, angle = i * 2.399963229728653, radius = std::sqrt(1 - z * z);
    TraceScratch scratch;
    RayTree tree;
    tracer.radiance({.origin = lamp, .direction = {radius * std::cos(angle), radius * std::sin(angle), z}}, scratch, &tree);
    const TracedRay* mirrored = whitted_named(tree, "R1");
    if (!mirrored) continue;
    ++met;
    const double miss = glm::length(glm::cross(eye - mirrored->ray.origin, mirrored->ray.direction));
    through_lens += glm::dot(eye - mirrored->ray.origin, mirrored->ray.direction) > 0 && miss < 0.05;
    through_eye += miss < 1e-6;
  }
  CHECK(met == 1406);
  CHECK(through_eye == 0);
  CHECK(through_lens == 0);
}

}  // namespace tuberia::tracer
