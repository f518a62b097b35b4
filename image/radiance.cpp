#include "image/radiance.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "image/limits.hpp"

namespace tuberia {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr std::string_view kMagics[] = {"#?RADIANCE", "#?RGBE"};

/// Reads on through the bytes; after the end it gives zeros and says so.
struct Reader {
  std::span<const std::byte> bytes;
  std::size_t position = 0;
  bool past_end = false;

  std::uint8_t next() {
    if (position < bytes.size()) return std::to_integer<std::uint8_t>(bytes[position++]);
    past_end = true;
    return 0;
  }

  std::string_view line() {
    const std::size_t begin = position;
    while (position < bytes.size() && bytes[position] != std::byte{'\n'}) ++position;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()) + begin, position - begin);
    next();  // the line's end
    return text;
  }
};

/// The number after a prefix such as "-Y "; 0 if it is missing or not a number of up to 6 digits.
int number_after(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return 0;
  text.remove_prefix(prefix.size());
  int number = 0, digits = 0;
  for (; !text.empty() && text[0] >= '0' && text[0] <= '9' && digits < 6; ++digits) {
    number = 10 * number + (text[0] - '0');
    text.remove_prefix(1);
  }
  return number;
}

float intensity(std::uint8_t mantissa, std::uint8_t exponent) {
  return exponent == 0 ? 0.0f : std::ldexp(static_cast<float>(mantissa), int{exponent} - (128 + 8));
}

/// One component of a run-length encoded row: counts above 128 repeat a byte, others copy bytes.
bool read_component(Reader& reader, std::vector<Rgbe>& row, int component) {
  for (std::size_t x = 0; x < row.size();) {
    const std::uint8_t count = reader.next();
    const bool repeats = count > 128;
    const std::size_t length = repeats ? count - 128u : count;
    if (length == 0 || length > row.size() - x) return false;
    std::uint8_t value = repeats ? reader.next() : std::uint8_t{0};
    for (const std::size_t end = x + length; x < end; ++x) {
      if (!repeats) value = reader.next();
      row[x][component] = value;
    }
  }
  return true;
}

/// One row, of either encoding; false if it is corrupt.
bool read_row(Reader& reader, std::vector<Rgbe>& row) {
  Rgbe first;
  for (std::uint8_t& byte : first) byte = reader.next();
  const std::size_t encoded_width = first[2] * 256u + first[3];
  const bool run_length_encoded = first[0] == 2 && first[1] == 2 && first[2] < 128 && row.size() >= 8;
  if (run_length_encoded) {
    if (encoded_width != row.size()) return false;
    for (int component = 0; component < 4; ++component) {
      if (!read_component(reader, row, component)) return false;
    }
    return true;
  }

  row[0] = first;
  for (std::size_t x = 1; x < row.size(); ++x) {
    for (std::uint8_t& byte : row[x]) byte = reader.next();
  }
  return true;
}

/// Reads the header to the first pixel; an image of the right size, still black.
Result<Image<Rgba32F>> read_header(Reader& reader) {
  reader.line();
  for (std::string_view line = reader.line(); !line.empty() && line != "\r"; line = reader.line()) {
    if (line.starts_with("FORMAT=") && !line.starts_with("FORMAT=32-bit_rle_rgbe")) {
      return Error{"its pixels are not in the format 32-bit_rle_rgbe"};
    }
  }
  std::string_view size = reader.line();
  if (reader.past_end) return Error{"the file is truncated"};
  const int height = number_after(size, "-Y ");
  const int width = number_after(size, " +X ");
  if (width == 0 || height == 0)
    return Error{"its header gives no valid size of the form -Y height +X width"};
  if (!reasonable_size(width, height)) {
    return Error{"it claims " + size_text(width, height) + " pixels, which is too large"};
  }
  // Four components in runs of at most 127 pixels, each of two bytes.
  const std::uint64_t least_bytes =
      std::uint64_t(height) * (8 * (static_cast<std::uint64_t>(width) / 128));
  if (reader.bytes.size() < least_bytes) return Error{"the file is truncated"};
  return Image<Rgba32F>(width, height);
}

}  // namespace

bool is_radiance(std::span<const std::byte> bytes) noexcept {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.starts_with(kMagics[0]) || text.starts_with(kMagics[1]);
}

Result<Image<Rgba32F>> decode_radiance(std::span<const std::byte> bytes) {
  if (!is_radiance(bytes)) return Error{"it does not begin as a Radiance file does"};
  Reader reader{.bytes = bytes};
  Result<Image<Rgba32F>> image = read_header(reader);
  if (!image) return image;

  std::vector<Rgbe> row(static_cast<std::size_t>(image->width()));
  for (int y = 0; y < image->height(); ++y) {
    const bool valid = read_row(reader, row);
    if (reader.past_end) return Error{"the file is truncated"};
    if (!valid) return Error{"row " + std::to_string(y) + " is corrupt"};
    for (int x = 0; x < image->width(); ++x) {
      const auto [r, g, b, exponent] = row[x];
      image->at(x, y) = {intensity(r, exponent), intensity(g, exponent), intensity(b, exponent), 1.0f};
    }
  }
  return image;
}

}  // namespace tuberia
