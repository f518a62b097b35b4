// Surfaces that must not shadow themselves, and light that goes through glass.

#include <cmath>

#include "tests/ray_tracer/whitted_scenes.hpp"

namespace tuberia::tracer {
namespace {

/// A ball and a tilted cube side by side, neither in the other's light, anywhere and of any size.
TracedScene convex_pair(double scale, double distance) {
  const auto placed = [&](double x, const char* turned) {
    return whitted_text(R"(, "transforms": [)", turned, R"({"scale": [)", scale, ",", scale, ",", scale, R"(]}, {"translate": [)", x * scale + distance, ",", distance, ",0]}]}");
  };
  return whitted_scene(whitted_text(R"({"ambient": 0, "lights": [{"type": "directional", "towards": [0, 1, 2], "shadow": {}}], "materials": {"white": {"model": "lambert", "diffuse": 1}},
    "objects": [{"shape": {"type": "sphere"}, "material": "white")", placed(-2, ""), R"(,{"shape": {"type": "cube"}, "material": "white")",
                                    placed(2, R"({"rotate": 40, "about": [1, 2, 3]}, )"), "]}"));
}

/// Points that face the light and are dark, and those that are lit, seen from the side of the light.
std::pair<int, int> speckles(const TracedScene& scene, double scale, double distance, const TraceSettings& settings) {
  const RayTracer tracer(scene, settings);
  TraceScratch scratch;
  const glm::dvec3 light = glm::normalize(glm::dvec3(0, 1, 2));
  int dark = 0, lit = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 120; ++x) {
      const glm::dvec3 through(scale * (-4 + (x + 0.5) / 15) + distance, scale * (-2 + (y + 0.5) / 15) + distance, 0);
      const Ray ray = whitted_towards(through + scale * glm::dvec3(0.3, 0.4, 8), through);
      const Hit hit = tracer.first_hit(ray, scratch);
      if (!hit) continue;
      const double cosine = glm::dot(scene.geometry().surface(ray, hit).normal, light);
      // Where light grazes, a point's last bits decide which side of the light it is on.
      if (cosine < 1e-4) continue;
      ++(tracer.radiance(ray, scratch).x > 0.5 * cosine ? lit : dark);
    }
  return {dark, lit};
}

}  // namespace

TEST_CASE("ray tracer: no remedy, and surfaces shadow themselves in speckles; each remedy, and none does", "[ray_tracer][B59]") {
  const TracedScene scene = convex_pair(1, 0);
  const auto [dark, lit] = speckles(scene, 1, 0, {.remedy = AcneRemedy::none});
  // As docs/ray_tracer.md has it.
  CHECK(dark == 765);
  CHECK(dark + lit == 1995);
  for (const AcneRemedy remedy : {AcneRemedy::moved_origin, AcneRemedy::tolerance, AcneRemedy::skip_convex}) {
    CAPTURE(static_cast<int>(remedy));
    CHECK(speckles(scene, 1, 0, {.remedy = remedy}).first == 0);
    CHECK(speckles(scene, 1, 0, {.remedy = remedy, .tolerance = 1e-5}).first == 0);  // the notes'
  }
}

TEST_CASE("ray tracer: no surface shadows itself at any size, anywhere", "[ray_tracer][B59]") {
  for (const double scale : {1e-3, 1.0, 1e3, 1e6})
    for (const double distance : {0.0, 100 * scale, -3e4 * scale}) {
      CAPTURE(scale, distance);
      const TracedScene scene = convex_pair(scale, distance);
      const auto [dark, lit] = speckles(scene, scale, distance, {});
      CHECK(dark == 0);
      CHECK(lit > 1000);
    }
}

TEST_CASE("ray tracer: a ring is shadowed by itself only where it stands in its own light", "[ray_tracer][B59]") {
  // Seen from the light, a torus is lit wherever it is seen.
  const TracedScene scene = whitted_scene(R"({"ambient": 0, "lights": [{"type": "directional", "towards": [0.3, 1, 0.5], "shadow": {}}],
    "materials": {"white": {"model": "lambert", "diffuse": 1}}, "objects": [{"shape": {"type": "torus"}, "material": "white"}]})");
  const glm::dvec3 light = glm::normalize(glm::dvec3(0.3, 1, 0.5)), across = glm::normalize(glm::cross(light, glm::dvec3(0, 0, 1))), along = glm::cross(light, across);
  const RayTracer tracer(scene);
  TraceScratch scratch;
  int dark = 0, lit = 0;
  for (int y = -60; y < 60; ++y)
    for (int x = -60; x < 60; ++x) {
      const Ray ray{.origin = 6.0 * light + (x + 0.5) / 40 * across + (y + 0.5) / 40 * along, .direction = -light};
      const Hit hit = tracer.first_hit(ray, scratch);
      if (hit && glm::dot(scene.geometry().surface(ray, hit).normal, light) > 1e-3) ++(tracer.radiance(ray, scratch).x > 0 ? lit : dark);
    }
  CHECK(dark == 0);
  CHECK(lit > 1000);
}

TEST_CASE("ray tracer: the shadow of a glass ball is darkest in its middle", "[ray_tracer][B76]") {
  const TracedScene scene = whitted_scene(R"({"ambient": 0, "lights": [{"type": "directional", "towards": [0, 1, 0], "shadow": {}}],
    "materials": {"floor": {"model": "lambert", "diffuse": 1}, "glass": {"diffuse": 0, "transmission": [0.9, 0.8, 0.7], "refractive_index": 1.3, "shadow_density": 0.5}},
    "objects": [{"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "floor"},
                {"shape": {"type": "sphere"}, "material": "glass", "transforms": [{"translate": [0, 2, 0]}]}]})");
  const auto floor_at = [&](double radius) { return whitted_ray(scene, whitted_towards({radius + 4, 0.5, 0}, {radius, 0, 0})).light; };
  double last = 0;
  for (int i = 0; i < 50; ++i) {
    const double radius = i / 50.0, path = 2 * std::sqrt(1 - radius * radius);
    const glm::dvec3 light = floor_at(radius);
    CAPTURE(radius);
    CHECK(whitted_is_near(light, glm::dvec3(0.9, 0.8, 0.7) * std::exp(-0.5 * path), 1e-6));
    CHECK(light.x > last);
    last = light.x;
  }
  CHECK(floor_at(1.001).x == Approx(1));
}

TEST_CASE("ray tracer: light goes through every body in its way, and out of the one that it shines in", "[ray_tracer][B76]") {
  const auto scene = [](const char* more) {
    return whitted_scene(whitted_text(R"({"ambient": 0, "lights": [{"type": "directional", "towards": [0, 1, 0], "shadow": {}}],
      "materials": {"floor": {"model": "lambert", "diffuse": 1}, "glass": {"model": "lambert", "diffuse": 1, "transmission": 0.5, "refractive_index": 1, "shadow_density": 0.25}, "wood": {"diffuse": 1}, "veil": {"alpha": 0.75}},
      "objects": [{"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "floor"},
                  {"name": "ball", "shape": {"type": "sphere"}, "material": "glass", "transforms": [{"translate": [0, 2, 0]}]})", more, "]}"));
  };
  const auto floor_of = [&](const char* more) { return whitted_ray(scene(more), whitted_towards({4, 0.5, 0}, {0, 0, 0})).light.x; };
  const double one = 0.5 * std::exp(-0.25 * 2);
  CHECK(floor_of("") == Approx(one));
  CHECK(floor_of(R"(,{"shape": {"type": "sphere"}, "material": "glass", "transforms": [{"translate": [0, 7, 0]}]})") == Approx(one * one));
  CHECK(floor_of(R"(,{"shape": {"type": "plane"}, "material": "veil", "transforms": [{"translate": [0, 7, 0]}]})") == Approx(one * 0.25));
  CHECK(floor_of(R"(,{"shape": {"type": "sphere"}, "material": "wood", "transforms": [{"translate": [0, 7, 0]}]})") == 0);
  // A sheet has no inside: kt alone, from either side.
  CHECK(floor_of(R"(,{"shape": {"type": "plane"}, "material": "glass", "transforms": [{"translate": [0, 7, 0]}]})") == Approx(one * 0.5));

  // The bottom of the ball is lit from above through all of it: kt once, and the whole path; seen through the top, which takes kt.
  const WhittedRay inside = whitted_ray(scene(""), {.origin = {0, 5, 0}, .direction = {0, -1, 0}}, {.most_level = 1});
  const TracedRay* bottom = whitted_named(inside.tree, "T1");
  REQUIRE(bottom);
  CHECK(bottom->light.x == Approx(one));
  CHECK(inside.light.x == Approx(1 + 0.5 * one));
}

TEST_CASE("ray tracer: a sheet that transmits is lit alike on either side", "[ray_tracer][B76]") {
  // With an index of 1 it is kd cos + kt times the background behind it, as the pipeline draws it, whichever way it faces.
  const auto seen = [](const char* shape, double kt, double side) {
    const TracedScene scene = whitted_scene(whitted_text(R"({"image": {"background": 0.4}, "ambient": 0, "lights": [{"type": "point", "position": [0, 0, )", 3 * side,
      R"(], "intensity": 0.75, "shadow": {}}], "materials": {"pane": {"model": "lambert", "diffuse": 1, "transmission": )", kt, R"(, "refractive_index": 1, "shadow_density": 0.5}},
      "objects": [{"shape": {)", shape, R"(}, "material": "pane", "transforms": [{"rotate": 90, "about": [1, 0, 0]}]}]})"));
    return whitted_ray(scene, whitted_towards({2, 0.5, 4 * side}, {0.3, 0.2, 0})).light.x;
  };
  const double cosine = 3 / glm::length(glm::dvec3(0.3, 0.2, 3));
  for (const char* shape : {R"("type": "plane")", R"("type": "disc")"})
    for (const double kt : {0.25, 1.0})
      for (const double side : {1.0, -1.0}) {
        CAPTURE(shape, kt, side);
        CHECK(seen(shape, kt, side) == Approx(0.75 * cosine + kt * 0.4));
      }
}

TEST_CASE("ray tracer: a body around the lamp takes kt, and its density as far as the lamp", "[ray_tracer][B76]") {
  const auto scene_of = [](const char* shape, double density, double height, double turned) {
    return whitted_scene(whitted_text(R"({"ambient": 0, "lights": [{"type": "point", "position": [0, )", height, R"(, 0], "shadow": {}}],
      "materials": {"floor": {"model": "lambert", "diffuse": 1}, "glass": {"model": "lambert", "diffuse": 1, "transmission": 0.8, "refractive_index": 1, "shadow_density": )", density, R"(}},
      "objects": [{"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "floor"},
                  {"shape": {)", shape, R"(}, "material": "glass", "transforms": [{"rotate": )", turned, R"(, "about": [1, 0, 0]}, {"translate": [0, 3, 0]}]}]})"));
  };
  const auto floor_of = [&](const char* shape, double density, double height, double x = 0, double turned = 0) {
    const double cosine = height / glm::length(glm::dvec3(x, height, 0));
    return whitted_ray(scene_of(shape, density, height, turned), whitted_towards({4, 0.5, 0}, {x, 0, 0})).light.x / cosine;
  };
  const char* const ball = R"("type": "sphere")";
  CHECK(floor_of(ball, 0, 3) == Approx(0.8));
  CHECK(floor_of(ball, 3, 3) == Approx(0.8 * std::exp(-3.0)));                    // the lamp in the middle: one unit of glass
  CHECK(floor_of(ball, 3, 3, 1) == Approx(0.8 * std::exp(-3.0)));
  CHECK(floor_of(ball, 3, 3.5) == Approx(0.8 * std::exp(-3 * 1.5)));
  CHECK(floor_of(ball, 3, 7) == Approx(0.8 * std::exp(-3 * 2.0)));                // the lamp above the ball
  CHECK(floor_of(R"("type": "plane")", 3, 7) == Approx(0.8));                     // a sheet has no inside, from behind
  CHECK(floor_of(R"("type": "plane")", 3, 7, 0, 180) == Approx(0.8));             // nor from the front

  // The inside of the ball that the lamp is in: light comes through no surface.
  const WhittedRay bottom = whitted_ray(scene_of(ball, 3, 3.5, 0), {.origin = {0, 3, 0}, .direction = {0, -1, 0}}, {.most_level = 0});
  CHECK(bottom.light.x == Approx(std::exp(-3 * 1.5)));
}

TEST_CASE("ray tracer: behind a surface others at the same place are met", "[ray_tracer][C40][B76]") {
  const char* const veil = R"({"shape": {"type": "plane"}, "material": "veil", "transforms": [{"translate": [0, 1, 0]}]})";
  const char* const lid = R"({"shape": {"type": "plane"}, "material": "lid", "transforms": [{"translate": [0, 1, 0]}]})";
  const auto scene = [](const char* first, const char* second, AcceleratorKind kind, SurfaceKind surfaces) {
    return whitted_scene(whitted_text(R"({"image": {"background": 100}, "ambient": 1, "lights": [{"type": "directional", "towards": [0, 1, 0], "shadow": {}}],
      "materials": {"floor": {"model": "lambert", "diffuse": 1, "ambient": 0}, "veil": {"alpha": 0.5, "ambient": 0.5, "diffuse": 0, "specular": 0}, "lid": {"ambient": 0.25, "diffuse": 0, "specular": 0}},
      "objects": [)", first, ",", second, R"(, {"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "floor"}]})"), {.surfaces = surfaces, .accelerator = kind});
  };
  for (const SurfaceKind surfaces : {SurfaceKind::exact, SurfaceKind::tessellated})
    for (const AcceleratorKind kind : {AcceleratorKind::none, AcceleratorKind::bounding_spheres, AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree}) {
      CAPTURE(static_cast<int>(kind), static_cast<int>(surfaces));
      const Ray from_above{.origin = {0.1, 4, 0.2}, .direction = {0, -1, 0}}, at_floor = whitted_towards({4, 0.5, 0}, {0.1, 0, 0.2});
      // The first of the two is seen first: half of the veil and half of the lid, or the lid alone.
      CHECK(whitted_ray(scene(veil, lid, kind, surfaces), from_above).light.x == Approx(0.5 * 0.5 + 0.5 * 0.25));
      CHECK(whitted_ray(scene(lid, veil, kind, surfaces), from_above).light.x == Approx(0.25));
      // No light leaks through the lid, and two veils take twice.
      CHECK(whitted_ray(scene(veil, lid, kind, surfaces), at_floor).light.x == 0);
      CHECK(whitted_ray(scene(lid, veil, kind, surfaces), at_floor).light.x == 0);
      CHECK(whitted_ray(scene(veil, veil, kind, surfaces), at_floor).light.x == Approx(0.25));
    }
}

}  // namespace tuberia::tracer
