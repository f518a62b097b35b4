#include "reference/oracle/texture.hpp"

#include <cmath>

#include "reference/oracle/cube.hpp"
#include "reference/oracle/footprint.hpp"

namespace tuberia::oracle {
namespace {

/// The texel that place i of an endless row of `size` texels shows; -1: the border.
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

Colour every(Interval x) { return {x, x, x, x}; }

Colour hull_of(const Colour& a, const Colour& b) {
  Colour colour;
  for (std::size_t c = 0; c < 4; ++c) colour[c] = hull(a[c], b[c]);
  return colour;
}

Colour mixed(const Colour& a, const Colour& b, Interval share) {
  Colour colour;
  for (std::size_t k = 0; k < 4; ++k) {
    // The documents speak of weights, which need not sum up to 1 to the last digit.
    const Interval mean = a[k] + (b[k] - a[k]) * share;
    colour[k] = a[k] == Interval(0.0) && b[k] == Interval(0.0) ? Interval(0.0) : widened(mean, 0x1p-21);
  }
  return colour;
}

/// Part of an interval that lies in [i, i + 1], counted from i.
Interval fraction(Interval x, std::int64_t i) {
  const double base = static_cast<double>(i);
  return {std::max(x.low - base, 0.0), std::min(x.high - base, 1.0)};
}

std::int64_t first_of(Interval a) { return static_cast<std::int64_t>(std::floor(a.low)); }
std::int64_t last_of(Interval a) { return static_cast<std::int64_t>(std::floor(a.high)); }

/// Reads one level of a texture for one point.
class LevelReader {
 public:
  LevelReader(const Texture& texture, const Sampler& sampler, const TextureLevel& level, Interval reference)
      : texture_(texture), sampler_(sampler), level_(level), reference_(reference) {}

  Colour read(Interval s, Interval t, Interval r, int face) const {
    const double shift = is_nearest() ? 0 : 0.5;
    const Interval x = scaled(s, level_.width, shift);
    const bool has_rows = texture_.kind != TextureKind::one_dimensional, is_box = texture_.kind == TextureKind::three_dimensional;
    const Interval y = has_rows ? scaled(t, level_.height, shift) : Interval(0.0);
    const Interval z = is_box ? scaled(r, level_.slices, shift) : Interval(static_cast<double>(face));
    if (!is_narrow(x) || !is_narrow(y) || !is_narrow(z)) return anything();
    bool is_first = true;
    Colour result;
    for (std::int64_t k = first_of(z); k <= last_of(z); ++k)
      for (std::int64_t j = first_of(y); j <= last_of(y); ++j)
        for (std::int64_t i = first_of(x); i <= last_of(x); ++i) {
          const Colour one = is_nearest() ? texel(i, j, k) : mean(x, y, z, i, j, k);
          result = is_first ? one : hull_of(result, one);
          is_first = false;
        }
    return result;
  }

 private:
  bool is_nearest() const { return sampler_.texels == TexelFilter::nearest; }
  static bool is_narrow(Interval a) { return a.is_known() && std::max(-a.low, a.high) < 1e12 && a.high - a.low < 4; }

  /// A coordinate in texels, with the errors of reducing and scaling it.
  static Interval scaled(Interval u, int size, double shift) {
    if (u == Interval(0.0)) return -shift;
    const double margin = (std::max({std::abs(u.low), std::abs(u.high), 1.0}) + 1) * size * 0x1p-22;
    return {u.low * size - shift - margin, u.high * size - shift + margin};
  }

  /// Bounds of all texels and the border.
  Colour anything() const {
    Colour all = border();
    for (const Colour& one : level_.texels) all = hull_of(all, one);
    if (texture_.is_depth && sampler_.compare) return every({0, 1});
    return all;
  }

  Colour border() const {
    Colour colour;
    for (int c = 0; c < 4; ++c) colour[static_cast<std::size_t>(c)] = widened(static_cast<double>(sampler_.border[c]));
    if (texture_.is_depth) colour = {colour[0], colour[0], colour[0], 1.0};
    return colour;
  }

  Colour compared(const Colour& texel) const {
    if (!texture_.is_depth || !sampler_.compare) return texel;
    const Outcome outcome = outcome_of(*sampler_.compare, reference_, texel[0].low);
    const Interval truth = outcome == Outcome::yes ? Interval(1.0) : outcome == Outcome::no ? Interval(0.0) : Interval{0, 1};
    return {truth, truth, truth, 1.0};
  }

