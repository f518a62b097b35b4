#include "raster/level_colours.hpp"

#include <array>
#include <utility>

namespace tuberia {

Rgba8 level_colour(int level) noexcept {
  constexpr std::array<Rgba8, 6> kHues{{{255, 0, 0, 255}, {255, 255, 0, 255}, {0, 255, 0, 255}, {0, 255, 255, 255}, {0, 0, 255, 255}, {255, 0, 255, 255}}};
  const Rgba8& hue = kHues[static_cast<std::size_t>(level % 6)];
  const int divisor = 1 << level / 6;
  const auto darker = [&](std::uint8_t code) { return static_cast<std::uint8_t>(code / divisor); };
  return {darker(hue.r), darker(hue.g), darker(hue.b), 255};
}

Result<Texture> level_coloured_texture(int width, int height) {
  Result<Texture> texture = Texture::create_empty({.width = width, .height = height});
  if (!texture) return texture;
  for (int i = 0; i < texture->level_count(); ++i) {
    const TextureLevel& level = texture->level(i);
    const auto replaced = texture->replace(i, 0, Image<Rgba8>(level.width, level.height, level_colour(i)));
    if (!replaced) return replaced.error();
  }
  return texture;
}

}  // namespace tuberia
