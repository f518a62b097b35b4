#include "raster/render_target.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "math/colour.hpp"
#include "raster/half_float.hpp"

namespace tuberia {
namespace {

std::uint32_t codes_of(const Rgba32F& c, ColourFormat format) {
  const auto code = [&](float x) -> std::uint32_t {
    return format == ColourFormat::srgb8 ? srgb_code_from_linear(static_cast<double>(x)) : unorm8_from_linear(x);
  };
  return code(c.r) | code(c.g) << 8 | code(c.b) << 16 | static_cast<std::uint32_t>(unorm8_from_linear(c.a)) << 24;
}

/// Calls visit(index, count) for runs of pixels of a tile, 0..kTilePixels-1, that lie in a rectangle
/// of the target: one run when all of them do.
template <class Visit>
void for_each_run(const Tile& tile, const PixelRect& rectangle, Visit&& visit) {
  const PixelRect part = intersection(rectangle, {tile.left, tile.top, tile.left + kTileSize, tile.top + kTileSize});
  if (part.empty()) return;
  if (part.right - part.left == kTileSize && part.bottom - part.top == kTileSize) return visit(0, kTilePixels);
  for (int y = part.top; y < part.bottom; ++y)
    for (int x = part.left; x < part.right; ++x) visit(index_in_tile(x - tile.left, y - tile.top), 1);
}

/// One value in each of the four planes of a block's pixels.
template <class Channel>
void fill_planes(Channel* colours, const Channel (&value)[4], const bool (&mask)[4], int index, int count) {
  const int run = std::min(count, kBlockPixels);
  for (int i = index; i < index + count; i += run)
    for (int c = 0; c < 4; ++c)
      if (mask[c]) std::fill_n(colours + i / kBlockPixels * (4 * kBlockPixels) + c * kBlockPixels + i % kBlockPixels, run, value[c]);
}

/// What a clear writes into the colours of any tile.
struct ColourFill {
  ColourFormat format;
  bool mask[4];
  std::uint32_t code, code_mask;
  float floats[4];
  std::uint16_t halves[4];

  ColourFill(const Rgba32F& c, const ColourMask& m, ColourFormat colour_format)
      : format(colour_format), mask{m.red, m.green, m.blue, m.alpha}, code(codes_of(c, colour_format)),
        code_mask((m.red ? 0xffu : 0u) | (m.green ? 0xff00u : 0u) | (m.blue ? 0xff0000u : 0u) | (m.alpha ? 0xff000000u : 0u)),
        floats{c.r, c.g, c.b, c.a},
        halves{half_from_float(c.r), half_from_float(c.g), half_from_float(c.b), half_from_float(c.a)} {}

