#include "scene/environment/background.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace tuberia {

Result<Background> Background::create(const Camera& camera) {
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  const ViewVolume& view = camera.view;
  if (!std::isfinite(view.left + view.right + view.bottom + view.top + view.near_distance)) return Error{"the camera's window is not finite"};

  Background background;
  const bool reversed = camera.reversed_depth;
  const float far_z = !reversed ? 1.0f : camera.clip_volume == ClipVolume::zero_to_w ? 0.0f : -1.0f;
  // One triangle in place of two: no quad of pixels is cut by a diagonal.
  constexpr glm::dvec2 kCorners[3] = {{-1, -1}, {3, -1}, {-1, 3}};
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 ndc = kCorners[i];
    background.clip_positions_[i] = {static_cast<float>(ndc.x), static_cast<float>(ndc.y), far_z, 1};
    // Linear over the window, so what is interpolated is right at each pixel.
    const double x = glm::mix(view.left, view.right, (ndc.x + 1) / 2), y = glm::mix(view.bottom, view.top, (ndc.y + 1) / 2);
    const bool perspective = camera.projection == Projection::perspective;
    const glm::dvec3 direction = perspective ? x * basis->u + y * basis->v - view.near_distance * basis->w : -basis->w;
    background.directions_[i] = glm::vec4(glm::vec3(direction / (perspective ? view.near_distance : 1.0)), 0);
  }
  background.state_.clipping.volume = camera.clip_volume;
  background.state_.depth.test = reversed ? Compare::greater_equal : Compare::less_equal;
  background.state_.depth.write = false;
  return background;
}

DrawCall Background::draw(const EnvironmentMap& map) const {
  return {.mesh = {.clip_positions = clip_positions_, .custom = directions_}, .program = environment_background(map), .state = state_};
}

}  // namespace tuberia
