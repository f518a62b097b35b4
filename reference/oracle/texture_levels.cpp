// From codes to linear texels, and from each level of a texture to the next.

#include <cmath>

#include "reference/oracle/target.hpp"
#include "reference/oracle/texture.hpp"

namespace tuberia::oracle {
namespace {

using Mean = std::array<double, 4>;

/// A level before it is rounded.
struct Unrounded {
  int width = 0, height = 0, slices = 1;
  std::vector<Mean> texels;
  const Mean& at(std::size_t x, std::size_t y, std::size_t z) const {
    return texels[(z * static_cast<std::size_t>(height) + y) * static_cast<std::size_t>(width) + x];
  }
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

using Shares = std::vector<double>;

Mean mean_of(const Unrounded& from, const Shares& across, const Shares& down, const Shares& deep) {
  Mean mean{};
  for (std::size_t k = 0; k < deep.size(); ++k)
    for (std::size_t j = 0; j < down.size(); ++j)
      for (std::size_t i = 0; i < across.size(); ++i) {
        const double share = across[i] * down[j] * deep[k];
        if (share == 0) continue;
        for (std::size_t c = 0; c < 4; ++c) mean[c] += share * from.at(i, j, k)[c];
      }
  return mean;
}

/// The slices of a box are halved, too; the faces of a cube stay apart.
Unrounded halved(const Unrounded& from, bool is_box) {
  Unrounded to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), is_box ? std::max(from.slices / 2, 1) : from.slices, {}};
  for (int z = 0; z < to.slices; ++z)
    for (int y = 0; y < to.height; ++y)
      for (int x = 0; x < to.width; ++x)
        to.texels.push_back(mean_of(from, shares(from.width, to.width, x), shares(from.height, to.height, y), shares(from.slices, to.slices, z)));
  return to;
}

/// A mean of up to 27 texels takes as many roundings, those of its weights, and one of its decoding: less
/// than 2.5e-6 of the largest texel, at each of `steps` levels. Floats may cancel in a mean, codes do not.
TextureLevel rounded(const Unrounded& level, const Texture& texture, ColourFormat format, int steps) {
  double largest = 0;
  for (const glm::vec4& f : texture.floats)
    for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(static_cast<double>(f[c])));
  TextureLevel result{level.width, level.height, level.slices, {}};
  for (const Mean& mean : level.texels) {
    Colour colour;
    for (std::size_t c = 0; c < 4; ++c) {
      const int channel = static_cast<int>(c);
      const double margin = 2.5e-6 * steps * std::max(largest, mean[c]);
      colour[c] = linear(stored({mean[c] - margin, mean[c] + margin}, channel, format), channel, format);
    }
    result.texels.push_back(colour);
  }
  return result;
}

}  // namespace

void complete(Texture& texture) {
  const ColourFormat format = !texture.floats.empty() ? ColourFormat::rgba32f : texture.is_srgb ? ColourFormat::srgb8 : ColourFormat::rgba8;
  TextureLevel first{texture.width, texture.height, texture.slices, {}};
  Unrounded level{texture.width, texture.height, texture.slices, {}};
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
  for (const glm::vec4& f : texture.floats) {
    const Mean texel{static_cast<double>(f.r), static_cast<double>(f.g), static_cast<double>(f.b), static_cast<double>(f.a)};
    first.texels.push_back({texel[0], texel[1], texel[2], texel[3]});
    level.texels.push_back(texel);
  }
  for (const float depth : texture.depths) {
    const Interval d = static_cast<double>(depth);
    first.texels.push_back({d, d, d, 1.0});
  }
  texture.levels = {first};
  if (!texture.has_mipmaps) return;
  const bool is_box = texture.kind == TextureKind::three_dimensional;
  while (level.width > 1 || level.height > 1 || (is_box && level.slices > 1)) {
    level = halved(level, is_box);
    texture.levels.push_back(rounded(level, texture, format, static_cast<int>(texture.levels.size())));
  }
}

}  // namespace tuberia::oracle
