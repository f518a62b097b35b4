#pragma once
// Stage 0, for the mesh and for what the program wants of it.

#include "base/parallel_for.hpp"
#include "base/result.hpp"
#include "pipeline/draw_call.hpp"
#include "pipeline/refusal.hpp"

namespace tuberia {

/// Exactly one kind of positions, arrays of their length, indices within them, vertices of the
/// screen on the screen.
Refusal check_mesh(const MeshView& mesh, Workers& workers);

/// A program, and lighting, that find what they read.
Refusal check_program(const DrawCall& draw);

/// A precision that the program has kernels for.
Refusal check_precision(const ProgramInterface& program, Precision precision);

}  // namespace tuberia
