#include "examples/tuberia/embedded_image.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

#include "image/write_image.hpp"

namespace tuberia::cli {
namespace {

std::string base64(std::span<const std::byte> bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string digits;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) digits += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63u];
  }
  return digits;
}

}  // namespace

std::string data_url(const Image<Rgba8>& image) { return "data:image/png;base64," + base64(encode_png(image)); }

}  // namespace tuberia::cli
