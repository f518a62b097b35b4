// Lesson 10: a ray tracer in a page. Nothing is projected and no triangle is filled: for each pixel we ask what a ray from the eye meets
// first, light it if the lamp sees it, and ask again along the mirrored and the refracted ray. Shadows, mirrors and glass, each of
// which took a pass of its own in the lessons before, come by themselves; what it costs is the search in `nearest`.   [B 5.1-5.5]

#include <array>
#include <filesystem>
#include <memory>

#include "image/write_image.hpp"
#include "math/colour.hpp"
#include "reference/ray_tracer/geometry.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"
#include "reference/ray_tracer/shapes/torus.hpp"

using namespace tuberia;
using namespace tuberia::tracer;

namespace {
struct Material {
  glm::dvec3 kd{0}, kr{0}, kt{0};  // diffuse, mirrored, transmitted
  double ks = 0;                   // the lamp's highlight
  bool is_chequered = false;
};

constexpr int kWidth = 600, kHeight = 400, kDeepest = 6;
constexpr double kGlass = 1.5, kExponent = 60;
const glm::dvec3 kLamp{-4, 7, 5}, kSky{0.45, 0.6, 0.8};
const std::array<Material, 4> kMaterials{{{.kd = {0.7, 0.7, 0.65}, .kr = glm::dvec3(0.08), .is_chequered = true},
                                          {.kd = glm::dvec3(0.05), .kr = {0.85, 0.85, 0.9}, .ks = 0.6},
                                          {.kr = glm::dvec3(0.06), .kt = glm::dvec3(0.94), .ks = 0.6},
                                          {.kd = {0.75, 0.25, 0.1}, .kr = glm::dvec3(0.1), .ks = 0.5}}};

Geometry scene() {
  const auto at = [](double x, double y, double z) { return glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1); };
  Geometry geometry;
  geometry.add_shape(std::make_shared<InfinitePlane>(), at(0, 0, 0), 0);
  geometry.add_shape(std::make_shared<Sphere>(1), at(-1.3, 1, -1), 1);
  geometry.add_shape(std::make_shared<Sphere>(0.8), at(0.6, 0.8, 0.6), 2);
  geometry.add_shape(std::make_shared<Torus>(0.9, 0.3), at(2.4, 0.3, -1.2), 3);
  return geometry;
}

Hit nearest(const Geometry& geometry, const Ray& ray) {
  const PreparedRay prepared(ray);
  Hit hit;
  for (std::int64_t item = 0; item < geometry.count(); ++item) geometry.intersect(item, prepared, hit);
  return hit;
}

/// I = kd Ia + Ip [kd (N.L) + ks (R.V)^n] if the lamp is seen + kr Ir + kt It                        [B 5-2]
glm::dvec3 trace(const Geometry& geometry, const Ray& ray, int level) {
  if (level > kDeepest) return glm::dvec3(0);
  const Hit hit = nearest(geometry, ray);
  if (!hit) return glm::mix(glm::dvec3(0.9), kSky, std::max(ray.direction.y, 0.0));
  const SurfacePoint point = geometry.surface(ray, hit);
  const Material& material = kMaterials[static_cast<std::size_t>(geometry.part_of(hit.item))];
  const bool inside = glm::dot(ray.direction, point.normal) > 0;
  const glm::dvec3 V = -ray.direction, N = inside ? -point.normal : point.normal;
  const double cosine = glm::dot(N, V);
  // Rays start a little off the surface, or rounding would have them meet it again.                    [B 5.4]
  const auto leave = [&](const glm::dvec3& direction) {
    const double side = glm::dot(direction, N) < 0 ? -1 : 1;
    return Ray{.origin = point.position + side * safe_offset(point) * N, .direction = glm::normalize(direction)};
  };

  const bool is_dark = material.is_chequered && std::fmod(std::floor(point.texcoord.x) + std::floor(point.texcoord.y), 2) != 0;
  const glm::dvec3 kd = material.kd * (is_dark ? 0.25 : 1.0), to_lamp = kLamp - point.position, R = 2 * cosine * N - V;
  glm::dvec3 light = 0.25 * kd;
  Ray shadow_ray = leave(to_lamp);
  shadow_ray.t_max = glm::length(to_lamp);
  const double towards_lamp = glm::dot(N, shadow_ray.direction), mirrored = std::max(glm::dot(R, shadow_ray.direction), 0.0);
  if (towards_lamp > 0 && !nearest(geometry, shadow_ray)) light += kd * towards_lamp + material.ks * std::pow(mirrored, kExponent);

  const double eta = inside ? kGlass : 1 / kGlass, k = 1 - eta * eta * (1 - cosine * cosine);
  const bool goes_through = material.kt != glm::dvec3(0) && k >= 0;  // else total internal reflection: all of it is mirrored
  const glm::dvec3 kr = goes_through ? material.kr : material.kr + material.kt;
  if (goes_through) light += material.kt * trace(geometry, leave(eta * (cosine * N - V) - std::sqrt(k) * N), level + 1);  // [5-7]
  if (kr != glm::dvec3(0)) light += kr * trace(geometry, leave(R), level + 1);                                           // [5-5]
  return light;
}

}  // namespace

int main() {
  const Geometry geometry = scene();
  Image<Rgba8> image(kWidth, kHeight);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      glm::dvec3 light(0);
      for (const glm::dvec2& sample : {glm::dvec2(0.25, 0.25), {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}) {
        const glm::dvec3 window(x + sample.x - 0.5 * kWidth, 0.1 * kHeight - y - sample.y, -1.5 * kHeight);
        light += 0.25 * trace(geometry, {.origin = {0.4, 2.9, 7}, .direction = glm::normalize(window)}, 0);
      }
      image.at(x, y) = {srgb_code_from_linear(light.x), srgb_code_from_linear(light.y), srgb_code_from_linear(light.z), 255};
    }
  std::filesystem::create_directories("out");
  return write_image("out/a_ray_tracer_in_a_page.png", image) ? 0 : 1;
}
