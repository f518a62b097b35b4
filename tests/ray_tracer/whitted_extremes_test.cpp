// Rays, scenes and limits that are none, or more than anyone needs.

#include <sys/resource.h>

#include <cmath>
#include <limits>

#include "reference/ray_tracer/render.hpp"
#include "tests/ray_tracer/whitted_scenes.hpp"

namespace tuberia::tracer {
namespace {

bool is_light(const glm::dvec3& light) { return std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z) && std::min({light.x, light.y, light.z}) >= 0; }

/// Two mirrors that face each other, in a hall of them.
constexpr const char* kHall = R"({"ambient": 0.5, "lights": [{"type": "point", "position": [0, 0.5, 0], "shadow": {}}],
  "materials": {"mirror": {"diffuse": 0.1, "mirror": 1}}, "objects": [{"shape": {"type": "cube"}, "material": "mirror"}]})";

/// Balls of glass that mirror, too, in a box of mirrors: every hit of a ball is two rays.
constexpr const char* kGlassHall = R"({"ambient": 0.5, "lights": [{"type": "point", "position": [0, 0.9, 0], "shadow": {}}],
  "materials": {"mirror": {"diffuse": 0.1, "mirror": 0.9}, "glass": {"diffuse": 0.05, "mirror": 0.5, "transmission": 0.5}},
  "objects": [{"shape": {"type": "cube"}, "material": "mirror"}, {"shape": {"type": "sphere", "radius": 0.4}, "material": "glass", "transforms": [{"translate": [0.5, 0, 0]}]},
              {"shape": {"type": "sphere", "radius": 0.4}, "material": "glass", "transforms": [{"translate": [-0.5, 0, 0]}]}]})";

}  // namespace

TEST_CASE("ray tracer: depth 0 is the local model alone, depth 1000 ends", "[ray_tracer][extremes]") {
  const TracedScene hall = whitted_scene(kHall);
  const Ray ray = whitted_towards({0, 0, 0}, {1, 0.3, 0.2});
  const WhittedRay shallow = whitted_ray(hall, ray, {.most_level = 0});
  CHECK(shallow.scratch.rays_of_this_eye_ray == 1);
  const WhittedRay deep = whitted_ray(hall, ray, {.most_level = 1000});
  CHECK(deep.scratch.reflected_rays == 1000);
  CHECK(is_light(deep.light));
  CHECK(deep.tree.rays().back().level <= 1001);
  CHECK(svg_of(deep.tree).size() > 100'000);
}

TEST_CASE("ray tracer: a hall of glass ends when its rays are used up, and says so", "[ray_tracer][extremes]") {
  const TracedScene hall = whitted_scene(kGlassHall);
  const RayTracer tracer(hall, {.most_level = 1000});
  TraceScratch scratch;
  CHECK(is_light(tracer.radiance(whitted_towards({0, 0, 0.9}, {0.4, 0.1, 0}), scratch)));
  CHECK(scratch.rays_of_this_eye_ray == tracer.settings().most_rays);
  CHECK(scratch.unfollowed_rays > 0);
  // Each ray that was not followed had a parent that was.
  CHECK(scratch.unfollowed_rays <= tracer.settings().most_rays);

  // With a weight that matters it ends by itself.
  const RayTracer adaptive(hall, {.most_level = 1000, .least_weight = 0.01});
  TraceScratch other;
  CHECK(is_light(adaptive.radiance(whitted_towards({0, 0, 0.9}, {0.4, 0.1, 0}), other)));
  CHECK(other.unfollowed_rays == 0);
  CHECK(other.rays_of_this_eye_ray < tracer.settings().most_rays);
}

TEST_CASE("ray tracer: a recursion 1000 deep fits the stacks of all threads", "[ray_tracer][extremes]") {
  // Workers of oneTBB have 4 MB by default. The address sanitizer puts margins around everything that lies on a stack.
#if defined(__SANITIZE_ADDRESS__)
  constexpr int kLevels = 300;
#else
  constexpr int kLevels = 1000;
#endif
  const TracedScene hall = whitted_scene(kHall);
  Workers workers(4);
  std::vector<glm::dvec3> light(64);
  const RayTracer tracer(hall, {.most_level = kLevels});
  parallel_for(workers, 64, [&](std::int64_t i, int) {
    TraceScratch scratch;
    light[static_cast<std::size_t>(i)] = tracer.radiance(whitted_towards({0, 0, 0}, {1, 0.1, 0.01 * static_cast<double>(i)}), scratch);
  });
  for (const glm::dvec3& each : light) CHECK(is_light(each));
}

TEST_CASE("ray tracer: rays that are none bring nothing", "[ray_tracer][case-65][extremes]") {
  const TracedScene hall = whitted_scene(kGlassHall);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Ray& ray : {Ray{.direction = {0, 0, 0}}, Ray{.origin = {nan, 0, 0}}, Ray{.direction = {nan, 0, 1}}, Ray{.origin = {kInfinity, 0, 0}}, Ray{.direction = {kInfinity, 0, 0}},
                         Ray{.t_min = 2, .t_max = 1}, Ray{.t_min = nan}, Ray{.t_max = nan}}) {
    const WhittedRay seen = whitted_ray(hall, ray);
    CHECK(seen.light == glm::dvec3(0));
    CHECK(seen.tree.rays().empty());
    CHECK(seen.scratch.rays_of_this_eye_ray == 0);
    TraceScratch scratch;
    CHECK_FALSE(RayTracer(hall).first_hit(ray, scratch));
  }
}

