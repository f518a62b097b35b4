#include "bench/figures/label_placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tuberia::bench {
namespace {

constexpr double kLineHeight = 13, kCharacterWidth = 6.1, kPointRadius = 5, kFarthest = 78, kLeaderFrom = 13;
constexpr int kDirections = 16;

double width_of(const std::string& text) {
  // Continuation bytes of UTF-8 are no characters.
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; });
  return kCharacterWidth * static_cast<double>(characters) + 2;
}

/// The text's box when its nearest corner or side lies at this distance in this direction.
Box box_at(const Labelled& point, double distance, double angle) {
  const double dx = std::cos(angle), dy = std::sin(angle), width = width_of(point.text);
  const double x = point.x + distance * dx, y = point.y + distance * dy;
  const double left = x - width * (1 - dx) / 2, top = y - kLineHeight * (1 - dy) / 2;
  return {left, top, left + width, top + kLineHeight};
}

bool is_free(const Box& box, std::span<const Box> taken) {
  return std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return box.overlaps(other); });
}

PlacedLabel place(const Labelled& point, const Box& area, std::span<const Box> taken) {
  for (double distance = kPointRadius + 2; distance <= kFarthest; distance += 6)
    for (int i = 0; i < kDirections; ++i) {
      // To the upper right first, where no front runs, then by turns to both sides of it.
      const int step = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1) - kDirections / 8;
      const Box box = box_at(point, distance, 2 * std::numbers::pi * step / kDirections);
      if (area.holds(box) && is_free(box, taken))
        return {.is_shown = true, .box = box, .needs_leader = distance > kLeaderFrom};
    }
  return {};
}

}  // namespace

std::vector<PlacedLabel> place_labels(std::span<const Labelled> points, const Box& area) {
  std::vector<Box> taken;
  for (const Labelled& point : points)
    taken.push_back({point.x - kPointRadius, point.y - kPointRadius, point.x + kPointRadius, point.y + kPointRadius});
  std::vector<PlacedLabel> placed;
  for (const Labelled& point : points) {
    placed.push_back(point.text.empty() ? PlacedLabel{} : place(point, area, taken));
    if (placed.back().is_shown) taken.push_back(placed.back().box);
  }
  return placed;
}

}  // namespace tuberia::bench
