#pragma once
// The life of one primitive, from its vertices to its last fragment.

#include <limits>

#include "pipeline/fragment_record.hpp"

namespace tuberia {

/// How many of a primitive's fragments went how far.
struct FragmentFates {
  std::int64_t covered = 0;       // with a covered sample
  std::int64_t discarded = 0;     // by the program
  std::int64_t failed_alpha = 0;  // by the alpha test or alpha to coverage
  std::int64_t failed_depth = 0;  // by the stencil or depth test
  std::int64_t reached = 0;       // passed everything
};

/// A vertex as it was assembled.
struct PrimitiveVertex {
  std::uint32_t number = 0;                     // in the mesh
  std::optional<ObjectPosition> object;         // none if the mesh came in clip or screen space
  ClipPosition clip{};
  std::uint32_t outcode = 0;                    // planes that it is outside of, see namespace outcode
};

/// A corner of what clipping left.
struct PrimitiveCorner {
  std::uint32_t slot = 0;                       // its number in the chunk
  std::array<double, 3> weight{};               // of the primitive's vertices, linear in clip space
  bool is_new = false;                          // made by clipping
  ClipPosition clip{};
  std::array<double, 3> ndc{};
  std::int32_t x_units = 0, y_units = 0;        // screen, 1/256 pixel
  float depth = 0;                              // screen, in the depth range unless clipped outside it
  std::vector<float> attributes{};              // as the program declares them; empty if not computed
};

/// What goes on as one: a triangle of the fan that clipping made, the line or point that it left; or an
/// edge or corner of a polygon that is drawn as those.
struct PrimitivePiece {
  enum class Verdict : std::uint8_t { drawn, no_area, turned_away, no_pixel_centre, drawn_as_others };
  std::array<std::size_t, 3> corner{};          // into PrimitiveLife::corners, in the order of the fan
  std::array<std::size_t, 3> clockwise{};       // the same as it is drawn: clockwise on the screen
  int corner_count = 3;                         // 2: a line, 1: a point
  std::int64_t twice_area = 0;                  // of a triangle, square units; > 0: clockwise on the screen
  bool is_front = true;
  Verdict verdict = Verdict::drawn;
  std::optional<ScreenTriangle> set_up{};       // of drawn ones
  std::optional<ScreenShape> shape{};           // of points and lines
  std::vector<int> tiles{};                     // whose lists it is in
  int blocks = 0;                               // of 8x8 pixels with fragments of it
};

/// Everything is in the words of the stages' own headers; spaces are named.
struct PrimitiveLife {
  enum class Clip : std::uint8_t { untouched, cut, outside, not_finite };
  std::uint32_t primitive = 0;
  bool found = false;                           // false: the draw has no such primitive
  RecordedDraw draw;
  Topology topology = Topology::triangles;
  Attributes attributes = Attributes::none;     // that the program reads
  Viewport viewport;
  PixelRect clip_rect;                          // the pixels that may be drawn
  ClipLimits limits;
  CullingState culling;
  std::vector<PrimitiveVertex> vertices;        // three, of a line two, of a point one
  Clip clip = Clip::untouched;
  std::vector<PrimitiveCorner> corners;         // of the polygon that clipping left, in its order
  std::vector<PrimitivePiece> pieces;
  FragmentFates fates;
  PixelRect covered;                            // the smallest rectangle with all its fragments
  std::vector<FragmentRecord> fragments;        // those within the recorder's window
};

/// Watches one draw. All fragments are counted, those of the window kept, too: a triangle as large
/// as the screen has more of them than anyone wants to read.
///
///     PrimitiveRecorder recorder(17);
///     pipeline.draw(target, draw, recorder);
///     recorder.life().corners ...
class PrimitiveRecorder : public Observer {
 public:
  static constexpr int kAnywhere = std::numeric_limits<std::int32_t>::max() / 2;

  explicit PrimitiveRecorder(std::uint32_t primitive, const PixelRect& window = {0, 0, kAnywhere, kAnywhere})
      : watch_(window) {
    life_.primitive = primitive;
  }

  void begin(const DrawCall& draw, const AcceptedDraw& accepted) override;
  void after(Stage stage, const Chunk& chunk) override;
  void before(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) override;
  void after(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) override;
  void end(const DrawStatistics&) override { life_.fragments = watch_.fragments(); }

  const PrimitiveLife& life() const noexcept { return life_; }

 private:
  bool holds(const Chunk& chunk) const noexcept;
  void assembled(const Chunk& chunk);
  void clipped(const Chunk& chunk);
  void projected(const Chunk& chunk);
  void culled(const Chunk& chunk);
  void set_up(const Chunk& chunk);
  void attributes(const Chunk& chunk);
  void binned(const Chunk& chunk);
  PrimitivePiece& add_piece(const Chunk& chunk, const std::array<std::uint32_t, 3>& slots, int corner_count);
  std::size_t corner_of(const Chunk& chunk, std::uint32_t slot);
  PrimitivePiece* piece_with(const std::array<std::uint32_t, 3>& slots, int corner_count);
  PrimitivePiece* piece_of(const Chunk& chunk, std::size_t record);
  void rasterized(const Chunk& chunk, const FragmentBlock& block);

  PrimitiveLife life_;
  FragmentWatch watch_;
  const DrawCall* draw_ = nullptr;              // while it is drawn
  std::vector<std::uint32_t> vertex_slot_;
  int live_before_ = 0;
};

}  // namespace tuberia
