#pragma once
// Numbers made of measurements.

#include <optional>
#include <span>
#include <vector>

namespace tuberia::bench {

/// Of at least one value; the mean of the two middle ones when their number is even.
double median(std::vector<double> values);

/// The value below which this part (0..1) of at least one value lies, between neighbours by their distance.
double quantile(std::vector<double> values, double part);

/// Of at least one value, all positive.
double geometric_mean(std::span<const double> values);

/// One measured point of a curve; both positive.
struct CurvePoint {
  double x = 0, y = 0;
};

/// y = factor * x^exponent, by least squares on the logarithms.
struct PowerLaw {
  double exponent = 0, factor = 0;
  std::optional<double> standard_error{};  // of the exponent; two points alone have none
  double from = 0, to = 0;                 // the x of the points it was fitted to
};

/// Nothing for fewer than two points, or when all have one x.
std::optional<PowerLaw> fit_power_law(std::span<const CurvePoint> points);

/// The law of the upper third of a curve's points, or of the last three: how it goes on. At the lower
/// end a fixed cost lies over it and makes every curve look flat, in the middle are the steps where
/// something no longer fits a cache.
std::optional<PowerLaw> fit_upper_end(std::span<const CurvePoint> points);

/// From this on an exponent counts as more than proportional; below, as noise.
inline constexpr double kSuperlinear = 1.05;

}  // namespace tuberia::bench
