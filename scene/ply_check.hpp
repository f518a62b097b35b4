#pragma once
// A look at a PLY file before Assimp reads it, which trusts its counts and fills up what is missing.

#include <string>
#include <string_view>

namespace tuberia {

/// What is wrong with a PLY file's bytes, ASCII or binary; empty if nothing was found: a header
/// that breaks off, counts that the size makes impossible, elements that break off.
std::string why_not_ply(std::string_view bytes);

}  // namespace tuberia
