#include "image/read_image.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "image/stb_functions.hpp"
#include <stb/stb_image.h>

#include "image/file.hpp"
#include "image/jpeg_check.hpp"
#include "image/limits.hpp"
#include "image/pfm.hpp"
#include "image/pnm.hpp"
#include "image/radiance.hpp"

namespace tuberia {
namespace {

// No format here packs more pixels into a byte (a progressive JPEG's first scan comes nearest,
// with 256 pixels a bit), so a header that claims more is corrupt: refused before the memory is
// asked for.
constexpr std::int64_t kMostPixelsPerByte = 16384;

/// Bytes in memory as stb reads them. stb answers reads past the end with zeros, so that the lower
/// part of a truncated JPEG, TGA or BMP would be grey or noise; we remember that it asked.
struct Source {
  std::span<const std::byte> bytes;
  std::size_t position = 0;
  char* refill_buffer = nullptr;  // where stb asks for a whole buffer ahead of its needs
  bool read_past_end = false;
};

int read_bytes(void* user, char* destination, int size) {
  auto& source = *static_cast<Source*>(user);
  const std::size_t wanted = static_cast<std::size_t>(size);
  const std::size_t given = std::min(wanted, source.bytes.size() - source.position);
  if (given > 0) std::memcpy(destination, source.bytes.data() + source.position, given);
  std::memset(destination + given, 0, wanted - given);
  source.position += given;

  // The first read of all, and later ones to the same place, only look ahead: for them, it is past
  // the end only when not a single byte is left.
  if (source.refill_buffer == nullptr) source.refill_buffer = destination;
  const bool looks_ahead = destination == source.refill_buffer;
  if (given == 0 || (given < wanted && !looks_ahead)) source.read_past_end = true;
  return static_cast<int>(given);
}

void skip_bytes(void* user, int count) {
  auto& source = *static_cast<Source*>(user);
  const auto left = static_cast<std::int64_t>(source.bytes.size() - source.position);
  const auto back = -static_cast<std::int64_t>(source.position);
  source.position += static_cast<std::size_t>(std::clamp<std::int64_t>(count, back, left));
}

int at_end(void* user) {
  const auto& source = *static_cast<const Source*>(user);
  return source.position >= source.bytes.size();
}

constexpr stbi_io_callbacks kCallbacks{read_bytes, skip_bytes, at_end};

struct FreeStb {
  void operator()(void* pixels) const noexcept { stbi_image_free(pixels); }
};

Error refusal(const std::string& name, const std::string& reason) {
  return {"cannot read image " + name + ": " + reason};
}

std::string stb_reason() {
  const char* reason = stbi_failure_reason();
  if (reason == nullptr) return "corrupt image";
  return std::strcmp(reason, "Image not of any known type, or corrupt") == 0 ? "unknown image format"
                                                                             : reason;
}

/// What speaks against an image that claims these sides; empty if nothing.
std::string why_not_size(int width, int height, std::size_t size_bytes) {
  if (!reasonable_size(width, height)) {
    return "it claims " + size_text(width, height) + " pixels, which is too large";
  }
  const std::int64_t pixels = std::int64_t{width} * height;
  if (pixels > kMostPixelsPerByte * static_cast<std::int64_t>(size_bytes)) {
    return "it claims " + size_text(width, height) + " pixels in " + std::to_string(size_bytes) +
           " bytes: truncated or corrupt";
  }
  return {};
}

Result<Image<Rgba8>> decode_with_stb(std::span<const std::byte> bytes, const std::string& name) {
  if (!jpeg_tables_fit(bytes)) return refusal(name, "a Huffman table of the JPEG is corrupt");
  int width = 0, height = 0, channels = 0;
  Source header{.bytes = bytes};
  if (stbi_info_from_callbacks(&kCallbacks, &header, &width, &height, &channels) == 0) {
    return refusal(name, stb_reason());
  }
  if (const std::string reason = why_not_size(width, height, bytes.size()); !reason.empty()) {
    return refusal(name, reason);
  }

  Source source{.bytes = bytes};
  const std::unique_ptr<stbi_uc, FreeStb> codes(
      stbi_load_from_callbacks(&kCallbacks, &source, &width, &height, &channels, STBI_rgb_alpha));
  if (source.read_past_end) return refusal(name, "the file is truncated");
  if (!codes) return refusal(name, stb_reason());
  static_assert(sizeof(Rgba8) == 4);
  Image<Rgba8> image(width, height);
  std::memcpy(image.pixels().data(), codes.get(), image.pixels().size_bytes());
  return image;
}

}  // namespace

Result<Image<Rgba8>> decode_image(std::span<const std::byte> bytes, std::string_view name) {
  const std::string quoted_name = quoted_path(std::filesystem::path(name));
  if (bytes.empty()) return refusal(quoted_name, "it is empty");
  if (is_pnm(bytes)) {
    Result<Image<Rgba8>> image = decode_pnm(bytes);
    return image ? std::move(image) : refusal(quoted_name, image.error().message);
  }
  return decode_with_stb(bytes, quoted_name);
}

Result<Image<Rgba8>> read_image(const std::filesystem::path& path) {
  const Result<std::vector<std::byte>> bytes = read_file(path);
  if (!bytes) return bytes.error();
  return decode_image(*bytes, path.string());
}

Result<Image<Rgba32F>> read_float_image(const std::filesystem::path& path) {
  const Result<std::vector<std::byte>> bytes = read_file(path);
  if (!bytes) return bytes.error();

  const bool begins_as_pfm = bytes->size() >= 2 && (*bytes)[0] == std::byte{'P'} &&
                             ((*bytes)[1] == std::byte{'F'} || (*bytes)[1] == std::byte{'f'});
  if (!begins_as_pfm && !is_radiance(*bytes)) {
    // 8-bit codes are no intensities; to decode them is for the caller, who knows their curve.
    return refusal(quoted_path(path), "it is neither a Radiance .hdr nor a .pfm file");
  }
  Result<Image<Rgba32F>> image = begins_as_pfm ? decode_pfm(*bytes) : decode_radiance(*bytes);
  return image ? std::move(image) : refusal(quoted_path(path), image.error().message);
}

}  // namespace tuberia
