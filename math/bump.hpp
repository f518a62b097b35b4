#pragma once
// Relief that only the normals know of, in double precision: what references and tests go by. The
// pipeline's form is pipeline/programs/bump-inl.hpp.                              [A 1.2] [B 4.2.1]

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "math/lattice_noise.hpp"

namespace tuberia {

/// A surface's tangents dp/du and dp/dv at a point, lengths kept, and its unit normal there.
struct SurfaceFrame {
  glm::dvec3 tangent{1, 0, 0}, bitangent{0, 1, 0}, normal{0, 0, 1};
};

/// The unit normal of the surface p + height * normal from the height's derivatives by u and v, in the
/// tangents' units: n'' = J n + d_u (n x t_v) + d_v (t_u x n) with J = (t_u x t_v).n; turned round where J < 0,
/// which are mirrored coordinates [FIX 10]. The notes' t_u x t_v is J n where n is at right angles to both; interpolated normals
/// are so only nearly, and J n leaves them as they are where there is no relief. That height is small is taken for granted (height * dn/du is dropped).
/// The normal comes back unchanged from a slope of 0 and from tangents that are 0, not finite, or parallel
/// to 1e-6 once projected at right angles to n.
glm::dvec3 perturbed_normal(const SurfaceFrame& frame, const glm::dvec2& slope) noexcept;

/// The normal that a picture of normals asks for: x along the tangent, y against the bitangent (up in the
/// picture, whose v runs down), z along the normal; below 0 counts as 0. gain multiplies the slopes x/z and y/z.
glm::dvec3 mapped_normal(const SurfaceFrame& frame, const glm::dvec3& tangent_space_normal, double gain) noexcept;

/// gain * (f(u + D, v) - f(u - D, v)) / (2 D), and the same by v.                          [A 1.2]
template <class Height>
glm::dvec2 central_differences(const Height& height, const glm::dvec2& uv, const glm::dvec2& step, double gain) {
  return {gain * (height(uv.x + step.x, uv.y) - height(uv.x - step.x, uv.y)) / (2 * step.x),
          gain * (height(uv.x, uv.y + step.y) - height(uv.x, uv.y - step.y)) / (2 * step.y)};
}

/// Reliefs in closed form with their derivatives by u and v. `scale` counts waves, dimples or bumps along
/// one unit of u and of v; where it is a whole number the relief repeats with each unit, so that surfaces
/// that close have no seam.
/// Sines along u, along v and across both, a third each: within [-1, 1].
HeightAndSlope waves(const glm::dvec2& uv, double scale) noexcept;
/// Dimples, one in each square at a random place, with radii of 0.35 to 0.65 squares: -(1 - r^2)^2 each; heights in [-9, 0], mostly
/// above -1.
HeightAndSlope orange(const glm::dvec2& uv, double scale, std::uint32_t seed) noexcept;
/// Two octaves of gradient noise: within [-1, 1].
HeightAndSlope rough(const glm::dvec2& uv, double scale, std::uint32_t seed) noexcept;

/// After how many cells a relief of that scale repeats: the scale if it is a whole number, or never.
double relief_period(double scale) noexcept;

}  // namespace tuberia
