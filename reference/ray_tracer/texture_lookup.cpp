#include "reference/ray_tracer/texture_lookup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "math/colour.hpp"

namespace tuberia::tracer {
namespace {

using Wrap = description::Texture::Wrap;

/// A level before it is rounded.
using Texels = Image<glm::dvec4>;

glm::dvec4 colour_of(const Rgba32F& texel) { return {texel.r, texel.g, texel.b, texel.a}; }

/// The texels of a row that one of a row about half as long covers, and their shares: two, or three of an odd number.
struct Taps {
  int first = 0, count = 1;
  std::array<double, 3> shares{1, 0, 0};

  Taps(int from, int to, int i) {
    const double step = static_cast<double>(from) / to, begin = i * step, end = (i + 1) * step;
    first = static_cast<int>(begin);
    count = std::min(static_cast<int>(std::ceil(end - 1e-9)), from) - first;
    for (int k = 0; k < count; ++k) {
      const double covered = std::min(end, first + k + 1.0) - std::max(begin, first + k + 0.0);
      shares[static_cast<std::size_t>(k)] = covered / step;
    }
  }
};

Texels halved(const Texels& from) {
  Texels to(std::max(from.width() / 2, 1), std::max(from.height() / 2, 1));
  for (int y = 0; y < to.height(); ++y) {
    const Taps down(from.height(), to.height(), y);
    for (int x = 0; x < to.width(); ++x) {
      const Taps across(from.width(), to.width(), x);
      glm::dvec4 mean(0);
      for (int j = 0; j < down.count; ++j)
        for (int i = 0; i < across.count; ++i)
          mean += down.shares[static_cast<std::size_t>(j)] * across.shares[static_cast<std::size_t>(i)] * from.at(across.first + i, down.first + j);
      to.at(x, y) = mean;
    }
  }
  return to;
}

/// To the nearest code and back, where there are codes; see TexturePicture.
float rounded(double value, bool has_codes, bool is_srgb) {
  if (!has_codes) return static_cast<float>(value);
  if (is_srgb) return linear_from_srgb_codes()[srgb_code_from_linear(value)];
  return static_cast<float>(std::floor(255 * value + 0.5)) / 255;
}

Image<Rgba32F> rounded(const Texels& texels, const TexturePicture& picture) {
  const bool has_codes = !picture.codes.empty();
  Image<Rgba32F> level(texels.width(), texels.height());
  for (std::size_t i = 0; i < level.pixels().size(); ++i) {
    const glm::dvec4& c = texels.pixels()[i];
    const auto colour = [&](double channel) { return rounded(channel, has_codes, picture.is_srgb); };
    level.pixels()[i] = {colour(c.r), colour(c.g), colour(c.b), rounded(c.a, has_codes, false)};
  }
  return level;
}

/// Into [0, 1], or of mirrored ones [0, 2], where the same is seen.
double reduced(double u, Wrap wrap) {
  if (!std::isfinite(u)) return 0;
  if (wrap == Wrap::repeat) return u - std::floor(u);
  if (wrap == Wrap::mirror) return u - 2 * std::floor(u / 2);
  return std::clamp(u, -1.0, 2.0);
}

/// The texel that place i of an endless row of `size` texels shows.
int wrapped(int i, int size, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
  const int period = wrap == Wrap::mirror ? 2 * size : size;
  const int place = (i % period + period) % period;
  return place < size ? place : period - 1 - place;
}

/// The level of detail of a pixel's footprint, and how many samples along which step.                  [rules T3]
struct Samples {
  double level_of_detail = 0;
  int count = 1;
  glm::dvec2 step{0};  // from the first to the last, of texture coordinates, and 1/count of it more
};

/// The size of the ellipse that a pixel covers, whose shorter axis decides where `anisotropy` allows it.   [Heckbert]
Samples samples_of(const TextureFootprint& footprint, const glm::dvec2& size, double anisotropy) {
  const glm::dvec2 right = footprint.right * size, down = footprint.down * size;
  const double a = glm::dot(right, right), b = glm::dot(right, down), c = glm::dot(down, down);
  if (!std::isfinite(a + c) || a + c == 0) return {};
  if (!(anisotropy > 1)) return {.level_of_detail = 0.5 * std::log2(std::max(a, c))};
  const double half = 0.5 * (a - c), root = std::sqrt(half * half + b * b), longest = 0.5 * (a + c) + root;
  const double area = std::abs(right.x * down.y - right.y * down.x);
  const double ratio = std::max(area * anisotropy > longest ? longest / area : anisotropy, 1.0);
  glm::dvec2 along = half >= 0 ? glm::dvec2(half + root, b) : glm::dvec2(b, root - half);
  along = along == glm::dvec2(0) ? glm::dvec2(1, 0) : glm::normalize(along);
  return {.level_of_detail = 0.5 * std::log2(longest) - std::log2(ratio), .count = static_cast<int>(std::ceil(ratio)),
          .step = along.x * footprint.right + along.y * footprint.down};
}

}  // namespace

TextureRules rules_of(const description::Texture& texture) noexcept {
  using Filter = description::Texture::Filter;
  using Mipmaps = TextureRules::Mipmaps;
  const bool has_none = texture.filter == Filter::nearest || texture.filter == Filter::bilinear;
  return {.is_nearest = texture.filter == Filter::nearest || texture.filter == Filter::mipmap_nearest,
          .mipmaps = has_none ? Mipmaps::none : texture.filter == Filter::mipmap_nearest ? Mipmaps::nearest : Mipmaps::linear,
          .wrap = texture.wrap, .anisotropy = texture.anisotropy};
}

TextureLookup::TextureLookup(const TexturePicture& picture, const TextureRules& rules) : rules_(rules) {
  levels_.push_back(light_of(picture));
  const Image<Rgba32F>& finest = levels_.front();
  Texels texels(finest.width(), finest.height());
  for (std::size_t i = 0; i < texels.pixels().size(); ++i) texels.pixels()[i] = colour_of(finest.pixels()[i]);
  while (rules.mipmaps != TextureRules::Mipmaps::none && (texels.width() > 1 || texels.height() > 1)) {
    texels = halved(texels);
    levels_.push_back(rounded(texels, picture));
  }
}

void TextureLookup::colour_levels() {
  constexpr std::array<Rgba8, 6> kHues{{{255, 0, 0}, {255, 255, 0}, {0, 255, 0}, {0, 255, 255}, {0, 0, 255}, {255, 0, 255}}};
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const Rgba8& hue = kHues[i % kHues.size()];
    const int divisor = 1 << i / kHues.size();
    const auto intensity = [&](int code) { return static_cast<float>(code / divisor) / 255; };
    levels_[i] = Image<Rgba32F>(levels_[i].width(), levels_[i].height(), {intensity(hue.r), intensity(hue.g), intensity(hue.b), 1});
  }
}

