#pragma once
// What Assimp takes on trust in a file and must not; looked at before it sees the file.

#include <cstddef>
#include <span>
#include <string>

namespace tuberia {

/// What is wrong with a file of the given extension (".obj", lower case); empty if nothing was
/// found. For Collada, OBJ, OFF and PLY see collada_check.hpp and its neighbours; GLB: a length
/// beyond the end; ASCII STL: no end.
std::string why_not_model_file(std::span<const std::byte> bytes, const std::string& extension);

}  // namespace tuberia
