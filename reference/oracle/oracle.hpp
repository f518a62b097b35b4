#pragma once
// The scalar oracle: a fixed-function machine written to be obviously right, from docs/machine.md
// and docs/conventions.md alone. Every primitive asks every sample of the target whether it is
// covered. Slow, and independent of raster and pipeline.

#include <cstdint>

#include "reference/oracle/state.hpp"
#include "reference/oracle/target.hpp"

namespace tuberia::oracle {

struct Counts {
  std::int64_t primitives_in = 0;    // assembled
  std::int64_t clipped = 0;          // of these, cut or lost at more than one plane; points never are
  std::int64_t after_clipping = 0;   // triangles of clipped polygons' fans, lines and points
  std::int64_t drawn = 0;            // survived culling, and hold the centre of a pixel between their bounds
  std::int64_t fragments = 0;        // with a covered sample
  std::int64_t fragments_shaded = 0; // handed to the program
  std::int64_t samples_passed = 0;   // all tests
  bool are_certain = true;           // whether no decision hung on a tie
};

Counts draw(Target&, const Draw&);

}  // namespace tuberia::oracle
