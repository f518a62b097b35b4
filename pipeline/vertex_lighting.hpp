#pragma once
// The local model at the vertices, for Gouraud shading.

#include "pipeline/state.hpp"
#include "raster/instruction_set.hpp"

namespace tuberia {

/// points, normals: x, y, z arrays of `pitch` floats each, world space, normals unit; pitch is a
/// multiple of kKernelPadding. colours: r, g, b, a arrays of `pitch` floats each. Exact.
using VertexLightingKernel = void (*)(const Lighting&, const float* points, const float* normals, int pitch, float* colours);

VertexLightingKernel vertex_lighting_kernel(InstructionSet) noexcept;

/// In place of colours n.l and n.h (or r.v) of the first light and of the second, an array each; 0 of a
/// light that is not there.
VertexLightingKernel vertex_cosines_kernel(InstructionSet) noexcept;

}  // namespace tuberia
