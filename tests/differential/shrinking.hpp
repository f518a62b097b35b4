#pragma once
// Makes a scene on which the machines disagree as small and plain as it can be, and describes it.

#include <string>

#include "tests/differential/comparison.hpp"

namespace tuberia::differential {

/// The smallest scene found on which the machines still disagree.
Scene shrunk(Scene, Machines&);

std::string described(const Scene&);

/// The disagreement on the shrunk scene, and that scene; empty if the machines agree.
std::string explained(const Scene&, Machines&);

}  // namespace tuberia::differential
