// A picture of each primitive under the local model.
#include <catch2/catch.hpp>

#include "image/image.hpp"
#include "math/colour.hpp"
#include "math/reflection.hpp"
#include "reference/ray_tracer/shapes/cuboid.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/polygon.hpp"
#include "reference/ray_tracer/shapes/polyhedron.hpp"
#include "reference/ray_tracer/shapes/quadric.hpp"
#include "reference/ray_tracer/shapes/round_shapes.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"
#include "reference/ray_tracer/shapes/torus.hpp"
#include "scene/shapes/shapes.hpp"
#include "tests/golden/golden.hpp"
#include "tests/ray_tracer/shapes_support.hpp"

namespace tuberia::tracer::shapes_test {
namespace {

constexpr int kCell = 80, kColumns = 5, kRows = 3;

/// Three rows of five on a floor that has no end, seen from the front and above.
Geometry all_primitives() {
  glm::dmat4 saddle(0);
  saddle[0][0] = 1, saddle[2][2] = -1, saddle[1][3] = saddle[3][1] = -0.5;
  const std::vector<glm::dvec4> gem{{1, 1, 1, -1}, {-1, 1, 1, -1}, {1, 1, -1, -1}, {-1, 1, -1, -1}, {1, -1, 0, -1}, {-1, -1, 0, -1}, {0, -1, 1, -1}, {0, -1, -1, -1}};
  const std::vector<glm::dvec3> frame{{-0.9, -0.9, 0}, {0.9, -0.9, 0}, {0.9, 0.9, 0}, {0, 0.3, 0}, {-0.9, 0.9, 0}};
  const std::vector<std::vector<glm::dvec3>> hole{{{-0.4, -0.6, 0}, {0.4, -0.6, 0}, {0, 0, 0}}};
  const std::vector<std::shared_ptr<const Shape>> shapes{
      std::make_shared<Sphere>(0.9), std::make_shared<Cylinder>(0.7, 1.5), std::make_shared<Cylinder>(0.7, 1.5, false), std::make_shared<Cone>(0.8, 1.6),
      std::make_shared<Cone>(0.8, 1.6, false), std::make_shared<Torus>(0.65, 0.27), std::make_shared<Cuboid>(glm::dvec3(1.2)), std::make_shared<Disc>(0.9),
      std::make_shared<Rectangle>(1.6, 1.6), *Polygon::create(frame, hole), *Polyhedron::create(gem), *Quadric::create(saddle, glm::dvec3(-0.7), glm::dvec3(0.7))};
  Geometry geometry;
  const auto place = [](std::size_t i) {
    const double x = 2.2 * (static_cast<double>(i % kColumns) - 2), y = 2.2 * (1 - static_cast<double>(i / kColumns));
    return scaled(1, {x, y, 0}) * turned(0.6, {1, 0, 0}) * turned(0.5, {0, 1, 0});
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) geometry.add_shape(shapes[i], place(i), static_cast<int>(i));
  geometry.add_mesh(*torus_mesh({.radius = 0.65, .tube_radius = 0.27, .slices = 12, .stacks = 6}), place(12), 12);
  geometry.add_mesh(*torus_mesh({.radius = 0.65, .tube_radius = 0.27, .slices = 12, .stacks = 6}), place(13), 13, true);
  geometry.add_shape(std::make_shared<InfinitePlane>(), scaled(1, {0, -3.6, 0}) * turned(0.1, {1, 0, 0}), 14);
  return geometry;
}

glm::dvec3 local_model(const SurfacePoint& point, const glm::dvec3& to_eye, int part) {
  const glm::dvec2 squares = glm::floor((part == 14 ? 0.5 : 8.0) * point.texcoord);
  const bool is_dark = static_cast<int>(squares.x + squares.y) % 2 != 0;
  const glm::vec3 diffuse = part == 14 ? glm::vec3(is_dark ? 0.3f : 0.5f) : is_dark ? glm::vec3(0.15f, 0.3f, 0.55f) : glm::vec3(0.8f, 0.75f, 0.6f);
  const ReflectionConstants constants{.ambient = diffuse, .diffuse = diffuse, .specular = glm::vec3(0.3f), .exponent = 30};
  const glm::dvec3 facing = glm::dot(point.normal, to_eye) < 0 ? -point.normal : point.normal;
  return 0.2 * glm::dvec3(diffuse) + reflected_share(constants, {.normal = facing, .to_light = glm::normalize(glm::dvec3(-0.5, 0.8, 0.7)), .to_eye = to_eye});
}

}  // namespace

TEST_CASE("shapes: a picture with each primitive", "[ray_tracer][A42]") {
  const Geometry geometry = all_primitives();
  Image<Rgba8> image(kColumns * kCell, kRows * kCell, {200, 210, 225, 255});
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::dvec3 eye(0, 0, 14), window((x + 0.5) / kCell - 0.5 * kColumns, 0.5 * kRows - (y + 0.5) / kCell, -5.4);
      const Ray ray{.origin = eye, .direction = glm::normalize(window)};
      const Hit hit = nearest_hit(geometry, ray);
      if (!hit) continue;
      const glm::dvec3 colour = local_model(geometry.surface(ray, hit), -ray.direction, geometry.part_of(hit.item));
      image.at(x, y) = {srgb_code_from_linear(colour.x), srgb_code_from_linear(colour.y), srgb_code_from_linear(colour.z), 255};
    }
  CHECK(tuberia::test::golden_difference("ray_traced_shapes", image) == "");
}

}  // namespace tuberia::tracer::shapes_test
