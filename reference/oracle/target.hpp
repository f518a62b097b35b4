#pragma once
// What the oracle draws to: for each sample a colour, a depth code and a stencil code.

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "reference/oracle/state.hpp"

namespace tuberia::oracle {

/// A sample's contents. Colours are bounds of what is stored: codes 0..255 in 8-bit formats,
/// numbers in float formats; apart only where the value lies too near to a tie.
struct Sample {
  std::array<Interval, 4> colour;
  std::int32_t depth = 0;
  std::uint8_t stencil = 0;
  bool is_uncertain = false;  // whether a fragment was drawn here hung on a tie: anything may be stored
};

/// A clear of part of a target: what is absent stays, and so do masked channels and bits.
struct Clear {
  std::optional<glm::vec4> colour;
  std::optional<float> depth;
  std::optional<std::uint8_t> stencil;
  std::optional<Rectangle> scissor;
  std::array<bool, 4> mask{true, true, true, true};
  std::uint8_t stencil_write_mask = 0xff;
};

struct Target {
  Target(int target_width, int target_height, int samples_per_pixel, ColourFormat colour, DepthFormat depth);

  int width, height, samples;
  ColourFormat colour_format;
  DepthFormat depth_format;
  std::vector<Sample> contents;  // row by row, the samples of a pixel together

  Sample& at(int x, int y, int sample) {
    return contents[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                        static_cast<std::size_t>(samples) + static_cast<std::size_t>(sample)];
  }
  void clear(const glm::vec4& colour, float depth, std::uint8_t stencil);
  void clear(const Clear&);
  /// One pixel of the image that a multisampled target resolves to; depth and stencil of sample 0.
  Sample resolved(int x, int y);
};

/// Offset of a sample from the pixel's centre, in 1/256 pixel.
struct SampleOffset {
  int x = 0, y = 0;
};
SampleOffset sample_offset(int samples, int sample);

std::int32_t depth_code(float depth, DepthFormat format);

/// What channel 0..3 of a format stores for a linear number, and back.
Interval stored(Interval linear, int channel, ColourFormat format);
Interval linear(Interval stored, int channel, ColourFormat format);
constexpr bool is_8_bit(ColourFormat format) { return format == ColourFormat::rgba8 || format == ColourFormat::srgb8; }

}  // namespace tuberia::oracle
