#include "bench/guard/small_workloads.hpp"

#include <numbers>

#include "math/transforms.hpp"

namespace tuberia::bench {
namespace {

constexpr int kWidth = 320, kHeight = 180, kDepthOnlySize = 256, kTexels = 128;

struct SmallRecipe {
  const char* name;
  Workload (*make)();
};

Workload sized(Workload workload) {
  workload.width_pixels = kWidth;
  workload.height_pixels = kHeight;
  workload.texture_size_texels = kTexels;
  return workload;
}

glm::mat4 wide_perspective(double near_distance, double far_distance) {
  return perspective(std::numbers::pi / 3, 16.0 / 9, near_distance, far_distance, ClipVolume::minus_w_to_w).value();
}

Workload layers(bool blend) {
  return sized({.mesh = filling_quads(16, true, blend ? 64 : 255, LayerOrder::back_to_front), .blend = blend});
}

Workload trilinear_planes() {
  return sized({.mesh = leaning_planes(4, 16.0f / 9),
                .clip_from_view = wide_perspective(0.1, 100),
                .filter = Filter::linear_mipmap_linear});
}

Workload grid(int columns, int rows, int how_many) {
  return sized({.mesh = jittered_grids(columns, rows, how_many, LayerOrder::back_to_front)});
}

Workload depth_grid() {
  return {.mesh = jittered_grids(32, 32, 8, LayerOrder::back_to_front),
          .depth_only = true,
          .width_pixels = kDepthOnlySize,
          .height_pixels = kDepthOnlySize};
}

Workload lit_sphere() {
  return sized({.mesh = unit_sphere(200),
                .view_from_object = compose(translation({0, 0, -18.6}), rotation({1, 0, 0}, 0.4)),
                .clip_from_view = wide_perspective(0.1, 100),
                .cull_back = true,
                .lit = true,
                .specular = true});
}

// Between the houses of a small city, so that its floor and the nearest walls are clipped.
Workload clipped_city() {
  const glm::mat4 turn = compose(rotation({1, 0, 0}, 0.14), rotation({0, 1, 0}, 0.2));
  return sized({.mesh = city(16),
                .view_from_object = compose(turn, translation({-0.3, -1.7, -12})),
                .clip_from_view = wide_perspective(0.5, 400),
                .filter = Filter::linear_mipmap_linear,
                .cull_back = true,
                .lit = true});
}

constexpr SmallRecipe kRecipesInSmall[] = {
    {"fill", [] { return layers(false); }},
    {"blend", [] { return layers(true); }},
    {"texture_trilinear", trilinear_planes},
    {"small_triangles", [] { return grid(40, 23, 4); }},   // 31 pixels each
    {"tiny_triangles", [] { return grid(226, 127, 1); }},  // 1 pixel each
    {"depth_only", depth_grid},
    {"lit_vertices", lit_sphere},
    {"clipped_scene", clipped_city},
};

}  // namespace

std::vector<std::string> small_workload_names() {
  std::vector<std::string> names;
  for (const SmallRecipe& recipe : kRecipesInSmall) names.emplace_back(recipe.name);
  return names;
}

Result<Workload> make_small_workload(std::string_view name) {
  for (const SmallRecipe& recipe : kRecipesInSmall) {
    if (name != recipe.name) continue;
    Workload workload = recipe.make();
    workload.name = name;
    return workload;
  }
  return Error{"no small workload is called " + std::string(name)};
}

}  // namespace tuberia::bench
