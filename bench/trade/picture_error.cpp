#include "bench/trade/picture_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/compare.hpp"
#include "math/colour.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr double kLargestCode = 255;

double code_of(float intensity, Signal signal) {
  // What is not a number becomes 0, as in a target of codes.
  const double clamped = intensity > 0 ? std::min(static_cast<double>(intensity), 1.0) : 0.0;
  return kLargestCode * (signal == Signal::linear ? srgb_from_linear(clamped) : clamped);
}

using Codes = std::array<double, 3>;

Codes codes_of(const Rgba32F& pixel, Signal signal) {
  return {code_of(pixel.r, signal), code_of(pixel.g, signal), code_of(pixel.b, signal)};
}

Rgba8 rounded(const Codes& codes) {
  const auto round = [](double code) { return static_cast<std::uint8_t>(std::floor(code + 0.5)); };
  return {round(codes[0]), round(codes[1]), round(codes[2]), 255};
}

}  // namespace

Image<Rgba8> screen_codes(const Image<Rgba32F>& picture, Signal signal) {
  Image<Rgba8> codes(picture.width(), picture.height());
  for (std::size_t i = 0; i < codes.pixels().size(); ++i)
    codes.pixels()[i] = rounded(codes_of(picture.pixels()[i], signal));
  return codes;
}

Result<CodeError> code_error(const Image<Rgba32F>& picture, const Image<Rgba32F>& ideal, Signal signal) {
  if (picture.width() != ideal.width() || picture.height() != ideal.height() || picture.empty())
    return Error{"pictures of different sizes, or without pixels, cannot be compared"};
  CodeError error;
  double squares = 0;
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const Codes mine = codes_of(picture.pixels()[i], signal), theirs = codes_of(ideal.pixels()[i], signal);
    for (std::size_t c = 0; c < mine.size(); ++c) {
      const double difference = std::abs(mine[c] - theirs[c]);
      error.largest_code = std::max(error.largest_code, difference);
      squares += difference * difference;
    }
  }
  error.rmse_codes = std::sqrt(squares / (3 * static_cast<double>(picture.pixels().size())));
  return error;
}

Result<PictureError> picture_error(const Image<Rgba32F>& picture, const Image<Rgba32F>& ideal, Signal signal) {
  const auto codes = code_error(picture, ideal, signal);
  if (!codes) return codes.error();
  const auto compared = compare(screen_codes(picture, signal), screen_codes(ideal, signal));
  if (!compared) return compared.error();
  PictureError error{*codes};
  const auto pixels = static_cast<double>(picture.pixels().size());
  error.differing_share = static_cast<double>(compared->differing_pixels) / pixels;
  error.psnr_db = compared->psnr_db;
  error.ssim = compared->ssim;
  error.mean_ciede2000 = compared->mean_ciede2000;
  error.largest_ciede2000 = compared->largest_ciede2000;
  return error;
}

}  // namespace tuberia::bench::trade
