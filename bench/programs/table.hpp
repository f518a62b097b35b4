#pragma once
// The programs whose fragments are timed, and the techniques that the surface program combines.

#include <functional>
#include <string>
#include <vector>

#include "pipeline/fragment_program.hpp"
#include "pipeline/programs/surface.hpp"
#include "pipeline/state.hpp"

namespace tuberia::bench {

/// One that stands alone, with the vertex lighting or cosines that it may need.
struct NamedProgram {
  std::string name;
  FragmentProgram program;
  TransformState transform{};
};

/// A change to the surface program's uniforms: what it adds is its increment.
struct Technique {
  std::string name;
  std::function<void(SurfaceUniforms&)> add;
};

/// Techniques together, by name.
struct Combination {
  std::vector<std::string> techniques;
};

/// Every program but surface; flat, which all are compared with, comes first.
std::vector<NamedProgram> named_programs();

/// The surface that techniques are added to: Lambert's, one directional light.
SurfaceUniforms base_surface();

std::vector<Technique> techniques();
std::vector<Combination> combinations();

/// The base with these techniques.
SurfaceUniforms surface_with(const std::vector<std::string>& names);

/// "bump + environment cube".
std::string name_of(const Combination& combination);

}  // namespace tuberia::bench
