#pragma once
// What may happen to a fragment between its program and its depth test: fog, and tests of its alpha.

#include <cstdint>

#include "image/image.hpp"
#include "raster/depth_state.hpp"

namespace tuberia {

/// Drops fragments whose alpha does not stand in this relation to the reference.
struct AlphaTest {
  Compare test = Compare::always;
  float reference = 0;  // [0, 1]
  bool operator==(const AlphaTest&) const = default;
};

/// Share f of the fragment's colour that the fog lets through, at fog coordinate c, clamped to [0, 1]:
/// linear (end - c) / (end - start); exp e^-(density c); exp2 e^-(density c)^2.
enum class FogMode : std::uint8_t { off, linear, exp, exp2 };

struct FogState {
  FogMode mode = FogMode::off;
  Rgba32F colour{0, 0, 0, 0};  // linear; its alpha is not used: fog leaves alpha alone
  float density = 1, start = 0, end = 1;  // density >= 0; with start = end a step: all the colour before it, none from there on
  bool per_vertex = false;  // the share is computed at the vertices and interpolated like a colour, not at each fragment
  bool operator==(const FogState&) const = default;
};

/// Multisampling.
struct SampleState {
  bool alpha_to_coverage = false;  // a fragment of alpha A keeps only floor(A n + 1/2) of n samples, the first ones
  bool operator==(const SampleState&) const = default;
};

}  // namespace tuberia
