#pragma once
// Cube maps: the faces that a direction may meet, and the texels beside a face.

#include <array>
#include <vector>

#include "reference/oracle/texture.hpp"

namespace tuberia::oracle {

struct CubeFace {
  int number = 4;  // +x, -x, +y, -y, +z, -z
  Interval s, t;
};

/// Of equal coordinates z names the face before y before x; several faces where the bounds overlap.
std::vector<CubeFace> faces_of(const std::array<Interval, 3>& direction);

/// Texel (i, j) of a face; beyond its edge, of the face that lies there.
const Colour& cube_texel(const TextureLevel&, std::int64_t i, std::int64_t j, int face);

/// A vector along a face's s and t, and outwards.
Triple in_frame(int face, const Triple& v);

/// Steps of a direction in texels of a face, seen on the plane of the face.
Steps projected_steps(int face, const Triple& direction, const Steps& steps, int size);

/// Whether "a <test> b" holds.
Outcome outcome_of(Compare test, Interval a, double b);

}  // namespace tuberia::oracle
