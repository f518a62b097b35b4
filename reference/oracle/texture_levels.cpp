// From codes to linear texels, and from each level of a texture to the next.

#include <cmath>

#include "reference/oracle/target.hpp"
#include "reference/oracle/texture.hpp"

namespace tuberia::oracle {
namespace {

using Mean = std::array<double, 4>;

/// A level before it is rounded.
struct Unrounded {
  int width = 0, height = 0;
  std::vector<Mean> texels;
};

/// Shares of the texels of a row that place i of a row half as long covers.
std::vector<double> shares(int from, int to, int i) {
  std::vector<double> share(static_cast<std::size_t>(from));
  const double step = static_cast<double>(from) / to;
  for (int k = 0; k < from; ++k) {
    const double covered = std::min((i + 1) * step, k + 1.0) - std::max(i * step, static_cast<double>(k));
    share[static_cast<std::size_t>(k)] = std::max(covered, 0.0) / step;
  }
  return share;
}

Unrounded halved(const Unrounded& from) {
  Unrounded to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x) {
      const std::vector<double> across = shares(from.width, to.width, x), down = shares(from.height, to.height, y);
      Mean mean{};
      for (std::size_t j = 0; j < down.size(); ++j)
        for (std::size_t i = 0; i < across.size(); ++i)
          for (std::size_t c = 0; c < 4; ++c)
            mean[c] += across[i] * down[j] * from.texels[j * static_cast<std::size_t>(from.width) + i][c];
      to.texels.push_back(mean);
    }
  return to;
}

TextureLevel rounded(const Unrounded& level, ColourFormat format) {
  TextureLevel result{level.width, level.height, 1, {}};
  for (const Mean& mean : level.texels) {
    Colour colour;
    for (std::size_t c = 0; c < 4; ++c) {
      const int channel = static_cast<int>(c);
      colour[c] = linear(stored(widened(mean[c], 1e-6), channel, format), channel, format);
    }
    result.texels.push_back(colour);
  }
  return result;
}

}  // namespace

void complete(Texture& texture) {
  const ColourFormat format = texture.is_srgb ? ColourFormat::srgb8 : ColourFormat::rgba8;
  TextureLevel first{texture.width, texture.height, texture.slices, {}};
  Unrounded level{texture.width, texture.height, {}};
  for (const auto& codes : texture.texels) {
    Colour colour;
    Mean mean;
    for (std::size_t c = 0; c < 4; ++c) {
      colour[c] = linear(static_cast<double>(codes[c]), static_cast<int>(c), format);
      mean[c] = (colour[c].low + colour[c].high) / 2;
    }
    first.texels.push_back(colour);
    level.texels.push_back(mean);
  }
  for (const glm::vec4& f : texture.floats)
    first.texels.push_back({static_cast<double>(f.r), static_cast<double>(f.g), static_cast<double>(f.b), static_cast<double>(f.a)});
  for (const float depth : texture.depths) {
    const Interval d = static_cast<double>(depth);
    first.texels.push_back({d, d, d, 1.0});
  }
  texture.levels = {first};
  if (!texture.has_mipmaps) return;
  while (level.width > 1 || level.height > 1) {
    level = halved(level);
    texture.levels.push_back(rounded(level, format));
  }
}

}  // namespace tuberia::oracle
