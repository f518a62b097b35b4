#include "examples/tuberia/views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "examples/tuberia/frame_maps.hpp"
#include "examples/tuberia/heat.hpp"
#include "examples/tuberia/view_programs.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::cli {
namespace {

constexpr std::array<std::string_view, 9> kNames{"colour", "overdraw", "depth", "normals", "uv", "lod", "tiles", "triangle-size", "wireframe"};
constexpr Rgba8 kNothing{24, 26, 32, 255};

std::uint8_t code_of(float value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)); }

/// The mesh that a draw shows.
const Mesh* mesh_of(const DrawCall& draw, const Model& model) {
  for (const Mesh& mesh : model.meshes)
    if (mesh.positions.data() == draw.mesh.positions.data()) return &mesh;
  return nullptr;
}

LevelUniforms levels_of(const DrawCall& draw, const Model& model) {
  const Mesh* mesh = mesh_of(draw, model);
  const auto material = static_cast<std::size_t>(mesh != nullptr && mesh->material >= 0 ? mesh->material : 0);
  if (mesh == nullptr || material >= model.materials.size() || model.materials[material].texture < 0) return {};
  const Image<Rgba8>& image = model.textures[static_cast<std::size_t>(model.materials[material].texture)].image;
  const int longest = std::max(image.width(), image.height());
  return {{image.width(), image.height()}, std::floor(std::log2(static_cast<float>(longest)))};
}

/// Every draw with a program that writes numbers, opaque; draws that lack the attribute are left out.
void replace_programs(Frame& frame, const Model& model, View view) {
  const bool normals = view == View::normals;
  std::erase_if(frame.draws, [&](const DrawCall& draw) { return normals ? draw.mesh.normals.empty() : draw.mesh.texcoords.empty(); });
  for (DrawCall& draw : frame.draws) {
    draw.program = normals ? show_normals() : show_texcoords(levels_of(draw, model));
    draw.state.transform.vertex_lighting.reset();
    draw.state.blend = {};
    draw.state.depth.write = true;
  }
}

/// One colour for each pixel that was drawn (alpha is not 0 there).
template <class ColourOf>
Image<Rgba8> coloured(const Image<Rgba32F>& numbers, ColourOf&& colour_of) {
  Image<Rgba8> image(numbers.width(), numbers.height(), kNothing);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (numbers.at(x, y).a > 0) image.at(x, y) = colour_of(numbers.at(x, y));
  return image;
}

ViewPicture normals_picture(const Image<Rgba32F>& numbers) {
  return {coloured(numbers, [](const Rgba32F& n) { return Rgba8{code_of(n.r * 0.5f + 0.5f), code_of(n.g * 0.5f + 0.5f), code_of(n.b * 0.5f + 0.5f), 255}; }),
          "red, green, blue: x, y, z of the unit normal in world space, codes 0 to 255 for -1 to 1"};
}

std::string range_text(const char* name, float low, float high) {
  char text[64];
  std::snprintf(text, sizeof text, "%s %.3f to %.3f", name, static_cast<double>(low), static_cast<double>(high));
  return text;
}

ViewPicture uv_picture(const Image<Rgba32F>& numbers) {
  const float inf = std::numeric_limits<float>::infinity();
  float low_u = inf, high_u = -inf, low_v = inf, high_v = -inf;
  auto image = coloured(numbers, [&](const Rgba32F& n) {
    low_u = std::min(low_u, n.r), high_u = std::max(high_u, n.r);
    low_v = std::min(low_v, n.g), high_v = std::max(high_v, n.g);
    const float u = n.r - std::floor(n.r), v = n.g - std::floor(n.g);
    const bool odd = (static_cast<int>(u * 8) + static_cast<int>(v * 8)) % 2 != 0;
    return Rgba8{code_of(u), code_of(v), static_cast<std::uint8_t>(odd ? 96 : 0), 255};
  });
  if (low_u > high_u) return {std::move(image), "no mesh has texture coordinates"};
  return {std::move(image), "texture space: red " + range_text("u", low_u, high_u) + ", green " + range_text("v", low_v, high_v) +
                                " (their fractions), blue: squares of 1/8"};
}

/// A colour for each level; between levels they are mixed, as trilinear filtering mixes the levels.
Rgba8 level_colour(float level) {
  constexpr std::array<std::array<float, 3>, 8> kLevels{{{225, 225, 225}, {70, 110, 230}, {50, 190, 220}, {60, 190, 90},
                                                         {220, 210, 50}, {240, 140, 40}, {220, 50, 40}, {200, 60, 200}}};
  const float at = std::clamp(level, 0.0f, static_cast<float>(kLevels.size() - 1));
  const auto first = std::min(static_cast<std::size_t>(at), kLevels.size() - 2);
  const auto mixed = [&](std::size_t c) {
    return static_cast<std::uint8_t>(std::lround(std::lerp(kLevels[first][c], kLevels[first + 1][c], at - static_cast<float>(first))));
  };
  return {mixed(0), mixed(1), mixed(2), 255};
}

