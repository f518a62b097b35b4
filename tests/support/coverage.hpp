#pragma once
// Which pixels triangles cover: as the library's kernels say, and as the definition does.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "math/edge_function.hpp"
#include "raster/binning.hpp"
#include "raster/fragment_block.hpp"
#include "raster/geometry_kernels.hpp"
#include "tests/support/random.hpp"

namespace tuberia::test {

using Triangle = std::array<SnappedPoint, 3>;

/// Everything that must be equal when two ways to cover agree.
struct Coverage {
  int width = 0, height = 0;
  std::uint64_t count = 0;  // covered pixels, with overdraw
  std::uint64_t hash = 0;   // sum of (i + 1) * (y * width + x + 1) over the pixels of triangle i
  std::vector<std::uint32_t> pixels_of;       // how many each triangle covers
  std::vector<std::uint64_t> fingerprint_of;  // of each triangle's set of pixels, whatever the order
  std::vector<std::uint32_t> owners;          // how many triangles cover each pixel

  Coverage(int width_pixels, int height_pixels, std::size_t triangles)
      : width(width_pixels), height(height_pixels), pixels_of(triangles, 0), fingerprint_of(triangles, 0),
        owners(static_cast<std::size_t>(width_pixels) * static_cast<std::size_t>(height_pixels), 0) {}

  void add(std::size_t triangle, int x, int y) {
    const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    ++count;
    hash += (triangle + 1) * (pixel + 1);
    ++pixels_of[triangle];
    fingerprint_of[triangle] += Random::mixed(pixel + 1);
    ++owners[pixel];
  }

  /// The union of what disjoint parts of a target show.
  Coverage& operator+=(const Coverage& other) {
    count += other.count;
    hash += other.hash;
    for (std::size_t i = 0; i < pixels_of.size(); ++i) {
      pixels_of[i] += other.pixels_of[i];
      fingerprint_of[i] += other.fingerprint_of[i];
    }
    for (std::size_t i = 0; i < owners.size(); ++i) owners[i] += other.owners[i];
    return *this;
  }

  std::int64_t empty_triangles() const { return std::count(pixels_of.begin(), pixels_of.end(), 0u); }
  std::uint32_t most_owners() const { return *std::max_element(owners.begin(), owners.end()); }
  std::int64_t pixels_with_owners() const {
    return std::count_if(owners.begin(), owners.end(), [](std::uint32_t n) { return n > 0; });
  }
  std::uint32_t owners_at(int x, int y) const { return owners[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
  bool operator==(const Coverage&) const = default;
};

/// Triangles on their way through the library's own culling, setup and binning, with w = 1 and
/// depth 0 unless told otherwise. Vertex k of triangle i has slot 3 i + k.
class TriangleSet {
 public:
  TriangleSet(std::span<const Triangle> triangles, int width, int height, InstructionSet instruction_set,
              const PixelRect& clip, std::span<const float> w = {}, std::span<const float> depth = {},
              EdgeArithmetic edges = EdgeArithmetic::exact)
      : clip_(intersection(clip, {0, 0, width, height})), tiles_per_row_((width + kTileSize - 1) / kTileSize),
        tile_rows_((height + kTileSize - 1) / kTileSize) {
    fill(triangles, w, depth);
    const GeometryKernels& kernels = geometry_kernels(instruction_set);
    const TriangleArrays arrays{v_[0].data(), v_[1].data(), v_[2].data(), v_[3].data(), v_[4].data(), is_back_.data()};
    if (!clip_.empty()) kept_ = kernels.cull(arrays, static_cast<int>(triangles.size()), vertices_.data(), {}, clip_).kept;
    screen_.resize(static_cast<std::size_t>(kept_));
    kernels.set_up(arrays, kept_, vertices_.data(), false, screen_.data());
    if (edges != EdgeArithmetic::exact)
      for (ScreenTriangle& record : screen_) record.is_near = 0, record.edge_arithmetic = edges;
    lists_.build(screen_, clip_, tiles_per_row_, tile_rows_, edges != EdgeArithmetic::exact ? 0.5 : 0.0);
  }

  int kept() const { return kept_; }
  std::span<const ScreenTriangle> screen_triangles() const { return screen_; }
  const TileLists& lists() const { return lists_; }
  int tiles_per_row() const { return tiles_per_row_; }
  int tile_count() const { return tiles_per_row_ * tile_rows_; }

  /// Calls visit(block) for all blocks of fragments, tile by tile, in the order of the lists.
  template <class Visit>
  void for_each_block(const BlockKernels& kernels, Visit&& visit) const {
    std::vector<FragmentBlock> blocks;
    for (int tile = 0; tile < tile_count(); ++tile) {
      const Tile place{.left = tile % tiles_per_row_ * kTileSize, .top = tile / tiles_per_row_ * kTileSize};
      for (const std::uint16_t number : lists_.of_tile(tile)) {
        blocks.clear();
        kernels.rasterize(screen_[number], place, clip_, blocks);
        for (const FragmentBlock& block : blocks) visit(block);
      }
    }
  }

 private:
  void fill(std::span<const Triangle> triangles, std::span<const float> w, std::span<const float> depth) {
    const std::size_t corners = 3 * triangles.size(), padded = corners + kKernelPadding;
    vertices_.resize(padded);
    for (std::size_t i = 0; i < w.size(); ++i) vertices_[i].w = w[i];
    for (std::size_t i = 0; i < depth.size(); ++i) vertices_[i].depth = depth[i];
    is_back_.resize(triangles.size() + kKernelPadding);
    for (auto& array : v_) array.resize(triangles.size() + kKernelPadding, 0u);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        vertices_[3 * i + k].x = triangles[i][k].x;
        vertices_[3 * i + k].y = triangles[i][k].y;
        v_[k][i] = static_cast<std::uint32_t>(3 * i + k);
      }
      v_[3][i] = static_cast<std::uint32_t>(3 * i);
      v_[4][i] = static_cast<std::uint32_t>(i);
    }
  }

