// Scenes with numbers that nobody would choose: refused, or traced to an end.

#include <cctype>
#include <cmath>

#include "reference/ray_tracer/ray_tracer.hpp"
#include "tests/ray_tracer/traced_scene_support.hpp"

namespace tuberia::tracer::traced_test {
namespace {

/// Of every kind of shape, material and light a small one. Numbers with a point may be changed, counts have none.
constexpr const char* kMutableScene = R"({
  "image": {"width": 16, "height": 16, "background": 0.5}, "camera": {"eye": [0.0, 1.5, 6.0], "look_at": [0.0, 0.5, 0.0], "near": 0.2, "far": 50.0, "fovy_degrees": 50.0}, "ambient": 0.3,
  "lights": [{"type": "directional", "towards": [1.0, 2.0, 3.0], "intensity": 0.5, "shadow": {}, "look_at": [0.0, 0.0, 1.0], "projection": {"texture": "squares", "up": [0.0, 0.0, 1.0], "height": 20.0}},
    {"type": "spot", "position": [-1.0, 4.0, 1.0], "look_at": [0.0, 0.0, 0.5], "cone_degrees": 40.5, "full_cone_degrees": 20.5, "falloff": "linear", "falloff_distance": 2.0, "shadow": {}},
    {"type": "area", "position": [0.0, 5.0, 0.0], "edge_u": [1.0, 0.0, 1.0], "edge_v": [-1.0, 0.0, 1.0], "falloff": "inverse-square", "intensity": 90.0}],
  "textures": {"squares": {"source": "random-squares", "size": 16, "anisotropy": 4.0}, "ramp": {"source": "gradient", "size": 16, "level_rule": "distance", "texel_distance": 3.0}},
  "materials": {"mirror": {"model": "blinn-phong", "mirror": 0.5, "exponent": 20.0, "specular": 0.4, "bump": {"type": "waves", "gain": 0.1, "scale": 6.0}},
    "glass": {"transmission": 0.9, "refractive_index": 1.3, "shadow_density": 0.5}, "metal": {"model": "cook-torrance", "specular": 1.0, "roughness": 0.2, "refractive_index": 0.7},
    "film": {"alpha": 0.5, "texture": "ramp", "mapping": {"repeat": [2.0, 3.0]}}, "wood": {"pattern": {"type": "wood", "scale": 4.0, "turbulence": 0.3}},
    "globe": {"texture": "squares", "mapping": {"type": "sphere", "pole": [0.0, 1.0, 0.0], "equator": [1.0, 0.0, 0.0], "repeat": [2.0, 1.0]}, "bump": {"type": "height-texture", "texture": "ramp", "gain": 0.2}}},
  "environment": {"source": "sky", "rotation_degrees": 30.0, "sky": {"sun_towards": [0.0, 1.0, 1.0], "sun_degrees": 3.0, "cloudiness": 0.4}},
  "objects": [{"shape": {"type": "infinite-plane"}, "material": "wood", "transforms": [{"translate": [0.0, -1.0, 0.0]}]},
    {"shape": {"type": "cube", "size": [1.0, 2.0, 1.0]}, "material": "mirror", "transforms": [{"rotate": 30.0, "about": [0.0, 1.0, 0.5]}, {"translate": [-2.0, 0.0, 0.0]}]},
    {"shape": {"type": "sphere", "radius": 0.8}, "material": "glass"}, {"shape": {"type": "sphere", "radius": 0.5}, "material": "globe", "transforms": [{"scale": [1.0, 2.0, 1.0]}, {"translate": [1.5, 0.0, 0.0]}]},
    {"shape": {"type": "torus", "ring_radius": 0.6, "tube_radius": 0.2}, "material": "metal", "transforms": [{"translate": [0.0, 1.0, 0.0]}]},
    {"shape": {"type": "cylinder", "radius": 0.3, "height": 1.0}, "material": "glass", "transforms": [{"translate": [2.0, 0.5, 0.5]}]},
    {"shape": {"type": "cone", "radius": 0.3, "height": 1.0, "capped": false}, "material": "film", "transforms": [{"translate": [-1.0, 0.5, 1.0]}]},
    {"shape": {"type": "quadric", "q": [[1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, -0.1]], "lower": [-1.0, -1.0, -1.0], "upper": [1.0, 1.0, 1.0]},
     "transforms": [{"translate": [3.0, 0.0, -2.0]}]},
    {"shape": {"type": "polygon", "outline": [[-3.0, 0.0, -3.0], [3.0, 0.0, -3.0], [3.0, 2.0, -3.0], [-3.0, 2.0, -3.0]], "holes": [{"points": [[0.0, 0.5, -3.0], [1.0, 0.5, -3.0], [0.5, 1.0, -3.0]]}]}, "material": "film"},
    {"shape": {"type": "polyhedron", "planes": [[1.0, 0.0, 0.0, -0.3], [-1.0, 0.0, 0.0, -0.3], [0.0, 1.0, 0.0, -0.3], [0.0, -1.0, 0.0, -0.3], [0.0, 0.0, 1.0, -0.3], [0.0, 0.0, -1.0, -0.3]]}, "material": "mirror",
     "transforms": [{"translate": [0.0, 2.0, 1.0]}]},
    {"shape": {"type": "height-field", "width": 2.0, "depth": 2.0, "height": 0.5, "heights": [[0.0, 1.0, 0.0], [1.0, 0.5, 1.0]]}, "material": "film"},
    {"shape": {"type": "mesh", "positions": [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], "texcoords": [[0.0, 1.0], [1.0, 1.0], [0.0, 0.0]], "triangles": [[0, 1, 2]]}, "material": "film"}]
})";

