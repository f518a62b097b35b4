#pragma once
// A scene with a golden picture: drawn on every instruction set with one thread and with three.

#include "tests/golden/golden.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia::test {

inline constexpr Rgba32F kGoldenSky{0.05f, 0.08f, 0.15f, 1};

/// draw: (Studio&) -> void, or (Studio&) -> Image<Rgba8> where the picture is not the whole target.
template <class Draw>
void check_golden(const char* name, Canvas canvas, Draw&& draw) {
  for_every_instruction_set([&](InstructionSet set) {
    for (const int threads : {1, 3}) {
      canvas.options = {.threads = threads, .instruction_set = set};
      Studio studio(canvas);
      if constexpr (std::is_void_v<decltype(draw(studio))>) {
        draw(studio);
        CHECK(golden_difference(name, studio.target().colour_image()) == "");
      } else {
        CHECK(golden_difference(name, draw(studio)) == "");
      }
    }
  });
}

/// A canvas for pictures to be looked at.
inline Canvas golden_canvas() { return {.width = 160, .height = 120, .colour = ColourFormat::srgb8, .background = kGoldenSky}; }

/// The part of a 160 x 120 picture that cell (column, row) of a grid takes, two pixels apart.
inline Viewport grid_cell(int column, int row, int columns, int rows) {
  const int width = 160 / columns, height = 120 / rows;
  return {.x = column * width + 1, .y = row * height + 1, .width_pixels = width - 2, .height_pixels = height - 2};
}

}  // namespace tuberia::test