  PixelRect clip_;
  int tiles_per_row_, tile_rows_, kept_ = 0;
  std::vector<ScreenVertex> vertices_;
  std::vector<std::uint32_t> v_[5];
  std::vector<std::uint8_t> is_back_;
  std::vector<ScreenTriangle> screen_;
  TileLists lists_;
};

inline constexpr PixelRect kEverything{0, 0, 1 << 20, 1 << 20};

/// What the library's kernels cover.
inline Coverage covered(std::span<const Triangle> triangles, int width, int height, InstructionSet instruction_set,
                        const PixelRect& clip = kEverything, Precision precision = Precision::exact,
                        EdgeArithmetic edges = EdgeArithmetic::exact) {
  Coverage result(width, height, triangles.size());
  const TriangleSet set(triangles, width, height, instruction_set, clip, {}, {}, edges);
  set.for_each_block(block_kernels(instruction_set, precision), [&](const FragmentBlock& block) {
    for (int i = 0; i < kBlockPixels; ++i)
      if ((block.live >> i & 1u) != 0) result.add(block.triangle->primitive, block.left + block_x(i), block.top + block_y(i));
  });
  return result;
}

/// What the definition covers: every centre asked, in 64-bit integers, under the top-left rule.
inline Coverage covered_by_definition(std::span<const Triangle> triangles, int width, int height) {
  Coverage result(width, height, triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    auto [a, b, c] = triangles[i];
    const std::int64_t area = twice_area(a, b, c);
    if (area == 0) continue;
    if (area < 0) std::swap(b, c);
    const EdgeFunction edges[3] = {{a, b}, {b, c}, {c, a}};
    // Nothing outside the box of the corners can be inside the triangle.
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const int x0 = std::max(0, left / 256 - 1), x1 = std::min(width - 1, right / 256 + 1);
    const int y0 = std::max(0, top / 256 - 1), y1 = std::min(height - 1, bottom / 256 + 1);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const SnappedPoint centre{x * kSubpixelUnits + kPixelCentre, y * kSubpixelUnits + kPixelCentre};
        if (edges[0].owns(centre) && edges[1].owns(centre) && edges[2].owns(centre)) result.add(i, x, y);
      }
  }
  return result;
}

}  // namespace tuberia::test
