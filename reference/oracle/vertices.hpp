#pragma once
// Vertices in clip space, and how they join into primitives.

#include <array>
#include <cstdint>
#include <vector>

#include "reference/oracle/interval.hpp"
#include "reference/oracle/state.hpp"

namespace tuberia::oracle {

/// All that is interpolated; colours first.
inline constexpr std::size_t kColour = 0, kTexcoord = 4, kFogCoordinate = 6, kUnitCoordinates = 7, kScalars = 7 + 4 * kTextureUnits;
using Scalars = std::array<Interval, kScalars>;

struct ClipVertex {
  float x = 0, y = 0, z = 0, w = 1;
  Scalars front{}, back{};  // attributes of front and back faces
  bool edge_flag = true;
};

/// The vertices that arrive at assembly, in order, with the clip position (or screen w) of each.
std::vector<ClipVertex> transformed(const Draw&);

/// Numbers of the vertices of each primitive, the provoking one first; 1, 2 or 3 of them.
struct Primitive {
  int corners = 3;
  std::array<std::size_t, 3> vertex{};
};
std::vector<Primitive> assembled(Topology, std::size_t vertices);

}  // namespace tuberia::oracle
