#include <catch2/catch.hpp>

#include "tests/support/meshes.hpp"
#include "tests/support/render.hpp"

namespace tuberia {

namespace {

std::string digest_of_everything(const PipelineOptions& options, ColourFormat colour, DepthFormat depth) {
  test::Studio studio({.width = 161, .height = 119, .colour = colour, .depth = depth, .background = {0.1f, 0.2f, 0.3f, 1},
                       .options = options});
  test::draw_everything(studio, 161.0f / 119.0f);
  return studio.digest();
}

void check_for_all_machines(ColourFormat colour, DepthFormat depth, const std::string& pinned) {
  for (const InstructionSet set : supported_instruction_sets())
    for (const int threads : {1, 2, 3, 7}) {
      INFO(name_of(set) << ", " << threads << " threads");
      CHECK(digest_of_everything({.threads = threads, .instruction_set = set}, colour, depth) == pinned);
    }
}

}  // namespace

// The digests are part of the contract: whoever changes one says in the commit which bits changed,
// and why. g++ and clang, every instruction set and every number of threads must give the same.
TEST_CASE("determinism: one scene has one digest", "[pipeline][exact]") {
  SECTION("sRGB, 24-bit depths") {
    check_for_all_machines(ColourFormat::srgb8, DepthFormat::d24, "6cbbce42f0a8a25958fb01c4c5faf6bd5174f40e4800a9ef4c8ab28ba7280bcc");
  }
  SECTION("floats, float depths") {
    check_for_all_machines(ColourFormat::rgba32f, DepthFormat::d32f, "8b6a898a690f80d6890f7a602ec20f89247721f86ece18fa41a575c36e5e16a2");
  }
  SECTION("linear codes, 16-bit depths") {
    check_for_all_machines(ColourFormat::rgba8, DepthFormat::d16, "e49b196c6c693b4848eb211ab39308112492fe365cc0e0fd0e69b213daf523fa");
  }
}

TEST_CASE("determinism: drawing again draws the same", "[pipeline][exact]") {
  // One pipeline for both: what it keeps for its speed must not show.
  test::Studio studio({.width = 100, .height = 80});
  test::draw_everything(studio, 1.25f);
  const std::string first = studio.digest();
  studio.pipeline().clear(studio.target(), {0, 0, 0, 0});
  test::draw_everything(studio, 1.25f);
  CHECK(studio.digest() == first);
}

}  // namespace tuberia