  Colour texel(std::int64_t i, std::int64_t j, std::int64_t k) const {
    if (texture_.kind == TextureKind::cube) {
      const auto within = [&](std::int64_t a) { return is_nearest() ? std::clamp<std::int64_t>(a, 0, level_.width - 1) : a; };
      return compared(cube_texel(level_, within(i), within(j), static_cast<int>(k)));
    }
    const int x = wrapped(i, level_.width, sampler_.wrap_u);
    const int y = texture_.kind == TextureKind::one_dimensional ? 0 : wrapped(j, level_.height, sampler_.wrap_v);
    const int z = texture_.kind == TextureKind::three_dimensional ? wrapped(k, level_.slices, sampler_.wrap_w) : 0;
    return compared(x < 0 || y < 0 || z < 0 ? border() : level_.at(x, y, z));
  }

  /// A corner of a cube has three texels around it: the fourth tap is their mean.
  Colour tap(std::int64_t i, std::int64_t j, std::int64_t k, std::int64_t di, std::int64_t dj) const {
    const auto beyond = [&](std::int64_t a) { return a < 0 || a >= level_.width; };
    if (texture_.kind != TextureKind::cube || !beyond(i + di) || !beyond(j + dj)) return texel(i + di, j + dj, k);
    const Colour a = texel(i + 1 - di, j + dj, k), b = texel(i + di, j + 1 - dj, k), c = texel(i + 1 - di, j + 1 - dj, k);
    Colour colour;
    for (std::size_t n = 0; n < 4; ++n) colour[n] = widened(((a[n] + b[n]) + c[n]) / Interval(3.0), 0x1p-21);
    return colour;
  }

  /// Of the texel after number i.
  Interval weight(Interval x, std::int64_t i) const {
    const Interval w = fraction(x, i);
    if (sampler_.weights == FilterWeights::floats) return w;
    // A sum that is rounded on its way to a whole number may reach the next one.
    const auto rounded = [](double a) { return std::floor(a * 256 + 0.5) / 256; };
    return {rounded(w.low - 0x1p-24), rounded(w.high + 0x1p-24)};
  }

  Colour mean(Interval x, Interval y, Interval z, std::int64_t i, std::int64_t j, std::int64_t k) const {
    const auto row = [&](std::int64_t dj, std::int64_t slice) {
      return mixed(tap(i, j, slice, 0, dj), tap(i, j, slice, 1, dj), weight(x, i));
    };
    const auto slice = [&](std::int64_t number) {
      return texture_.kind == TextureKind::one_dimensional ? row(0, number) : mixed(row(0, number), row(1, number), weight(y, j));
    };
    return texture_.kind == TextureKind::three_dimensional ? mixed(slice(k), slice(k + 1), weight(z, k)) : slice(k);
  }

