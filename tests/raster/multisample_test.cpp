#include <catch2/catch.hpp>

#include <bit>

#include "raster/geometry_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Triangle;

namespace {

constexpr int kSampleCounts[] = {2, 4, 8, 16};

/// Clockwise ones of the triangles, as set-up hands them to a multisampled target: with bounds a
/// pixel wider, whether or not they hold a centre. Depth of corner k of triangle i: depths[3 i + k].
struct SampledSet {
  std::vector<Triangle> triangles;
  std::vector<float> depths;
  std::vector<ScreenTriangle> screen;

  SampledSet(std::span<const Triangle> from, InstructionSet set, std::uint64_t depth_seed = 0) {
    for (Triangle t : from) {
      const std::int64_t area = twice_area(t[0], t[1], t[2]);
      if (area == 0) continue;
      if (area < 0) std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
    const std::size_t corners = 3 * triangles.size(), padded = corners + kKernelPadding;
    std::vector<ScreenVertex> vertices(padded);
    std::vector<std::uint32_t> v[5];
    for (auto& array : v) array.resize(triangles.size() + kKernelPadding, 0u);
    std::vector<std::uint8_t> is_back(triangles.size() + kKernelPadding, 0);
    depths.resize(padded);
    test::Random random(depth_seed);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        v[k][i] = static_cast<std::uint32_t>(3 * i + k);
        depths[3 * i + k] = random.between(0, 1);
        vertices[3 * i + k] = {triangles[i][k].x, triangles[i][k].y, depths[3 * i + k], 1};
      }
    screen.resize(triangles.size());
    geometry_kernels(set).set_up({v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(), is_back.data()}, static_cast<int>(triangles.size()),
                                 vertices.data(), true, screen.data());
  }

  /// Calls visit(triangle number, block) for all blocks of a target.
  template <class Visit>
  void for_each_block(int samples, int width, int height, InstructionSet set, const PixelRect& clip, Visit&& visit) const {
    std::vector<FragmentBlock> blocks;
    for (std::size_t i = 0; i < screen.size(); ++i)
      for (int top = 0; top < height; top += kTileSize)
        for (int left = 0; left < width; left += kTileSize) {
          blocks.clear();
          block_kernels(set, Precision::exact).rasterize(screen[i], {.left = left, .top = top, .samples = samples}, clip, blocks);
          for (const FragmentBlock& block : blocks) visit(i, block);
        }
  }
};

SnappedPoint sample_point(int x, int y, SamplePosition position) {
  return {x * 256 + 128 + position.x * 16, y * 256 + 128 + position.y * 16};
}

bool covers(const Triangle& t, SnappedPoint p) {
  return EdgeFunction{t[0], t[1]}.owns(p) && EdgeFunction{t[1], t[2]}.owns(p) && EdgeFunction{t[2], t[0]}.owns(p);
}

/// One bit a sample of every pixel: how the kernels cover, and how the definition does.
using SampleImage = std::vector<std::uint16_t>;

SampleImage defined_samples(const Triangle& t, int samples, int width, int height) {
  SampleImage image(static_cast<std::size_t>(width * height), 0);
  const auto positions = sample_positions(samples);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t s = 0; s < positions.size(); ++s)
        if (covers(t, sample_point(x, y, positions[s]))) image[static_cast<std::size_t>(y * width + x)] |= static_cast<std::uint16_t>(1u << s);
  return image;
}

void add_block(SampleImage& image, const FragmentBlock& block, int width) {
  std::uint64_t all = 0;
  for (int s = 0; s < block.samples; ++s) {
    all |= block.sample_live[s];
    for (int i = 0; i < kBlockPixels; ++i)
      if ((block.sample_live[s] >> i & 1u) != 0)
        image[static_cast<std::size_t>((block.top + block_y(i)) * width + block.left + block_x(i))] |= static_cast<std::uint16_t>(1u << s);
  }
  CHECK(all == block.live);
  CHECK(block.live != 0);
}

