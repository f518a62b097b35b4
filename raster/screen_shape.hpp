#pragma once
// What a point or a line needs on the screen beside its ScreenTriangle record.

#include <cstdint>

namespace tuberia {

/// A line's pattern: bit (counter / factor) mod 16 of `bits`, lowest first, says whether a fragment
/// is drawn; the counter counts pixels along the major axis.
struct StipplePattern {
  std::uint16_t bits = 0xffff;
  int factor = 1;  // 1..256
  bool operator==(const StipplePattern&) const = default;
};

/// One entry for each ScreenTriangle of a chunk that holds points or lines. The record of a point or
/// line uses only bounds, depths, 1/w, vertices and numbers: weight 1 runs from 0 at vertex[0] to 1
/// at vertex[1] of a line, all other weights are 0; vertex[2] repeats another vertex.
struct ScreenShape {
  enum class Kind : std::uint8_t { triangle, line, point };
  Kind kind = Kind::triangle;
  bool round = false;                    // points: a disc, not a square
  std::int32_t x[2] = {}, y[2] = {};     // 24.8 units; both ends of a line; a point's centre is the first
  std::int32_t size = 256;               // width or diameter, 24.8 units; of aliased lines a whole number of pixels
  std::uint32_t stipple_start = 0;       // the counter at the line's first pixel
};

}  // namespace tuberia
