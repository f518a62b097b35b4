#pragma once
// Portable float map: a short text header, then 32-bit floats, the lowest row first.

#include <cstddef>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// The image in a PFM file's bytes, of one channel (grey, copied to r, g and b) or three; alpha 1.
/// Errors: no reason but what is wrong ("the header is not that of a PFM file").
Result<Image<Rgba32F>> decode_pfm(std::span<const std::byte> bytes);

/// Little-endian PFM. Bits are kept, those of NaN too. Alpha is not part of the format.
std::vector<std::byte> encode_pfm(const Image<Rgba32F>& image);
std::vector<std::byte> encode_pfm(const Image<float>& image);

}  // namespace tuberia
