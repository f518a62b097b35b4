#include "scene/environment/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <utility>

#include "scene/environment/directions.hpp"

namespace tuberia {
namespace {

constexpr int kMostSamplesEachWay = 16;

glm::dvec3 colour_of(const Rgba32F& texel) {
  return {static_cast<double>(texel.r), static_cast<double>(texel.g), static_cast<double>(texel.b)};
}

/// The weighted mean of the four texels around (x, y), in texels from the upper left corner of an image;
/// texel(column, row) is asked for one beyond each border, too.
template <class TexelAt>
glm::dvec3 bilinear_mean(double x, double y, const TexelAt& texel) {
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
  const int column = static_cast<int>(left), row = static_cast<int>(top);
  const double weight_x = x - 0.5 - left, weight_y = y - 0.5 - top;
  const glm::dvec3 upper = glm::mix(texel(column, row), texel(column + 1, row), weight_x);
  const glm::dvec3 lower = glm::mix(texel(column, row + 1), texel(column + 1, row + 1), weight_x);
  return glm::mix(upper, lower, weight_y);
}

/// The mean over a texel. direction_of: of a point of the image, in [0, 1] each way.
template <class DirectionOf>
Rgba32F mean_over_texel(const Surroundings& surroundings, const DirectionOf& direction_of, glm::dvec2 corner, glm::dvec2 size, double texel_radians) {
  const double wanted = std::ceil(texel_radians / surroundings.detail_radians - 1e-9);
  const int samples = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(kMostSamplesEachWay)));
  glm::dvec3 sum(0);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 within = (glm::dvec2(i, j) + 0.5) / static_cast<double>(samples);
      sum += surroundings.radiance(glm::normalize(direction_of(corner + within * size)));
    }
  const glm::vec3 mean(sum / static_cast<double>(samples * samples));
  return {mean.r, mean.g, mean.b, 1};
}

/// radians_of: how large an angle the texel around a point spans, each way at most.
template <class DirectionOf, class RadiansOf>
Image<Rgba32F> image_of(const Surroundings& surroundings, int width, int height, const DirectionOf& direction_of, const RadiansOf& radians_of) {
  Image<Rgba32F> image(width, height);
  const glm::dvec2 size = 1.0 / glm::dvec2(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::dvec2 corner = glm::dvec2(x, y) * size;
      image.at(x, y) = mean_over_texel(surroundings, direction_of, corner, size, radians_of(corner + 0.5 * size));
    }
  return image;
}

}  // namespace

Surroundings panorama_surroundings(Image<Rgba32F> panorama) {
  const auto image = std::make_shared<const Image<Rgba32F>>(std::move(panorama));
  const int width = image->width(), height = image->height();
  const auto texel = [=](int x, int y) { return colour_of(image->at((x + width) % width, std::clamp(y, 0, height - 1))); };
  const double detail = std::numbers::pi / std::max(height, (width + 1) / 2);
  return {[=](const glm::dvec3& direction) {
            const glm::dvec2 point = panorama_point(direction);
            return bilinear_mean(point.x * width, point.y * height, texel);
          },
          detail};
}

Surroundings cube_surroundings(CubeImages faces) {
  const auto images = std::make_shared<const CubeImages>(std::move(faces));
  const int size = images->front().width();
  return {[=](const glm::dvec3& direction) {
            const CubeFacePoint point = cube_face_point(direction);
            // A texel beyond the face's edge is the one that its neighbour has there.
            const auto texel = [&](int x, int y) {
              const glm::dvec2 centre = (glm::dvec2(x, y) + 0.5) / static_cast<double>(size);
              const CubeFacePoint there = cube_face_point(cube_face_direction({point.face, centre}));
              const auto index = [size](double s) { return std::clamp(static_cast<int>(s * size), 0, size - 1); };
              return colour_of((*images)[static_cast<std::size_t>(there.face)].at(index(there.at.x), index(there.at.y)));
            };
            return bilinear_mean(point.at.x * size, point.at.y * size, texel);
          },
          2.0 / size};
}

Surroundings sphere_map_surroundings(Image<Rgba32F> map) {
  const auto image = std::make_shared<const Image<Rgba32F>>(std::move(map));
  const int width = image->width(), height = image->height();
  const auto texel = [=](int x, int y) { return colour_of(image->at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1))); };
  return {[=](const glm::dvec3& direction) {
            const glm::dvec2 point = sphere_map_point(direction);
            return bilinear_mean(point.x * width, point.y * height, texel);
          },
          4.0 / std::max(width, height)};
}

Image<Rgba32F> panorama_of(const Surroundings& surroundings, int width, int height) {
  const double radians = std::numbers::pi * std::max(2.0 / width, 1.0 / height);
  return image_of(surroundings, width, height, panorama_direction, [=](const glm::dvec2&) { return radians; });
}

CubeImages cube_of(const Surroundings& surroundings, int size) {
  CubeImages faces;
  for (int face = 0; face < 6; ++face) {
    const auto direction_of = [=](const glm::dvec2& at) { return cube_face_direction({face, at}); };
    faces[static_cast<std::size_t>(face)] = image_of(surroundings, size, size, direction_of, [=](const glm::dvec2&) { return 2.0 / size; });
  }
  return faces;
}

Image<Rgba32F> sphere_map_of(const Surroundings& surroundings, int size) {
  // At sin(a) from the ball's middle it mirrors what lies at 2 a from +z: texels span most at the rim.
  const auto radians_of = [=](const glm::dvec2& at) {
    const glm::dvec2 n = 2.0 * at - 1.0;
    return 4.0 / size / std::sqrt(std::max(1 - glm::dot(n, n), 1.0 / size));
  };
  return image_of(surroundings, size, size, sphere_map_direction, radians_of);
}

}  // namespace tuberia
