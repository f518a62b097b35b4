#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Triangle;

namespace {

/// What docs/machine.md says of a clockwise triangle: whole numbers exactly, quotients rounded in
/// double and then to float.
struct DefinedRecord {
  std::int64_t constant[3];
  std::int32_t per_x[3], per_y[3];
  std::uint8_t remainder[3];
  float weight_scale, weight_offset[2], depth_delta[2], inverse_w[3];

  explicit DefinedRecord(const ScreenVertex (&v)[3]) {
    const std::int64_t area = twice_area({v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y});
    const double inverse_area = 1.0 / static_cast<double>(area);
    weight_scale = static_cast<float>(256 * inverse_area);
    for (int k = 0; k < 3; ++k) {
      const ScreenVertex &from = v[(k + 1) % 3], &to = v[(k + 2) % 3];
      per_x[k] = from.y - to.y;
      per_y[k] = to.x - from.x;
      const std::int64_t rule = per_x[k] > 0 || (per_x[k] == 0 && per_y[k] > 0) ? 0 : 1;
      const std::int64_t centre = std::int64_t{per_x[k]} * (128 - from.x) + std::int64_t{per_y[k]} * (128 - from.y);
      constant[k] = (centre - rule) >> 8;
      remainder[k] = static_cast<std::uint8_t>((centre - rule) & 255);
      if (k > 0) weight_offset[k - 1] = static_cast<float>(static_cast<double>(remainder[k] + rule) * inverse_area);
    }
    for (int k = 0; k < 2; ++k) depth_delta[k] = static_cast<float>(static_cast<double>(v[k + 1].depth) - static_cast<double>(v[0].depth));
    const double least = static_cast<double>(std::min({v[0].w, v[1].w, v[2].w}));
    for (int k = 0; k < 3; ++k) inverse_w[k] = static_cast<float>(std::max(least / static_cast<double>(v[k].w), 0x1p-100));
  }

  bool is_of(const ScreenTriangle& t, bool has_samples) const {
    bool same = weight_scale == t.weight_scale && std::equal(weight_offset, weight_offset + 2, t.weight_offset) &&
                std::equal(depth_delta, depth_delta + 2, t.depth_delta) && std::equal(inverse_w, inverse_w + 3, t.inverse_w) &&
                std::equal(per_x, per_x + 3, t.per_x) && std::equal(per_y, per_y + 3, t.per_y);
    for (int k = 0; k < 3; ++k)
      same &= static_cast<double>(constant[k]) == t.constant[k] && static_cast<std::int32_t>(constant[k]) == t.constant_low[k] &&
              t.remainder[k] == (has_samples ? remainder[k] : 0);
    return same;
  }
};

float random_w(test::Random& random) {
  switch (random.below(4)) {
    case 0: return 1;
    case 1: return 0x1p-149f * static_cast<float>(1 + random.below(1000));
    case 2: return 1e38f * random.between(0.1f, 3);
    default: return random.between(0.01f, 100);
  }
}

/// Vertices of the triangles, turned clockwise, with depths and w of all kinds.
std::vector<ScreenVertex> vertices_of(std::span<const Triangle> triangles, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<ScreenVertex> vertices;
  for (Triangle t : triangles) {
    const std::int64_t area = twice_area(t[0], t[1], t[2]);
    if (area == 0) continue;
    if (area < 0) std::swap(t[1], t[2]);
    const float common = random_w(random);
    const bool is_affine = random.below(2) == 0;
    for (const SnappedPoint& p : t) vertices.push_back({p.x, p.y, random.between(0, 1), is_affine ? common : random_w(random)});
  }
  return vertices;
}

void check_records(std::span<const Triangle> triangles, std::uint64_t seed, bool has_samples) {
  std::vector<ScreenVertex> vertices = vertices_of(triangles, seed);
  const std::size_t count = vertices.size() / 3;
  vertices.resize(vertices.size() + kKernelPadding);
  std::vector<std::uint32_t> v[5];
  for (auto& array : v) array.resize(count + kKernelPadding, 0u);
  std::vector<std::uint8_t> is_back(count + kKernelPadding);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) v[k][i] = static_cast<std::uint32_t>(3 * i + k);
    v[3][i] = v[i % 3][i];
    v[4][i] = static_cast<std::uint32_t>(7 * i);
    is_back[i] = i % 5 == 0;
  }
  for_every_instruction_set([&](InstructionSet set) {
    std::vector<ScreenTriangle> records(count);
    geometry_kernels(set).set_up({v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(), is_back.data()},
                                 static_cast<int>(count), vertices.data(), has_samples, records.data());
    for (std::size_t i = 0; i < count; ++i) {
      const ScreenVertex corner[3] = {vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]};
      const ScreenTriangle& t = records[i];
      const bool numbers = t.vertex[0] == 3 * i && t.vertex[1] == 3 * i + 1 && t.vertex[2] == 3 * i + 2 && t.primitive == 7 * i &&
                           t.provoking_vertex == v[3][i] && t.is_back == is_back[i] && t.depth == corner[0].depth &&
                           (t.perspective == kIsAffine) == (corner[0].w == corner[1].w && corner[0].w == corner[2].w);
      if (!numbers || !DefinedRecord(corner).is_of(t, has_samples)) FAIL("seed " << seed << ", triangle " << i);
    }
  });
}

}  // namespace

TEST_CASE("set-up: every record is that of the definition, whatever way a triangle takes", "[raster][exact]") {
  for (const bool has_samples : {false, true}) {
    check_records(test::small_triangles(131, 6000, 8192, 8192), 131, has_samples);
    // About as large as the quick way allows; in one register with small ones; and of any size.
    check_records(test::random_triangles(132, 6000, 3000000, 3000000 + 64 * 256), 132, has_samples);
    check_records(test::random_triangles(133, 6000, -8388608, -8388608 + 20 * 256), 133, has_samples);
    std::vector<Triangle> mixed = test::small_triangles(134, 6000, 300, 200);
    const std::vector<Triangle> large = test::random_triangles(135, 300, -8388608, 8388608);
    for (std::size_t i = 0; i < large.size(); ++i) mixed[i * i % mixed.size()] = large[i];
    check_records(mixed, 134, has_samples);
  }
}

TEST_CASE("set-up: bounds are the centres within the corners", "[raster][exact]") {
  const std::vector<Triangle> triangles = test::small_triangles(136, 2000, 300, 200);
  const test::TriangleSet set(triangles, 300, 200, best_instruction_set(), test::kEverything);
  for (const ScreenTriangle& t : set.screen_triangles()) {
    const Triangle& from = triangles[t.primitive];
    const auto [left, right] = std::minmax({from[0].x, from[1].x, from[2].x});
    const auto [top, bottom] = std::minmax({from[0].y, from[1].y, from[2].y});
    const auto first = [](int units) { return static_cast<int>(std::ceil((units - 128) / 256.0)); };
    const auto last = [](int units) { return static_cast<int>(std::floor((units - 128) / 256.0)); };
    CHECK((t.left == first(left) && t.top == first(top) && t.right == last(right) && t.bottom == last(bottom)));
  }
}

}  // namespace tuberia
