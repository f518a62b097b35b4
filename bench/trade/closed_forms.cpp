#include "bench/trade/closed_forms.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "math/colour.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kTexels = 256;

double sinc(double x) { return std::abs(x) < 1e-9 ? 1 : std::sin(x) / x; }

/// Mean size of a sum of four variables spread evenly over intervals of these widths about 0, from its characteristic
/// function: (2/pi) times the integral over u > 0 of (1 - phi(u)) / u^2.
double mean_size_of_sum(const double (&widths)[4]) {
  constexpr double kStep = 0.1, kEnd = 200;
  double sum = 0;
  for (double u = kStep / 2; u < kEnd; u += kStep) {
    double phi = 1;
    for (const double width : widths) phi *= sinc(width * u / 2);
    sum += (1 - phi) / (u * u) * kStep;
  }
  return 2 / kPi * (sum + 1 / kEnd);
}

/// The depth that an eye of these distances stores for a distance.
double depth_of(double distance, bool reversed) {
  constexpr double kNear = 0.1, kFar = 1e4;
  return reversed ? kNear / (kFar - kNear) * (kFar / distance - 1) : kFar / (kFar - kNear) * (1 - kNear / distance);
}

/// Grows with the distance.
double code_of(double distance, DepthCoding coding) {
  switch (coding) {
    case DepthCoding::unorm16:
      return std::floor(depth_of(distance, false) * 65535 + 0.5);
    case DepthCoding::unorm24:
      return std::floor(depth_of(distance, false) * 16777215 + 0.5);
    case DepthCoding::float32:
      return static_cast<double>(static_cast<float>(depth_of(distance, false)));
    case DepthCoding::float32_reversed:
      return -static_cast<double>(static_cast<float>(depth_of(distance, true)));
  }
  return 0;
}

/// Area of the unit square about the origin on the side of the line cos x + sin y <= offset, 0 <= sin <= cos.
double area_below(double cos, double sin, double offset) {
  const double half = (cos + sin) / 2, flat = (cos - sin) / 2;
  if (offset <= -half) return 0;
  if (offset > 0) return 1 - area_below(cos, sin, -offset);
  if (offset < -flat) return (offset + half) * (offset + half) / (2 * cos * sin);
  return 0.5 + offset / cos;
}

double fresnel(double cosine, double index) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
  const double s = (cosine - index * inside) / (cosine + index * inside);
  const double p = (index * cosine - inside) / (index * cosine + inside);
  return (s * s + p * p) / 2;
}

}  // namespace

double wrong_pixels_by_rounding(int bits) {
  constexpr int kDirections = 24, kPlaces = 24;
  double sum = 0;
  for (int i = 0; i < kDirections; ++i)
    for (int j = 0; j < kPlaces; ++j) {
      const double angle = kPi / 4 * (i + 0.5) / kDirections, along = (j + 0.5) / kPlaces;
      const double cos = std::cos(angle), sin = std::sin(angle);
      sum += mean_size_of_sum({cos * (1 - along), sin * (1 - along), cos * along, sin * along});
    }
  return std::ldexp(1000 * sum / (kDirections * kPlaces), -bits);
}

double perspective_coordinate(double t, double w_right) noexcept { return t / w_right / ((1 - t) + t / w_right); }

double texel_error_by_steps(double w_right, int step, double phase) {
  double largest = 0;
  for (int x = 0; x < kTexels; ++x) {
    const double begin = x / step * step + phase, at = x + 0.5;
    const auto u = [&](double pixel) { return kTexels * perspective_coordinate(pixel / kTexels, w_right); };
    const double share = (at - begin) / step, linear = (1 - share) * u(begin) + share * u(begin + step);
    largest = std::max(largest, std::abs(linear - u(at)));
  }
  return largest;
}

// u(t) = t / (w - (w - 1) t) has u'' = 2 w (w - 1) / (w - (w - 1) t)^3, largest at t = 1.
double texel_error_bound(double w_right, int step) { return step * step / 8.0 * 2 * w_right * (w_right - 1) / kTexels; }

double misordered_pairs(DepthCoding coding, double relative_gap) {
  constexpr int kPairs = 200'000;
  const double range = std::log(1e4 / 0.1 / (1 + relative_gap));
  int wrong = 0;
  for (int i = 0; i < kPairs; ++i) {
    const double distance = 0.1 * std::exp(range * (i + 0.5) / kPairs);
    wrong += code_of(distance, coding) < code_of(distance * (1 + relative_gap), coding) ? 0 : 1;
  }
  return static_cast<double>(wrong) / kPairs;
}

