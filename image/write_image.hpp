#pragma once
// Images in memory into files, whole or not at all.

#include <cstddef>
#include <filesystem>
#include <vector>

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// Writes codes as they are, in the format of the extension: .png, .tga, .bmp (all with alpha),
/// .ppm and .jpg (quality 95) without. The target keeps its old content if anything fails.
/// Errors: an unknown extension, an empty or too large image, a missing or unwritable folder, a
/// folder as target, a full disk.
Result<Nothing> write_image(const std::filesystem::path& path, const Image<Rgba8>& image);

/// Writes linear intensities as .pfm (bits kept) or .hdr (Radiance: 8-bit mantissas, within 1 % of
/// the largest component; negative and NaN become 0, more than 1e38 becomes 1e38). Alpha is lost.
/// Errors: as above.
Result<Nothing> write_image(const std::filesystem::path& path, const Image<Rgba32F>& image);

/// Writes one channel, of depths for example, as .pfm (bits kept) or .png: 8-bit grey, 0 black and
/// 1 white, rounded to the nearest code, values outside [0, 1] clamped, NaN black.
/// Errors: as above.
Result<Nothing> write_image(const std::filesystem::path& path, const Image<float>& image);

/// The errors of writing a picture, as codes or as intensities, that can be known before it is made: an unknown extension, a
/// missing folder, a folder as target.
Result<Nothing> check_picture_path(const std::filesystem::path& path);

/// The bytes of a PNG file, for those who keep it elsewhere. The image must not be empty.
std::vector<std::byte> encode_png(const Image<Rgba8>& image);

}  // namespace tuberia
