#include "reference/oracle/diamond.hpp"

#include <array>
#include <compare>
#include <optional>

namespace tuberia::oracle {
namespace {

/// constant + h * first + h^2 * second, for a positive h smaller than every number: such sums are
/// ordered by their terms, the largest first.
struct Infinitesimal {
  std::int64_t constant = 0, first = 0, second = 0;
  auto operator<=>(const Infinitesimal&) const = default;
};
Infinitesimal operator*(const Infinitesimal& a, std::int64_t b) { return {a.constant * b, a.first * b, a.second * b}; }

/// A place on the segment: 0 at a, 1 at b. The denominator is positive.
struct Place {
  Infinitesimal numerator;
  std::int64_t denominator = 1;
};
bool operator<(const Place& a, const Place& b) { return a.numerator * b.denominator < b.numerator * a.denominator; }

/// One of the diamond's four sides: inside where sign_x (x - cx) + sign_y (y - cy) < 128.
struct Side {
  std::int64_t sign_x, sign_y;

  /// How far the moved point p is inside, positive strictly inside.
  Infinitesimal depth_of(UnitPoint p, UnitPoint c) const {
    return {128 - sign_x * (p.x - c.x) - sign_y * (p.y - c.y), -sign_x, -sign_y};
  }
};
constexpr std::array<Side, 4> kSides{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

bool is_inside(UnitPoint p, UnitPoint c) {
  for (const Side& side : kSides)
    if (!(Infinitesimal{} < side.depth_of(p, c))) return false;
  return true;
}

}  // namespace

bool leaves_diamond(UnitPoint a, UnitPoint b, UnitPoint c) {
  if ((a.x == b.x && a.y == b.y) || is_inside(b, c)) return false;
  // Along the segment the depth inside each side is depth + t slope: the open interval of t in which
  // all four are positive must have a point in [0, 1].
  std::optional<Place> after, before;
  for (const Side& side : kSides) {
    const Infinitesimal depth = side.depth_of(a, c);
    const std::int64_t slope = -side.sign_x * (b.x - a.x) - side.sign_y * (b.y - a.y);
    if (slope == 0) {
      if (!(Infinitesimal{} < depth)) return false;
      continue;
    }
    if (slope > 0) {
      const Place entry{depth * -1, slope};
      if (!after || *after < entry) after = entry;
    } else {
      const Place exit{depth, -slope};
      if (!before || exit < *before) before = exit;
    }
  }
  const Place start{{0, 0, 0}, 1}, end{{1, 0, 0}, 1};
  if (after && !(*after < end)) return false;
  if (before && !(start < *before)) return false;
  return !after || !before || *after < *before;
}

}  // namespace tuberia::oracle
