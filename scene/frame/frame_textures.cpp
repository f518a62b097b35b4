#include "scene/frame/frame_textures.hpp"

#include <array>

#include "raster/level_colours.hpp"
#include "scene/content/texture_picture.hpp"

namespace tuberia {
namespace {

Result<Texture> texture_of(const TexturePicture& picture) {
  if (picture.codes.empty()) return Texture::create(picture.light);
  return Texture::create(picture.codes, picture.is_srgb ? TextureEncoding::srgb : TextureEncoding::linear);
}

}  // namespace

Sampler sampler_of(const description::Texture& texture) noexcept {
  using Filter = description::Texture::Filter;
  constexpr std::array kWraps{Wrap::repeat, Wrap::clamp, Wrap::mirror};
  const Wrap wrap = kWraps[static_cast<std::size_t>(texture.wrap)];
  Sampler sampler{.wrap_u = wrap, .wrap_v = wrap, .wrap_w = wrap, .max_anisotropy = static_cast<float>(texture.anisotropy)};
  if (texture.filter == Filter::nearest || texture.filter == Filter::mipmap_nearest) sampler.texels = TexelFilter::nearest;
  if (texture.filter == Filter::nearest || texture.filter == Filter::bilinear) sampler.mipmaps = MipmapFilter::none;
  if (texture.filter == Filter::mipmap_nearest) sampler.mipmaps = MipmapFilter::nearest;
  return sampler;
}

Result<FrameTexture> frame_texture(const SceneDescription& scene, const description::Texture& texture) {
  const auto picture = texture_picture(scene, texture);
  if (!picture) return picture.error();
  auto made = texture_of(*picture);
  if (made && texture.level_colours) made = level_coloured_texture(made->level(0).width, made->level(0).height);
  if (!made) return Error{"texture '" + texture.name + "': " + made.error().message};
  FrameTexture ready{.texture = std::make_shared<const Texture>(*std::move(made)), .sampler = sampler_of(texture)};
  if (texture.level_rule == description::Texture::LevelRule::distance) ready.access.level_rule = TextureAccess::LevelRule::distance;
  ready.access.texel_distance = static_cast<float>(texture.texel_distance);
  return ready;
}

}  // namespace tuberia
