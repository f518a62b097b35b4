#include "reference/oracle/texture.hpp"

#include <cmath>

namespace tuberia::oracle {
namespace {

constexpr double kWhole = 1 << 14;  // more texels apart than this: any texel at all

double decoded(std::uint8_t code, bool is_srgb) {
  const double signal = code / 255.0;
  if (!is_srgb) return signal;
  return signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
}

/// The texel that column (or row) i of an endless texture shows; -1: the border.
int wrapped(std::int64_t i, int size, Wrap wrap) {
  const auto modulo = [](std::int64_t a, std::int64_t n) { return (a % n + n) % n; };
  switch (wrap) {
    case Wrap::repeat: return static_cast<int>(modulo(i, size));
    case Wrap::clamp: return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
    case Wrap::mirror: {
      const std::int64_t m = modulo(i, 2 * static_cast<std::int64_t>(size));
      return static_cast<int>(m < size ? m : 2 * static_cast<std::int64_t>(size) - 1 - m);
    }
    case Wrap::border: return i < 0 || i >= size ? -1 : static_cast<int>(i);
  }
  return 0;
}

Colour texel(const Texture& texture, const Sampler& sampler, std::int64_t i, std::int64_t j) {
  const int x = wrapped(i, texture.width, sampler.wrap_u), y = wrapped(j, texture.height, sampler.wrap_v);
  Colour colour;
  for (std::size_t c = 0; c < 4; ++c) {
    if (x < 0 || y < 0) {
      colour[c] = widened(static_cast<double>(sampler.border[static_cast<int>(c)]));
      continue;
    }
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(texture.width) + static_cast<std::size_t>(x);
    const std::uint8_t code = texture.texels[at][c];
    colour[c] = decoded(code, texture.is_srgb && c < 3);
    if (code != 0 && code != 255) colour[c] = widened(colour[c]);
  }
  return colour;
}

Colour hull_of(const Colour& a, const Colour& b) {
  Colour colour;
  for (std::size_t c = 0; c < 4; ++c) colour[c] = hull(a[c], b[c]);
  return colour;
}

Colour anything() { return {Interval{0, 1}, Interval{0, 1}, Interval{0, 1}, Interval{0, 1}}; }

/// Part of an interval that lies in [i, i + 1], counted from i.
Interval fraction(Interval x, std::int64_t i) {
  const double base = static_cast<double>(i);
  return {std::max(x.low - base, 0.0), std::min(x.high - base, 1.0)};
}

Colour bilinear(const Texture& texture, const Sampler& sampler, std::int64_t i, std::int64_t j, Interval fx, Interval fy) {
  const Colour a = texel(texture, sampler, i, j), b = texel(texture, sampler, i + 1, j);
  const Colour c = texel(texture, sampler, i, j + 1), d = texel(texture, sampler, i + 1, j + 1);
  Colour colour;
  for (std::size_t k = 0; k < 4; ++k) {
    const Interval upper = a[k] + (b[k] - a[k]) * fx, lower = c[k] + (d[k] - c[k]) * fx;
    // The documents speak of weights, which need not sum up to 1 to the last digit.
    const Interval mean = upper + (lower - upper) * fy;
    colour[k] = mean == Interval(0.0) ? mean : widened(mean, 0x1p-21);
  }
  return colour;
}

/// A coordinate in texels, with the errors of reducing and scaling it.
Interval scaled(Interval u, int size, double shift) {
  const double margin = (std::max({std::abs(u.low), std::abs(u.high), 1.0}) + 1) * size * 0x1p-22;
  return {u.low * size - shift - margin, u.high * size - shift + margin};
}

}  // namespace

Colour sample(const Texture& texture, const Sampler& sampler, Interval u, Interval v) {
  const bool nearest = sampler.texels == TexelFilter::nearest;
  if (!u.is_known() || !v.is_known()) return {unknown(), unknown(), unknown(), unknown()};
  const Interval x = scaled(u, texture.width, nearest ? 0 : 0.5), y = scaled(v, texture.height, nearest ? 0 : 0.5);
  if (std::max({-x.low, x.high, -y.low, y.high}) > 1e15 || x.high - x.low > kWhole || y.high - y.low > kWhole ||
      (x.high - x.low + 1) * (y.high - y.low + 1) > 64)
    return hull_of(anything(), {Interval(static_cast<double>(sampler.border.r)), Interval(static_cast<double>(sampler.border.g)),
                                Interval(static_cast<double>(sampler.border.b)), Interval(static_cast<double>(sampler.border.a))});
  const auto first = [](Interval a) { return static_cast<std::int64_t>(std::floor(a.low)); };
  const auto last = [](Interval a) { return static_cast<std::int64_t>(std::floor(a.high)); };
  bool is_first = true;
  Colour result;
  for (std::int64_t j = first(y); j <= last(y); ++j)
    for (std::int64_t i = first(x); i <= last(x); ++i) {
      const Colour one = nearest ? texel(texture, sampler, i, j)
                                 : bilinear(texture, sampler, i, j, fraction(x, i), fraction(y, j));
      result = is_first ? one : hull_of(result, one);
      is_first = false;
    }
  return result;
}

}  // namespace tuberia::oracle