ViewPicture lod_picture(const Image<Rgba32F>& numbers) {
  ValueRange range{.low = std::numeric_limits<float>::infinity()};
  auto image = coloured(numbers, [&](const Rgba32F& n) {
    range.low = std::min(range.low, n.b), range.high = std::max(range.high, n.b);
    return level_colour(n.b);
  });
  if (range.low > range.high) return {std::move(image), "no mesh has texture coordinates"};
  return {std::move(image), "level of detail, " + range_text("levels", range.low, range.high) +
                                ": 0 white, 1 blue, 2 cyan, 3 green, 4 yellow, 5 orange, 6 red, 7 and more violet"};
}

/// Lines with the hidden ones removed: the surface is drawn first, without colours and pushed back.
void make_wireframe(Frame& frame) {
  std::vector<DrawCall> lines = frame.draws;
  for (DrawCall& draw : frame.draws) {
    draw.state.blend = {.write = false};
    draw.state.depth.write = true;
    draw.state.rasterization.polygon_offset = {.factor = frame.far_depth > 0 ? 1.0f : -1.0f, .units = frame.far_depth > 0 ? 1.0f : -1.0f};
  }
  for (DrawCall& draw : lines) {
    draw.state.rasterization.front_mode = draw.state.rasterization.back_mode = PolygonMode::line;
    draw.state.depth.test = frame.far_depth > 0 ? Compare::less_equal : Compare::greater_equal;
    draw.state.blend = {};
    draw.state.transform.vertex_lighting.reset();
    draw.mesh.colours = {};
    draw.program = gouraud();
    frame.draws.push_back(draw);
  }
}

ViewPicture picture_of(View view, Frame& frame, const FrameMaps& maps) {
  const auto heat = [](const Image<float>& values, const char* unit, bool logarithmic) {
    const ValueRange range = range_of(values);
    return ViewPicture{heat_image(values, range, logarithmic), legend_of(range, unit, logarithmic)};
  };
  switch (view) {
    case View::overdraw: return heat(maps.overdraw, "fragments a pixel", false);
    case View::tiles: return heat(maps.tile_load, "primitives a tile of 64x64 pixels", true);
    case View::triangle_size: return heat(maps.triangle_size, "pixels of screen area a triangle", true);
    case View::depth: return depth_picture(frame);
    case View::normals: return normals_picture(frame.target.linear_image());
    case View::uv: return uv_picture(frame.target.linear_image());
    case View::lod: return lod_picture(frame.target.linear_image());
    case View::wireframe: return {frame.target.colour_image(), "the triangles' edges, hidden ones left out"};
    case View::colour: break;
  }
  return {frame.target.colour_image(), "the model's colours"};
}

}  // namespace

std::vector<std::string> view_names() { return {kNames.begin(), kNames.end()}; }

std::optional<View> view_named(std::string_view name) noexcept {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<View>(found - kNames.begin());
}

ViewPicture depth_picture(const Frame& frame) {
  Image<float> depths = frame.target.depth_image();
  for (float& depth : depths.pixels())
    if (depth == frame.far_depth) depth = -1;
  const ValueRange range = range_of(depths, -0.5f);
  return {heat_image(depths, range, false, -0.5f), legend_of(range, "depth in screen space")};
}

Result<ViewPicture> draw_view(View view, const Model& model, const RenderOptions& options, Pipeline& pipeline) {
  RenderOptions adapted = options;
  const bool numbers = view == View::normals || view == View::uv || view == View::lod;
  if (numbers) {
    adapted.colour_format = ColourFormat::rgba32f;
    adapted.background = {0, 0, 0, 0};
  }
  auto frame = prepare(model, adapted);
  if (!frame) return frame.error();
  if (numbers) replace_programs(*frame, model, view);
  if (view == View::wireframe) make_wireframe(*frame);

  const bool watched = view == View::overdraw || view == View::tiles || view == View::triangle_size;
  FrameMaps maps(options.width_pixels, options.height_pixels);
  clear(*frame, pipeline);
  const auto drawn = draw(*frame, pipeline, watched ? &maps : nullptr);
  if (!drawn) return drawn.error();
  return picture_of(view, *frame, maps);
}

}  // namespace tuberia::cli
