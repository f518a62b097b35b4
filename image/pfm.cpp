#include "image/pfm.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "image/limits.hpp"

namespace tuberia {
namespace {

struct Header {
  int channels = 0, width = 0, height = 0;
  bool little_endian = true;
  std::size_t size_bytes = 0;
};

bool is_space(char letter) { return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r'; }

/// The next word of the header, which ends at one white space; empty at the end of the bytes.
std::string next_word(std::string_view text, std::size_t& position) {
  while (position < text.size() && is_space(text[position])) ++position;
  const std::size_t begin = position;
  while (position < text.size() && !is_space(text[position])) ++position;
  return std::string(text.substr(begin, position - begin));
}

int positive_int(const std::string& word) {
  if (word.empty() || word.size() > 9) return 0;
  for (const char digit : word) {
    if (digit < '0' || digit > '9') return 0;
  }
  return std::atoi(word.c_str());
}

Result<Header> read_header(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  Header header;
  std::size_t position = 0;
  const std::string magic = next_word(text, position);
  if (magic != "PF" && magic != "Pf") return Error{"it does not begin as a PFM file does"};
  header.channels = magic == "PF" ? 3 : 1;
  header.width = positive_int(next_word(text, position));
  header.height = positive_int(next_word(text, position));
  if (header.width == 0 || header.height == 0) return Error{"its header gives no valid width and height"};

  // The sign of the scale tells the byte order; its magnitude means nothing to us.
  const double scale = std::atof(next_word(text, position).c_str());
  if (!std::isfinite(scale) || scale == 0.0) return Error{"its header gives no valid scale"};
  header.little_endian = scale < 0.0;
  header.size_bytes = position + 1;
  return header;
}

float float_at(const std::byte* bytes, bool little_endian) {
  std::uint32_t bits = 0;
  for (int byte = 0; byte < 4; ++byte) {
    const int shift = little_endian ? 8 * byte : 24 - 8 * byte;
    bits |= std::to_integer<std::uint32_t>(bytes[byte]) << shift;
  }
  return std::bit_cast<float>(bits);
}

void append_float(std::vector<std::byte>& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<std::byte>(bits >> shift & 0xffu));
}

std::vector<std::byte> header_bytes(const char* magic, int width, int height) {
  const std::string text =
      std::string(magic) + "\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() + static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 12);
  for (const char letter : text) bytes.push_back(static_cast<std::byte>(letter));
  return bytes;
}

}  // namespace

Result<Image<Rgba32F>> decode_pfm(std::span<const std::byte> bytes) {
  const Result<Header> header = read_header(bytes);
  if (!header) return header.error();
  if (!reasonable_size(header->width, header->height)) {
    return Error{"it claims " + size_text(header->width, header->height) + " pixels, which is too large"};
  }
  const std::size_t row_bytes = static_cast<std::size_t>(header->width) * header->channels * 4;
  if (bytes.size() < header->size_bytes + row_bytes * header->height)
    return Error{"the file is truncated"};

  Image<Rgba32F> image(header->width, header->height);
  const std::byte* source = bytes.data() + header->size_bytes;
  for (int y = header->height - 1; y >= 0; --y) {
    for (Rgba32F& pixel : image.row(y)) {
      pixel.r = float_at(source, header->little_endian);
      pixel.g = header->channels == 3 ? float_at(source + 4, header->little_endian) : pixel.r;
      pixel.b = header->channels == 3 ? float_at(source + 8, header->little_endian) : pixel.r;
      source += 4 * header->channels;
    }
  }
  return image;
}

std::vector<std::byte> encode_pfm(const Image<Rgba32F>& image) {
  std::vector<std::byte> bytes = header_bytes("PF", image.width(), image.height());
  for (int y = image.height() - 1; y >= 0; --y) {
    for (const Rgba32F& pixel : image.row(y)) {
      append_float(bytes, pixel.r);
      append_float(bytes, pixel.g);
      append_float(bytes, pixel.b);
    }
  }
  return bytes;
}

std::vector<std::byte> encode_pfm(const Image<float>& image) {
  std::vector<std::byte> bytes = header_bytes("Pf", image.width(), image.height());
  for (int y = image.height() - 1; y >= 0; --y) {
    for (const float value : image.row(y)) append_float(bytes, value);
  }
  return bytes;
}

}  // namespace tuberia
