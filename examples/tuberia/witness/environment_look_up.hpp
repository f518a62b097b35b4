#pragma once
// The picture of its surroundings that the pipeline reads for a scene, made once more and looked up in double.

#include <array>
#include <functional>
#include <glm/mat3x3.hpp>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "math/camera.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/environment/surroundings.hpp"

namespace tuberia::witness {

/// Of the upper left pixel of a block of 2 x 2, and of those to its right and below it.
using BlockDirections = std::array<glm::dvec3, 3>;

class EnvironmentLookUp {
 public:
  /// camera: the observer's, whose axes a sphere map has. Errors of environment_picture.
  static Result<EnvironmentLookUp> create(const SceneDescription& scene, const description::Environment& environment, const Camera& camera);

  /// A cube map in the world's axes.
  explicit EnvironmentLookUp(CubeImages faces) { add_levels(std::move(faces)); }

  /// Linear RGB; directions of world space, unit. Trilinear, at the level of detail of docs/conventions.md.
  glm::dvec3 radiance(const glm::dvec3& direction, const BlockDirections& block) const;

 private:
  EnvironmentLookUp() = default;
  double level_of_cube(const glm::dvec3& direction, const BlockDirections& block) const;
  double level_of_angle(const BlockDirections& block) const;
  void add_levels(CubeImages faces);
  void add_levels(Image<Rgba32F> picture, Surroundings (*as_surroundings)(Image<Rgba32F>));

  description::Environment::LookUp kind_ = description::Environment::LookUp::cube;
  glm::dmat3 map_from_world_{1.0};
  std::vector<std::function<glm::dvec3(const glm::dvec3&)>> levels_;  // each by bilinear filtering
  double texels_per_radian_ = 1;      // of panoramas and sphere maps
  double cube_size_ = 1;              // texels
};

}  // namespace tuberia::witness
