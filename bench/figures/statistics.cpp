#include "bench/figures/statistics.hpp"

#include <algorithm>
#include <cmath>

#include "base/assertion.hpp"

namespace tuberia::bench {

double median(std::vector<double> values) {
  TUBERIA_ASSERT(!values.empty(), "the median of nothing");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double geometric_mean(std::span<const double> values) {
  TUBERIA_ASSERT(!values.empty(), "the geometric mean of nothing");
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

std::optional<PowerLaw> fit_power_law(std::span<const CurvePoint> points) {
  if (points.size() < 2) return {};
  const auto count = static_cast<double>(points.size());
  double mean_x = 0, mean_y = 0;
  for (const CurvePoint& point : points) {
    mean_x += std::log(point.x) / count;
    mean_y += std::log(point.y) / count;
  }
  double xx = 0, xy = 0;
  for (const CurvePoint& point : points) {
    const double x = std::log(point.x) - mean_x;
    xx += x * x;
    xy += x * (std::log(point.y) - mean_y);
  }
  if (!(xx > 0)) return {};

  PowerLaw law{.exponent = xy / xx, .factor = std::exp(mean_y - xy / xx * mean_x)};
  if (points.size() > 2) {
    double residuals = 0;
    for (const CurvePoint& point : points) {
      const double off = std::log(point.y) - mean_y - law.exponent * (std::log(point.x) - mean_x);
      residuals += off * off;
    }
    law.standard_error = std::sqrt(residuals / (count - 2) / xx);
  }
  return law;
}

std::optional<PowerLaw> fit_upper_half(std::span<const CurvePoint> points) {
  std::vector<CurvePoint> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; });
  const std::size_t half = std::min(sorted.size(), std::max<std::size_t>(3, (sorted.size() + 1) / 2));
  return fit_power_law(std::span(sorted).last(half));
}

}  // namespace tuberia::bench
