#pragma once
// The surroundings that an environment names, read or made.

#include <glm/mat3x3.hpp>
#include <variant>

#include "base/result.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/environment/surroundings.hpp"

namespace tuberia {

/// What an environment is told by: a function of the direction, a panorama, or six faces; in axes of its own.
using EnvironmentPicture = std::variant<Surroundings, Image<Rgba32F>, CubeImages>;

/// Errors: of the files' readers, and for one that is rendered, which has to be drawn first.
Result<EnvironmentPicture> environment_picture(const SceneDescription& scene, const description::Environment& environment);

/// The same as a function of the direction.
Surroundings surroundings_of(EnvironmentPicture picture);

/// The surroundings' axes from the world's: the environment's rotation.
glm::dmat3 source_from_world(const description::Environment& environment) noexcept;

/// Surroundings as they are seen in axes that are turned: source_from_map takes a direction to one of the source.
Surroundings turned(Surroundings source, const glm::dmat3& source_from_map);

}  // namespace tuberia
