#pragma once
// A look at an OBJ file's lines before Assimp reads it, to name the line that is wrong.

#include <string>
#include <string_view>
#include <vector>

namespace tuberia {

/// What is wrong with an OBJ file's text; empty if nothing was found: indices of 0 or beyond the
/// model's vertices, texture coordinates or normals, vertices of fewer than three numbers, and a
/// last line that breaks off within a vertex or face. Says nothing about UTF-16.
std::string why_not_obj(std::string_view text);

/// The names in the file's mtllib lines.
std::vector<std::string> material_libraries_of_obj(std::string_view text);

}  // namespace tuberia
