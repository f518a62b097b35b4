#pragma once
// Environment maps drawn on the faces of a cube, and surroundings to make them of.

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/programs/environment_map.hpp"
#include "scene/environment/directions.hpp"
#include "scene/environment/environment_maps.hpp"
#include "scene/environment/sky.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

namespace tuberia::test {

/// Clouds, horizon and glow, but no disc: nothing brighter than a screen shows, nor sharper than a map holds.
inline Surroundings sunless_sky() {
  Sky sky;
  sky.sun = glm::dvec3(0);
  return {[sky](const glm::dvec3& d) { return sky_radiance(sky, d); }, 0.01};
}

/// Random texels, so that a look-up half a texel off shows.
inline Image<Rgba32F> noise_image(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image<Rgba32F> image(width, height);
  for (Rgba32F& texel : image.pixels()) texel = {random.between(0, 1), random.between(0, 1), random.between(0, 1), 1};
  return image;
}

/// Covers the target, with the directions through one face of a cube at its pixels.
struct FaceOfDirections {
  static constexpr glm::vec4 kClipPositions[3] = {{-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1}};
  std::array<glm::vec4, 3> directions{};

  explicit FaceOfDirections(int face) {
    const glm::dvec2 corners[3] = {{0, 1}, {2, 1}, {0, -1}};
    for (std::size_t i = 0; i < 3; ++i) directions[i] = glm::vec4(glm::vec3(cube_face_direction({face, corners[i]})), 0);
  }
  MeshView view() const { return {.clip_positions = kClipPositions, .custom = directions}; }
};

inline Canvas float_canvas(int size, const PipelineOptions& options = {.threads = 1}) {
  return {.width = size, .height = size, .colour = ColourFormat::rgba32f, .options = options};
}

/// What a map shows in the directions of the pixels of a cube's face.
inline Image<Rgba32F> looked_up(const EnvironmentMap& map, int face, int size, const PipelineOptions& options = {.threads = 1}) {
  Studio studio(float_canvas(size, options));
  PipelineState state;
  state.depth = kDepthOff;
  studio.draw(FaceOfDirections(face).view(), environment_background(map), state);
  return studio.target().linear_image();
}

/// The unit direction at the centre of a pixel of a face.
inline glm::dvec3 pixel_direction(int face, int size, int x, int y) {
  return glm::normalize(cube_face_direction({face, (glm::dvec2(x, y) + 0.5) / static_cast<double>(size)}));
}

inline glm::dvec3 radiance_of(const Rgba32F& pixel) { return {static_cast<double>(pixel.r), static_cast<double>(pixel.g), static_cast<double>(pixel.b)}; }

inline double largest_component(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace tuberia::test