TEST_CASE("ray tracer: refractive indices that are none are refused or bend nothing", "[ray_tracer][extremes][bad-input]") {
  SceneDescription description = whitted_description(R"({"image": {"background": 0.5}, "materials": {"glass": {"transmission": 0.9}},
    "objects": [{"shape": {"type": "sphere"}, "material": "glass"}]})");
  for (const float index : {-1.5f, 0.0f, 1e30f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    CAPTURE(index);
    description.materials.front().refractive_index = glm::vec3(index);
    Workers workers(1);
    const auto scene = TracedScene::create(description, workers);
    if (!scene) {
      CHECK(scene.error().message.find("glass") != std::string::npos);
      continue;
    }
    CHECK(is_light(whitted_ray(*scene, whitted_towards({0, 0.3, 4}, {0, 0, 0}), {.most_level = 20}).light));
  }
  // The largest and the smallest that are accepted.
  for (const float index : {1e-3f, 1e3f}) {
    description.materials.front().refractive_index = glm::vec3(index);
    const TracedScene scene = whitted_scene(description);
    for (int i = 0; i < 50; ++i) CHECK(is_light(whitted_ray(scene, whitted_towards({0, 0.3, 4}, {0, 0.025 * i, 0}), {.most_level = 20}).light));
  }
}

TEST_CASE("ray tracer: a scene without lights shows its ambient light, an empty one its background", "[ray_tracer][extremes]") {
  const TracedScene dark = whitted_scene(R"({"ambient": 0.25, "lights": [], "materials": {"grey": {"diffuse": 0.5}}, "objects": [{"shape": {"type": "sphere"}, "material": "grey"}]})");
  CHECK(whitted_is_near(whitted_ray(dark, whitted_towards({0, 0, 5}, {0, 0, 0})).light, glm::dvec3(0.125), 1e-7));
  const TracedScene empty = whitted_scene(R"({"image": {"background": 0.75}, "objects": []})");
  CHECK(whitted_is_near(whitted_ray(empty, whitted_towards({0, 0, 5}, {0, 0, 0})).light, glm::dvec3(0.75), 1e-7));
}

TEST_CASE("ray tracer: the eye may stand inside a body, or on its surface", "[ray_tracer][extremes]") {
  const TracedScene ball = whitted_scene(R"({"image": {"background": 0.5}, "ambient": 0.25, "lights": [{"type": "directional", "shadow": {}}], "materials": {"grey": {"diffuse": 0.5}, "glass": {"diffuse": 0, "transmission": 0.5}},
    "objects": [{"name": "grey", "shape": {"type": "sphere"}, "material": "grey"}, {"name": "glass", "shape": {"type": "sphere"}, "material": "glass", "transforms": [{"translate": [5, 0, 0]}]}]})");
  // Of what is opaque the outside is lit, from whichever side it is seen, as the pipeline has it.
  CHECK(whitted_ray(ball, {.origin = {0.1, 0.2, 0.3}, .direction = {0, 0, -1}}).light.x == Approx(0.125));
  CHECK(whitted_ray(ball, {.origin = {0, 0, 0.3}, .direction = {0, 0, 1}}).light.x == Approx(0.625));
  // Out of glass.
  const WhittedRay out = whitted_ray(ball, {.origin = {5, 0, 0}, .direction = {0, 0, 1}});
  CHECK(out.light.x == Approx(0.25));
  CHECK(out.scratch.transmitted_rays == 1);
  for (const glm::dvec3& direction : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0)}) {
    CHECK(is_light(whitted_ray(ball, {.origin = {1, 0, 0}, .direction = direction}).light));
    CHECK(is_light(whitted_ray(ball, {.origin = {6, 0, 0}, .direction = direction}).light));
  }
}

TEST_CASE("ray tracer: a lamp on a surface, or at the point that is seen, gives no number that is none", "[ray_tracer][extremes]") {
  for (const char* falloff : {"none", "linear", "inverse-square"}) {
    const TracedScene scene = whitted_scene(whitted_text(R"({"lights": [{"type": "point", "position": [0, 0, 0], "look_at": [0, -1, 0], "shadow": {}, "falloff": ")", falloff, R"("}],
      "materials": {"shiny": {"specular": 0.5}}, "objects": [{"shape": {"type": "plane"}, "material": "shiny"}]})"));
    for (const glm::dvec3& point : {glm::dvec3(0), glm::dvec3(1e-12, 0, 0), glm::dvec3(0.5, 0, 0)}) CHECK(is_light(whitted_ray(scene, whitted_towards({0, 2, 0}, point)).light));
  }
}

}  // namespace tuberia::tracer
