#pragma once
// Scenes whose right picture is known by a formula: each shows one kind of error, and nothing else.

#include "bench/trade/scene.hpp"

namespace tuberia::bench::trade {

/// 16384 random triangles of some 15 pixels' extent, four sets of 4096 in the four channels, at positions finer than
/// any grid. Ideal: exact coverage of the vertices as they were given. Error: wrong pixels per 1000 px of edge.
Scene random_triangles();

/// 200 random triangles over a square target of `size` pixels, in each of the four channels. Held against the reference
/// setting; error: wrong pixels per 1000 px of edge.
Scene large_triangles(int size);

/// A square of 256 x 256 pixels and 256 texels, w from 1 at the left to `w_right`: its colour is the coordinate.
/// Ideal: the perspective-correct coordinate. Error: the largest, in texels.
Scene receding_texels(double w_right);

/// 16384 pairs of rectangles, at distances spread evenly over the logarithm from 0.1 to 1e4, the second of each
/// pair nearer by a relative gap: it must hide the first, which was drawn before. Error: share of pairs, in %, where
/// it does not.
Scene depth_pairs(double relative_gap);

/// White polygons on black: triangles in every direction, or rectangles whose sides lean 0.5 to 4 degrees. Ideal: the
/// exact area of every pixel's covered part. Error: the root mean square over the pixels that an edge crosses, 0..1.
Scene polygon_edges(bool near_axis);

/// The square between two normals that lean out by an angle, lit from straight ahead: its middle should be as bright
/// as the light. Ideal: the highlight of the exact normal. Error: the largest, in codes.
Scene highlight_between_normals(double lean_degrees, float shininess);

/// All intensities from 0 to 1, left to right. Error: the RMSE in codes of the screen.
Scene intensity_ramp();

/// Black layers of alpha 1/255 over white. Ideal: (254/255)^layers.                                   [case 45]
Scene thin_layers(int layers);

}  // namespace tuberia::bench::trade
