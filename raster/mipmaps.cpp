#include "raster/mipmaps.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace tuberia {
namespace {

/// Which texels of a row of `size` make texel i of the halved row, and with which weights: two
/// halves of an even row; of an odd row 2m+1 three, sharing the outer ones with the neighbours.
struct Taps {
  int first = 0, count = 1;
  std::array<float, 3> weight{1, 0, 0};
};

Taps taps_of(int size, int i) {
  if (size == 1) return {};
  if (size % 2 == 0) return {.first = 2 * i, .count = 2, .weight = {0.5f, 0.5f, 0}};
  const int half = size / 2;
  const float unit = 1.0f / static_cast<float>(size);
  return {.first = 2 * i, .count = 3,
          .weight = {static_cast<float>(half - i) * unit, static_cast<float>(half) * unit,
                     static_cast<float>(i + 1) * unit}};
}

/// One channel of a mean: the weights of thirds and fifths do not add up to 1 to the last digit, so
/// the sum is kept within the texels' range, and a constant stays one.                 [rules T1]
struct Mean {
  float sum = 0, low = std::numeric_limits<float>::infinity(), high = -low;
  void add(float weight, float texel) {
    sum += weight * texel;
    low = std::min(low, texel);
    high = std::max(high, texel);
  }
  float value() const { return sum < low ? low : sum > high ? high : sum; }
};

Rgba32F weighted_mean(const LinearLevel& from, const Taps& columns, const Taps& rows, const Taps& slices) {
  Mean r, g, b, a;
  for (int k = 0; k < slices.count; ++k)
    for (int j = 0; j < rows.count; ++j)
      for (int i = 0; i < columns.count; ++i) {
        const auto of = [](const Taps& taps, int n) { return taps.weight[static_cast<std::size_t>(n)]; };
        const float weight = of(slices, k) * (of(rows, j) * of(columns, i));
        const std::size_t row = static_cast<std::size_t>(slices.first + k) * static_cast<std::size_t>(from.height) + static_cast<std::size_t>(rows.first + j);
        const Rgba32F& texel = from.texels[row * static_cast<std::size_t>(from.width) + static_cast<std::size_t>(columns.first + i)];
        r.add(weight, texel.r);
        g.add(weight, texel.g);
        b.add(weight, texel.b);
        a.add(weight, texel.a);
      }
  return {r.value(), g.value(), b.value(), a.value()};
}

}  // namespace

LinearLevel halved(const LinearLevel& from, bool halve_slices) {
  LinearLevel to{.width = std::max(1, from.width / 2), .height = std::max(1, from.height / 2),
                 .slices = halve_slices ? std::max(1, from.slices / 2) : from.slices, .texels = {}};
  to.texels.reserve(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * static_cast<std::size_t>(to.slices));
  std::vector<Taps> columns(static_cast<std::size_t>(to.width));
  for (int x = 0; x < to.width; ++x) columns[static_cast<std::size_t>(x)] = taps_of(from.width, x);
  for (int z = 0; z < to.slices; ++z) {
    const Taps slices = halve_slices ? taps_of(from.slices, z) : Taps{.first = z};
    for (int y = 0; y < to.height; ++y) {
      const Taps rows = taps_of(from.height, y);
      for (const Taps& column : columns) to.texels.push_back(weighted_mean(from, column, rows, slices));
    }
  }
  return to;
}

}  // namespace tuberia
