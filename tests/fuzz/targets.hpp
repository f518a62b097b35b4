#pragma once
// What the fuzzers try: any bytes at all. Each function says in a sentence what is wrong, or nothing; a
// crash, a sanitizer's complaint or an exception says it, too.

#include <cstdint>
#include <span>
#include <string>

namespace tuberia::fuzz {

using Input = std::span<const std::uint8_t>;

/// A target's format, a draw's whole state, its vertices, textures and coordinates. Nothing outside
/// viewport and scissor may change, a refused draw changes nothing, every instruction set and number of
/// threads gives the same bits, and the triangles alone cover what the rational witness says.
std::string try_raster(Input);

/// A file; the first byte chooses its extension. What is read must be drawable; scenes, that they are written
/// as they were read.
std::string try_files(Input);

/// The command line of a drawing command, one argument a line. What is accepted must be drawable.
std::string try_options(Input);

}  // namespace tuberia::fuzz
