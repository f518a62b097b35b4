#include <cmath>
#include <numbers>

#include "image/compare.hpp"

namespace tuberia {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// sqrt(c^7 / (c^7 + 25^7)), which corrects both the a axis and the rotation.
double chroma_weight(double chroma) {
  const double c2 = chroma * chroma;
  const double c7 = c2 * c2 * c2 * chroma;
  constexpr double k25To7 = 6103515625.0;
  return std::sqrt(c7 / (c7 + k25To7));
}

/// Equation 7: in [0, 2 pi); 0 for grey, whose hue is undefined.
double hue_radians(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.0;
  const double hue = std::atan2(b, a);
  return hue < 0.0 ? hue + kTurn : hue;
}

/// Equation 10: the shorter way round from one hue to the other.
double hue_difference(double from, double to) {
  const double difference = to - from;
  if (difference > std::numbers::pi) return difference - kTurn;
  if (difference < -std::numbers::pi) return difference + kTurn;
  return difference;
}

/// Equation 14: halfway along the shorter way round.
double mean_hue(double first, double second) {
  const double sum = first + second;
  if (std::abs(first - second) <= std::numbers::pi) return 0.5 * sum;
  return 0.5 * (sum < kTurn ? sum + kTurn : sum - kTurn);
}

/// Equation 15.
double hue_weight(double hue) {
  return 1.0 - 0.17 * std::cos(hue - radians(30)) + 0.24 * std::cos(2 * hue) +
         0.32 * std::cos(3 * hue + radians(6)) - 0.20 * std::cos(4 * hue - radians(63));
}

/// Equations 16, 17 and 21: the interaction of chroma and hue among the blues.
double rotation(double hue, double chroma) {
  const double distance = (hue - radians(275)) / radians(25);
  const double angle = radians(30) * std::exp(-distance * distance);
  return -std::sin(2.0 * angle) * 2.0 * chroma_weight(chroma);
}

}  // namespace

double ciede2000(const Lab& first, const Lab& second) noexcept {
  // Greys are moved along a so that the formula fits them too.
  const double stretch =
      1.5 - 0.5 * chroma_weight(0.5 * (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)));
  const double a1 = first.a * stretch, a2 = second.a * stretch;
  const double chroma1 = std::hypot(a1, first.b), chroma2 = std::hypot(a2, second.b);
  const double hue1 = hue_radians(a1, first.b), hue2 = hue_radians(a2, second.b);
  const bool any_grey = chroma1 * chroma2 == 0.0;

  const double lightness_difference = second.l - first.l;
  const double chroma_difference = chroma2 - chroma1;
  const double hue_chord =
      any_grey ? 0.0 : 2.0 * std::sqrt(chroma1 * chroma2) * std::sin(0.5 * hue_difference(hue1, hue2));

  const double lightness = 0.5 * (first.l + second.l) - 50.0;
  const double chroma = 0.5 * (chroma1 + chroma2);
  const double hue = any_grey ? hue1 + hue2 : mean_hue(hue1, hue2);

  const double l = lightness_difference /
                   (1.0 + 0.015 * lightness * lightness / std::sqrt(20.0 + lightness * lightness));
  const double c = chroma_difference / (1.0 + 0.045 * chroma);
  const double h = hue_chord / (1.0 + 0.015 * chroma * hue_weight(hue));
  return std::sqrt(l * l + c * c + h * h + rotation(hue, chroma) * c * h);
}

}  // namespace tuberia
