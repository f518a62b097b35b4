#pragma once
// Pictures of a model that show how it was drawn.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "examples/tuberia/render_model.hpp"

namespace tuberia::cli {

enum class View { colour, overdraw, depth, normals, uv, lod, tiles, triangle_size, wireframe };

std::vector<std::string> view_names();
std::optional<View> view_named(std::string_view name) noexcept;

struct ViewPicture {
  Image<Rgba8> image;
  std::string legend;  // what the colours mean, with the range of values
};

/// Errors as prepare(); `normals` and `uv` of meshes without them are left out.
Result<ViewPicture> draw_view(View view, const Model& model, const RenderOptions& options, Pipeline& pipeline);

/// Depths of what was drawn, near dark; where the buffer was not touched nothing.
ViewPicture depth_picture(const Frame& frame);

}  // namespace tuberia::cli
