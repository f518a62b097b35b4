// Perfect mirrors: what they add to the local model, and what a mirror sphere shows.

#include <catch2/catch.hpp>

#include <numbers>

#include "math/bump.hpp"
#include "math/camera.hpp"
#include "pipeline/programs/surface.hpp"
#include "scene/shapes/shapes.hpp"
#include "tests/support/environments.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/mesh_view.hpp"

namespace tuberia {
namespace {

using test::largest_component;
using test::radiance_of;

/// Nothing but the mirror image, kps times.
SurfaceUniforms pure_mirror(const EnvironmentMap& map, const glm::dvec3& eye, const glm::vec3& kps = glm::vec3(1)) {
  SurfaceUniforms uniforms;
  uniforms.reflection.ambient = uniforms.reflection.diffuse = glm::vec3(0);
  uniforms.environment = map;
  uniforms.mirror = kps;
  uniforms.eye = eye;
  return uniforms;
}

/// Each colour is the direction it comes from: 1/2 + d/2.
Surroundings direction_colours() {
  return {[](const glm::dvec3& d) { return 0.5 + 0.5 * d; }, 0.05};
}
glm::dvec3 direction_of(const Rgba32F& pixel) { return glm::normalize(2.0 * radiance_of(pixel) - 1.0); }

/// The three maps of one surroundings.
std::array<EnvironmentMap, 3> three_maps(const Surroundings& surroundings) {
  return {*cube_map(cube_of(surroundings, 128)), *sphere_map(sphere_map_of(surroundings, 512)), *panorama_map(panorama_of(surroundings, 512, 256))};
}

/// A unit sphere at the origin, seen from far up +z through a window of its middle plane.
struct DistantSphere {
  static constexpr int kSize = 65;
  static constexpr double kDistance = 200;
  Mesh mesh = *sphere_mesh({.radius = 1, .slices = 512, .stacks = 256});

