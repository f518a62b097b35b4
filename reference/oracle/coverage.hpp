#pragma once
// Whether a primitive covers a point of the screen, and with which weights; by exact integers, for
// one point at a time.

#include <array>
#include <cstdint>

#include "reference/oracle/screen.hpp"
#include "reference/oracle/target.hpp"

namespace tuberia::oracle {

/// Weights of vertices 1 and 2 (vertex 0 has the rest), as the documents' floats.
struct Weights {
  float one = 0, two = 0;
};

/// A primitive set up for its draw's state.
class Shape {
 public:
  Shape(const ScreenPrimitive&, const Draw&, int samples);

  /// Whether sample `sample` of pixel (x, y) is covered.
  bool covers(int x, int y, int sample) const;

  /// At the centre of a pixel, and at one of its samples.
  Weights weights(int x, int y) const { return weights_at(x, y, {0, 0}, x); }
  /// At a centre that may lie in another square of 64x64 pixels than column `square_x`, whose plane counts.
  Weights weights(int x, int y, int square_x) const { return weights_at(x, y, {0, 0}, square_x); }
  float depth(int x, int y, int sample) const;

  /// The vertices in the order that the weights mean.
  const ScreenVertex& vertex(std::size_t i) const { return vertices_[i]; }
  const ScreenPrimitive& primitive() const { return primitive_; }

 private:
  struct Edge {
    std::int64_t per_x = 0, per_y = 0, x = 0, y = 0, rule = 0;  // rule: 0 for top-left edges, 1 for others
    std::int64_t at(std::int64_t px, std::int64_t py) const { return per_x * (px - x) + per_y * (py - y); }
  };

  void set_up_triangle();
  Weights weights_at(int x, int y, SampleOffset, int square_x) const;
  float near_weight(const Edge&, int x, int y, SampleOffset) const;
  float far_weight(const Edge&, int x, int y, SampleOffset, int square_x) const;
  bool triangle_covers(std::int64_t px, std::int64_t py) const;
  bool rounded_edges_cover(int x, int y) const;
  bool point_covers(std::int64_t px, std::int64_t py) const;
  bool thin_line_covers(int x, int y) const;
  bool wide_line_covers(int x, int y) const;
  bool rectangle_covers(std::int64_t px, std::int64_t py) const;
  bool stipple_shows(int x, int y) const;

  const ScreenPrimitive& primitive_;
  const Draw& draw_;
  int samples_;
  std::array<ScreenVertex, 3> vertices_;
  std::array<Edge, 3> edges_{};
  std::int64_t area_ = 0;
  bool is_far_ = false;   // spans more than 1984 pixels, or has other edges than the usual
  std::int64_t size_ = 0;   // of points and multisampled lines, units
  std::int64_t width_ = 1;  // of other lines, pixels
};

}  // namespace tuberia::oracle
