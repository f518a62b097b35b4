#include "image/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "image/limits.hpp"
#include "image/ssim.hpp"

namespace tuberia {
namespace {

using DecodeTable = std::array<double, 256>;

/// The intensity of every sRGB code.                          [IEC61966] in docs/sources.md
DecodeTable srgb_decode_table() {
  DecodeTable intensities{};
  for (int code = 0; code < 256; ++code) {
    const double encoded = code / 255.0;
    intensities[code] = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
  }
  return intensities;
}

/// The compressive function of L*a*b*, of an intensity relative to white.
double lab_curve(double ratio) {
  constexpr double kDelta = 6.0 / 29.0;
  return ratio > kDelta * kDelta * kDelta ? std::cbrt(ratio)
                                          : ratio / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

Lab lab_from_srgb(const Rgba8& pixel, const DecodeTable& intensities) {
  const double r = intensities[pixel.r], g = intensities[pixel.g], b = intensities[pixel.b];
  const double x = 0.4124564 * r + 0.3575761 * g + 0.1804375 * b;
  const double y = 0.2126729 * r + 0.7151522 * g + 0.0721750 * b;
  const double z = 0.0193339 * r + 0.1191920 * g + 0.9503041 * b;

  // White is the sum of the matrix's columns, so that every grey has a and b of 0.
  constexpr double kWhiteX = 0.4124564 + 0.3575761 + 0.1804375;
  constexpr double kWhiteY = 0.2126729 + 0.7151522 + 0.0721750;
  constexpr double kWhiteZ = 0.0193339 + 0.1191920 + 0.9503041;
  const double fx = lab_curve(x / kWhiteX), fy = lab_curve(y / kWhiteY), fz = lab_curve(z / kWhiteZ);
  return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

int difference(std::uint8_t a, std::uint8_t b) { return std::abs(int{a} - int{b}); }

/// 10 log10(255^2 / mean squared error).
double psnr_db(std::int64_t sum_of_squares, std::int64_t component_count) {
  if (sum_of_squares == 0) return std::numeric_limits<double>::infinity();
  const double mean = static_cast<double>(sum_of_squares) / static_cast<double>(component_count);
  return 10.0 * std::log10(255.0 * 255.0 / mean);
}

std::uint8_t visible(int difference_codes) {
  return difference_codes == 0 ? std::uint8_t{0}
                               : static_cast<std::uint8_t>(std::min(255, 64 + 8 * difference_codes));
}

Rgba8 visible_difference(const Rgba8& a, const Rgba8& b) {
  const Rgba8 shown{visible(difference(a.r, b.r)), visible(difference(a.g, b.g)),
                    visible(difference(a.b, b.b)), 255};
  const bool only_alpha = shown == Rgba8{} && a.a != b.a;
  return only_alpha ? Rgba8{255, 255, 255, 255} : shown;
}

}  // namespace

Result<Comparison> compare(const Image<Rgba8>& a, const Image<Rgba8>& b) {
  if (a.width() != b.width() || a.height() != b.height()) {
    return Error{"cannot compare images of different sizes: " + size_text(a.width(), a.height()) +
                 " and " + size_text(b.width(), b.height())};
  }
  if (a.empty()) return Error{"cannot compare images without pixels"};

  const DecodeTable intensities = srgb_decode_table();
  Comparison result;
  std::int64_t sum_of_squares = 0;
  double sum_of_ciede2000 = 0.0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba8 p = a.pixels()[i], q = b.pixels()[i];
    if (p == q) continue;
    const int dr = difference(p.r, q.r), dg = difference(p.g, q.g), db = difference(p.b, q.b);
    result.largest_difference = std::max({result.largest_difference, dr, dg, db, difference(p.a, q.a)});
    ++result.differing_pixels;
    sum_of_squares += dr * dr + dg * dg + db * db;
    if (dr + dg + db == 0) continue;
    const double colour = ciede2000(lab_from_srgb(p, intensities), lab_from_srgb(q, intensities));
    sum_of_ciede2000 += colour;
    result.largest_ciede2000 = std::max(result.largest_ciede2000, colour);
  }

  const auto pixel_count = static_cast<std::int64_t>(a.pixels().size());
  result.equal = result.differing_pixels == 0;
  result.psnr_db = psnr_db(sum_of_squares, 3 * pixel_count);
  result.mean_ciede2000 = sum_of_ciede2000 / static_cast<double>(pixel_count);
  result.ssim = sum_of_squares == 0 ? 1.0 : mean_ssim(a, b);
  return result;
}

Image<Rgba8> difference_image(const Image<Rgba8>& a, const Image<Rgba8>& b) {
  constexpr Rgba8 kOnlyInOne{255, 0, 255, 255};
  Image<Rgba8> result(std::max(a.width(), b.width()), std::max(a.height(), b.height()), kOnlyInOne);
  for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
    for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
      result.at(x, y) = visible_difference(a.at(x, y), b.at(x, y));
    }
  }
  return result;
}

}  // namespace tuberia
