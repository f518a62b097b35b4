#pragma once
// Curves as SVG, inside a page of bench/figures/page.hpp, whose colours they take.

#include <optional>
#include <string>
#include <vector>

#include "bench/figures/statistics.hpp"

namespace tuberia::bench {

struct Series {
  std::string name;
  std::vector<CurvePoint> points;  // by growing x
  std::optional<PowerLaw> law{};   // drawn as a band, and named in the key
};

struct Axis {
  std::string label;        // with its unit
  bool logarithmic = true;  // then all values are positive; otherwise it begins at 0
};

struct Chart {
  Axis x, y;
  std::vector<Series> series;
};

/// "1.02 ± 0.01", or without the error if there is none.
std::string exponent_text(const PowerLaw& law);

/// Whether the curve grows faster than its x.
bool is_superlinear(const PowerLaw& law) noexcept;

/// A figure with a key; exponents above kSuperlinear are marked.
std::string figure_of(const Chart& chart);

}  // namespace tuberia::bench