  Image<Rgba32F> picture(const FragmentProgram& program, double left, double right, double bottom, double top, const PipelineOptions& options = {.threads = 1}) const {
    Camera camera{.eye = {0, 0, kDistance}};
    const double scale = 1 / kDistance;  // the window stands at distance 1
    camera.view = {.left = left * scale, .right = right * scale, .bottom = bottom * scale, .top = top * scale, .near_distance = 1, .far_distance = 300};
    test::Studio studio(test::float_canvas(kSize, options));
    PipelineState state;
    state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
    state.culling.cull = CullFace::back;
    studio.draw(test::view_of(mesh), program, state);
    return studio.target().linear_image();
  }
};

}  // namespace

TEST_CASE("mirror: kps blends the environment in linearly", "[environment][A27]") {
  const DistantSphere sphere;
  const EnvironmentMap map = three_maps(direction_colours())[0];
  const auto with_kps = [&](const glm::vec3& kps) {
    SurfaceUniforms uniforms = pure_mirror(map, {0, 0, DistantSphere::kDistance}, kps);
    uniforms.reflection.diffuse = {0.4f, 0.3f, 0.2f};
    uniforms.reflection.ambient = glm::vec3(0.5f);
    uniforms.lights = {{.light = {.towards = {0.6f, 0, 0.8f}}, .shadow = {}, .projected = {}}};
    return sphere.picture(surface(uniforms), -1.1, 1.1, -1.1, 1.1);
  };
  const Image<Rgba32F> without = with_kps(glm::vec3(0)), whole = with_kps(glm::vec3(1));
  for (const glm::vec3 kps : {glm::vec3(0.25f), glm::vec3(0.5f), glm::vec3(0, 0.75f, 1)}) {
    const Image<Rgba32F> part = with_kps(kps);
    double most = 0;
    for (std::size_t i = 0; i < part.pixels().size(); ++i) {
      const glm::dvec3 low = radiance_of(without.pixels()[i]), high = radiance_of(whole.pixels()[i]);
      most = std::max(most, largest_component(radiance_of(part.pixels()[i]) - (low + glm::dvec3(kps) * (high - low))));
    }
    CHECK(most < 1e-6);
  }
  // The whole mirror adds just what the environment shows there.
  const glm::dvec3 added = radiance_of(whole.at(32, 32)) - radiance_of(without.at(32, 32));
  CHECK(largest_component(added - glm::dvec3(0.5, 0.5, 1)) < 5e-3);
}

TEST_CASE("mirror: a sphere shows the eye's side in its middle, what is behind it at its edge", "[environment][A28][A29][A32][A33]") {
  const DistantSphere sphere;
  for (const EnvironmentMap& map : three_maps(direction_colours())) {
    const FragmentProgram mirror = surface(pure_mirror(map, {0, 0, DistantSphere::kDistance}));
    INFO("kind " << static_cast<int>(map.kind));
    test::for_every_machine([&](InstructionSet set, Precision precision) {
      const PipelineOptions options{.threads = 1, .instruction_set = set, .precision = precision};
      const Image<Rgba32F> whole = sphere.picture(mirror, -1.1, 1.1, -1.1, 1.1, options);
      CHECK(glm::dot(direction_of(whole.at(32, 32)), glm::dvec3(0, 0, 1)) > 0.9999);
      // 45 degrees up its slope the sphere shows what is right above, and beside it.
      const auto at = [](double x) { return static_cast<int>((x + 1.1) / 2.2 * DistantSphere::kSize); };
      CHECK(glm::dot(direction_of(whole.at(32, at(-std::sqrt(0.5)))), glm::dvec3(0, 1, 0)) > 0.995);
      CHECK(glm::dot(direction_of(whole.at(at(std::sqrt(0.5)), 32)), glm::dvec3(1, 0, 0)) > 0.995);

      // The silhouette, magnified: from one half thousandth of the radius inside it on, r is forward within 4 degrees;
      // a ball of 512 texels has its outermost texel for all within 2 acos(1 - 2 / 512) of that, 10.2 degrees.
      const double degrees = map.kind == EnvironmentMap::Kind::sphere ? 10.2 : 4;
      const Image<Rgba32F> edge = sphere.picture(mirror, 0.9985, 1.0015, -0.001, 0.001, options);
      int x = DistantSphere::kSize - 1;
      while (x > 0 && edge.at(x, 32).a == 0) --x;
      REQUIRE(x > 16);
      CHECK(glm::dot(direction_of(edge.at(x, 32)), glm::dvec3(0, 0, -1)) > std::cos(degrees * std::numbers::pi / 180));
    });
  }
}

// notes 16.5: r from the bump-perturbed normal; pattern, relief and mirror at once.
TEST_CASE("mirror: relief bends the mirror direction, and the pattern stays below", "[environment][A36][A27]") {
  const Mesh ground = *plane_mesh({.width = 2, .depth = 2});
  Camera camera{.eye = {0.3, 2, 1.5}};
  camera.view = *perspective_volume(0.6, 1, 0.1, 10);
  EnvironmentMap map = three_maps(direction_colours())[0];
  map.sampler.mipmaps = MipmapFilter::none;
  constexpr int kSize = 48;
  const auto picture = [&](float kps) {
    SurfaceUniforms uniforms = pure_mirror(map, camera.eye, glm::vec3(kps));
    uniforms.reflection.ambient = glm::vec3(1);
    uniforms.ambient_light = glm::vec3(0.5f);
    uniforms.colour.pattern = {.kind = Pattern::Kind::checker, .first = {1, 0.5f, 0}, .second = {0, 0.25f, 1}, .scale = 4};
    uniforms.bump = {.kind = BumpMap::Kind::waves, .texture = nullptr, .sampler = {}, .gain = 0.05f, .scale = 3};
    test::Studio studio(test::float_canvas(kSize));
    PipelineState state;
    state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
    studio.draw(test::view_of(ground), surface(uniforms), state);
    return studio.target().linear_image();
  };
  const Image<Rgba32F> matt = picture(0), glossy = picture(0.5f);
  double most = 0, bent = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      if (matt.at(x, y).a == 0) continue;
      const CameraBasis basis = *camera_basis(camera.eye, camera.point_of_interest, camera.up);
      const glm::dvec2 at = ((glm::dvec2(x, y) + 0.5) / static_cast<double>(kSize) * 2.0 - 1.0) * glm::dvec2(camera.view.right, -camera.view.top);
      const glm::dvec3 ray = glm::normalize(at.x * basis.u + at.y * basis.v - camera.view.near_distance * basis.w);
      const glm::dvec3 point = camera.eye - ray * (camera.eye.y / ray.y);
      const glm::dvec2 slope = 0.05 * waves({point.x / 2 + 0.5, point.z / 2 + 0.5}, 3).slope;
      const glm::dvec3 n = perturbed_normal({{2, 0, 0}, {0, 0, 2}, {0, 1, 0}}, slope);
      const glm::dvec3 r = ray - 2 * glm::dot(ray, n) * n;
      most = std::max(most, largest_component(2.0 * (radiance_of(glossy.at(x, y)) - radiance_of(matt.at(x, y))) - (0.5 + 0.5 * r)));
      bent = std::max(bent, glm::length(r - glm::dvec3(ray.x, -ray.y, ray.z)));
    }
  CHECK(most < 2e-3);
  CHECK(bent > 0.3);
  const auto is_one_of_both = [](const Rgba32F& pixel) { return pixel.r > 0.45f || pixel.b > 0.45f; };
  CHECK((is_one_of_both(matt.at(24, 24)) && is_one_of_both(matt.at(20, 30))));
}

TEST_CASE("mirror: a mirror sphere in the sky is the same by each map", "[environment][A28][A33][A32]") {
  const DistantSphere sphere;
  const Surroundings sky = test::sunless_sky();
  const double window = 1.1;
  for (EnvironmentMap map : three_maps(sky)) {
    map.sampler.mipmaps = MipmapFilter::none;  // compared with points of the sky, not with what a pixel covers
    const Image<Rgba32F> seen = sphere.picture(surface(pure_mirror(map, {0, 0, DistantSphere::kDistance})), -window, window, -window, window);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < DistantSphere::kSize; ++y)
      for (int x = 0; x < DistantSphere::kSize; ++x) {
        const glm::dvec2 at = (glm::dvec2(x, DistantSphere::kSize - 1 - y) + 0.5) / static_cast<double>(DistantSphere::kSize) * 2.0 * window - window;
        if (glm::dot(at, at) > 0.9 || seen.at(x, y).a == 0) continue;
        // Nearly parallel rays: the sphere is hit where they pass the middle plane, but for the distance.
        const glm::dvec3 n(at, std::sqrt(1 - glm::dot(at, at))), v = glm::normalize(glm::dvec3(0, 0, DistantSphere::kDistance) - n);
        const glm::dvec3 apart = glm::abs(radiance_of(seen.at(x, y)) - sky.radiance(glm::normalize(2 * glm::dot(n, v) * n - v)));
        sum += (apart.x + apart.y + apart.z) / 3;
        ++count;
      }
    INFO("kind " << static_cast<int>(map.kind));
    REQUIRE(count > 1000);
    CHECK(255 * sum / count < 2);
  }
}

}  // namespace tuberia
