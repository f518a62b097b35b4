// A frame mirrored at a plane, and the tracer's reflection off that plane.                     [rules, case 57]

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <set>

#include "examples/tuberia/witness/explaining.hpp"
#include "scene/content/develop.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/description/read_scene.hpp"
#include "scene/frame/scene_frame.hpp"

namespace tuberia::witness {
namespace {

// The plane n.p = d, and two directions within it.
const glm::dvec3 kN = glm::dvec3(1, 2, 2) / 3.0, kT = glm::dvec3(2, -2, 1) / 3.0, kB = glm::dvec3(2, 1, -2) / 3.0;
constexpr double kD = 3;

/// Coordinates along the plane and over it.
glm::dvec3 before_plane(double along, double across, double over) { return kD * kN + along * kT + across * kB + over * kN; }

/// M of the mirror: p - 2 (n.p - d) n.
glm::dmat4 mirror_matrix() {
  glm::dmat4 m(1);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) m[column][row] -= 2 * kN[row] * kN[column];
  m[3] = glm::dvec4(2 * kD * kN, 1);
  return m;
}

constexpr const char* kThings = R"({
  "image": {"width": 150, "height": 100}, "camera": {"fovy_degrees": 40, "near": 0.5, "far": 60}, "ambient": 0.2,
  "lights": [{"type": "directional", "towards": [0.2, 1, 0.6], "intensity": 0.7}],
  "materials": {"red": {"diffuse": [0.8, 0.2, 0.1], "specular": 0.3, "exponent": 20}, "green": {"diffuse": [0.2, 0.7, 0.3]}, "blue": {"model": "lambert", "diffuse": [0.2, 0.3, 0.8]},
                "mirror": {"model": "lambert", "ambient": 0, "diffuse": 0, "mirror": 1}},
  "objects": [{"shape": {"type": "sphere", "radius": 0.6}, "material": "red"}, {"shape": {"type": "cube", "size": [0.8, 0.8, 0.8]}, "material": "green"},
              {"shape": {"type": "cone", "radius": 0.5, "height": 1.2}, "material": "blue"}]
})";

/// Things that only the mirror shows to the eye.
SceneDescription things() {
  auto scene = scene_from_json(kThings, "things.json");
  if (!scene) FAIL(scene.error().message);
  using Kind = description::Transform::Kind;
  const glm::dvec3 places[] = {before_plane(-2.2, -0.9, 3), before_plane(-2.5, 0.9, 3.4), before_plane(-1.6, 0.1, 3.9)};
  for (std::size_t i = 0; i < scene->objects.size(); ++i)
    scene->objects[i].transforms = {{.kind = Kind::rotate, .vector = {1, 0.4, 0.3}, .degrees = 33.0 + 40.0 * static_cast<double>(i)}, {.kind = Kind::translate, .vector = places[i]}};
  scene->camera.eye = before_plane(3, 0, 4);
  scene->camera.look_at = before_plane(0, 0, 0);
  scene->camera.up = kB;
  return *scene;
}

SceneDescription mirrored_things() {
  SceneDescription scene = things();
  for (description::Object& object : scene.objects) object.transforms.push_back({.kind = description::Transform::Kind::matrix, .matrix = mirror_matrix()});
  for (description::Light& light : scene.lights) light.towards -= 2 * glm::dot(kN, light.towards) * kN;
  return scene;
}

SceneDescription things_and_mirror() {
  SceneDescription scene = things();
  using Kind = description::Transform::Kind;
  const glm::dvec3 up(0, 1, 0);
  scene.objects.push_back({.name = "mirror", .shape = description::Plane{.width = 60, .depth = 60}, .material = "mirror",
                           .transforms = {{.kind = Kind::rotate, .vector = glm::cross(up, kN), .degrees = std::acos(kN.y) * 180 / std::numbers::pi}, {.kind = Kind::translate, .vector = kD * kN}}});
  return scene;
}