double coverage_rms(std::span<const glm::dvec2> samples, double lean) {
  constexpr int kDirections = 720, kOffsets = 400;
  double squares = 0, weight = 0;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (int i = 0; i < kDirections; ++i) {
      const double angle = quarter * kPi / 2 + lean * (2 * (i + 0.5) / kDirections - 1);
      const double x = std::cos(angle), y = std::sin(angle);
      const double cos = std::max(std::abs(x), std::abs(y)), sin = std::min(std::abs(x), std::abs(y)),
                   reach = (cos + sin) / 2;
      for (int j = 0; j < kOffsets; ++j) {
        const double offset = reach * (2 * (j + 0.5) / kOffsets - 1);
        const auto inside = std::count_if(samples.begin(), samples.end(),
                                          [&](const glm::dvec2& at) { return x * at.x + y * at.y <= offset; });
        const double error =
            static_cast<double>(inside) / static_cast<double>(samples.size()) - area_below(cos, sin, offset);
        squares += reach * error * error;  // an edge crosses pixels in proportion to its reach
        weight += reach;
      }
    }
  return std::sqrt(squares / weight);
}

double gouraud_highlight(double lean_degrees, double shininess) noexcept {
  return std::pow(std::cos(lean_degrees * kPi / 180), shininess);
}

double mean_normal_length(double between_degrees) noexcept { return std::cos(between_degrees / 2 * kPi / 180); }

double length_after_one_step(double between_degrees) noexcept {
  const double length = mean_normal_length(between_degrees);
  return length * (1.5 - 0.5 * length * length);
}

double schlick_power_error(double exponent) {
  double largest = 0;
  for (int i = 0; i <= 100'000; ++i) {
    const double t = i / 100'000.0;
    largest = std::max(largest, std::abs(t / (exponent - exponent * t + t) - std::pow(t, exponent)));
  }
  return largest;
}

double schlick_fresnel_error(double index) {
  const double normal = (index - 1) * (index - 1) / ((index + 1) * (index + 1));
  double largest = 0;
  for (int i = 0; i <= 100'000; ++i) {
    const double cosine = i / 100'000.0;
    largest = std::max(largest, std::abs(normal + (1 - normal) * std::pow(1 - cosine, 5) - fresnel(cosine, index)));
  }
  return largest;
}

double fast_inverse_root_error(int newton_steps) {
  double largest = 0;
  for (float x = 1; x < 4; x += 0x1p-14f) {  // the error repeats with every factor of four
    float y = std::bit_cast<float>(0x5f3759dfu - (std::bit_cast<std::uint32_t>(x) >> 1));
    for (int i = 0; i < newton_steps; ++i) y = y * (1.5f - 0.5f * x * y * y);
    largest = std::max(largest, std::abs(static_cast<double>(y) * std::sqrt(static_cast<double>(x)) - 1));
  }
  return largest;
}

int white_under_layers_in_codes(int layers) {
  int code = 255;
  for (int i = 0; i < layers; ++i) code = static_cast<int>(std::floor(code * (254.0 / 255) + 0.5));
  return code;
}

double white_under_layers(int layers) noexcept { return 255 * std::pow(254.0 / 255, layers); }

int srgb_codes_kept_by_linear_codes() {
  std::set<int> kept;
  for (int code = 0; code < 256; ++code)
    kept.insert(static_cast<int>(std::floor(255 * linear_from_srgb(code / 255.0) + 0.5)));
  return static_cast<int>(kept.size());
}

int codes_missed_by_plain_gamma() {
  int most = 0;
  for (int code = 0; code < 256; ++code) {
    const double intensity = linear_from_srgb(code / 255.0);
    most = std::max(most, std::abs(static_cast<int>(std::floor(255 * std::pow(intensity, 1 / 2.2) + 0.5)) - code));
  }
  return most;
}

double axis_level_of_detail(glm::dvec2 dx, glm::dvec2 dy, double most_samples) noexcept {
  const double longer = std::max(glm::length(dx), glm::length(dy)),
               shorter = std::min(glm::length(dx), glm::length(dy));
  return std::log2(longer / std::min(longer / shorter, most_samples));
}

double ellipse_level_of_detail(glm::dvec2 dx, glm::dvec2 dy, double most_samples) noexcept {
  // Singular values of the matrix of both: of its square the sum is the trace, the product the determinant.
  const double trace = glm::dot(dx, dx) + glm::dot(dy, dy), determinant = dx.x * dy.y - dx.y * dy.x;
  const double root = std::sqrt(std::max(0.0, trace * trace - 4 * determinant * determinant));
  const double longer = std::sqrt((trace + root) / 2), shorter = std::sqrt(std::max(0.0, (trace - root) / 2));
  return std::log2(longer / std::min(longer / shorter, most_samples));
}

}  // namespace tuberia::bench::trade
