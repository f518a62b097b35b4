#include "raster/shape_coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "math/fixed_point.hpp"

namespace tuberia {
namespace {

__extension__ typedef __int128 Wide;  // squares of products of units

constexpr int kTileBlocks = kBlocksPerTileRow * kBlocksPerTileRow;

/// Which samples of a tile's pixels are covered, block by block.
class TileMask {
 public:
  explicit TileMask(const Tile& tile) : tile_(tile) {
    for (int s = 0; s < tile.samples; ++s) bits_[static_cast<std::size_t>(s)].fill(0);
  }
  /// Pixel (x, y) of the target, inside the tile.
  void add(int x, int y, int sample = 0) {
    const int index = index_in_tile(x - tile_.left, y - tile_.top);
    bits_[static_cast<std::size_t>(sample)][static_cast<std::size_t>(index / kBlockPixels)] |= std::uint64_t{1} << index % kBlockPixels;
  }
  std::uint64_t of(int block, int sample) const { return bits_[static_cast<std::size_t>(sample)][static_cast<std::size_t>(block)]; }

 private:
  const Tile& tile_;
  std::array<std::array<std::uint64_t, kTileBlocks>, kMaxSamples> bits_;
};

/// The pixels of the tile that the record's bounds and the clip rectangle let through.
PixelRect pixels_of(const ScreenTriangle& record, const Tile& tile, const PixelRect& clip) {
  const PixelRect bounds{record.left, record.top, record.right + 1, record.bottom + 1};
  return intersection(intersection(bounds, clip), {tile.left, tile.top, tile.left + kTileSize, tile.top + kTileSize});
}

constexpr std::int64_t centre_of(int pixel) { return std::int64_t{pixel} * kSubpixelUnits + kPixelCentre; }

/// Calls visit(x, y, sample, point_x, point_y) for every place in the rectangle where coverage is tested.
template <class Visit>
void for_each_sample(const PixelRect& pixels, int samples, Visit&& visit) {
  const auto positions = sample_positions(samples);
  for (int y = pixels.top; y < pixels.bottom; ++y)
    for (int x = pixels.left; x < pixels.right; ++x)
      for (int s = 0; s < samples; ++s) {
        const SamplePosition& at = positions[static_cast<std::size_t>(s)];
        visit(x, y, s, centre_of(x) + at.x * kUnitsPerSampleStep, centre_of(y) + at.y * kUnitsPerSampleStep);
      }
}

void cover_point(const ScreenShape& point, const PixelRect& pixels, int samples, TileMask& mask) {
  const std::int64_t size = point.size;
  for_each_sample(pixels, samples, [&](int x, int y, int s, std::int64_t px, std::int64_t py) {
    const std::int64_t dx = px - point.x[0], dy = py - point.y[0];
    const auto within = [&](std::int64_t d) { return -size <= 2 * d && 2 * d < size; };
    if (point.round ? 4 * (dx * dx + dy * dy) < size * size : within(dx) && within(dy)) mask.add(x, y, s);
  });
}

/// A line seen along its major axis: "along" is x of x-major lines and y of others.
struct MajorLine {
  bool is_x_major;
  std::int64_t a_along, a_across, b_along, b_across;

  explicit MajorLine(const ScreenShape& s) {
    is_x_major = std::abs(std::int64_t{s.x[1]} - s.x[0]) >= std::abs(std::int64_t{s.y[1]} - s.y[0]);
    a_along = is_x_major ? s.x[0] : s.y[0], a_across = is_x_major ? s.y[0] : s.x[0];
    b_along = is_x_major ? s.x[1] : s.y[1], b_across = is_x_major ? s.y[1] : s.x[1];
  }
  bool is_empty() const { return a_along == b_along; }  // the major extent of any other line is not 0
  void move_across(std::int64_t units) { a_across += units, b_across += units; }

  /// How much of the way from a to b lies before a place.
  double share(double along) const {
    const double whole = static_cast<double>(b_along - a_along);
    return std::clamp((along - static_cast<double>(a_along)) / whole, 0.0, 1.0);
  }
};

/// Whether the pattern has a fragment at pixel `major` of the major axis.
bool is_drawn(const StipplePattern& pattern, const ScreenShape& line, const MajorLine& ends, int major) {
  if (pattern.bits == 0xffff) return true;
  const std::int64_t first = ends.a_along >> kSubpixelBits;
  const std::int64_t counter = std::int64_t{line.stipple_start} + std::abs(major - first);
  return (pattern.bits >> counter / pattern.factor % 16 & 1) != 0;
}

/// Lines of one sample. Both ends are moved by an infinitely small (h, h^2), so that nothing ever
/// lies on a border: what decides where a number is 0 is the sign of its change by h, then by h^2.
class DiamondExit {
 public:
  explicit DiamondExit(const MajorLine& line) : line_(line) {
    const std::int64_t along = line.b_along - line.a_along, across = line.b_across - line.a_across;
    // At a fixed place along the axis the moved line lies higher by h^2 - slope h (x-major) or by
    // h - slope h^2 (y-major).
    tie_goes_down_ = line.is_x_major && (across > 0) == (along > 0) && across != 0;
  }

