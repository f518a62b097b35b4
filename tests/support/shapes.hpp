#pragma once
// Procedural meshes and textures: small, and of numbers that every machine computes alike.

#include <cmath>
#include <memory>

#include "math/transforms.hpp"
#include "raster/texture.hpp"
#include "tests/support/mesh.hpp"

namespace tuberia::test {

/// A unit sphere of `rings` x 2 `rings` quadrilaterals with normals, texture coordinates and the
/// normals as colours. Angles are rounded to 1/1024, so that no library's last bit can show.
inline Mesh sphere(int rings) {
  constexpr double kPi = 3.14159265358979323846;
  const auto rounded = [](double x) { return static_cast<float>(std::round(x * 1024) / 1024); };
  Mesh mesh;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j <= 2 * rings; ++j) {
      const double polar = kPi * i / rings, azimuth = kPi * j / rings;
      const glm::vec3 n{rounded(std::sin(polar) * std::cos(azimuth)), rounded(std::cos(polar)),
                        rounded(std::sin(polar) * std::sin(azimuth))};
      mesh.positions.push_back(n);
      mesh.normals.push_back(n);
      mesh.texcoords.push_back({static_cast<float>(j) / static_cast<float>(rings), static_cast<float>(i) / static_cast<float>(rings)});
      mesh.colours.push_back(glm::vec4(n * 0.5f + 0.5f, 1.0f));
    }
  const auto number = [&](int i, int j) { return static_cast<std::uint32_t>(i * (2 * rings + 1) + j); };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < 2 * rings; ++j) {
      // Counter-clockwise from outside.
      for (const std::uint32_t index : {number(i, j), number(i, j + 1), number(i + 1, j), number(i, j + 1),
                                        number(i + 1, j + 1), number(i + 1, j)})
        mesh.indices.push_back(index);
    }
  return mesh;
}

/// A rectangle from corner a along u and v, texture coordinates 0 to `repeats`, normal up its front.
inline Mesh rectangle(glm::vec3 a, glm::vec3 u, glm::vec3 v, glm::vec3 normal, float repeats = 1, glm::vec4 colour = glm::vec4(1)) {
  Mesh mesh;
  mesh.positions = {a, a + u, a + u + v, a + v};
  mesh.normals.assign(4, normal);
  mesh.texcoords = {{0, 0}, {repeats, 0}, {repeats, repeats}, {0, repeats}};
  mesh.colours.assign(4, colour);
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

/// Squares of `cell` texels in two colours by turns.
inline Image<Rgba8> checkerboard(int size, int cell, Rgba8 even, Rgba8 odd) {
  Image<Rgba8> image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) image.at(x, y) = (x / cell + y / cell) % 2 == 0 ? even : odd;
  return image;
}

inline std::shared_ptr<const Texture> texture_of(const Image<Rgba8>& image, TextureEncoding encoding = TextureEncoding::linear) {
  return std::make_shared<const Texture>(*Texture::create(image, encoding));
}

/// The clip matrix of a camera at `eye` that looks at the origin, 60 degrees high.
inline glm::mat4 clip_from_world(glm::dvec3 eye, double aspect, double near_distance = 0.1, double far_distance = 100) {
  const CameraBasis basis = *camera_basis(eye, {0, 0, 0}, {0, 1, 0});
  const glm::mat4 clip_from_view = *perspective(1.0471975511965976, aspect, near_distance, far_distance, ClipVolume::minus_w_to_w);
  return compose(clip_from_view, view_from_world(basis, eye));
}

}  // namespace tuberia::test
