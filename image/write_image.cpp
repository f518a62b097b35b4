#include "image/write_image.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "image/stb_functions.hpp"
#include <stb/stb_image_write.h>

#include "image/file.hpp"
#include "image/limits.hpp"
#include "image/pfm.hpp"
#include "image/pnm.hpp"

namespace tuberia {
namespace {

using Bytes = std::vector<std::byte>;

constexpr int kJpegQuality = 95;
constexpr float kLargestRadiance = 1e38f;  // the format's exponent ends at 2^127

Error refusal(const std::filesystem::path& path, const std::string& reason) {
  return {"cannot write image " + quoted_path(path) + ": " + reason};
}

Error unknown_extension(const std::filesystem::path& path, const char* supported) {
  const std::string extension = lower_case_extension(path);
  return refusal(path,
                 (extension.empty() ? "it has no extension" : "unknown extension '" + extension + "'") +
                     "; supported: " + supported);
}

/// stb's way of handing over what it encoded, piece by piece.
void append(void* bytes, void* data, int size) {
  const auto* begin = static_cast<const std::byte*>(data);
  auto& all = *static_cast<Bytes*>(bytes);
  all.insert(all.end(), begin, begin + size);
}

Bytes encode_hdr(const Image<Rgba32F>& image) {
  const auto representable = [](float value) {
    return value > 0.0f ? std::min(value, kLargestRadiance) : 0.0f;  // NaN compares false
  };
  Image<Rgba32F> safe = image;
  for (Rgba32F& pixel : safe.pixels()) {
    pixel = {representable(pixel.r), representable(pixel.g), representable(pixel.b), 1.0f};
  }
  Bytes bytes;
  stbi_write_hdr_to_func(append, &bytes, safe.width(), safe.height(), 4, &safe.pixels().data()->r);
  return bytes;
}

Bytes encode_grey_png(const Image<float>& image) {
  std::vector<std::uint8_t> codes;
  codes.reserve(image.pixels().size());
  for (const float value : image.pixels()) {
    const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // NaN compares false
    codes.push_back(static_cast<std::uint8_t>(std::lround(clamped * 255.0f)));
  }
  Bytes bytes;
  stbi_write_png_to_func(append, &bytes, image.width(), image.height(), 1, codes.data(), image.width());
  return bytes;
}

/// The encoded image; empty for an extension that is not ours.
Bytes encode(const Image<Rgba8>& image, const std::string& extension) {
  Bytes bytes;
  const int width = image.width(), height = image.height();
  const void* pixels = image.pixels().data();
  if (extension == ".png") stbi_write_png_to_func(append, &bytes, width, height, 4, pixels, 4 * width);
  if (extension == ".tga") stbi_write_tga_to_func(append, &bytes, width, height, 4, pixels);
  if (extension == ".bmp") stbi_write_bmp_to_func(append, &bytes, width, height, 4, pixels);
  if (extension == ".ppm") bytes = encode_ppm(image);
  if (extension == ".jpg" || extension == ".jpeg") {
    stbi_write_jpg_to_func(append, &bytes, width, height, 4, pixels, kJpegQuality);
  }
  return bytes;
}

Bytes encode(const Image<Rgba32F>& image, const std::string& extension) {
  if (extension == ".pfm") return encode_pfm(image);
  if (extension == ".hdr") return encode_hdr(image);
  return {};
}

Bytes encode(const Image<float>& image, const std::string& extension) {
  if (extension == ".pfm") return encode_pfm(image);
  if (extension == ".png") return encode_grey_png(image);
  return {};
}

/// What all formats share. supported: the extensions, for the error.
template <class Pixel>
Result<Nothing> encode_and_write(const std::filesystem::path& path, const Image<Pixel>& image,
                                 const char* supported) {
  if (image.empty()) return refusal(path, "the image has no pixels");
  if (!reasonable_size(image.width(), image.height())) {
    return refusal(path, size_text(image.width(), image.height()) + " pixels are too many");
  }
  const Bytes bytes = encode(image, lower_case_extension(path));
  if (bytes.empty()) return unknown_extension(path, supported);
  return write_file(path, bytes);
}

}  // namespace

Result<Nothing> write_image(const std::filesystem::path& path, const Image<Rgba8>& image) {
  return encode_and_write(path, image, ".png, .tga, .bmp, .ppm, .jpg");
}

Result<Nothing> write_image(const std::filesystem::path& path, const Image<Rgba32F>& image) {
  return encode_and_write(path, image, ".pfm, .hdr");
}

Result<Nothing> write_image(const std::filesystem::path& path, const Image<float>& image) {
  return encode_and_write(path, image, ".pfm, .png");
}

Result<Nothing> check_picture_path(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  const bool is_known = !encode(Image<Rgba8>(1, 1), extension).empty() || !encode(Image<Rgba32F>(1, 1), extension).empty();
  return is_known ? check_writable(path) : unknown_extension(path, ".png, .tga, .bmp, .ppm, .jpg, .pfm, .hdr");
}

std::vector<std::byte> encode_png(const Image<Rgba8>& image) { return encode(image, ".png"); }

}  // namespace tuberia
