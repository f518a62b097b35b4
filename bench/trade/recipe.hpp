#pragma once
// How a scene is drawn: everything that a switch may turn, as plain data.

#include "pipeline/pipeline.hpp"
#include "raster/render_target.hpp"
#include "raster/sampler.hpp"

namespace tuberia::bench::trade {

/// Where lit surfaces get their light: once a triangle, at its vertices, or at every fragment from interpolated
/// cosines, or at every fragment from an interpolated normal.
enum class Shading { flat, gouraud, dot_product, phong };

/// A scene reads what concerns it and sets the rest itself: matrices, lights, textures.
struct Recipe {
  PipelineOptions pipeline{.threads = 1};
  RenderTargetDescription target{.width = 640, .height = 360};
  int supersampling = 1;  // so many times as many pixels each way, of which the mean is taken
  Sampler sampler{};
  Shading shading = Shading::phong;
  NormalInterpolation normals = NormalInterpolation::renormalized;  // of Phong shading
  bool reversed_depth = false;                                      // near is 1 and far 0; clip volume 0 <= z <= w
  PipelineState state{};                                            // where every draw's state begins
};

}  // namespace tuberia::bench::trade
