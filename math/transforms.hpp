#pragma once
// The matrices of the chain object -> world -> view -> clip. They act on column vectors, are
// computed in double and rounded once to float, so that no float function of a C library is in
// their bits. Names read to_from_source.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "base/result.hpp"
#include "math/spaces.hpp"

namespace tuberia {

/// A camera's axes in world space, unit and perpendicular: u right, v up, w BACKWARDS [C 2.1].
struct CameraBasis {
  glm::dvec3 u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};
  bool operator==(const CameraBasis&) const = default;
};

/// What an eye sees [C 2.3, 2.4]: a window and two distances, view space, world units.
/// left..top: the window, for a perspective view on the plane at near_distance.
/// near_distance, far_distance: along -z. An orthographic view takes any near < far, a perspective
/// one 0 < near < far, and far may be infinite.
struct ViewVolume {
  double left = -1, right = 1, bottom = -1, top = 1, near_distance = 0.1, far_distance = 100;
  bool operator==(const ViewVolume&) const = default;
};

/// The look-at basis [C 2.2]. All in world space, finite; up need not be unit or perpendicular.
/// Error when eye and point_of_interest coincide, or up is 0 or parallel to the line of sight.
Result<CameraBasis> camera_basis(const glm::dvec3& eye, const glm::dvec3& point_of_interest,
                                 const glm::dvec3& up);

/// The view matrix [C 2.5]: eye goes to the origin, the axes of the basis to x, y and z.
glm::mat4 view_from_world(const CameraBasis& basis, const glm::dvec3& eye) noexcept;

/// The symmetric window of a vertical opening fovy_radians in (0, pi) and an aspect
/// width / height > 0 [C 2.4]. Error naming the parameter that is out of range.
Result<ViewVolume> perspective_volume(double fovy_radians, double aspect, double near_distance,
                                      double far_distance);

/// The centred window of an orthographic view, world units [C 2.3]. width, height > 0 and finite, near < far finite.
/// Error naming the parameter that is out of range.
Result<ViewVolume> orthographic_volume(double width, double height, double near_distance, double far_distance);

/// The clip matrix of a parallel view [C 3.3], w = 1. reversed_depth swaps the two ends of z: near
/// gets what far got. Error for an empty, unordered or non-finite volume.
Result<glm::mat4> orthographic(const ViewVolume& view, ClipVolume clip_volume, bool reversed_depth = false);

/// The clip matrix of a perspective view through any window [C 3.4, FIX 2], w = distance along -z.
/// reversed_depth swaps the two ends of z, which evens out the precision of a float depth buffer
/// with ClipVolume::zero_to_w. Error as for orthographic, and for near_distance <= 0.
Result<glm::mat4> frustum(const ViewVolume& view, ClipVolume clip_volume, bool reversed_depth = false);

/// frustum of perspective_volume, with the errors of both.
Result<glm::mat4> perspective(double fovy_radians, double aspect, double near_distance, double far_distance,
                              ClipVolume clip_volume, bool reversed_depth = false);

glm::mat4 translation(const glm::dvec3& offset) noexcept;

/// Factors along x, y and z; 0 and negative ones are allowed.
glm::mat4 scaling(const glm::dvec3& factors) noexcept;

/// Counter-clockwise rotation about an axis through the origin, seen against the axis's direction.
/// The axis need not be unit; the zero axis gives the identity.
glm::mat4 rotation(const glm::dvec3& axis, double angle_radians) noexcept;

/// Reflection at the plane of the points p with normal . p = distance. The normal need not be unit; a
/// zero one gives the identity. It is its own inverse and turns every winding round.
glm::mat4 mirror(const glm::dvec3& normal, double distance) noexcept;

/// The product to_from_middle * middle_from_source, summed in double and rounded once.
glm::mat4 compose(const glm::mat4& to_from_middle, const glm::mat4& middle_from_source) noexcept;

/// What normals are multiplied with: the inverse transpose of the linear part. Never NaN or Inf
/// for a finite matrix: a singular one (flattened to a plane) gives its cofactors with the largest
/// set to 1, which still turn normals onto the plane's; one that leaves only a line or a point
/// gives the identity. The results are not unit: normalize after multiplying.
glm::mat3 normal_matrix(const glm::mat4& world_from_object) noexcept;

}  // namespace tuberia
