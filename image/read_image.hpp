#pragma once
// Image files into memory.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// The image in a PNG, JPEG, TGA, BMP, PPM or PGM file (told by its content, not its name), codes
/// as stored; grey becomes r = g = b, a missing alpha 255, 16-bit codes are cut to 8.
/// Errors: the file is missing, a folder, empty, of an unknown format, truncated, corrupt, or
/// claims more than 32768 pixels a side or 2^28 in all.
Result<Image<Rgba8>> read_image(const std::filesystem::path& path);

/// The same for a file that lies in memory; `name` names it in an error.
Result<Image<Rgba8>> decode_image(std::span<const std::byte> bytes, std::string_view name);

/// The linear intensities of a Radiance .hdr or a .pfm file (told by its content); alpha 1.
/// Errors: as read_image.
Result<Image<Rgba32F>> read_float_image(const std::filesystem::path& path);

}  // namespace tuberia
