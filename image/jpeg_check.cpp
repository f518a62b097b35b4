#include "image/jpeg_check.hpp"

#include <cstdint>

namespace tuberia {
namespace {

constexpr int kHuffmanTables = 0xc4, kStartOfImage = 0xd8, kEndOfImage = 0xd9, kTemporary = 0x01;
constexpr std::size_t kMostCodes = 256;

/// The byte at a position; 0 past the end.
int byte_at(std::span<const std::byte> bytes, std::size_t position) {
  return position < bytes.size() ? std::to_integer<int>(bytes[position]) : 0;
}

/// Whether every table of one DHT segment fits: a class byte, 16 counts of codes, then the codes.
bool tables_fit(std::span<const std::byte> bytes, std::size_t position, std::size_t end) {
  while (position < end) {
    std::size_t codes = 0;
    for (std::size_t length = 1; length <= 16; ++length) codes += byte_at(bytes, position + length);
    if (codes > kMostCodes) return false;
    position += 17 + codes;
  }
  return true;
}

/// Markers without a length: stuffed zeros and restarts inside the coded data among them.
bool stands_alone(int marker) {
  const bool restart = marker >= 0xd0 && marker <= 0xd7;
  return marker == 0 || marker == kTemporary || marker == kStartOfImage || restart;
}

}  // namespace

bool jpeg_tables_fit(std::span<const std::byte> bytes) noexcept {
  if (byte_at(bytes, 0) != 0xff || byte_at(bytes, 1) != kStartOfImage) return true;
  std::size_t position = 2;
  while (position < bytes.size()) {
    // The next marker: 0xff, repeated at will, and one other byte.
    while (position < bytes.size() && byte_at(bytes, position) != 0xff) ++position;
    while (position < bytes.size() && byte_at(bytes, position) == 0xff) ++position;
    const int marker = byte_at(bytes, position++);
    if (marker == kEndOfImage) return true;
    if (stands_alone(marker)) continue;

    const std::size_t length = 256u * byte_at(bytes, position) + byte_at(bytes, position + 1);
    if (marker == kHuffmanTables && !tables_fit(bytes, position + 2, position + length)) return false;
    position += length < 2 ? 2 : length;
  }
  return true;
}

}  // namespace tuberia
