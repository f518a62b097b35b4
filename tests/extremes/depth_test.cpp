// What depth buffers can tell apart: rules Z1 to Z3, cases 30 to 33.

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "math/transforms.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Studio;

namespace {

constexpr double kNearPlane = 0.1, kFarPlane = 1e4;

/// The depth of what is this far away, of a view from kNearPlane to kFarPlane, 0 <= z <= w.
double depth_at(double distance, bool reversed) {
  const double standard = kFarPlane / (kFarPlane - kNearPlane) * (1 - kNearPlane / distance);
  return reversed ? kNearPlane / (kFarPlane - kNearPlane) * (kFarPlane / distance - 1) : standard;
}

struct Buffer {
  DepthFormat format;
  bool reversed;
};
constexpr Buffer kD16{DepthFormat::d16, false}, kD24{DepthFormat::d24, false}, kFloat{DepthFormat::d32f, false}, kReversed{DepthFormat::d32f, true};

std::int32_t code_at(double distance, const Buffer& buffer) {
  return code_of_depth(static_cast<float>(depth_at(distance, buffer.reversed)), buffer.format);
}

/// How far apart two codes are at a distance: the step of a code by the slope of the depth.
double step_at(double distance, const Buffer& buffer) {
  const std::int32_t code = code_at(distance, buffer);
  const double last = buffer.format == DepthFormat::d16 ? 65535 : 16777215;
  const double step = buffer.format == DepthFormat::d32f
                          ? static_cast<double>(depth_of_code(code + 1, buffer.format)) - static_cast<double>(depth_of_code(code, buffer.format))
                          : 1 / last;
  const double slope = kFarPlane * kNearPlane / (kFarPlane - kNearPlane) / (distance * distance);
  return step / slope;
}

/// The share of pairs at any scale, the second by a share `gap` farther, that the codes do not put in this order.
double confused(double gap, const Buffer& buffer) {
  test::Random random(31);
  constexpr int kPairs = 100000;
  int wrong = 0;
  for (int i = 0; i < kPairs; ++i) {
    const double share = static_cast<double>(random.u64() >> 11) * 0x1p-53, distance = kNearPlane * std::pow(kFarPlane / kNearPlane, share);
    const std::int32_t nearer = code_at(distance, buffer), farther = code_at(distance * (1 + gap), buffer);
    wrong += buffer.reversed ? nearer <= farther : nearer >= farther;
  }
  return static_cast<double>(wrong) / kPairs;
}

/// Which of two planes across the view is seen, red at the first distance or green at the second.
char seen_of(double red_distance, double green_distance, bool green_first, const Buffer& buffer, InstructionSet set) {
  PipelineState state;
  state.clipping.volume = ClipVolume::zero_to_w;
  state.transform.clip_from_world = *perspective(1, 1, kNearPlane, kFarPlane, ClipVolume::zero_to_w, buffer.reversed);
  state.depth.test = buffer.reversed ? Compare::greater : Compare::less;
  Studio studio({.width = 9, .height = 9, .depth = buffer.format, .far_depth = buffer.reversed ? 0.0f : 1.0f, .options = {.threads = 1, .instruction_set = set}});
  for (const bool green : {green_first, !green_first}) {
    const auto z = static_cast<float>(-(green ? green_distance : red_distance)), reach = -4 * z;
    studio.draw(test::rectangle({-reach, -reach, z}, {2 * reach, 0, 0}, {0, 2 * reach, 0}, {0, 0, 1}, 1, green ? glm::vec4(0, 1, 0, 1) : glm::vec4(1, 0, 0, 1)).view(), gouraud(), state);
  }
  return studio.target().colour_image().at(4, 4).r != 0 ? 'r' : 'g';
}

/// A plane over the screen, z = z_at_corner + x dzdx + y dzdy in pixels from the upper left corner of 100 x 100.
std::int32_t code_with_offset(const PolygonOffset& offset, DepthFormat format, float z_at_corner, InstructionSet set) {
  const auto vertex = [&](int x, int y) {
    return ScreenVertex{.x = x * 256, .y = y * 256, .depth = z_at_corner + 0.001f * static_cast<float>(x) + 0.002f * static_cast<float>(y)};
  };
  const std::vector<ScreenVertex> corners{vertex(0, 0), vertex(100, 0), vertex(0, 100)};
  PipelineState state;
  state.rasterization.polygon_offset = offset;
  Studio studio({.width = 100, .height = 100, .depth = format, .options = {.threads = 1, .instruction_set = set}});
  studio.draw({.screen_positions = corners}, flat(), state);
  return studio.target().depth_codes().at(8, 8);
}

}  // namespace