glm::dvec4 TextureLookup::at(const glm::dvec2& uv, const TextureFootprint& footprint) const noexcept {
  const Samples samples = samples_of(footprint, glm::dvec2(size()), rules_.anisotropy);
  glm::dvec4 sum(0);
  for (int i = 0; i < samples.count; ++i) sum += at_level(uv + ((i + 0.5) / samples.count - 0.5) * samples.step, samples.level_of_detail);
  return sum / static_cast<double>(samples.count);
}

glm::dvec4 TextureLookup::at_level(const glm::dvec2& uv, double level_of_detail) const noexcept {
  const int last = level_count() - 1;
  const double lod = level_of_detail > 0 ? std::min(level_of_detail, static_cast<double>(last)) : 0;
  if (rules_.mipmaps != TextureRules::Mipmaps::linear) return within_level(level(std::min(static_cast<int>(std::ceil(lod + 0.5)) - 1, last)), uv);
  const int finer = static_cast<int>(lod);
  const glm::dvec4 colour = within_level(level(finer), uv);
  return finer == lod ? colour : glm::mix(colour, within_level(level(finer + 1), uv), lod - finer);
}

glm::dvec4 TextureLookup::within_level(const Image<Rgba32F>& level, const glm::dvec2& uv) const noexcept {
  const double x = reduced(uv.x, rules_.wrap) * level.width(), y = reduced(uv.y, rules_.wrap) * level.height();
  const auto texel = [&](double column, double row) {
    return colour_of(level.at(wrapped(static_cast<int>(column), level.width(), rules_.wrap), wrapped(static_cast<int>(row), level.height(), rules_.wrap)));
  };
  if (rules_.is_nearest) return texel(std::floor(x), std::floor(y));
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
  const glm::dvec4 upper = glm::mix(texel(left, top), texel(left + 1, top), x - 0.5 - left);
  const glm::dvec4 lower = glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - 0.5 - left);
  return glm::mix(upper, lower, y - 0.5 - top);
}

}  // namespace tuberia::tracer
