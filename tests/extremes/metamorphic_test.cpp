// Changes of a scene that must not change its picture, or change it in a known way: rules, section 5.8. The
// scaled, the scissored, the moved and the mirrored ones of single triangles are among the other tests.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/support/drawn_coverage.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Mesh;
using test::Studio;

namespace {

/// Triangles before and behind the eye, with colours; no indices.
struct ClipScene {
  std::vector<glm::vec4> positions, colours;
  MeshView view() const { return {.clip_positions = positions, .colours = colours}; }
};

ClipScene random_clip_scene(std::uint64_t seed, int triangles) {
  test::Random random(seed);
  ClipScene scene;
  for (int i = 0; i < 3 * triangles; ++i) {
    scene.positions.push_back({random.between(-2, 2), random.between(-2, 2), random.between(-1, 1), random.between(-0.25f, 2)});
    scene.colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 1)});
  }
  return scene;
}

std::string digest_of(const MeshView& mesh, const PipelineState& state = {}, const FragmentProgram& program = gouraud(), InstructionSet set = best_instruction_set()) {
  Studio studio({.width = 150, .height = 110, .colour = ColourFormat::rgba32f, .depth = DepthFormat::d32f, .options = {.threads = 3, .instruction_set = set}});
  studio.draw(mesh, program, state);
  return studio.digest();
}

}  // namespace

TEST_CASE("metamorphic: 2^k times all of x, y, z, w is the same scene", "[extremes][C3][metamorphic]") {
  const ClipScene scene = random_clip_scene(201, 300);
  for_every_instruction_set([&](InstructionSet set) {
    const std::string once = digest_of(scene.view(), {}, gouraud(), set);
    for (const float scale : {0x1p-100f, 0x1p-20f, 0x1p-1f, 0x1p20f, 0x1p120f}) {
      ClipScene scaled = scene;
      for (glm::vec4& p : scaled.positions) p *= scale;
      CHECK(digest_of(scaled.view(), {}, gouraud(), set) == once);
    }
  });
}

TEST_CASE("metamorphic: where a triangle begins does not matter for what it covers", "[extremes][R6][metamorphic]") {
  const auto triangles = test::random_triangles(202, 400, -20000, 60000);
  const test::PublishedCoverage right = test::published(test::drawn_sums(triangles, 160, 120, {.threads = 1}));
  for_every_instruction_set([&](InstructionSet set) {
    for (const auto& order : {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
      std::vector<test::Triangle> turned;
      for (const test::Triangle& t : triangles) turned.push_back({t[order[0]], t[order[1]], t[order[2]]});
      CHECK((test::published(test::drawn_sums(turned, 160, 120, {.threads = 3, .instruction_set = set})) == right));
    }
  });
}

TEST_CASE("metamorphic: opaque triangles of distinct depths may come in any order", "[extremes][B2][metamorphic]") {
  // One depth a triangle, all different in every format.
  test::Random random(203);
  std::vector<std::size_t> order(150);
  std::iota(order.begin(), order.end(), 0u);
  const ClipScene scene = random_clip_scene(203, 150);
  const auto ordered = [&] {
    ClipScene result;
    for (const std::size_t i : order)
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
        glm::vec4 p = scene.positions[k];
        p.w = std::abs(p.w) + 0.25f;
        p.z = (2 * (static_cast<float>(i) + 0.5f) / 150 - 1) * p.w;
        result.positions.push_back(p), result.colours.push_back(scene.colours[k]);
      }
    return result;
  };
  for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
    for (const Compare test : {Compare::less, Compare::greater}) {
      PipelineState state;
      state.depth.test = test;
      std::string first;
      for (int i = 0; i < 4; ++i) {
        Studio studio({.width = 100, .height = 80, .depth = format, .far_depth = test == Compare::less ? 1.0f : 0.0f, .options = {.threads = 2}});
        studio.draw(ordered().view(), gouraud(), state);
        if (first.empty()) first = studio.digest();
        CHECK(studio.digest() == first);
        for (std::size_t k = order.size() - 1; k > 0; --k) std::swap(order[k], order[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(k) + 1))]);
      }
    }
}

TEST_CASE("metamorphic: split at a vertex on the snap grid, a triangle covers the same", "[extremes][R3][metamorphic]") {
  test::Random random(204);
  std::vector<test::Triangle> whole, parts;
  while (whole.size() < 500) {
    // The corners of an edge differ by whole multiples of 16 units, so that 15 points of it are on the grid.
    const auto any = [&] { return static_cast<std::int32_t>(random.below(80000) - 20000); };
    const SnappedPoint a{any(), any()}, step{static_cast<std::int32_t>(random.below(4001) - 2000), static_cast<std::int32_t>(random.below(4001) - 2000)};
    const auto share = static_cast<std::int32_t>(1 + random.below(15));
    const SnappedPoint b{a.x + 16 * step.x, a.y + 16 * step.y}, middle{a.x + share * step.x, a.y + share * step.y}, c{any(), any()};
    whole.push_back({a, b, c});
    parts.push_back({a, middle, c}), parts.push_back({middle, b, c});
  }
  for_every_instruction_set([&](InstructionSet set) {
    for (std::size_t i = 0; i < whole.size(); i += 100) {
      const auto sums = [&](std::span<const test::Triangle> triangles) { return test::drawn_sums(triangles, 160, 120, {.threads = 1, .instruction_set = set}); };
      const Image<Rgba32F> one = sums(std::span(whole).subspan(i, 100)), two = sums(std::span(parts).subspan(2 * i, 200));
      for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
          if (one.at(x, y).g != two.at(x, y).g) FAIL("seed 204, pixel " << x << ", " << y);
    }
  });
}