TEST_CASE("depth: codes are rounded, and clamped before that", "[extremes][Z1]") {
  CHECK(code_of_depth(0.5f, DepthFormat::d24) == 8388608);
  CHECK(code_of_depth(0.5f, DepthFormat::d16) == 32768);
  for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
    CHECK(code_of_depth(-3, format) == 0);
    CHECK(code_of_depth(7, format) == code_of_depth(1, format));
  }
  for_every_instruction_set([](InstructionSet set) {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
      for (const float depth : {0.0f, 0.5f, 0.3f, 1.0f}) {
        const std::vector<ScreenVertex> corners{{.x = -256, .y = -256, .depth = depth}, {.x = 9999, .y = -256, .depth = depth}, {.x = -256, .y = 9999, .depth = depth}};
        PipelineState state;
        state.depth.test = Compare::always;
        Studio studio({.width = 9, .height = 9, .depth = format, .options = {.threads = 1, .instruction_set = set}});
        studio.draw({.screen_positions = corners}, flat(), state);
        CHECK(studio.target().depth_codes().at(5, 3) == code_of_depth(depth, format));
      }
  });
}

TEST_CASE("depth: what interpolation and offset leave is clamped to the viewport's range", "[extremes][Z2]") {
  for_every_instruction_set([](InstructionSet set) {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
      for (const float units : {-1e9f, 1e9f}) {
        PipelineState state;
        state.viewport.depth_range = {0.25f, 0.75f};
        state.depth.test = Compare::always;
        state.rasterization.polygon_offset = {.factor = 0, .units = units};
        const std::vector<glm::vec4> corners{{-1, -1, -1, 1}, {3, -1, 1, 1}, {-1, 3, 1, 1}};
        Studio studio({.width = 9, .height = 9, .depth = format, .options = {.threads = 1, .instruction_set = set}});
        studio.draw({.clip_positions = corners}, flat(), state);
        const Image<std::int32_t> codes = studio.target().depth_codes();
        for (const std::int32_t code : codes.pixels()) CHECK(code == code_of_depth(units < 0 ? 0.25f : 0.75f, format));
      }
  });
}

TEST_CASE("depth: the steps of every format from near to far", "[extremes][Z1][case-30]") {
  struct Known {
    double distance, d16, d24, floats, reversed;
  };
  for (const Known& k : {Known{10, .01526, 5.96e-5, 5.96e-5, 9.31e-7}, {100, 1.526, .00596, .00596, 1.16e-5}, {1000, 152.6, .596, .596, 7.28e-5}, {5000, 3815, 14.9, 14.9, 2.27e-4}}) {
    INFO("at " << k.distance);
    CHECK(step_at(k.distance, kD16) == Approx(k.d16).epsilon(2e-3));
    CHECK(step_at(k.distance, kD24) == Approx(k.d24).epsilon(2e-3));
    CHECK(step_at(k.distance, kFloat) == Approx(k.floats).epsilon(2e-3));
    CHECK(step_at(k.distance, kReversed) == Approx(k.reversed).epsilon(5e-3));
  }
}

