#include "scene/find_texture.hpp"

#include <algorithm>
#include <system_error>

namespace tuberia {
namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string text) {
  for (char& letter : text) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return text;
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// The entry of a folder that has this name, in this case or in another.
std::optional<fs::path> entry_of(const fs::path& folder, const std::string& name) {
  if (is_there(folder / name)) return folder / name;
  std::optional<fs::path> found;
  std::error_code code;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, code), end; !code && entry != end;
       entry.increment(code)) {
    const std::string candidate = entry->path().filename().string();
    if (lower_case(candidate) != lower_case(name)) continue;
    if (!found || candidate < found->filename().string()) found = folder / candidate;
  }
  return found;
}

std::optional<fs::path> file_at(const fs::path& folder, const fs::path& relative) {
  fs::path place = folder;
  for (const fs::path& part : relative) {
    if (part.empty() || part == ".") continue;
    const std::optional<fs::path> next = part == ".." ? place / part : entry_of(place, part.string());
    if (!next) return std::nullopt;
    place = *next;
  }
  std::error_code ignored;
  if (!fs::is_regular_file(place, ignored)) return std::nullopt;
  return place;
}

int hexadecimal(char letter) {
  if (letter >= '0' && letter <= '9') return letter - '0';
  if (letter >= 'a' && letter <= 'f') return letter - 'a' + 10;
  return letter >= 'A' && letter <= 'F' ? letter - 'A' + 10 : -1;
}

/// "%20" and the like, which the URIs of glTF and Collada have for unusual letters.
std::string percent_decoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size() && hexadecimal(text[i + 1]) > 0 &&
                        hexadecimal(text[i + 2]) >= 0;
    decoded +=
        escape ? static_cast<char>(16 * hexadecimal(text[i + 1]) + hexadecimal(text[i + 2])) : text[i];
    if (escape) i += 2;
  }
  return decoded;
}

}  // namespace

std::optional<fs::path> find_beside_model(const fs::path& folder, const std::string& name) {
  for (std::string spelling : {name, percent_decoded(name)}) {
    if (spelling.find('\0') != std::string::npos) continue;
    std::replace(spelling.begin(), spelling.end(), '\\', '/');
    if (spelling.starts_with("file://")) spelling.erase(0, 7);
    const fs::path path(spelling);
    if (const auto found = file_at(path.is_absolute() ? "/" : folder, path.relative_path())) return found;
    if (const auto found = file_at(folder, path.filename())) return found;
  }
  return std::nullopt;
}

ModelTexture missing_texture(const std::string& name) {
  constexpr int kSidePixels = 64, kCellPixels = 8;
  ModelTexture texture{
      .name = name, .image = Image<Rgba8>(kSidePixels, kSidePixels, {0, 0, 0, 255}), .missing = true};
  for (int y = 0; y < kSidePixels; ++y) {
    for (int x = 0; x < kSidePixels; ++x) {
      if ((x / kCellPixels + y / kCellPixels) % 2 == 0) texture.image.at(x, y) = {255, 0, 255, 255};
    }
  }
  return texture;
}

}  // namespace tuberia
