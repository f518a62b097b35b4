#pragma once
// Where the names of points go, so that they hide neither one another nor the points.

#include <span>
#include <string>
#include <vector>

namespace tuberia::bench {

struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;

  bool overlaps(const Box& other) const noexcept {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool holds(const Box& other) const noexcept {
    return left <= other.left && top <= other.top && right >= other.right && bottom >= other.bottom;
  }
};

struct Labelled {
  double x = 0, y = 0;  // pixels
  std::string text{};   // empty: only to be kept clear of
};

struct PlacedLabel {
  bool is_shown = false;
  Box box{};                  // of the text
  bool needs_leader = false;  // too far from its point to be recognized as its
};

/// One for each point, in their order. area: all that may be written on. A label for which there is no
/// room is left out.
std::vector<PlacedLabel> place_labels(std::span<const Labelled> points, const Box& area);

}  // namespace tuberia::bench
