#include "reference/oracle/cube.hpp"

#include <cmath>

namespace tuberia::oracle {
namespace {

/// Which coordinates (0, 1, 2 of a direction) run along s and t of each face, and in which sense.
struct FaceAxes {
  int major, s_axis, t_axis;
  double major_sign, s_sign, t_sign;
};
constexpr std::array<FaceAxes, 6> kFaces{{{0, 2, 1, 1, -1, -1}, {0, 2, 1, -1, 1, -1}, {1, 0, 2, 1, 1, 1},
                                          {1, 0, 2, -1, 1, -1}, {2, 0, 1, 1, 1, -1}, {2, 0, 1, -1, -1, -1}}};

}  // namespace

std::vector<CubeFace> faces_of(const std::array<Interval, 3>& direction) {
  std::array<Interval, 3> size;
  for (std::size_t i = 0; i < 3; ++i) size[i] = absolute(direction[i]);
  std::vector<CubeFace> faces;
  for (int number = 0; number < 6; ++number) {
    const FaceAxes& axes = kFaces[static_cast<std::size_t>(number)];
    const auto major = static_cast<std::size_t>(axes.major);
    const Interval along = axes.major_sign > 0 ? direction[major] : -direction[major];
    bool may_be = along.high > 0;
    for (std::size_t other = 0; other < 3; ++other) {
      if (other == major) continue;
      // The later axis wins between equals.
      if (other > major ? size[major].high <= size[other].low : size[major].high < size[other].low) may_be = false;
    }
    if (!may_be) continue;
    const auto coordinate = [&](int axis, double sign) {
      const Interval c = direction[static_cast<std::size_t>(axis)];
      const Interval ratio = (sign > 0 ? c : -c) / size[major];
      return (ratio + Interval(1.0)) * Interval(0.5);
    };
    faces.push_back({number, coordinate(axes.s_axis, axes.s_sign), coordinate(axes.t_axis, axes.t_sign)});
  }
  return faces;
}

Triple in_frame(int face, const Triple& v) {
  const FaceAxes& axes = kFaces[static_cast<std::size_t>(face)];
  const auto along = [&](int axis, double sign) {
    const Interval c = v[static_cast<std::size_t>(axis)];
    return sign > 0 ? c : -c;
  };
  return {along(axes.s_axis, axes.s_sign), along(axes.t_axis, axes.t_sign), along(axes.major, axes.major_sign)};
}

Steps projected_steps(int face, const Triple& direction, const Steps& steps, int size) {
  const auto [a, b, m] = in_frame(face, direction);
  const Interval s = a / m, t = b / m, half = size / 2.0;
  const auto projected = [&, m = m](const Triple& step) {
    const auto [da, db, dm] = in_frame(face, step);
    return Triple{((da - s * dm) / m) * half, ((db - t * dm) / m) * half, 0.0};
  };
  return {projected(steps.x), projected(steps.y)};
}

const Colour& cube_texel(const TextureLevel& level, std::int64_t i, std::int64_t j, int face) {
  const int n = level.width;
  if (i >= 0 && i < n && j >= 0 && j < n) return level.at(static_cast<int>(i), static_cast<int>(j), face);
  // The texel's centre on the face's plane, seen from the middle of the cube, lies on the next face.
  const FaceAxes& axes = kFaces[static_cast<std::size_t>(face)];
  std::array<Interval, 3> direction;
  const auto centre = [n](std::int64_t k) { return (2 * static_cast<double>(k) + 1) / n - 1; };
  direction[static_cast<std::size_t>(axes.major)] = axes.major_sign;
  direction[static_cast<std::size_t>(axes.s_axis)] = axes.s_sign * centre(i);
  direction[static_cast<std::size_t>(axes.t_axis)] = axes.t_sign * centre(j);
  const CubeFace next = faces_of(direction).front();
  const auto texel = [n](Interval c) { return std::clamp(static_cast<int>(std::floor(c.low * n)), 0, n - 1); };
  return level.at(texel(next.s), texel(next.t), next.number);
}

Outcome outcome_of(Compare test, Interval a, double b) {
  if (!a.is_known()) return test == Compare::always ? Outcome::yes : test == Compare::never ? Outcome::no : Outcome::maybe;
  // Between the bounds the relation changes only where it does at one of them, or in between at b.
  const bool low = holds(test, a.low, b), high = holds(test, a.high, b);
  if (low != high) return Outcome::maybe;
  if (a.low < b && b < a.high && holds(test, b, b) != low) return Outcome::maybe;
  return low ? Outcome::yes : Outcome::no;
}

}  // namespace tuberia::oracle