  /// The one pixel across the axis, at pixel `major` along it, whose diamond the endless line meets:
  /// the slope is at most 1, so it leaves no other row for it than that at the centre.
  std::int64_t candidate(int major) const {
    std::int64_t along = line_.b_along - line_.a_along, across = line_.b_across - line_.a_across;
    if (along < 0) along = -along, across = -across;
    const std::int64_t place = line_.a_across * along + across * (centre_of(major) - line_.a_along);
    const std::int64_t row = along * kSubpixelUnits;
    std::int64_t quotient = place / row, rest = place % row;
    if (rest < 0) --quotient, rest += row;
    return rest == 0 && tie_goes_down_ ? quotient - 1 : quotient;
  }

  /// Whether the line itself meets that diamond, and does not end in it.
  bool draws(int major, std::int64_t minor) const {
    const std::int64_t centre = centre_of(major), from = std::min(line_.a_along, line_.b_along), to = std::max(line_.a_along, line_.b_along);
    const bool crosses = from < centre && centre <= to;
    return (crosses || in_diamond(line_.a_along, line_.a_across, major, minor)) &&
           !in_diamond(line_.b_along, line_.b_across, major, minor);
  }

 private:
  bool in_diamond(std::int64_t along, std::int64_t across, int major, std::int64_t minor) const {
    const std::int64_t u = along - centre_of(major), v = across - (minor * kSubpixelUnits + kPixelCentre);
    const std::int64_t distance = std::abs(u) + std::abs(v);
    if (distance != kPixelCentre) return distance < kPixelCentre;
    return (line_.is_x_major ? u : v) < 0;  // x moves on by h: towards the centre only from its left
  }

  const MajorLine& line_;
  bool tie_goes_down_;
};

void cover_thin_line(const ScreenShape& shape, const MajorLine& whole, const StipplePattern& stipple, const PixelRect& pixels, TileMask& mask) {
  const int width = shape.size / kSubpixelUnits;
  MajorLine line = whole;
  line.move_across(-std::int64_t{kPixelCentre} * (width - 1));
  const DiamondExit rule(line);
  const bool x_major = line.is_x_major;
  const int first = x_major ? pixels.left : pixels.top, end = x_major ? pixels.right : pixels.bottom;
  const std::int64_t low = x_major ? pixels.top : pixels.left, high = x_major ? pixels.bottom : pixels.right;
  for (int major = first; major < end; ++major) {
    if (!is_drawn(stipple, shape, line, major)) continue;
    const std::int64_t minor = rule.candidate(major);
    if (!rule.draws(major, minor)) continue;
    for (std::int64_t m = std::max(minor, low); m < std::min(minor + width, high); ++m) {
      const int at = static_cast<int>(m);
      if (x_major) mask.add(major, at);
      else mask.add(at, major);
    }
  }
}

/// The rectangle around a line, for targets of several samples.
struct LineRectangle {
  std::int64_t x, y, dx, dy, length_squared;
  Wide half_width_squared;  // 4 across^2 at the sides: size^2 |d|^2

  explicit LineRectangle(const ScreenShape& s)
      : x(s.x[0]), y(s.y[0]), dx(std::int64_t{s.x[1]} - s.x[0]), dy(std::int64_t{s.y[1]} - s.y[0]), length_squared(dx * dx + dy * dy),
        half_width_squared(Wide{s.size} * s.size * length_squared) {}

  bool covers(std::int64_t px, std::int64_t py) const {
    const std::int64_t rx = px - x, ry = py - y, along = rx * dx + ry * dy;
    if (along < 0 || along >= length_squared) return false;
    const std::int64_t across = dx * ry - dy * rx;
    const Wide squared = Wide{4} * across * across;
    return across < 0 ? squared <= half_width_squared : squared < half_width_squared;
  }

