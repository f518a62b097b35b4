// Lesson 5: textures. A chequered floor, far into the distance, by three samplers. Where many texels fall on one
// pixel, the nearest one is a matter of chance, and the squares dissolve into false patterns; a mipmap keeps means of
// 2x2, 4x4, 8x8, ... texels, and mixing the two whose texels are as large as a pixel calms the picture [A 1.1]. It also
// blurs what is seen at a low angle, unless several samples are taken along the pixel's long footprint.

#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"
#include "scene/mesh_editing.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shapes/shapes.hpp"

using namespace tuberia;

namespace {

Image<Rgba8> chequers() {
  Image<Rgba8> image(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) image.at(x, y) = (x / 32 + y / 32) % 2 == 0 ? Rgba8{235, 225, 200, 255} : Rgba8{120, 30, 30, 255};
  return image;
}

}  // namespace

int main() {
  constexpr int kWidth = 300, kHeight = 300;
  const auto texture = std::make_shared<const Texture>(*Texture::create(chequers(), TextureEncoding::srgb));  // with its mipmaps
  const Mesh floor = *with_repeated_texture(*plane_mesh({.width = 200, .depth = 200}), {100, 100});
  const Camera camera{.eye = {0, 1.2, 0}, .point_of_interest = {0.4, 0.55, -3}, .view = *perspective_volume(0.9, double(kWidth) / kHeight, 0.1, 200)};

  const Sampler samplers[] = {{.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none},
                              {.texels = TexelFilter::bilinear, .mipmaps = MipmapFilter::linear},
                              {.texels = TexelFilter::bilinear, .mipmaps = MipmapFilter::linear, .max_anisotropy = 16}};
  RenderTarget target = *RenderTarget::create(3 * kWidth, kHeight, ColourFormat::srgb8);
  Pipeline pipeline;
  pipeline.clear(target, {0.3f, 0.5f, 0.8f, 1});
  int left = 0;
  for (const Sampler& sampler : samplers) {
    DrawCall draw{.mesh = mesh_view(floor), .program = textured({.texture = texture, .sampler = sampler}), .state = {}};
    draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
    draw.state.viewport.viewport = Viewport{left, 0, kWidth, kHeight};  // each in a third of the picture
    if (!pipeline.draw(target, draw)) return 1;
    left += kWidth;
  }
  std::filesystem::create_directories("out");
  return write_image("out/textures_and_mipmaps.png", target.colour_image()) ? 0 : 1;
}
