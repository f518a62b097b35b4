#pragma once
// What stb 2.27 takes on trust in a JPEG and must not.

#include <cstddef>
#include <span>

namespace tuberia {

/// Whether no Huffman table of the file declares more than 256 codes, which would make stb write
/// past its own tables. True of files that are no JPEG.
bool jpeg_tables_fit(std::span<const std::byte> bytes) noexcept;

}  // namespace tuberia
