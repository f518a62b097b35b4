#pragma once
// What a scene leaves behind, in three lines that are quickly compared.

#include <string>

#include "pipeline/pipeline.hpp"
#include "tests/extremes/determinism/scene.hpp"

namespace tuberia::determinism {

/// SHA-256 of every sample: its colour as stored; its depth code, and stencil code if there is one;
/// the number of the primitive that is seen there, from a second drawing of the same geometry.
struct Digests {
  std::string colour, depth, primitives;
  bool operator==(const Digests&) const = default;
};

/// Draws the scene. An error when the pipeline refuses one of its draws.
Result<Digests> digests_of(const Scene& scene, const PipelineOptions& options);

}  // namespace tuberia::determinism
