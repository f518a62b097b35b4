#pragma once
// Environment maps from image files.

#include <array>
#include <filesystem>
#include <string_view>

#include "base/result.hpp"
#include "scene/environment/surroundings.hpp"

namespace tuberia {

/// "+x" to "-z" of a face 0..5.
std::string_view cube_face_name(int face) noexcept;

/// Error naming the first texel that is infinite or not a number, row by row from the upper left:
/// filtering would spread it over every look-up nearby. `name` says which image.
Result<Nothing> check_finite(const Image<Rgba32F>& image, std::string_view name);

/// Error unless the six are squares of one size, at least one texel, and finite; it names the face.
Result<Nothing> check_cube(const CubeImages& faces);

/// The linear radiance in a file, alpha 1: as stored in .hdr and .pfm, decoded from sRGB codes in what
/// read_image reads (PNG, JPEG, ...). Errors: as of those readers, and of check_finite.
Result<Image<Rgba32F>> read_environment_image(const std::filesystem::path& path);

/// Six files: +x, -x, +y, -y, +z, -z. Errors name the face and its file; as check_cube.
Result<CubeImages> read_cube_images(const std::array<std::filesystem::path, 6>& paths);

/// The six files of a cube map in a folder, by their names without extension: px nx py ny pz nz, or
/// posx negx ..., or right left top bottom front back. Error naming the face that is missing, and if
/// several files would do for one.
Result<std::array<std::filesystem::path, 6>> find_cube_files(const std::filesystem::path& folder);

}  // namespace tuberia
