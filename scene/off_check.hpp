#pragma once
// A look at an OFF file before Assimp reads it, which trusts its counts and bends bad indices.

#include <string>
#include <string_view>

namespace tuberia {

/// What is wrong with an OFF file's text; empty if nothing was found: counts that the size makes
/// impossible, missing lines, faces that break off, indices out of range. Says nothing about
/// binary OFF.
std::string why_not_off(std::string_view text);

}  // namespace tuberia
