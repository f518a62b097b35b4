#pragma once
// The options of every command that draws a model: how large, how shaded, seen from where.

#include "examples/tuberia/render_model.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <utility>

namespace tuberia::cli {

struct PictureArguments {
  std::string size = "1280x720", shading = "auto", filter = "trilinear", format = "srgb8", depth_format = "d24";
  std::string perspective = "each-pixel", edges = "exact", filter_weights = "float", footprint = "usual", fog = "off", normals = "renormalized";
  float anisotropy = 1;
  std::vector<float> fog_range{0, 1}, fog_colour{0.5f, 0.5f, 0.5f};
  std::vector<float> background{0.035f, 0.04f, 0.055f};
  RenderOptions options;  // what needs no translation
};

/// "1920x1080" to two numbers. Error naming --size.
Result<std::pair<int, int>> parse_size(const std::string& text);

void add_picture_options(CLI::App& command, PictureArguments& arguments);

/// Error when --size is not a size.
Result<RenderOptions> render_options_of(const PictureArguments& arguments);

}  // namespace tuberia::cli
