#pragma once
// What triangle setup knows of a triangle, and all that the tiles need.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace tuberia {

/// In which numbers the pixels of a triangle are decided. exact: 32 bits within a tile wherever they are
/// enough, set up in 64; exact_64: 64 bits everywhere, which covers the same and takes longer. The
/// others round to floats: the edge functions as distances from the corner of a square of 64x64 pixels,
/// or as planes over the whole target.
enum class EdgeArithmetic : std::uint8_t { exact, exact_64, float_anchored, float_plane };

/// A triangle of screen space, set up. Its vertices 0, 1, 2 run clockwise on the screen (y down),
/// so every edge function is positive inside. Edge i lies opposite vertex i.
///
/// The edge function of edge i at the centre of pixel (x, y), in square units of 1/256 pixel, is
///     E = 256 * e + (remainder),  e = constant + per_x * x + per_y * y   in whole numbers,
/// with 0 <= remainder < 256 the same for all pixels, since centres are whole pixels apart. The
/// top-left rule has already been taken off, so a centre is covered exactly when all e >= 0.
/// Points and lines are such records, too: see ScreenShape.
///
/// Two cache lines: the first tells which centres of a small triangle are covered, and with what
/// weights; the second what is needed once something is. Set-up writes it by these offsets.
struct alignas(64) ScreenTriangle {
  std::int16_t left, top, right, bottom;  // centres that may be covered, all inclusive
  std::int32_t per_x[3], per_y[3];  // |.| <= 2^24
  std::int32_t constant_low[3];     // the constants' lowest 32 bits

  // Barycentric weight i (i = 1, 2) at a centre: weight_scale * e + weight_offset[i-1].
  float weight_scale;               // 256 / twice the area
  float weight_offset[2];

  // How attributes follow 1/w: one of the two below, or the length in pixels, 8, 16 or 32, of the
  // segments of a row at whose ends alone weights are divided.
  std::uint8_t perspective;
  // Spans of up to kNearSpanPixels keep e within 32 bits at every pixel of every touched tile, so
  // weights come straight from e; larger ones take weights from planes anchored to the pixel grid.
  std::uint8_t is_near;
  std::uint8_t is_back;             // turned away; 0 for points and lines, and where nobody asked
  EdgeArithmetic edge_arithmetic = EdgeArithmetic::exact;  // others only where is_near is 0
  std::uint8_t remainder[3];        // of the edge functions, see above: what multisampling starts from

  // Depth is linear in screen space: depth + w1 * depth_delta[0] + w2 * depth_delta[1].
  alignas(64) float depth;
  float depth_delta[2];

  float inverse_w[3];               // smallest w / w of each vertex: 1/w up to a common factor; >= kLeastInverseW
  std::uint16_t vertex[3];          // slots of the vertices in their chunk
  std::uint16_t provoking_vertex;   // the slot that gives the attributes that are not interpolated
  std::uint32_t primitive;          // number of the primitive in its draw
  double constant[3];               // integers, |.| <= 2^42
};
static_assert(sizeof(ScreenTriangle) == 128, "two cache lines");
static_assert(offsetof(ScreenTriangle, weight_scale) == 44 && offsetof(ScreenTriangle, remainder) == 60 &&
              offsetof(ScreenTriangle, primitive) == 96 && offsetof(ScreenTriangle, constant) == 104);

/// ScreenTriangle::perspective: weights are divided at each pixel; or nowhere, since w is equal at all
/// vertices or shall count as equal.
inline constexpr std::uint8_t kDividesEachPixel = 0, kIsAffine = 1;

/// What tells whether a triangle is hidden, so that those which are need not be fetched.
struct TriangleExtent {
  std::int16_t left, top, right, bottom;  // as of the triangle
  // Between these lie the depths of all its fragments; of large triangles, that are asked block by
  // block, infinities.
  float lowest, highest;
};
static_assert(sizeof(TriangleExtent) == 16);

/// Triangles up to this size rarely hold a whole block.
inline constexpr int kSmallPixels = 16;

inline TriangleExtent extent_of(const ScreenTriangle& t) noexcept {
  const bool is_small = t.is_near != 0 && t.right - t.left < kSmallPixels && t.bottom - t.top < kSmallPixels;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (!is_small) return {t.left, t.top, t.right, t.bottom, -kInfinity, kInfinity};
  // A near triangle's weights are right to some 2^-22 inside it, so no depth there lies farther beyond
  // those of the vertices than the margin.
  const float second = t.depth + t.depth_delta[0], third = t.depth + t.depth_delta[1];
  const float margin = 0x1p-19f * (std::abs(t.depth) + std::abs(t.depth_delta[0]) + std::abs(t.depth_delta[1]));
  return {t.left, t.top, t.right, t.bottom, std::min(std::min(second, third), t.depth) - margin,
          std::max(std::max(second, third), t.depth) + margin};
}

/// The least relative 1/w: its reciprocal is still a float, so no quotient of weights overflows.
inline constexpr double kLeastInverseW = 0x1p-100;

/// |E| <= 2 * span * (span + tile), in units, must stay below 2^39 for e to fit 32 bits:
/// 2 * (1984*256) * (1984*256 + 64*256) = 5.3e11 < 2^39 = 5.5e11.
inline constexpr int kNearSpanPixels = 1984;
static_assert(2.0 * (kNearSpanPixels * 256.0) * ((kNearSpanPixels + 64) * 256.0) < 549755813888.0);

/// Weights of larger triangles are planes anchored at the corners of squares of this many pixels,
/// fixed to the grid of pixels whatever the tile size, so that no tile size can change a bit.
inline constexpr int kAnchorSquarePixels = 64;

}  // namespace tuberia
