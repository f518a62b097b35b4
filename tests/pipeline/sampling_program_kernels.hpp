#pragma once
// A program that reads a texture through each way that Fragment offers.

#include <memory>

#include "pipeline/fragment_program.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia::test {

enum class SampleCall { one, two, three, compared };

struct SampleCallUniforms {
  std::shared_ptr<const Texture> texture;
  Sampler sampler;
  SampleCall call = SampleCall::two;
};

/// Samples at `custom`: s; s, t; s, t, r; or s, t, r with the fourth as the reference.
FragmentProgram sample_call(SampleCallUniforms uniforms);

/// Discards every fragment and then samples s, t of `custom` all the same.
FragmentProgram sample_discarded(SampleCallUniforms uniforms);

}  // namespace tuberia::test
