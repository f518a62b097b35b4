#include "reference/oracle/fog.hpp"

#include <cmath>

namespace tuberia::oracle {
namespace {

Interval mapped(Interval a, double (*increasing)(double)) { return {increasing(a.low), increasing(a.high)}; }

}  // namespace

Interval fog_share(const Fog& fog, Interval c) {
  if (!c.is_known()) return unknown();
  const Interval density = static_cast<double>(fog.density);
  const Interval start = static_cast<double>(fog.start), end = static_cast<double>(fog.end);
  if (fog.mode == FogMode::linear) {
    const Interval share = (end - c) / (end - start);
    return share.is_known() ? clamped(share, 0, 1) : Interval{0, 1};
  }
  Interval thickness = density * c;
  if (fog.mode == FogMode::exp2) thickness = thickness * thickness;
  if (!thickness.is_known()) return {0, 1};
  // The documents allow e^x an error: that of the exponent scaled, and that of the power itself.
  thickness = widened(thickness, 0x1p-21);
  return clamped(widened(mapped(-thickness, [](double x) { return std::exp(x); }), 1e-6), 0, 1);
}

}  // namespace tuberia::oracle
