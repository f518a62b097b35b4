// Depth-map shadows against segments to the light.

#include <catch2/catch.hpp>

#include "tests/shadows/shadow_scene.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia {

using test::kLamp;
using test::kSun;
using test::ShadowScene;

namespace {

struct Agreement {
  int compared = 0, shadowed = 0, near_edges = 0, wrong = 0;
  double share() const { return 1 - static_cast<double>(wrong) / compared; }
};

/// Whether V changes within two texels of a point, by rays through the map's texels to the point's tangent plane.
bool is_near_edge(const test::RayScene& rays, const ShadowScene& scene, const LightView& view, double texels, const glm::dvec3& point, const glm::dvec3& normal) {
  const bool directional = scene.light.kind == Light::Kind::directional;
  const double w = (glm::dmat4(view.map_from_world) * glm::dvec4(point, 1)).w;
  const auto lit_at = [&](double right, double down) {
    const glm::dvec3 beside = point + (glm::dvec3(view.right) * right + glm::dvec3(view.down) * down) * (w / texels);
    const glm::dvec3 l = test::to_light(scene.light, beside);
    // The ray through `beside` meets the tangent plane at beside + s l.
    const double s = glm::dot(point - beside, normal) / glm::dot(l, normal);
    return rays.is_visible(beside + (s + 1e-4) * l, directional ? l : (1 - s - 1e-4) * l, directional);
  };
  const bool here = lit_at(0, 0);
  for (int down = -2; down <= 2; ++down)
    for (int right = -2; right <= 2; ++right)
      if (lit_at(right, down) != here) return true;
  return false;
}

Agreement compare_with_rays(ShadowScene scene, const Light& light, int map_size, int picture_size) {
  scene.light = light;
  const LightView view = test::value_of(light_view(light, scene.bounds()));
  const ShadowMap map = test::shadow_map_of(scene, view, {.size = map_size});
  const Image<Rgba32F> drawn = test::light_terms_picture(scene, {.light = light, .shadow = map}, picture_size);
  const test::RayScene rays = scene.rays();
  Agreement agreement;
  for (int y = 0; y < picture_size; ++y)
    for (int x = 0; x < picture_size; ++x) {
      const test::Ray ray = test::pixel_ray(scene.eye, x, y, picture_size);
      const test::RayHit hit = rays.first_hit(ray);
      if (!hit) continue;
      const glm::dvec3 point = ray.at(hit.t), l = test::to_light(light, point);
      // Where a surface is turned away its light is 0 whatever V.
      if (glm::dot(hit.shading_normal, l) <= 0) continue;
      if (is_near_edge(rays, scene, view, map_size, point, hit.normal)) {
        ++agreement.near_edges;
        continue;
      }
      ++agreement.compared;
      const bool lit = rays.is_visible(point, l, light.kind == Light::Kind::directional);
      if (!lit) ++agreement.shadowed;
      if (lit != (drawn.at(x, y).r > 0.5f)) ++agreement.wrong;
    }
  return agreement;
}

}  // namespace

TEST_CASE("shadows: away from edges maps and rays agree, for lamps and for suns", "[shadows][A18][A14][C38]") {
  const std::pair<const char*, ShadowScene> scenes[] = {{"spheres", test::spheres_on_a_plane()}, {"box", test::box_on_a_plane()}, {"pole", test::thin_pole()}};
  for (const auto& [name, scene] : scenes)
    for (const Light& light : {kSun, kLamp}) {
      const Agreement agreement = compare_with_rays(scene, light, 512, 96);
      INFO(name << (light.kind == Light::Kind::directional ? ", sun: " : ", lamp: ") << agreement.wrong << " of " << agreement.compared << " wrong, " << agreement.shadowed << " in shadow, "
                << agreement.near_edges << " near edges");
      CHECK(agreement.share() >= 0.99);
      CHECK(agreement.shadowed > 10);
      CHECK(agreement.near_edges < agreement.compared / 10);
    }
}

}  // namespace tuberia
