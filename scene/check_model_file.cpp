#include "scene/check_model_file.hpp"

#include <cstdint>
#include <string_view>

#include "scene/collada_check.hpp"
#include "scene/obj_check.hpp"
#include "scene/off_check.hpp"
#include "scene/ply_check.hpp"

namespace tuberia {
namespace {

/// Four bytes, the lowest first.
std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t position) {
  std::uint32_t word = 0;
  for (int i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(bytes[position + i]) << (8 * i);
  return word;
}

/// The header's words: magic, version, length. Version 1 is left to Assimp: files that all readers
/// accept claim a few bytes more than they have.
std::string why_not_glb(std::span<const std::byte> bytes) {
  if (bytes.size() < 12) return "it is truncated: shorter than its header";
  const std::uint32_t version = word_at(bytes, 4), length = word_at(bytes, 8);
  if (version < 2 || length <= bytes.size()) return {};
  return "it is truncated: " + std::to_string(length) + " bytes claimed, " +
         std::to_string(bytes.size()) + " there";
}

/// ASCII STL ends with "endsolid"; a file that breaks off would make Assimp lose memory. Binary
/// STL is told by its size, for its text may begin with "solid" too.
std::string why_not_stl(std::span<const std::byte> bytes, std::string_view text) {
  constexpr std::size_t kHeaderBytes = 84, kFacetBytes = 50;
  const bool binary = bytes.size() >= kHeaderBytes &&
                      bytes.size() - kHeaderBytes == kFacetBytes * std::size_t{word_at(bytes, 80)};
  if (binary) return {};
  if (!text.starts_with("solid") || text.find("endsolid") != std::string_view::npos) return {};
  return "it is truncated: it does not end with 'endsolid'";
}

}  // namespace

std::string why_not_model_file(std::span<const std::byte> bytes, const std::string& extension) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (extension == ".obj") return why_not_obj(text);
  if (extension == ".off") return why_not_off(text);
  if (extension == ".ply" || text.starts_with("ply\n") || text.starts_with("ply\r"))
    return why_not_ply(text);
  if (extension == ".stl") return why_not_stl(bytes, text);
  if (extension == ".dae") return why_not_collada(text);
  if (extension == ".glb" || text.starts_with("glTF")) return why_not_glb(bytes);
  return {};
}

}  // namespace tuberia
