#pragma once
// Gouraud's interpolation as the notes print it, in double.                             [B 3.2]

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace tuberia::test {

struct ShadedCorner {
  double x = 0, y = 0, intensity = 0;  // pixels, y down
};

/// Where a scan line enters and leaves a polygon, and the intensities there.
struct ScanLine {
  double left_x = 0, right_x = 0, left = 0, right = 0;
};

/// IQ = (1 - u) IA + u IB with u = AQ / AB, along an edge.
constexpr double along(double first, double second, double part) { return (1 - part) * first + part * second; }

/// The scan line at height y through a triangle that it crosses.
inline ScanLine scan_line(const std::array<ShadedCorner, 3>& triangle, double y) {
  std::vector<std::pair<double, double>> crossings;
  for (std::size_t i = 0; i < 3; ++i) {
    const ShadedCorner &a = triangle[i], &b = triangle[(i + 1) % 3];
    if ((a.y < y) == (b.y < y)) continue;
    const double u = (y - a.y) / (b.y - a.y);
    crossings.emplace_back(along(a.x, b.x, u), along(a.intensity, b.intensity, u));
  }
  std::sort(crossings.begin(), crossings.end());
  const auto& [left_x, left] = crossings.front();
  const auto& [right_x, right] = crossings.back();
  return {.left_x = left_x, .right_x = right_x, .left = left, .right = right};
}

/// IP = (1 - v) IQ + v IR with v = QP / QR.
inline double intensity_at(const ScanLine& line, double x) {
  return along(line.left, line.right, (x - line.left_x) / (line.right_x - line.left_x));
}

/// The same at the centres of pixels from the first one right of Q on: each its neighbour's intensity and dI dv.
inline std::vector<double> incremental(const ScanLine& line, double first_x, int count) {
  const double step = (line.right - line.left) * (1 / (line.right_x - line.left_x));  // once a scan line
  std::vector<double> intensities{intensity_at(line, first_x)};
  while (static_cast<int>(intensities.size()) < count) intensities.push_back(intensities.back() + step);
  return intensities;
}

}  // namespace tuberia::test
