#pragma once
// From covered samples to the colour of a fragment, and the tests that it must pass.

#include "reference/oracle/coverage.hpp"
#include "reference/oracle/state.hpp"
#include "reference/oracle/target.hpp"

namespace tuberia::oracle {

/// The attributes of a fragment at the centre of its pixel: weights with perspective, as bounds.
struct FragmentWeights {
  Interval one, two;
};
FragmentWeights perspective_weights(const Shape&, const Draw&, int x, int y);
Interval interpolated(const Shape&, const FragmentWeights&, std::size_t scalar);

struct ShadedFragment {
  Colour colour;
  Outcome is_kept = Outcome::yes;  // what became of it in the program
};
/// The program, and the fog.
ShadedFragment shaded(const Shape&, const Draw&, int x, int y);

/// Whether sample `sample` of `samples` survives alpha to coverage and the alpha test.
Outcome alpha_keeps(const Draw&, Interval alpha, int sample, int samples);

/// Stencil and depth test of a sample, with their effects on it; whether both pass.
bool stencil_and_depth(Sample&, const Draw&, bool is_back, float depth, DepthFormat);

}  // namespace tuberia::oracle
