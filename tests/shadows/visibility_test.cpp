// Depth-map shadows against segments to the light.

#include <catch2/catch.hpp>

#include "tests/support/shadow_scenes.hpp"

namespace tuberia {

using test::kLamp;
using test::kSun;

namespace {

struct Agreement {
  int compared = 0, shadowed = 0, near_edges = 0, wrong = 0;
  double share() const { return 1 - static_cast<double>(wrong) / compared; }
};

/// What a texel's sides span at a point, world units.
struct TexelSides {
  glm::dvec3 right, down;
};

TexelSides texel_at(const ShadowMap& map, const glm::dvec3& point) {
  const glm::dvec4 seen = glm::dmat4(map.map_from_world) * glm::dvec4(point, 1);
  if (map.depths->kind() != TextureKind::cube) return {glm::dvec3(map.texel_right) * seen.w, glm::dvec3(map.texel_down) * seen.w};
  const glm::dvec3 size = glm::abs(glm::dvec3(seen));
  const double largest = std::max({size.x, size.y, size.z}), texel = 2 * largest / map.depths->level(0).width;
  const int axis = size.z == largest ? 2 : size.y == largest ? 1 : 0;
  TexelSides sides{glm::dvec3(0), glm::dvec3(0)};
  sides.right[(axis + 1) % 3] = texel;
  sides.down[(axis + 2) % 3] = texel;
  return sides;
}

/// Whether V changes within two texels of a point, by rays through the map's texels to the point's tangent plane.
bool is_near_edge(const test::RayScene& rays, const Light& light, const TexelSides& texel, const glm::dvec3& point, const glm::dvec3& normal) {
  const bool directional = light.kind == Light::Kind::directional;
  const auto lit_at = [&](double right, double down) {
    const glm::dvec3 beside = point + texel.right * right + texel.down * down;
    const glm::dvec3 l = test::to_light(light, beside);
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

Agreement compare_with_rays(test::ShadowScene scene, const Light& light, int map_size, int picture_size) {
  scene.light = light;
  Pipeline pipeline({.threads = 1});
  const ShadowMap map = test::value_of(draw_shadow_map(pipeline, scene.draws(), light, scene.bounds(), {.size = map_size}));
  const Image<Rgba32F> drawn = test::visibility_picture(scene, map, picture_size);
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
      if (light.kind == Light::Kind::spot && glm::dot(glm::normalize(-l), glm::dvec3(light.axis)) < light.cos_outer) continue;
      if (is_near_edge(rays, light, texel_at(map, point), point, hit.normal)) {
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

void check_agreement(const char* name, const Agreement& agreement) {
  INFO(name << ": " << agreement.wrong << " of " << agreement.compared << " wrong, " << agreement.shadowed << " in shadow, " << agreement.near_edges << " near edges");
  CHECK(agreement.share() >= 0.99);
  CHECK(agreement.shadowed > 10);
  CHECK(agreement.near_edges < agreement.compared / 10);
}

}  // namespace

TEST_CASE("shadows: away from edges maps and rays agree, for lamps and for suns", "[shadows][A18][A14][C38]") {
  const std::pair<const char*, test::ShadowScene> scenes[] = {{"spheres", test::spheres_on_a_plane()}, {"box", test::box_on_a_plane()}, {"pole", test::thin_pole()}};
  for (const auto& [name, scene] : scenes)
    for (const Light& light : {kSun, kLamp}) {
      INFO((light.kind == Light::Kind::directional ? "sun" : "lamp"));
      check_agreement(name, compare_with_rays(scene, light, 512, 96));
    }
}

TEST_CASE("shadows: away from edges maps and rays agree, for a lamp among what it lights", "[shadows][A18][A14][C38]") {
  const Light lamp{.kind = Light::Kind::point, .towards = {0.1f, 1.7f, 0.2f}};
  const test::ShadowScene scene = test::room();
  REQUIRE_FALSE(light_view(lamp, scene.bounds()));
  check_agreement("room", compare_with_rays(scene, lamp, 512, 96));
  // And from where the corners of the room, and so the edges between the faces of the cube, are seen.
  test::ShadowScene from_below = scene;
  from_below.eye = test::eye_at({-2.9, 0.3, -2.9}, {1.5, 2.2, 1.5});
  check_agreement("room from below", compare_with_rays(from_below, lamp, 512, 96));
}

TEST_CASE("shadows: away from edges maps and rays agree, for a spot among what it lights", "[shadows][A18][A14][C38]") {
  const Light spot{.kind = Light::Kind::spot, .towards = {1.9f, 2.5f, 1.6f}, .axis = glm::normalize(glm::vec3(-2, -1.6f, -2.2f)), .cos_inner = 0.8f, .cos_outer = 0.8f};
  const test::ShadowScene scene = test::room();
  REQUIRE(light_view(spot, scene.bounds()));
  check_agreement("room", compare_with_rays(scene, spot, 512, 96));
}

}  // namespace tuberia
