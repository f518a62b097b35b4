#include "scene/environment/read_environment.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "image/file.hpp"
#include "image/read_image.hpp"
#include "math/colour.hpp"

namespace tuberia {
namespace {

using FaceNames = std::array<std::string_view, 6>;

constexpr FaceNames kNamings[] = {{"px", "nx", "py", "ny", "pz", "nz"},
                                  {"posx", "negx", "posy", "negy", "posz", "negz"},
                                  {"right", "left", "top", "bottom", "front", "back"}};

std::string size_of(const Image<Rgba32F>& image) { return std::to_string(image.width()) + " x " + std::to_string(image.height()); }

Error refused_face(int face, const std::string& reason) { return {"face " + std::string(cube_face_name(face)) + ": " + reason}; }

Image<Rgba32F> decoded(const Image<Rgba8>& codes) {
  const auto& linear = linear_from_srgb_codes();
  Image<Rgba32F> image(codes.width(), codes.height());
  std::transform(codes.pixels().begin(), codes.pixels().end(), image.pixels().begin(),
                 [&](const Rgba8& code) { return Rgba32F{linear[code.r], linear[code.g], linear[code.b], 1}; });
  return image;
}

bool holds_floats(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".hdr" || extension == ".pfm";
}

/// The files of a folder whose names, but for the extension, are `stem`.
std::vector<std::filesystem::path> files_named(const std::vector<std::filesystem::path>& files, std::string_view stem) {
  std::vector<std::filesystem::path> found;
  std::copy_if(files.begin(), files.end(), std::back_inserter(found), [&](const std::filesystem::path& file) { return file.stem() == stem; });
  return found;
}

Result<std::vector<std::filesystem::path>> files_in(const std::filesystem::path& folder) {
  std::error_code failure;
  std::vector<std::filesystem::path> files;
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
    if (std::error_code ignored; entry->is_regular_file(ignored)) files.push_back(entry->path());
  if (failure) return Error{"cannot read folder " + quoted_path(folder) + ": " + failure.message()};
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::string_view cube_face_name(int face) noexcept {
  constexpr std::string_view kNames[6] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  return kNames[std::clamp(face, 0, 5)];
}

Result<Nothing> check_finite(const Image<Rgba32F>& image, std::string_view name) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Rgba32F& texel = image.at(x, y);
      const std::pair<char, float> channels[] = {{'r', texel.r}, {'g', texel.g}, {'b', texel.b}};
      for (const auto& [channel, value] : channels)
        if (!std::isfinite(value))
          return Error{std::string(name) + ": texel (" + std::to_string(x) + ", " + std::to_string(y) + ") has " + channel + " = " +
                       (std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf") + ", which no filter can mix"};
    }
  return Nothing{};
}

Result<Nothing> check_cube(const CubeImages& faces) {
  for (int i = 0; i < 6; ++i) {
    const Image<Rgba32F>& face = faces[static_cast<std::size_t>(i)];
    if (face.empty()) return refused_face(i, "it is missing");
    if (face.width() != face.height()) return refused_face(i, "it has " + size_of(face) + " texels, but faces of a cube are square");
    if (face.width() != faces[0].width()) return refused_face(i, "it has " + size_of(face) + " texels, but face +x has " + size_of(faces[0]));
    if (auto finite = check_finite(face, "face " + std::string(cube_face_name(i))); !finite) return finite.error();
  }
  return Nothing{};
}

Result<Image<Rgba32F>> read_environment_image(const std::filesystem::path& path) {
  Result<Image<Rgba32F>> image = [&]() -> Result<Image<Rgba32F>> {
    if (holds_floats(path)) return read_float_image(path);
    Result<Image<Rgba8>> codes = read_image(path);
    if (!codes) return codes.error();
    return decoded(*codes);
  }();
  if (!image) return image;
  if (auto finite = check_finite(*image, "image " + quoted_path(path)); !finite) return finite.error();
  return image;
}

Result<CubeImages> read_cube_images(const std::array<std::filesystem::path, 6>& paths) {
  CubeImages faces;
  for (int i = 0; i < 6; ++i) {
    const auto number = static_cast<std::size_t>(i);
    Result<Image<Rgba32F>> face = read_environment_image(paths[number]);
    if (!face) return refused_face(i, face.error().message);
    faces[number] = std::move(*face);
  }
  if (auto checked = check_cube(faces); !checked) return checked.error();
  return faces;
}

Result<std::array<std::filesystem::path, 6>> find_cube_files(const std::filesystem::path& folder) {
  const auto files = files_in(folder);
  if (!files) return files.error();
  // The naming that most files follow: so one missing face is told from another naming.
  const auto faces_present = [&](const FaceNames& naming) {
    return std::count_if(naming.begin(), naming.end(), [&](std::string_view name) { return !files_named(*files, name).empty(); });
  };
  const FaceNames& naming = *std::max_element(std::begin(kNamings), std::end(kNamings),
                                              [&](const FaceNames& a, const FaceNames& b) { return faces_present(a) < faces_present(b); });
  std::array<std::filesystem::path, 6> paths;
  for (int i = 0; i < 6; ++i) {
    const std::string_view name = naming[static_cast<std::size_t>(i)];
    const auto found = files_named(*files, name);
    if (found.empty()) return refused_face(i, "no file " + quoted_path(name) + " of any image format is in folder " + quoted_path(folder));
    if (found.size() > 1) return refused_face(i, "both " + quoted_path(found[0]) + " and " + quoted_path(found[1]) + " would do");
    paths[static_cast<std::size_t>(i)] = found.front();
  }
  return paths;
}

}  // namespace tuberia
