// Which object a pixel shows: the picture's draws with numbers in place of colours.        [A 2.1] [C]

#include "pipeline/programs/programs.hpp"
#include "scene/frame/scene_frame.hpp"

namespace tuberia {
namespace {

/// Floats tell whole numbers apart up to 2^24; 0 is the background.
glm::vec4 number_of(std::size_t object) { return {static_cast<float>(object + 1), 0, 0, 1}; }

Image<int> objects_in(const Image<Rgba32F>& numbers) {
  Image<int> objects(numbers.width(), numbers.height());
  for (std::size_t i = 0; i < objects.pixels().size(); ++i) objects.pixels()[i] = static_cast<int>(numbers.pixels()[i].r) - 1;
  return objects;
}

}  // namespace

Result<NearestObjects> SceneFrame::nearest_objects(Pipeline& pipeline) const {
  auto target = RenderTarget::create(size_.x, size_.y, ColourFormat::rgba32f, DepthFormat::d32f);
  if (!target) return target.error();
  pipeline.clear(*target, {0, 0, 0, 1});
  std::vector<glm::vec4> numbers;
  for (const Part& part : parts_) {
    DrawCall draw = draw_of(part, camera_);
    const bool is_cut_out = part.part.alpha_cutoff > 0 && part.part.own_texture != nullptr;
    // The same geometry has the same depths, so what passes the alpha test is found again by them.
    if (is_cut_out) {
      DrawCall holes = draw;
      holes.program = textured({.texture = part.part.own_texture, .sampler = {}, .tint = glm::vec4(1), .alpha_cutoff = part.part.alpha_cutoff}, true);
      holes.state.blend.write = false;
      if (const auto drawn = pipeline.draw(*target, holes); !drawn) return drawn.error();
      draw.state.depth.test = Compare::equal;
    }
    numbers.assign(part.part.mesh.positions.size(), number_of(part.object));
    draw.mesh.colours = numbers;
    draw.program = flat();
    if (const auto drawn = pipeline.draw(*target, draw); !drawn) return drawn.error();
  }
  return NearestObjects{.objects = objects_in(target->linear_image()), .depths = target->depth_image()};
}

}  // namespace tuberia
