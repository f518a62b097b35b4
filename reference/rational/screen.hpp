#pragma once
// From corners in clip space to the snapped triangles of the screen, and which pixels they cover.

#include <cstdint>

#include "reference/rational/clipping.hpp"

namespace tuberia::rational {

/// What a draw says about the way to the screen.
struct View {
  Viewport viewport;
  int lowest_z = -1;                      // of the clip volume: -1 or 0
  float near_depth = 0, far_depth = 1;    // what its two ends map to
};

/// A corner on the screen: units of 1/256 pixel, depth as the contract's float.
struct ScreenCorner {
  std::int64_t x = 0, y = 0;
  float depth = 0, w = 1;
};

/// The position that a corner has from here on: a vertex its own, a new corner that of the contract, its
/// exact place rounded to float once. Sets `is_doubtful` where the contract's doubles may be rounded to a
/// neighbour.
ClipVertex position_of(const Polygon&, const Corner&, const Triangle&, bool& is_doubtful);

/// Divided, mapped and snapped: each number exact until its one rounding; `is_doubtful` as above. w > 0.
ScreenCorner on_screen(const ClipVertex&, const View&, bool& is_doubtful);

/// A triangle whose vertices run clockwise on the screen (y down), and what it covers.
class ScreenTriangle {
 public:
  /// `first`, `second`, `third`: in the order in which they were assembled.
  ScreenTriangle(const ScreenCorner& first, const ScreenCorner& second, const ScreenCorner& third);

  /// Doubled, in square units; 0 covers nothing.
  std::int64_t area() const noexcept { return area_; }
  bool is_turned() const noexcept { return is_turned_; }
  const ScreenCorner& corner(std::size_t i) const noexcept { return corners_[i]; }

  /// Whether the centre of pixel (x, y) lies inside, or on a left or top edge. Exact: corners within
  /// +-2^23 units and pixels within +-2^15 keep an edge's value below 2^50.
  bool covers(int x, int y) const noexcept;

  /// The depth of the plane through the corners at a pixel's centre, to some 1e-15 of the largest.
  double depth_at(int x, int y) const noexcept;

  /// How far the contract's float may be from it there: a few roundings of numbers up to the largest
  /// depth and, where the triangle spans more than 1984 pixels, up to what the plane rises within the
  /// square of 64 pixels from whose corner the contract starts.
  double depth_error() const noexcept;

 private:
  struct Edge {
    std::int64_t per_x, per_y, x, y, least;  // covered from `least` on: 0 for left and top edges, else 1
    std::int64_t at(int pixel_x, int pixel_y) const noexcept {
      return per_x * (256 * std::int64_t{pixel_x} + 128 - x) + per_y * (256 * std::int64_t{pixel_y} + 128 - y);
    }
  };
  std::array<ScreenCorner, 3> corners_;
  std::array<Edge, 3> edges_;  // edge i lies opposite corner i
  std::int64_t area_ = 0;
  bool is_turned_ = false;
};

/// The triangles that a clip-space triangle becomes: those of its polygon's fan that have an area.
struct Result {
  std::vector<ScreenTriangle> triangles;
  int fan_triangles = 0;  // with those that have none
  bool is_cut = false;
  bool is_doubtful = false;  // the contract's roundings in double may lead to another result
};
Result triangles_of(const Triangle&, const View&);

}  // namespace tuberia::rational
