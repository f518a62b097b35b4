#pragma once
// Procedural meshes: small, and of numbers that every machine computes alike.

#include <cmath>

#include "math/transforms.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

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

/// A scene with something of everything: a lit sphere, a textured floor that the near plane cuts,
/// random triangles with and without w > 0, and two blended layers over it all.
inline void draw_everything(Studio& studio, float aspect) {
  const glm::mat4 camera = clip_from_world({1.5, 1.25, 2.5}, static_cast<double>(aspect));
  Lighting light;
  light.specular = glm::vec3(0.5f);
  light.eye = {1.5f, 1.25f, 2.5f};
  light.light_count = 2;
  light.lights[0].towards = {0, 0.8f, 0.6f};
  light.lights[1] = {.kind = Light::Kind::point, .towards = {-2, 1, 1}, .intensity = {0.2f, 0.3f, 0.9f}};
  const auto texture = texture_of(checkerboard(64, 8, {250, 240, 40, 255}, {30, 60, 200, 255}), TextureEncoding::srgb);

  PipelineState state;
  state.transform.clip_from_world = camera;
  const Mesh floor = rectangle({-30, -1, -30}, {0, 0, 60}, {60, 0, 0}, {0, 1, 0}, 40);
  studio.draw(floor.view(), textured({.texture = texture, .sampler = {}}), state);
  const Mesh ball = sphere(24);
  studio.draw(ball.view(), phong(light), state);

  state.transform.world_from_object = translation({-1.5, 0, -0.5});
  studio.draw(ball.view(), textured_lit({.texture = texture, .sampler = {}, .lighting = light}), state);
  state.transform.world_from_object = translation({1.5, 0, -1.5});
  state.transform.vertex_lighting = light;
  studio.draw(ball.view(), gouraud(), state);
  state.transform.vertex_lighting.reset();
  state.transform.world_from_object = glm::mat4(1);

  Random random(51);
  Mesh shards;
  for (int i = 0; i < 80; ++i) {
    // Most are small; every tenth reaches behind the eye.
    const glm::vec3 centre{random.between(-3, 3), random.between(-1, 2), random.between(-3, 2)};
    const float reach = i % 10 == 0 ? 4.0f : 0.4f;
    for (int k = 0; k < 3; ++k) {
      shards.positions.push_back(centre + reach * glm::vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
      shards.colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 0.7f)});
    }
  }
  state.depth.write = false;
  state.blend.mode = BlendMode::source_over;
  studio.draw(shards.view(), gouraud(), state);
  state.blend.mode = BlendMode::additive;
  state.rasterization.scissor = PixelRect{10, 5, 90, 60};
  shards.colours.assign(shards.positions.size(), glm::vec4(0.06f, 0.03f, 0.01f, 0));
  studio.draw(shards.view(), flat(), state);
}

}  // namespace tuberia::test
