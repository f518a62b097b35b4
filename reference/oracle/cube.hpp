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

/// Whether "a <test> b" holds.
Outcome outcome_of(Compare test, Interval a, double b);

}  // namespace tuberia::oracle
