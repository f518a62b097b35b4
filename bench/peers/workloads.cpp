#include "bench/peers/workloads.hpp"

#include <numbers>

#include "math/transforms.hpp"

namespace tuberia::bench {

namespace {

constexpr double kDegrees = std::numbers::pi / 180.0;
constexpr const char* kBunnyFile = "/usr/share/glmark2/models/bunny.obj";
constexpr int kFillLayers = 16, kTextureLayers = 8;

using MakeWorkload = Result<Workload> (*)();
struct Recipe {
  const char* name;
  MakeWorkload make;
};

glm::mat4 perspective_1080p(double fovy_degrees, double near_distance, double far_distance) {
  return perspective(fovy_degrees * kDegrees, 1920.0 / 1080.0, near_distance, far_distance, ClipVolume::minus_w_to_w)
      .value();
}

Workload fill(bool smooth, LayerOrder order) {
  return {.mesh = filling_quads(kFillLayers, smooth, 255, order), .flat = !smooth};
}

Workload blended_fill(bool smooth) {
  return {.mesh = filling_quads(kFillLayers, smooth, 64, LayerOrder::back_to_front), .flat = !smooth, .blend = true};
}

Workload textured_fill(Filter filter) {
  return {.mesh = leaning_planes(kTextureLayers, 1920.0f / 1080.0f),
          .clip_from_view = perspective_1080p(60, 0.1, 100), .filter = filter};
}

Workload small_triangles(LayerOrder order) { return {.mesh = jittered_grids(240, 135, 16, order)}; }

Workload depth_only_triangles(LayerOrder order) {
  return {.mesh = jittered_grids(256, 256, 8, order), .depth_only = true, .width_pixels = 2048, .height_pixels = 2048};
}

// Two million triangles on few pixels: all the work is at the vertices.
Workload far_sphere(bool lit) {
  return {.mesh = unit_sphere(1000),
          .view_from_object = compose(translation({0, 0, -18.6}), rotation({1, 0, 0}, 25 * kDegrees)),
          .clip_from_view = perspective_1080p(60, 0.1, 100), .cull_back = true, .lit = lit, .specular = lit};
}

Result<Workload> bunny(int subdivisions) {
  auto mesh = model_of_height_2(kBunnyFile);
  if (!mesh) return mesh.error();
  for (int i = 0; i < subdivisions; ++i) *mesh = subdivided(*mesh);
  return Workload{.mesh = std::move(*mesh), .view_from_object = translation({0, 0, -2.9}),
                  .clip_from_view = perspective_1080p(45, 0.1, 100), .cull_back = true, .lit = true, .specular = true};
}

// From between the boxes, 1.7 above the street, looking slightly down and aside.
Workload city_street() {
  const glm::mat4 turn = compose(rotation({1, 0, 0}, 8 * kDegrees), rotation({0, 1, 0}, 12 * kDegrees));
  return {.mesh = city(64), .view_from_object = compose(turn, translation({-0.3, -1.7, -60})),
          .clip_from_view = perspective_1080p(60, 0.5, 400), .filter = Filter::linear_mipmap_linear, .cull_back = true,
          .lit = true};
}

using enum LayerOrder;
constexpr Recipe kRecipes[] = {
    {"clear", [] { return Result<Workload>(Workload{}); }},
    {"fill_flat", [] { return Result(fill(false, back_to_front)); }},
    {"fill_gouraud", [] { return Result(fill(true, back_to_front)); }},
    {"fill_flat_f2b", [] { return Result(fill(false, front_to_back)); }},
    {"fill_gouraud_nodepth", [] {
       Workload workload = fill(true, back_to_front);
       workload.depth_test = false;
       return Result(std::move(workload));
     }},
    {"fill_blend", [] { return Result(blended_fill(false)); }},
    {"fill_blend_gouraud", [] { return Result(blended_fill(true)); }},
    {"fill_tex_nearest_nomip", [] { return Result(textured_fill(Filter::nearest)); }},
    {"fill_tex_linear_nomip", [] { return Result(textured_fill(Filter::linear)); }},
    {"fill_tex_nearest", [] { return Result(textured_fill(Filter::nearest_mipmap_nearest)); }},
    {"fill_tex_bilinear", [] { return Result(textured_fill(Filter::linear_mipmap_nearest)); }},
    {"fill_tex_trilinear", [] { return Result(textured_fill(Filter::linear_mipmap_linear)); }},
    {"small_tris", [] { return Result(small_triangles(back_to_front)); }},
    {"small_tris_f2b", [] { return Result(small_triangles(front_to_back)); }},
    {"tiny_tris", [] { return Result(Workload{.mesh = jittered_grids(1358, 764, 2, back_to_front)}); }},
    {"depth_only", [] { return Result(depth_only_triangles(back_to_front)); }},
    {"depth_only_f2b", [] { return Result(depth_only_triangles(front_to_back)); }},
    {"vertex_bound", [] { return Result(far_sphere(false)); }},
    {"vertex_bound_lit", [] { return Result(far_sphere(true)); }},
    {"model_bunny", [] { return bunny(0); }},
    {"model_bunny1M", [] { return bunny(2); }},
    {"scene_textured", [] { return Result(city_street()); }},
};

}  // namespace

std::vector<Image<Rgba8>> workload_textures(int size_texels) {
  return {noisy_checkerboard(size_texels, 0), noisy_checkerboard(size_texels, 777)};
}

std::vector<std::string> workload_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : kRecipes) names.emplace_back(recipe.name);
  return names;
}

Result<Workload> make_workload(std::string_view name) {
  for (const Recipe& recipe : kRecipes) {
    if (name != recipe.name) continue;
    auto workload = recipe.make();
    if (workload) workload->name = name;
    return workload;
  }
  return Error{"no workload is called " + std::string(name)};
}

}  // namespace tuberia::bench
