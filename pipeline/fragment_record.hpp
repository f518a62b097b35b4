#pragma once
// What became of one fragment: the common part of all recorders.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/observer.hpp"
#include "pipeline/pixel_contents.hpp"

namespace tuberia {

/// What a recorder must know of a draw to tell of its fragments.
struct RecordedDraw {
  std::string program;       // its name
  OutputState output;
  bool flat_shading = false;
};

/// One covered sample of a fragment.
struct SampleRecord {
  int sample = 0;
  float depth_value = 0;                   // interpolated, not yet clamped to the depth range
  std::optional<std::int32_t> depth_code;  // what was compared; none if the depth test was not reached
  std::optional<Stage> died_at;            // none: it reached the target
  bool stencil_failed = false;             // died at the depth test's stage by the stencil test
  SampleContents before, after;            // of the pixel: before this fragment, and after the last stage it reached
};

/// A fragment from rasterization to its end. Weights are those of the three vertices of its screen
/// triangle, clockwise; of a line the first two count.
struct FragmentRecord {
  int draw = 0;                             // counted from the recorder's first
  std::uint32_t primitive = 0;              // number in its draw
  int x = 0, y = 0;                         // pixel of the target
  bool is_back = false;
  std::array<std::int64_t, 3> vertex{};     // numbers in the mesh; -1: made by clipping
  std::array<std::uint32_t, 3> slot{};      // numbers in the chunk
  std::array<double, 3> weight{};           // in screen space; depth is interpolated with these
  std::array<double, 3> perspective{};      // corrected by 1/w; attributes are interpolated with these
  std::optional<Rgba32F> colour{};          // the program's, after fog; none if it was not shaded
  std::vector<Stage> stages{};              // that it entered, in the order in which they ran
  std::vector<SampleRecord> samples{};      // those that were covered

  bool reached_the_target() const noexcept;
  /// Where the last of its samples died; none if one reached the target.
  std::optional<Stage> died_at() const noexcept;
};

/// Follows the fragments of a draw's blocks, one block after the other, and keeps those of `window`.
/// Its three functions are called from an Observer's of the same name.
class FragmentWatch {
 public:
  explicit FragmentWatch(const PixelRect& window) noexcept : window_(window) {}

  void begin(const OutputState& output, int draw) noexcept { output_ = output, draw_ = draw; }
  void rasterized(const Chunk& chunk, const FragmentBlock& block, const Tile& tile);
  void after(Stage stage, const FragmentBlock& block, const Tile& tile);

  const std::vector<FragmentRecord>& fragments() const noexcept { return fragments_; }

 private:
  void add(const Chunk& chunk, const FragmentBlock& block, const Tile& tile, int index);
  void update(FragmentRecord& fragment, Stage stage, const FragmentBlock& block, const Tile& tile, int index) const;
  void update(SampleRecord& sample, Stage stage, const FragmentBlock& block, int index, bool is_back) const;

  PixelRect window_;
  OutputState output_{};
  int draw_ = 0;
  std::size_t first_of_block_ = 0;  // fragments_ from here on belong to the current block
  std::vector<FragmentRecord> fragments_;
};

/// A vertex's own slot: faces that are turned away may have colours, and with them slots, of their own.
inline std::uint32_t own_slot(const VertexBatch& vertices, std::uint32_t slot) noexcept {
  const auto back = static_cast<std::uint32_t>(vertices.back_slots);
  return back > 0 && slot >= back ? slot - back : slot;
}

/// Whether a new value stands in this relation to the stored one.
bool passes(Compare test, std::int32_t value, std::int32_t stored) noexcept;

/// "depth test"; in words, for people.
const char* name_of(Stage stage) noexcept;

}  // namespace tuberia