TEST_CASE("metamorphic: four scissored quadrants are the picture", "[extremes][R6][case-13][metamorphic]") {
  const Mesh ball = test::sphere(16), floor = test::rectangle({-30, -1, -30}, {0, 0, 60}, {60, 0, 0}, {0, 1, 0}, 40);
  const auto texture = test::texture_of(test::checkerboard(64, 8, {250, 240, 40, 255}, {30, 60, 200, 255}), TextureEncoding::srgb);
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world({1.5, 1.25, 2.5}, 1.25);
  const auto draw = [&](Studio& studio) {
    studio.draw(floor.view(), textured({.texture = texture, .sampler = {}}), state);
    studio.draw(ball.view(), phong({}), state);
  };
  for_every_instruction_set([&](InstructionSet set) {
    for (const int samples : {1, 4}) {
      const test::Canvas canvas{.width = 150, .height = 120, .samples = samples, .options = {.threads = 2, .instruction_set = set}};
      Studio whole(canvas), parts(canvas);
      state.rasterization.scissor.reset();
      draw(whole);
      for (const PixelRect& part : {PixelRect{0, 0, 67, 45}, {67, 0, 150, 45}, {0, 45, 67, 120}, {67, 45, 150, 120}}) {
        state.rasterization.scissor = part;
        draw(parts);
      }
      CHECK(parts.digest() == whole.digest());
    }
  });
}

TEST_CASE("metamorphic: moved by whole pixels, the picture moves and keeps its bits", "[extremes][R6][metamorphic]") {
  // Snapped triangles, all of them within the near span of 1984 pixels: interpolation moves along.
  test::Random random(205);
  std::vector<ScreenVertex> corners;
  std::vector<glm::vec4> colours;
  for (int i = 0; i < 600; ++i) {
    corners.push_back({.x = static_cast<std::int32_t>(random.below(24000) - 4000), .y = static_cast<std::int32_t>(random.below(20000) - 4000), .depth = random.between(0, 1), .w = random.between(0.5f, 4)});
    colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 1)});
  }
  const auto drawn = [&](int dx, int dy, InstructionSet set) {
    std::vector<ScreenVertex> moved = corners;
    for (ScreenVertex& v : moved) v.x += dx * 256, v.y += dy * 256;
    PipelineState state;
    state.rasterization.scissor = PixelRect{dx, dy, dx + 64, dy + 48};
    Studio studio({.width = 260, .height = 190, .colour = ColourFormat::rgba32f, .depth = DepthFormat::d32f, .options = {.threads = 2, .instruction_set = set}});
    studio.draw({.screen_positions = moved, .colours = colours}, gouraud(), state);
    return std::pair{studio.target().linear_image(), studio.target().depth_codes()};
  };
  const auto still = drawn(0, 0, InstructionSet::baseline);  // colours, depths
  for_every_instruction_set([&](InstructionSet set) {
    for (const auto& [dx, dy] : {std::pair{1, 0}, {64, 64}, {71, 13}, {193, 139}}) {
      const auto [there, depths] = drawn(dx, dy, set);
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
          if (there.at(x + dx, y + dy) != still.first.at(x, y) || depths.at(x + dx, y + dy) != still.second.at(x, y)) FAIL("moved by " << dx << ", " << dy << ": pixel " << x << ", " << y);
    }
  });
}

TEST_CASE("metamorphic: camera and world moved together, or scaled together, by a power of two", "[extremes][R6][metamorphic]") {
  test::Random random(206);
  Mesh mesh;
  for (int i = 0; i < 240; ++i) {
    mesh.positions.push_back({random.between(-2, 2), random.between(-2, 2), random.between(-9, -1)});
    mesh.colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), 1});
  }
  const glm::mat4 clip_from_view = *perspective(1, 1.25, 0.125, 64, ClipVolume::minus_w_to_w);
  const auto picture = [&](const glm::mat4& world_from_object, const glm::mat4& clip_from_world) {
    PipelineState state;
    state.transform.world_from_object = world_from_object;
    state.transform.clip_from_world = clip_from_world;
    return digest_of(mesh.view(), state);
  };
  const std::string still = picture(glm::mat4(1), clip_from_view);
  // Across the view: along it, a matrix holds the sum of two terms, of which a float keeps what it can.
  for (const double distance : {1.0, 1024.0, 0x1p40}) {
    const glm::dvec3 offset{distance, -4 * distance, 0};
    CHECK(picture(translation(offset), compose(clip_from_view, translation(-offset))) == still);
  }
  // The world larger, the near and far planes, too: every clip coordinate is multiplied.
  for (const double scale : {0x1p-30, 0x1p-1, 0x1p30}) {
    const glm::mat4 scaled_view = *perspective(1, 1.25, 0.125 * scale, 64 * scale, ClipVolume::minus_w_to_w);
    CHECK(picture(scaling({scale, scale, scale}), scaled_view) == still);
  }
}

}  // namespace tuberia
