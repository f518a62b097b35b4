#include "bench/figures/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assertion.hpp"

namespace tuberia::bench {

double quantile(std::vector<double> values, double part) {
  TUBERIA_ASSERT(!values.empty(), "the quantile of nothing");
  std::sort(values.begin(), values.end());
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

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
  const auto [least, most] = std::minmax_element(points.begin(), points.end(),
                                                 [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; });
  law.from = least->x;
  law.to = most->x;
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

std::optional<PowerLaw> fit_upper_end(std::span<const CurvePoint> points) {
  std::vector<CurvePoint> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; });
  const std::size_t third = std::min(sorted.size(), std::max<std::size_t>(3, (sorted.size() + 2) / 3));
  return fit_power_law(std::span(sorted).last(third));
}

}  // namespace tuberia::bench
