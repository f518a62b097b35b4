#pragma once
// PPM and PGM: a short text header, then codes, the upper row first.

#include <cstddef>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// Whether the bytes begin as a binary PPM (P6) or PGM (P5) does.
bool is_pnm(std::span<const std::byte> bytes) noexcept;

/// The image in a binary PPM's or PGM's bytes, codes scaled to 0..255 if the file's largest is
/// another; alpha 255. Our own decoder, since the one of stb 2.27 reads past its memory if the
/// codes have 16 bits.
/// Errors: no name but what is wrong ("the file is truncated").
Result<Image<Rgba8>> decode_pnm(std::span<const std::byte> bytes);

/// Binary PPM, largest code 255. Alpha is not part of the format.
std::vector<std::byte> encode_ppm(const Image<Rgba8>& image);

}  // namespace tuberia
