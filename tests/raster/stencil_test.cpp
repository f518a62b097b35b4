#include <catch2/catch.hpp>

#include "tests/support/blocks.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::for_every_machine;

namespace {

constexpr int kStencilOperations = 8;

int operated(StencilOperation operation, int stored, int reference) {
  switch (operation) {
    case StencilOperation::keep: return stored;
    case StencilOperation::zero: return 0;
    case StencilOperation::replace: return reference;
    case StencilOperation::increment: return stored == 255 ? 255 : stored + 1;
    case StencilOperation::decrement: return stored == 0 ? 0 : stored - 1;
    case StencilOperation::invert: return 255 - stored;
    case StencilOperation::increment_wrap: return stored == 255 ? 0 : stored + 1;
    case StencilOperation::decrement_wrap: return stored == 0 ? 255 : stored - 1;
  }
  return -1;
}

bool relates(Compare test, std::int64_t a, std::int64_t b) {
  const bool table[] = {false, a < b, a == b, a <= b, a > b, a != b, a >= b, true};  // in the order of Compare
  return table[static_cast<int>(test)];
}

struct StencilPixel {
  int stencil;
  std::int32_t depth;
  bool live;
  bool operator==(const StencilPixel&) const = default;
};

/// One fragment by the definition.
StencilPixel tested(StencilPixel pixel, std::int32_t code, const StencilFace& face, const DepthState& depth) {
  if (!pixel.live) return pixel;
  const bool matches = relates(face.test, face.reference & face.read_mask, pixel.stencil & face.read_mask);
  const bool nearer = relates(depth.test, code, pixel.depth);
  const StencilOperation operation = !matches ? face.fail : !nearer ? face.depth_fail : face.pass;
  const int result = operated(operation, pixel.stencil, face.reference);
  const bool passes = matches && nearer;
  return {(pixel.stencil & ~face.write_mask & 255) | (result & face.write_mask), passes && depth.write ? code : pixel.depth, passes};
}

StencilFace random_face(test::Random& random) {
  const auto byte = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  const auto mask = [&] { return random.below(2) == 0 ? std::uint8_t{0xff} : byte(); };
  const auto operation = [&] { return static_cast<StencilOperation>(random.below(kStencilOperations)); };
  StencilFace face;
  face.test = static_cast<Compare>(random.below(8));
  face.reference = byte(), face.read_mask = mask(), face.write_mask = mask();
  face.fail = operation(), face.depth_fail = operation(), face.pass = operation();
  return face;
}

/// A block of every sample's stencil codes and depths at random; the kernel against the definition.
void check_block(const OutputState& state, int samples, bool is_back, test::Random& random, InstructionSet set, Precision precision) {
  RenderTarget target = *RenderTarget::create({.width = kBlockSize, .height = kBlockSize, .depth = DepthFormat::d16, .stencil = true, .samples = samples});
  const Tile tile = target.tile(0);
  ScreenTriangle triangle{};
  triangle.is_back = is_back;
  FragmentBlock block;
  block.triangle = &triangle;
  block.samples = samples;
  std::vector<StencilPixel> expected;
  for (int s = 0; s < samples; ++s) {
    block.live |= block.sample_live[s] = random.u64() | random.u64();
    for (int i = 0; i < kBlockPixels; ++i) {
      // Few depths, so that equal ones meet; codes next to the ends of their range are likely.
      const auto new_code = static_cast<std::int32_t>(random.below(3)), old_code = static_cast<std::int32_t>(random.below(3));
      const auto stored = static_cast<std::uint8_t>(random.below(2) == 0 ? random.below(4) - 2 : random.below(256));
      block.depth_value[s][i] = depth_of_code(new_code, DepthFormat::d16);
      tile.depth[s * kTilePixels + i] = old_code;
      tile.stencil[s * kTilePixels + i] = stored;
      const bool live = (block.sample_live[s] >> i & 1u) != 0;
      expected.push_back(tested({stored, old_code, live}, new_code, is_back ? state.stencil.back : state.stencil.front, state.depth));
    }
  }
  block_kernels(set, precision).depth_test(block, state, tile);
  std::uint64_t any = 0;
  for (int s = 0; s < samples; ++s) {
    any |= block.sample_live[s];
    const auto codes = test::in_block_order(target.sample_stencil_codes(s));
    const auto depths = test::in_block_order(target.sample_depth_codes(s));
    for (std::size_t i = 0; i < kBlockPixels; ++i) {
      const StencilPixel found{codes[i], depths[i], (block.sample_live[s] >> i & 1u) != 0};
      if (found != expected[static_cast<std::size_t>(s) * kBlockPixels + i]) FAIL("seed 341, sample " << s << ", fragment " << i);
    }
  }
  CHECK(block.live == any);
}

OutputState stencil_output() {
  OutputState state = test::output_state(ColourFormat::rgba8, DepthFormat::d16);
  state.stencil.enabled = true;
  return state;
}

}  // namespace

TEST_CASE("stencil: every operation in every place does what its table says", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    test::Random random(341);
    OutputState state = stencil_output();
    for (int test = 0; test < 8; ++test)
      for (int operation = 0; operation < kStencilOperations; ++operation)
        for (int place = 0; place < 3; ++place) {
          StencilFace face = random_face(random);
          face.test = static_cast<Compare>(test);
          (place == 0 ? face.fail : place == 1 ? face.depth_fail : face.pass) = static_cast<StencilOperation>(operation);
          state.stencil.front = face;
          state.stencil.back = random_face(random);
          state.depth = {.test = static_cast<Compare>(random.below(8)), .write = random.below(2) == 0};
          check_block(state, 1, false, random, set, precision);
        }
  });
}

TEST_CASE("stencil: faces that are turned away have their own state, and samples their own codes", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    test::Random random(342);
    OutputState state = stencil_output();
    for (int round = 0; round < 100; ++round) {
      state.stencil.front = random_face(random);
      state.stencil.back = random_face(random);
      state.depth = {.test = static_cast<Compare>(random.below(8)), .write = random.below(2) == 0};
      for (const int samples : {1, 4, 16}) check_block(state, samples, round % 2 == 1, random, set, precision);
    }
  });
}

}  // namespace tuberia
