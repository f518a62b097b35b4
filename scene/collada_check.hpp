#pragma once
// A look at a Collada file before Assimp reads it, which trusts the counts of its arrays.

#include <string>
#include <string_view>

namespace tuberia {

/// What is wrong with a Collada file's text; empty if nothing was found: lists of indices with
/// other letters than digits (Assimp would never end), arrays without a count, and accessors that
/// reach beyond their array (Assimp would read past its memory). Says nothing about UTF-16.
std::string why_not_collada(std::string_view text);

}  // namespace tuberia