  const Texture& texture_;
  const Sampler& sampler_;
  const TextureLevel& level_;
  Interval reference_;
};

Colour read_level(const Texture& texture, const Sampler& sampler, const TexturePoint& point, std::size_t number) {
  const LevelReader reader(texture, sampler, texture.levels[number], point.reference);
  if (texture.kind != TextureKind::cube) return reader.read(point.s, point.t, point.r, 0);
  bool is_first = true;
  Colour result;
  for (const CubeFace& face : faces_of({point.s, point.t, point.r})) {
    const Colour one = reader.read(face.s, face.t, 0.0, face.number);
    result = is_first ? one : hull_of(result, one);
    is_first = false;
  }
  return is_first ? every(unknown()) : result;
}

/// With bias and bounds.
Interval bounded_level(const Sampler& sampler, Interval lod, double last) {
  const Interval biased = lod + Interval(static_cast<double>(sampler.lod_bias));
  const Interval within = clamped(biased, static_cast<double>(sampler.min_lod), static_cast<double>(sampler.max_lod));
  return clamped(within, 0, last);
}

Colour read_levels(const Texture& texture, const Sampler& sampler, const TexturePoint& point, Interval unbounded_level) {
  const double last = static_cast<double>(texture.levels.size() - 1);
  if (sampler.mipmaps == MipmapFilter::none || last == 0) return read_level(texture, sampler, point, 0);
  const Interval lod = bounded_level(sampler, unbounded_level, last);
  const auto level = [&](double number) { return read_level(texture, sampler, point, static_cast<std::size_t>(std::clamp(number, 0.0, last))); };
  bool is_first = true;
  Colour result;
  const auto add = [&](const Colour& one) {
    result = is_first ? one : hull_of(result, one);
    is_first = false;
  };
  if (sampler.mipmaps == MipmapFilter::nearest) {
    for (double i = std::ceil(lod.low + 0.5) - 1; i <= std::ceil(lod.high + 0.5) - 1; ++i) add(level(i));
  } else {
    for (double i = std::floor(lod.low); i <= std::floor(lod.high); ++i)
      add(mixed(level(i), level(i + 1), fraction(lod, static_cast<std::int64_t>(i))));
  }
  return result;
}

/// Sample i of n along the longer axis.
TexturePoint tap_at(const TexturePoint& point, const Footprint& footprint, int i, int n) {
  if (n == 1) return point;
  const Interval offset = widened((i + 0.5) / n - 0.5);
  TexturePoint tap = point;
  std::size_t k = 0;
  for (Interval* coordinate : {&tap.s, &tap.t, &tap.r}) {
    const Interval axis = point.steps.x[k] * footprint.along_x + point.steps.y[k] * footprint.along_y;
    *coordinate = *coordinate + axis * offset;
    ++k;
  }
  return tap;
}

/// The mean of n samples. Each step of the running mean errs by at most six roundings of the largest sample
/// over its number and one of the mean; weighted by what becomes of them these are less than 2^-20 of it.
Colour mean_along(const Texture& texture, const Sampler& sampler, const TexturePoint& point, const Footprint& footprint, int n) {
  Colour sum = every(0.0);
  std::array<double, 4> largest{};
  for (int i = 0; i < n; ++i) {
    const TexturePoint tap = tap_at(point, footprint, i, n);
    if (!tap.s.is_known() || !tap.t.is_known() || !tap.r.is_known()) return every(unknown());
    const Colour one = read_levels(texture, sampler, tap, footprint.level_of_detail);
    if (n == 1) return one;
    for (std::size_t c = 0; c < 4; ++c) {
      if (!one[c].is_known()) return every(unknown());
      sum[c] = {sum[c].low + one[c].low, sum[c].high + one[c].high};
      largest[c] = std::max(largest[c], absolute(one[c]).high);
    }
  }
  for (std::size_t c = 0; c < 4; ++c) sum[c] = {sum[c].low / n - largest[c] * 0x1p-20, sum[c].high / n + largest[c] * 0x1p-20};
  return sum;
}

/// For steps in texels of level 0.
Colour sample_footprint(const Texture& texture, const Sampler& sampler, const TexturePoint& point, const Steps& texels) {
  if (!(sampler.max_anisotropy > 1) || texture.kind == TextureKind::one_dimensional)
    return read_levels(texture, sampler, point, round_footprint(texels, sampler.footprint).level_of_detail);
  const bool by_steps = sampler.footprint == FootprintForm::steps;
  const Footprint footprint = by_steps ? stepped_footprint(texels, sampler.max_anisotropy) : elliptic_footprint(texels, sampler.max_anisotropy);
  if (!footprint.taps.is_known()) return every(unknown());
  const int fewest = static_cast<int>(std::ceil(footprint.taps.low)), most = static_cast<int>(std::ceil(footprint.taps.high));
  Colour result = mean_along(texture, sampler, point, footprint, fewest);
  for (int n = fewest + 1; n <= most; ++n) result = hull_of(result, mean_along(texture, sampler, point, footprint, n));
  return result;
}

}  // namespace

Colour sample(const Texture& texture, const Sampler& sampler, const TexturePoint& point) {
  if (!point.s.is_known() || !point.t.is_known() || !point.r.is_known()) return every(unknown());
  if (texture.kind != TextureKind::cube) return sample_footprint(texture, sampler, point, point.texel_steps);
  const Triple direction{point.s, point.t, point.r};
  bool is_first = true;
  Colour result;
  for (const CubeFace& face : faces_of(direction)) {
    const Steps texels = projected_steps(face.number, direction, point.steps, texture.width);
    const Colour one = sample_footprint(texture, sampler, point, texels);
    result = is_first ? one : hull_of(result, one);
    is_first = false;
  }
  return is_first ? every(unknown()) : result;
}

}  // namespace tuberia::oracle