  void operator()(void* colours, int index, int count) const {
    if (format == ColourFormat::rgba32f) return fill_planes(static_cast<float*>(colours), floats, mask, index, count);
    if (format == ColourFormat::rgba16f) return fill_planes(static_cast<std::uint16_t*>(colours), halves, mask, index, count);
    std::uint32_t* first = static_cast<std::uint32_t*>(colours) + index;
    if (code_mask == 0xffffffffu) std::fill_n(first, count, code);
    else for (int i = 0; i < count; ++i) first[i] = (first[i] & ~code_mask) | (code & code_mask);
  }
};

std::optional<Error> clear_refusal(const ClearCommand& command, bool has_stencil) {
  if (command.stencil && !has_stencil)
    return Error{"clear: stencil is " + std::to_string(*command.stencil) + ", but the target has no stencil buffer"};
  if (command.depth && std::isnan(*command.depth)) return Error{"clear: depth is not a number"};
  if (!command.colour) return {};
  const Rgba32F& c = *command.colour;
  for (const auto& [name, value] : {std::pair{"red", c.r}, {"green", c.g}, {"blue", c.b}, {"alpha", c.a}})
    if (std::isnan(value)) return Error{std::string("clear: the colour's ") + name + " is not a number"};
  return {};
}

}  // namespace

float depth_of_code(std::int32_t code, DepthFormat format) noexcept {
  switch (format) {
    case DepthFormat::d16: return static_cast<float>(code / 65535.0);
    case DepthFormat::d24: return static_cast<float>(code / 16777215.0);
    case DepthFormat::d32f: break;
  }
  return std::bit_cast<float>(code);
}

std::int32_t code_of_depth(float depth, DepthFormat format) noexcept {
  const float clamped = depth > 0 ? std::min(depth, 1.0f) : 0.0f;
  switch (format) {
    case DepthFormat::d16: return static_cast<std::int32_t>(std::floor(static_cast<double>(clamped) * 65535.0 + 0.5));
    case DepthFormat::d24: return static_cast<std::int32_t>(std::floor(static_cast<double>(clamped) * 16777215.0 + 0.5));
    case DepthFormat::d32f: break;
  }
  return std::bit_cast<std::int32_t>(clamped);
}

Result<RenderTarget> RenderTarget::create(const RenderTargetDescription& description) {
  const auto& [width, height, colour, depth, stencil, samples] = description;
  if (width < 1 || height < 1 || width > kMaxSize || height > kMaxSize)
    return Error{"a render target of " + std::to_string(width) + "x" + std::to_string(height) +
                 " pixels is out of range: 1 to " + std::to_string(kMaxSize) + " each way"};
  if (colour > ColourFormat::rgba16f || depth > DepthFormat::d32f)
    return Error{"a render target of colour format " + std::to_string(static_cast<int>(colour)) + " and depth format " +
                 std::to_string(static_cast<int>(depth)) + " is not possible: there are 0 to 3 and 0 to 2"};
  if (!is_sample_count(samples))
    return Error{"a render target of " + std::to_string(samples) + " samples a pixel is not possible: 1, 2, 4, 8 or 16 are"};
  RenderTarget target;
  target.description_ = description;
  target.tiles_per_row_ = (width + kTileSize - 1) / kTileSize;
  target.tile_rows_ = (height + kTileSize - 1) / kTileSize;
  const auto codes = static_cast<std::size_t>(target.tile_count()) * kTilePixels * static_cast<std::size_t>(samples);
  target.colour_.resize(codes * static_cast<std::size_t>(bytes_per_pixel(colour)));
  target.depth_.resize(codes, code_of_depth(1.0f, depth));
  if (stencil) target.stencil_.resize(codes);
  return target;
}

Tile RenderTarget::tile(int number) noexcept {
  const std::size_t first = static_cast<std::size_t>(number) * kTilePixels * static_cast<std::size_t>(samples());
  return {.left = number % tiles_per_row_ * kTileSize,
          .top = number / tiles_per_row_ * kTileSize,
          .colour = const_cast<std::byte*>(tile_colour(number, 0)),
          .depth = depth_.data() + first,
          .stencil = has_stencil() ? stencil_.data() + first : nullptr,
          .samples = samples()};
}

const std::byte* RenderTarget::tile_colour(int number, int sample) const noexcept {
  const auto plane = static_cast<std::size_t>(number) * static_cast<std::size_t>(samples()) + static_cast<std::size_t>(sample);
  return colour_.data() + plane * kTilePixels * static_cast<std::size_t>(bytes_per_pixel(colour_format()));
}

Result<Nothing> RenderTarget::clear(const ClearCommand& command, Workers& workers) {
  if (const std::optional<Error> refusal = clear_refusal(command, has_stencil())) return *refusal;
  // Pixels beyond the target's right and lower edges are never shown: without a scissor, whole tiles.
  const PixelRect rectangle = command.scissor ? intersection(*command.scissor, bounds())
                                              : PixelRect{0, 0, tiles_per_row_ * kTileSize, tile_rows_ * kTileSize};
  const ColourFill fill_colour(command.colour.value_or(Rgba32F{0, 0, 0, 0}), command.colour_mask, colour_format());
  const std::int32_t depth = code_of_depth(command.depth.value_or(1.0f), depth_format());
  const int mask = command.stencil_write_mask, stencil = command.stencil.value_or(std::uint8_t{0}) & mask;
  parallel_for(workers, tile_count(), [&](std::int64_t number, int) {
    const Tile all = tile(static_cast<int>(number));
    for (int s = 0; s < samples(); ++s) {
      const Tile plane = plane_of_sample(all, colour_format(), s);
      for_each_run(plane, rectangle, [&](int index, int count) {
        if (command.colour) fill_colour(plane.colour, index, count);
        if (command.depth) std::fill_n(plane.depth + index, count, depth);
        if (!command.stencil) return;
        for (int i = index; i < index + count; ++i)
          plane.stencil[i] = static_cast<std::uint8_t>((plane.stencil[i] & ~mask) | stencil);
      });
    }
  });
  return Nothing{};
}

void RenderTarget::clear_colour(const Rgba32F& colour, Workers& workers) {
  const ColourFill fill_colour(colour, {}, colour_format());
  parallel_for(workers, tile_count(), [&](std::int64_t number, int) {
    const Tile all = tile(static_cast<int>(number));
    for (int s = 0; s < samples(); ++s) fill_colour(plane_of_sample(all, colour_format(), s).colour, 0, kTilePixels);
  });
}

void RenderTarget::clear_depth(float depth, Workers& workers) {
  const std::int32_t code = code_of_depth(depth, depth_format());
  parallel_for(workers, tile_count(), [&](std::int64_t number, int) {
    std::fill_n(tile(static_cast<int>(number)).depth, kTilePixels * samples(), code);
  });
}

}  // namespace tuberia
