#pragma once
// Cutting primitives in clip space.

#include <array>
#include <vector>

#include "reference/oracle/vertices.hpp"

namespace tuberia::oracle {

/// A corner of a clipped primitive: where it is, and its shares of the primitive's own vertices.
struct Corner {
  double x = 0, y = 0, z = 0, w = 1;
  std::array<double, 3> weight{};

  /// The number of the vertex that this corner is, or -1.
  int vertex() const;
};

/// One half-space of clip space.
struct ClipPlane {
  enum class Kind { near_plane, far_plane, left, right, bottom, top, behind, user };
  Kind kind = Kind::near_plane;
  double lowest_z = -1, guard = 1;  // zl; gx or gy
  glm::dvec4 user{0};

  bool is_outside(const ClipVertex&) const;
  double distance(const Corner&) const;
  void settle(Corner&) const;  // moves a new corner exactly onto the plane
};

/// In the order in which they cut.
std::vector<ClipPlane> clip_planes(const Draw&, const Viewport&);

/// The polygon (3 corners or more, in the order of the primitive), line (2) or point (1) that is
/// left of a primitive; empty if nothing is. `was_cut`: it crossed a plane.
std::vector<Corner> clipped(const std::vector<ClipVertex>& vertices, const std::vector<ClipPlane>& planes, bool& was_cut);

}  // namespace tuberia::oracle