  /// Whether it lies farther from the centre of a block than a block is large. Not exact, but on the safe side.
  bool misses(int left, int top) const {
    const auto across = static_cast<double>(dx * (centre_of(top + kBlockSize / 2) - y) - dy * (centre_of(left + kBlockSize / 2) - x));
    const double reach = kBlockSize * kSubpixelUnits * std::sqrt(static_cast<double>(length_squared));
    return std::abs(across) > reach + 0.5 * std::sqrt(static_cast<double>(half_width_squared));
  }
};

void cover_smooth_line(const ScreenShape& shape, const MajorLine& line, const StipplePattern& stipple, const PixelRect& pixels,
                       int samples, TileMask& mask) {
  const LineRectangle rectangle(shape);
  constexpr int kStep = kBlockSize;
  for (int top = pixels.top & ~(kStep - 1); top < pixels.bottom; top += kStep)
    for (int left = pixels.left & ~(kStep - 1); left < pixels.right; left += kStep) {
      if (rectangle.misses(left, top)) continue;
      const PixelRect block = intersection(pixels, {left, top, left + kStep, top + kStep});
      for_each_sample(block, samples, [&](int x, int y, int s, std::int64_t px, std::int64_t py) {
        if (rectangle.covers(px, py) && is_drawn(stipple, shape, line, line.is_x_major ? x : y)) mask.add(x, y, s);
      });
    }
}

float depth_at(const ScreenTriangle& record, float weight1) { return record.depth_delta[0] * weight1 + record.depth; }

void set_point_values(const ScreenTriangle& record, FragmentBlock& block) {
  for (auto& weights : block.weight) std::fill(std::begin(weights), std::end(weights), 0.0f);
  for (int s = 0; s < block.samples; ++s) std::fill(std::begin(block.depth_value[s]), std::end(block.depth_value[s]), depth_at(record, 0));
}

/// Weights at all centres of the block, since programs look at their differences; depths at the samples.
void set_line_values(const ScreenTriangle& record, const MajorLine& line, FragmentBlock& block) {
  const auto positions = sample_positions(block.samples);
  const int origin = line.is_x_major ? block.left : block.top;
  for (int m = 0; m < kBlockSize; ++m) {
    const auto centre = static_cast<double>(centre_of(origin + m));
    const float weight = static_cast<float>(line.share(centre));
    for (int n = 0; n < kBlockSize; ++n) {
      const int i = line.is_x_major ? index_in_block(m, n) : index_in_block(n, m);
      block.weight[0][i] = weight;
      block.weight[1][i] = 0;
    }
    for (int s = 0; s < block.samples; ++s) {
      const SamplePosition& at = positions[static_cast<std::size_t>(s)];
      const double place = centre + kUnitsPerSampleStep * (line.is_x_major ? at.x : at.y);
      const float depth = depth_at(record, static_cast<float>(line.share(place)));
      for (int n = 0; n < kBlockSize; ++n) block.depth_value[s][line.is_x_major ? index_in_block(m, n) : index_in_block(n, m)] = depth;
    }
  }
}

/// Appends the blocks that have anything covered.
template <class SetValues>
void append(const ScreenTriangle& record, const Tile& tile, const TileMask& mask, std::vector<FragmentBlock>& out, SetValues&& set_values) {
  for (int number = 0; number < kTileBlocks; ++number) {
    std::uint64_t any = 0;
    for (int s = 0; s < tile.samples; ++s) any |= mask.of(number, s);
    if (any == 0) continue;
    FragmentBlock& block = out.emplace_back();
    block.left = tile.left + number % kBlocksPerTileRow * kBlockSize;
    block.top = tile.top + number / kBlocksPerTileRow * kBlockSize;
    block.triangle = &record;
    block.live = any;
    block.samples = tile.samples;
    for (int s = 0; s < tile.samples; ++s) block.sample_live[s] = mask.of(number, s);
    set_values(block);
  }
}

}  // namespace

void cover_shape(const ScreenTriangle& record, const ScreenShape& shape, const StipplePattern& stipple, const Tile& tile,
                 const PixelRect& clip, std::vector<FragmentBlock>& out) {
  const PixelRect pixels = pixels_of(record, tile, clip);
  if (pixels.empty()) return;
  TileMask mask(tile);
  if (shape.kind == ScreenShape::Kind::point) {
    cover_point(shape, pixels, tile.samples, mask);
    append(record, tile, mask, out, [&](FragmentBlock& block) { set_point_values(record, block); });
    return;
  }
  const MajorLine line(shape);
  if (line.is_empty()) return;
  if (tile.samples == 1) cover_thin_line(shape, line, stipple, pixels, mask);
  else cover_smooth_line(shape, line, stipple, pixels, tile.samples, mask);
  append(record, tile, mask, out, [&](FragmentBlock& block) { set_line_values(record, line, block); });
}

}  // namespace tuberia