/// The places of numbers with a point: where each begins and how long it is.
std::vector<std::pair<std::size_t, std::size_t>> numbers_in(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (std::isdigit(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.' || (end == i && text[end] == '-'))) ++end;
    if (end > i && text.find('.', i) < end && text[i] != '.') places.emplace_back(i, end - i);
    i = std::max(end, i + 1);
  }
  return places;
}

/// Rays from the camera's place and from inside of things, and where they end.
void trace_some(const TracedScene& scene, test::Random& random) {
  const RayTracer tracer(scene, {.most_level = 4, .most_rays = 200});
  TraceScratch scratch;
  for (int i = 0; i < 24; ++i) {
    const glm::dvec3 from = i % 3 == 0 ? glm::dvec3(0, 0, 0) : glm::dvec3(0, 1.5, 6), to(number_between(random, -3, 3), number_between(random, -1, 2), number_between(random, -3, 3));
    scratch.rays_of_this_eye_ray = 0;
    const glm::dvec3 light = tracer.radiance({.origin = from, .direction = glm::normalize(to - from)}, scratch);
    CAPTURE(from.y, to.x, to.y, to.z, light.x, light.y, light.z);
    CHECK((std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z)));
    CHECK(std::min({light.x, light.y, light.z}) >= -1e-12);
  }
}

}  // namespace

TEST_CASE("traced scene: any number in any place is refused by name or traced to an end", "[ray_tracer][traced_scene][bad]") {
  const std::string good = kMutableScene;
  const auto places = numbers_in(good);
  REQUIRE(places.size() > 150);
  const std::vector<std::string> odd{"0.0", "-0.0", "1e-30", "-1e-30", "1e30", "-1e30", "-1.0", "1e-3", "1e3", "1e9", "0.999999", "1.0"};
  const std::uint64_t seed = 61;
  CAPTURE(seed);
  test::Random random(seed);
  Workers workers(1);
  int refused = 0, made = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::string text = good;
    const auto& [at, length] = places[random.below(static_cast<std::uint32_t>(places.size()))];
    text.replace(at, length, odd[random.below(static_cast<std::uint32_t>(odd.size()))]);
    const auto scene = scene_from_json(text, "odd.json");
    if (!scene) continue;
    CAPTURE(trial, text.substr(at - std::min<std::size_t>(at, 60), 100));
    const auto traced_scene = TracedScene::create(*scene, workers, {.surfaces = trial % 2 == 0 ? SurfaceKind::exact : SurfaceKind::tessellated});
    if (!traced_scene) {
      CHECK(one_line_naming(traced_scene.error().message, ""));
      ++refused;
      continue;
    }
    trace_some(*traced_scene, random);
    ++made;
  }
  CHECK(made > 300);
  CHECK(refused > 0);
}

TEST_CASE("traced scene: the scene of every kind of thing is bright and finite", "[ray_tracer][traced_scene]") {
  const TracedScene scene = traced(std::string(kMutableScene));
  const RayTracer tracer(scene);
  TraceScratch scratch;
  test::Random random(62);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 from(0, 1.5, 6), to(number_between(random, -3, 3), number_between(random, -1, 2), number_between(random, -3, 3));
    scratch.rays_of_this_eye_ray = 0;
    const glm::dvec3 light = tracer.radiance({.origin = from, .direction = glm::normalize(to - from)}, scratch);
    CAPTURE(to.x, to.y, to.z);
    CHECK((std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z)));
    CHECK(std::min({light.x, light.y, light.z}) >= 0);
  }
}

}  // namespace tuberia::tracer::traced_test
