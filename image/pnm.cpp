#include "image/pnm.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "image/limits.hpp"

namespace tuberia {
namespace {

constexpr int kLargestNumber = 99'999'999;

char letter_at(std::span<const std::byte> bytes, std::size_t position) {
  return position < bytes.size() ? static_cast<char>(bytes[position]) : '\0';
}

bool is_space(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

/// The header's next number, after white space and comments; 0 if there is none.
int next_number(std::span<const std::byte> bytes, std::size_t& position) {
  while (is_space(letter_at(bytes, position)) || letter_at(bytes, position) == '#') {
    if (letter_at(bytes, position) == '#') {
      while (position < bytes.size() && letter_at(bytes, position) != '\n') ++position;
    }
    ++position;
  }
  int number = 0;
  for (; letter_at(bytes, position) >= '0' && letter_at(bytes, position) <= '9'; ++position) {
    number = std::min(10 * number + (letter_at(bytes, position) - '0'), kLargestNumber);
  }
  return number;
}

struct CodeFormat {
  int largest = 255;
  int bytes = 1;
};

std::uint8_t code_at(const std::byte* source, CodeFormat format) {
  int code = std::to_integer<int>(source[0]);
  if (format.bytes == 2) code = 256 * code + std::to_integer<int>(source[1]);
  if (format.largest == 255) return static_cast<std::uint8_t>(code);
  const int scaled = (2 * 255 * code + format.largest) / (2 * format.largest);
  return static_cast<std::uint8_t>(std::min(scaled, 255));
}

}  // namespace

bool is_pnm(std::span<const std::byte> bytes) noexcept {
  return letter_at(bytes, 0) == 'P' && (letter_at(bytes, 1) == '5' || letter_at(bytes, 1) == '6');
}

Result<Image<Rgba8>> decode_pnm(std::span<const std::byte> bytes) {
  if (!is_pnm(bytes)) return Error{"it does not begin as a PPM or PGM file does"};
  const int channels = letter_at(bytes, 1) == '6' ? 3 : 1;
  std::size_t position = 2;
  const int width = next_number(bytes, position);
  const int height = next_number(bytes, position);
  const int largest = next_number(bytes, position);
  if (width == 0 || height == 0 || largest == 0 || largest > 65535) {
    return Error{"its header gives no valid width, height and largest code"};
  }
  if (!reasonable_size(width, height)) {
    return Error{"it claims " + size_text(width, height) + " pixels, which is too large"};
  }

  // One white space ends the header.
  ++position;
  const CodeFormat format{.largest = largest, .bytes = largest > 255 ? 2 : 1};
  const std::size_t pixel_bytes = static_cast<std::size_t>(channels) * format.bytes;
  const std::size_t image_bytes =
      pixel_bytes * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (bytes.size() < position + image_bytes) {
    return Error{"it claims " + size_text(width, height) + " pixels, but the file is truncated"};
  }
  Image<Rgba8> image(width, height);
  const std::byte* source = bytes.data() + position;
  for (Rgba8& pixel : image.pixels()) {
    pixel.r = code_at(source, format);
    pixel.g = channels == 3 ? code_at(source + format.bytes, format) : pixel.r;
    pixel.b = channels == 3 ? code_at(source + 2 * format.bytes, format) : pixel.r;
    source += pixel_bytes;
  }
  return image;
}

std::vector<std::byte> encode_ppm(const Image<Rgba8>& image) {
  const std::string header =
      "P6\n" + std::to_string(image.width()) + " " + std::to_string(image.height()) + "\n255\n";
  std::vector<std::byte> bytes;
  bytes.reserve(header.size() + 3 * image.pixels().size());
  for (const char letter : header) bytes.push_back(static_cast<std::byte>(letter));
  for (const Rgba8& pixel : image.pixels()) {
    for (const std::uint8_t code : {pixel.r, pixel.g, pixel.b})
      bytes.push_back(static_cast<std::byte>(code));
  }
  return bytes;
}

}  // namespace tuberia