void check_samples(std::span<const Triangle> triangles, int samples, int width, int height, const char* what) {
  for_every_instruction_set([&](InstructionSet set) {
    const SampledSet sampled(triangles, set);
    std::vector<SampleImage> images(sampled.triangles.size(), SampleImage(static_cast<std::size_t>(width * height), 0));
    sampled.for_each_block(samples, width, height, set, {0, 0, width, height},
                           [&](std::size_t i, const FragmentBlock& block) { add_block(images[i], block, width); });
    for (std::size_t i = 0; i < images.size(); ++i)
      if (images[i] != defined_samples(sampled.triangles[i], samples, width, height))
        FAIL(what << ", " << samples << " samples: triangle " << i << " covers other samples than its edges say");
  });
}

}  // namespace

TEST_CASE("multisampling: a sample is covered exactly when its point is inside", "[raster][exact]") {
  // Seeds 301 to 304; small ones, slivers, large ones beyond the near span, the whole guard band.
  for (const int samples : kSampleCounts) {
    check_samples(test::small_triangles(301, 300, 80, 72), samples, 80, 72, "small, seed 301");
    check_samples(test::slivers(302, 60, 20000), samples, 80, 72, "slivers, seed 302");
    check_samples(test::random_triangles(303, 60, -300000, 300000), samples, 80, 72, "large, seed 303");
    check_samples(test::random_triangles(304, 60, -8388608, 8388607), samples, 80, 72, "guard band, seed 304");
  }
}

TEST_CASE("multisampling: triangles that share edges own each sample once", "[raster][exact]") {
  const auto mesh = test::jittered_mesh();
  for (const int samples : kSampleCounts)
    for_every_instruction_set([&](InstructionSet set) {
      std::vector<int> owners(static_cast<std::size_t>(128 * 96 * samples), 0);
      SampledSet(mesh, set).for_each_block(samples, 128, 96, set, {0, 0, 128, 96}, [&](std::size_t, const FragmentBlock& block) {
        for (int s = 0; s < samples; ++s)
          for (int i = 0; i < kBlockPixels; ++i)
            owners[static_cast<std::size_t>(((block.top + block_y(i)) * 128 + block.left + block_x(i)) * samples + s)] +=
                static_cast<int>(block.sample_live[s] >> i & 1u);
      });
      CHECK(std::all_of(owners.begin(), owners.end(), [](int n) { return n == 1; }));
    });
}

namespace {

/// docs/machine.md, "Weights", written a second time for one point.
struct DefinedWeights {
  const Triangle& t;
  float scale;

  explicit DefinedWeights(const Triangle& triangle) : t(triangle), scale(static_cast<float>(256 * (1.0 / area()))) {}
  double area() const { return static_cast<double>(twice_area(t[0], t[1], t[2])); }