TEST_CASE("depth: how many pairs of surfaces each format confuses", "[extremes][Z1][case-31]") {
  struct Known {
    double gap, d16, d24, floats;
  };
  for (const Known& k : {Known{1e-3, .549, .082, .082}, {1e-4, .750, .267, .267}, {1e-5, .942, .468, .468}, {1e-6, .994, .667, .668}}) {
    INFO("a gap of " << k.gap);
    CHECK(confused(k.gap, kD16) == Approx(k.d16).margin(0.006));
    CHECK(confused(k.gap, kD24) == Approx(k.d24).margin(0.006));
    CHECK(confused(k.gap, kFloat) == Approx(k.floats).margin(0.006));
    CHECK(confused(k.gap, kReversed) == 0);
  }
}

TEST_CASE("depth: two far planes, told apart or not", "[extremes][Z1][case-32]") {
  CHECK(code_at(1000, kD24) == 16775705);
  CHECK(code_at(1001, kD24) == 16775707);
  CHECK(code_at(1000, kD24) == code_at(1000.05, kD24));
  CHECK(code_at(1000, kReversed) == 951893726);
  CHECK(code_at(1000.05, kReversed) == 951893038);
  for_every_instruction_set([](InstructionSet set) {
    for (const bool green_first : {false, true}) {
      CHECK(seen_of(1000, 1001, green_first, kD24, set) == 'r');
      CHECK(seen_of(1001, 1000, green_first, kD24, set) == 'g');
      CHECK(seen_of(1000, 1000.05, green_first, kD24, set) == (green_first ? 'g' : 'r'));  // a tie: the first one stays
      CHECK(seen_of(1000, 1000.05, green_first, kReversed, set) == 'r');
      CHECK(seen_of(1000.05, 1000, green_first, kReversed, set) == 'g');
    }
  });
}

TEST_CASE("depth: a polygon is pushed by its slope and by units", "[extremes][Z3][case-33]") {
  // The largest difference in x or y is the slope; 0.0030002384 in 24 bits.
  const PolygonOffset offset{.factor = 1.5f, .units = 4};
  for_every_instruction_set([&](InstructionSet set) {
    const auto pushed = [&](const PolygonOffset& by, DepthFormat format, float corner) {
      const double last = format == DepthFormat::d16 ? 65535 : 16777215;
      return (code_with_offset(by, format, corner, set) - code_with_offset({}, format, corner, set)) / last;
    };
    CHECK(pushed(offset, DepthFormat::d24, 0.25f) == Approx(.0030002384185791016).margin(2.0 / 16777215));
    CHECK(pushed(offset, DepthFormat::d16, 0.25f) == Approx(.00306103515625).margin(1.0 / 65535));
    const auto depth = [&](const PolygonOffset& by) { return static_cast<double>(std::bit_cast<float>(code_with_offset(by, DepthFormat::d32f, 0.55f, set))); };
    CHECK(depth(offset) - depth({}) == Approx(.0030002384185791016).margin(2 * 0x1p-24));  // zmax .75: units of 2^-24
    // Neither term, nothing at all.
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
      CHECK(code_with_offset({.factor = 0, .units = 0}, format, 0.55f, set) == code_with_offset({}, format, 0.55f, set));
  });
}

TEST_CASE("depth: a slope without end counts only if it is asked for", "[extremes][Z3]") {
  // One unit wide and from 0 to 1 in depth: factor 0 must not make a NaN of it.
  const std::vector<ScreenVertex> steep{{.x = 128, .y = 0, .depth = 0}, {.x = 129, .y = 0, .depth = 1}, {.x = 128, .y = 2560, .depth = 0.5f}};
  for_every_instruction_set([&](InstructionSet set) {
    PipelineState state;
    state.depth.test = Compare::always;
    state.rasterization.polygon_offset = {.factor = 0, .units = 1};
    Studio studio({.width = 1, .height = 10, .depth = DepthFormat::d32f, .options = {.threads = 1, .instruction_set = set}});
    studio.draw({.screen_positions = steep}, flat(), state);
    const Image<float> depths = studio.target().depth_image();
    for (const float depth : depths.pixels()) CHECK((depth >= 0 && depth <= 1));
  });
}

}  // namespace tuberia
