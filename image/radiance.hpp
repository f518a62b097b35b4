#pragma once
// The Radiance .hdr format: a text header, then rows of three mantissas and a shared exponent.

#include <cstddef>
#include <span>

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// Whether the bytes begin as a Radiance file does.
bool is_radiance(std::span<const std::byte> bytes) noexcept;

/// The linear intensities in a Radiance file's bytes, flat or run-length encoded; alpha 1.
/// Our own decoder, since the one of stb 2.27 never ends on a truncated file.
/// Errors: no name but what is wrong ("the file is truncated").
Result<Image<Rgba32F>> decode_radiance(std::span<const std::byte> bytes);

}  // namespace tuberia