/// What a ray of the eye sees by way of the mirror.
struct MirroredSight {
  int object;
  glm::dvec3 light;
};

class MirroredSights {
 public:
  MirroredSights(const tracer::TracedScene& scene, const tracer::View& view) : scene_(scene), tracer_(scene), view_(view) {}

  MirroredSight at(const glm::dvec2& pixel, tracer::TraceScratch& scratch) const {
    const tracer::Ray eye_ray = view_.ray(pixel);
    const tracer::Hit mirror = tracer_.first_hit(eye_ray, scratch);
    REQUIRE(scene_.object_of(mirror.item) == 3);
    const tracer::Ray reflected{.origin = eye_ray.at(mirror.t), .direction = eye_ray.direction - 2 * glm::dot(kN, eye_ray.direction) * kN, .t_min = 1e-6};
    const tracer::Hit hit = tracer_.first_hit(reflected, scratch);
    return {hit ? scene_.object_of(hit.item) : -1, tracer_.radiance(eye_ray, scratch)};
  }

  /// Whether what was drawn lies between what is seen up to 2/256 pixel around.
  bool is_seen_beside(const glm::dvec2& pixel, const DrawnPixel& drawn, tracer::TraceScratch& scratch) const {
    LightRange range;
    for (int i = 0; i < 64; ++i) {
      const double angle = 0.3927 * i, radius = kEdgeDistance * (i + 1) / 64;
      const MirroredSight beside = at(pixel + radius * glm::dvec2(std::cos(angle), std::sin(angle)), scratch);
      if (beside.object == drawn.object) range.include(LightRange::of(beside.light));
    }
    return Development{}.may_be(drawn.colour, range);
  }

 private:
  const tracer::TracedScene& scene_;
  tracer::RayTracer tracer_;
  tracer::View view_;
};

}  // namespace

TEST_CASE("tracer witness: a mirrored frame is the reflection off the plane", "[case-57][A45][Y5][tracer_witness]") {
  // The case's own numbers: its point, and that mirroring twice is nothing and turns windings round.
  const glm::dmat4 M = mirror_matrix();
  CHECK(glm::length(glm::dvec3(M * glm::dvec4(4, 5, 6, 1)) - glm::dvec3(2, -23, -14) / 9.0) < 1e-14);
  CHECK(glm::determinant(glm::dmat3(M)) == Approx(-1));

  auto frame = SceneFrame::create(mirrored_things());
  REQUIRE(frame);
  Pipeline pipeline({.threads = 1});
  const auto objects = frame->nearest_objects(pipeline);
  const auto light = frame->draw(pipeline);
  REQUIRE((objects && light));
  const Image<Rgba8> drawn = srgb_codes_of(developed(*light, {}));

  Workers workers(1);
  const SceneDescription described = things_and_mirror();
  const auto scene = tracer::TracedScene::create(described, workers, {.surfaces = tracer::SurfaceKind::tessellated});
  REQUIRE(scene);
  const auto view = tracer::View::create(*camera_of(described.camera, 1.5), 150, 100);
  REQUIRE(view);
  const MirroredSights sights(*scene, *view);
  tracer::TraceScratch scratch;
  int on_edges = 0, beyond = 0;
  std::set<int> seen;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 150; ++x) {
      const DrawnPixel pixel{.colour = drawn.at(x, y), .object = objects->objects.at(x, y)};
      const glm::dvec2 centre(x + 0.5, y + 0.5);
      const MirroredSight traced = sights.at(centre, scratch);
      seen.insert(pixel.object);
      if (traced.object == pixel.object && Development{}.may_be(pixel.colour, LightRange::of(traced.light))) continue;
      ++(sights.is_seen_beside(centre, pixel, scratch) ? on_edges : beyond);
    }
  CHECK(seen == std::set<int>{-1, 0, 1, 2});
  CHECK(beyond == 0);
  CHECK(on_edges < 50);
}

}  // namespace tuberia::witness
