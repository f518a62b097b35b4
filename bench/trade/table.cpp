#include "bench/trade/table.hpp"

#include "bench/trade/probes.hpp"
#include "bench/trade/scenes.hpp"
#include "bench/trade/settings.hpp"

namespace tuberia::bench::trade {
namespace {

Scene with(Scene scene, const Setting& setting) {
  setting.apply(scene.recipe);
  return scene;
}

Setting both(const Setting& first, const Setting& second) {
  return {first.name + ", " + second.name, [=](Recipe& recipe) {
            first.apply(recipe);
            second.apply(recipe);
          }};
}

/// Of the filters and shadings the ones that whole scenes combine.
Switch filters() {
  const std::vector<Setting> all = filter_settings();
  return {"filter", {all[0], all[2], all[4], all[8]}, {}};
}
Switch antialiasing() {
  return {"samples", {sample_settings()[0], sample_settings()[2], supersampling_settings()[1]}, {}};
}
Switch few_samples() { return {"samples", {sample_settings()[0], sample_settings()[2]}, {}}; }
Switch precision() { return {"precision", precision_settings(), {}}; }

Stage precision_stage() {
  return {
      .name = "precision",
      .title = "Precision: exact or fast",
      .what =
          "Fast fuses multiplications with additions and approximates reciprocals, roots and powers. The "
          "error is that against exact precision, which is the same on every machine.",
      .error_label = "RMSE, codes of 255",
      .switches = {{"precision", precision_settings(), {against_reference(floor_scene()), against_reference(layers())}},
                   {"ingredients",
                    ingredient_settings(),
                    {against_reference(spheres()), against_reference(relief_scene()), against_reference(model())}}}};
}

Stage coverage_stage() {
  return {.name = "coverage",
          .title = "Coverage: subpixel bits and edge arithmetic",
          .what =
              "Vertices are rounded to a grid before anything is covered; pixels are wrong where an edge moves "
              "over their centres. Every bit halves them. Edge functions in integers are exact; in floats they have "
              "the wrong sign here and there, the "
              "more the larger the triangle.",
          .error_label = "wrong pixels per 1000 px of edge",
          .switches = {{"subpixel bits", subpixel_settings(), {random_triangles()}},
                       {"edge arithmetic", edge_arithmetic_settings(), {large_triangles(256), large_triangles(1024)}}}};
}

Stage interpolation_stage() {
  return {
      .name = "interpolation",
      .title = "Perspective: at each pixel, every few, or not at all",
      .what =
          "A coordinate of 256 texels over 256 pixels that recede from 1 to 2, 10 or 100 times the distance: by how "
          "many texels it is wrong, against the exact quotient.",
      .error_label = "largest error, texels",
      .switches = {
          {"perspective", perspective_settings(), {receding_texels(2), receding_texels(10), receding_texels(100)}}}};
}

Stage fog_stage() {
  return {
      .name = "fog",
      .title = "Fog: at fragments or at vertices",
      .what =
          "Fog computed at the vertices and interpolated is wrong inside large triangles: the street's floor has two.",
      .error_label = "RMSE, codes of 255",
      .switches = {{"fog", fog_settings(), {against_reference(foggy_street())}}}};
}

Stage texel_stage() {
  return {
      .name = "texels",
      .title = "Weights of texels",
      .what = "Weights of 8 bits, as in most hardware, against floats.",
      .error_label = "RMSE, codes of 255",
      .switches = {
          {"weights", weight_settings(), {against_reference(magnified_texture()), against_reference(floor_scene())}}}};
}

Stage depth_stage() {
  return {.name = "depth",
          .title = "Depth formats",
          .what =
              "Pairs of surfaces, one behind the other by a part of its distance, from 0.1 to 10,000 away (near "
              "plane 0.1, far plane 10,000): how many come out in the wrong order, or cannot be told apart.",
          .error_label = "pairs in the wrong order, %",
          .switches = {{"depth format",
                        depth_format_settings(),
                        {depth_pairs(1e-3), depth_pairs(1e-4), depth_pairs(1e-5), depth_pairs(1e-6)}}}};
}

Stage filter_stage() {
  const Setting anisotropic = filter_settings().front();
  return {
      .name = "filter",
      .title = "Texture filters",
      .what =
          "Against many samples a pixel: 144 of the nearest texel for the checkered floor, 64 of anisotropic "
          "filtering for the other. Footprints are those that anisotropic filtering 16 measures.",
      .error_label = "RMSE, codes of 255",
      .switches = {
          {"filter", filter_settings(), {checker_floor(), floor_scene()}},
          {"footprint", footprint_settings(), {with(checker_floor(), anisotropic), with(floor_scene(), anisotropic)}}}};
}

/// Anisotropic and trilinear filtering, and samples of nearest texels or of trilinear filtering, more and more.
std::vector<Setting> ways_to_sample() {
  const std::vector<Setting> filters = filter_settings(), grids = supersampling_settings();
  const Setting &anisotropic = filters[0], &trilinear = filters[4], &nearest = filters[8];
  std::vector<Setting> ways{anisotropic, trilinear, nearest};
  for (std::size_t i = 1; i < grids.size(); ++i) ways.push_back(both(nearest, grids[i]));
  for (std::size_t i = 1; i < 4; ++i) ways.push_back(both(trilinear, grids[i]));
  return ways;
}

Stage supersampling_stage() {
  return {.name = "supersampling",
          .title = "Textures: filters or more samples",
          .what =
              "The checkered floor, against 144 samples of the nearest texel a pixel. More samples cost what they are; "
              "a filter reads means that the mipmaps have ready.",
          .error_label = "RMSE, codes of 255",
          .switches = {{"filters and grids", ways_to_sample(), {checker_floor()}}}};
}

Stage edges_stage() {
  return {.name = "edges",
          .title = "Edges: multisampling and supersampling",
          .what =
              "Shares of pixels that white polygons cover, against exact areas, over all pixels that an edge "
              "crosses. Multisampling shades once a pixel; supersampling shades, and costs, every sample.",
          .error_label = "RMS error of coverage, 0..1",
          .switches = {{"multisampling", sample_settings(), {polygon_edges(false), polygon_edges(true)}},
                       {"supersampling", supersampling_settings(), {polygon_edges(false), polygon_edges(true)}}}};
}

Stage target_stage() {
  return {.name = "target",
          .title = "Colour formats",
          .what =
              "Against floats, as sRGB codes of the screen: linear 8-bit codes lose the dark shades, and "
              "layers thinner than a code never become thicker.",
          .error_label = "RMSE, sRGB codes of 255",
          .switches = {{"colour format", colour_format_settings(), {intensity_ramp(), thin_layers(255), [] {
                                                                      Scene scene = against_reference(layers());
                                                                      scene.signal = Signal::linear;
                                                                      return scene;
                                                                    }()}}}};
}

Stage shading_stage() {
  return {
      .name = "shading",
      .title = "Where light is computed",
      .what =
          "At every fragment, at the vertices, or once a triangle. The coarser the triangles the more of a "
          "highlight is lost between them.",
      .error_label = "RMSE, codes of 255",
      .switches = {{"shading",
                    shading_settings(),
                    {highlight_between_normals(10, 20), highlight_between_normals(20, 50),
                     highlight_between_normals(30, 10), against_reference(spheres()), against_reference(model())}}}};
}

}  // namespace

std::vector<Stage> all_stages() {
  return {coverage_stage(),      edges_stage(), interpolation_stage(), depth_stage(),  shading_stage(),  filter_stage(),
          supersampling_stage(), fog_stage(),   texel_stage(),         target_stage(), precision_stage()};
}

std::vector<WholeScene> whole_scenes() {
  const Switch fog{"fog", fog_settings(), {}};
  const Switch smooth{"shading", smooth_shading_settings(), {}},
      shading{
          "shading", {shading_settings()[0], shading_settings()[3], shading_settings()[4], shading_settings()[5]}, {}};
  const Switch steps{"perspective", {perspective_settings()[0], perspective_settings()[2]}, {}};
  const Switch depth{"depth format", depth_format_settings(), {}},
      colours{"colour format", colour_format_settings(), {}};
  return {{spheres(), {shading, precision(), antialiasing()}},
          {floor_scene(), {filters(), steps, precision(), few_samples()}},
          {relief_scene(), {filters(), smooth, precision(), few_samples()}},
          {model(), {shading, precision(), antialiasing()}},
          {layers(), {colours, precision(), few_samples()}},
          {close_planes(), {depth, precision(), few_samples()}},
          {foggy_street(), {smooth, fog, precision(), few_samples()}}};
}

std::vector<Combination> combinations(const std::vector<Switch>& switches) {
  std::vector<Combination> all{{{"", [](Recipe&) {}}, {}}};
  for (const Switch& each : switches) {
    std::vector<Combination> longer;
    for (const Combination& begun : all)
      for (std::size_t i = 0; i < each.settings.size(); ++i) {
        Combination next = begun;
        next.choices.push_back(i);
        next.setting.name += (begun.choices.empty() ? "" : " + ") + each.settings[i].name;
        next.setting.apply = [first = begun.setting.apply, second = each.settings[i].apply](Recipe& recipe) {
          first(recipe);
          second(recipe);
        };
        longer.push_back(std::move(next));
      }
    all = std::move(longer);
  }
  return all;
}

}  // namespace tuberia::bench::trade