  struct Edge {
    std::int64_t per_x, per_y, e, r;
  };
  Edge edge(std::size_t k, SnappedPoint p) const {
    const SnappedPoint from = t[(k + 1) % 3], to = t[(k + 2) % 3];
    const std::int64_t per_x = from.y - to.y, per_y = to.x - from.x;
    const std::int64_t value = per_x * (p.x - from.x) + per_y * (p.y - from.y);
    const std::int64_t rule = per_x > 0 || (per_x == 0 && per_y > 0) ? 0 : 1;
    const std::int64_t e = (value - rule) >> 8;
    return {per_x, per_y, e, value - 256 * e};
  }
  bool is_near() const {
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    return right - left <= 507904 && bottom - top <= 507904;
  }
  float weight(std::size_t k, int x, int y, SamplePosition position) const {
    const bool centre = position.x == 0 && position.y == 0;
    if (is_near()) {
      const Edge at = edge(k, sample_point(x, y, position));
      const float offset = centre ? static_cast<float>(static_cast<double>(at.r) * (1.0 / area()))
                                  : static_cast<float>(static_cast<double>(at.r) * (static_cast<double>(scale) / 256));
      return static_cast<float>(at.e) * scale + offset;
    }
    const int corner_x = x / 64 * 64, corner_y = y / 64 * 64;
    const Edge at = edge(k, sample_point(corner_x, corner_y, {0, 0}));
    const float offset = static_cast<float>(static_cast<double>(at.r) * (1.0 / area()));
    const float anchor = static_cast<float>(static_cast<double>(at.e) * static_cast<double>(scale) + static_cast<double>(offset));
    const float gx = static_cast<float>(static_cast<double>(at.per_x) * static_cast<double>(scale));
    const float gy = static_cast<float>(static_cast<double>(at.per_y) * static_cast<double>(scale));
    const float dx = static_cast<float>(x - corner_x) + static_cast<float>(position.x) / 16;
    const float dy = static_cast<float>(y - corner_y) + static_cast<float>(position.y) / 16;
    return dy * gy + (dx * gx + anchor);
  }
};

void check_weights(std::span<const Triangle> triangles, int samples, std::uint64_t seed) {
  for_every_instruction_set([&](InstructionSet set) {
    const SampledSet sampled(triangles, set, seed);
    const auto positions = sample_positions(samples);
    std::int64_t checked = 0;
    sampled.for_each_block(samples, 128, 128, set, {0, 0, 128, 128}, [&](std::size_t number, const FragmentBlock& block) {
      const DefinedWeights defined(sampled.triangles[number]);
      const float* z = sampled.depths.data() + 3 * number;
      const float d1 = static_cast<float>(static_cast<double>(z[1]) - static_cast<double>(z[0]));
      const float d2 = static_cast<float>(static_cast<double>(z[2]) - static_cast<double>(z[0]));
      for (int i = 0; i < kBlockPixels; ++i) {
        const int x = block.left + block_x(i), y = block.top + block_y(i);
        // Weights at the centre: of every pixel of a quad with a covered one.
        if ((block.live >> (i & ~3) & 15u) != 0)
          for (std::size_t k = 0; k < 2; ++k)
            if (block.weight[k][i] != defined.weight(k + 1, x, y, {0, 0})) FAIL("seed " << seed << ", triangle " << number << ": weight at (" << x << ", " << y << ")");
        for (int s = 0; s < samples; ++s) {
          if ((block.sample_live[s] >> i & 1u) == 0) continue;
          const SamplePosition position = positions[static_cast<std::size_t>(s)];
          const float w1 = defined.weight(1, x, y, position), w2 = defined.weight(2, x, y, position);
          ++checked;
          if (block.depth_value[s][i] != d2 * w2 + (d1 * w1 + z[0]))
            FAIL("seed " << seed << ", triangle " << number << ": depth of sample " << s << " at (" << x << ", " << y << ")");
        }
      }
    });
    CHECK(checked > 200);
  });
}

}  // namespace

TEST_CASE("multisampling: weights at centres and depths at samples, to the last bit", "[raster][exact]") {
  for (const int samples : {2, 16}) {
    check_weights(test::small_triangles(311, 300, 128, 128), samples, 311);
    check_weights(test::random_triangles(312, 40, -100000, 100000), samples, 312);
    check_weights(test::random_triangles(313, 60, -1000000, 1000000), samples, 313);
  }
}

TEST_CASE("multisampling: nothing outside the clip rectangle is covered", "[raster][exact]") {
  const auto triangles = test::random_triangles(321, 50, -20000, 50000);
  const PixelRect clip{11, 5, 77, 66};
  for_every_instruction_set([&](InstructionSet set) {
    SampleImage cut(128 * 96, 0), whole(128 * 96, 0);
    const SampledSet sampled(triangles, set);
    sampled.for_each_block(8, 128, 96, set, clip, [&](std::size_t, const FragmentBlock& block) { add_block(cut, block, 128); });
    sampled.for_each_block(8, 128, 96, set, {0, 0, 128, 96}, [&](std::size_t, const FragmentBlock& block) { add_block(whole, block, 128); });
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 128; ++x) {
        const bool inside = x >= clip.left && x < clip.right && y >= clip.top && y < clip.bottom;
        const auto i = static_cast<std::size_t>(y * 128 + x);
        if (cut[i] != (inside ? whole[i] : 0)) FAIL("seed 321, pixel (" << x << ", " << y << ")");
      }
  });
}

}  // namespace tuberia
