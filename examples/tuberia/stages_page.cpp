#include "examples/tuberia/stages_page.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

#include "examples/tuberia/embedded_image.hpp"
#include "examples/tuberia/heat.hpp"
#include "examples/tuberia/stage_text.hpp"
#include "examples/tuberia/stages_page_parts.hpp"
#include "examples/tuberia/views.hpp"

namespace tuberia::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kMostTriangles = 4000;  // of the model, seen from outside

Json map(const char* title, const Image<Rgba8>& image, std::string legend) {
  return {{"title", title}, {"legend", std::move(legend)}, {"picture", data_url(image)}};
}

Json heat_map(const char* title, const Image<float>& values, const char* unit, bool logarithmic) {
  const ValueRange range = range_of(values);
  return map(title, heat_image(values, range, logarithmic), legend_of(range, unit, logarithmic));
}

Json maps(const StageReport& report) {
  const ViewPicture depth = depth_picture(report.frame);
  return {map("The picture", report.frame.target.colour_image(), "as the target holds it"),
          heat_map("Overdraw", report.maps.overdraw, "fragments a pixel", false),
          heat_map("Triangle size", report.maps.triangle_size, "pixels of area", true),
          heat_map("Tile load", report.maps.tile_load, "primitives a tile of 64x64 pixels", true), map("Depth", depth.image, depth.legend)};
}

/// Four digits are plenty for a picture, and keep the page small.
double rounded(double value, double step) { return std::round(value / step) * step; }

void add_point(Json& list, const glm::dvec3& p, double step) {
  for (int c = 0; c < 3; ++c) list.push_back(static_cast<float>(rounded(p[c], step)));
}

/// Triangles evenly picked from all meshes.
Json triangles_world(const StageReport& report, const Model& model, std::int64_t stride) {
  const glm::dmat4 world_from_object(report.frame.world_from_object);
  const double step = std::max(static_cast<double>(model.bounds().radius()), 1e-30) * 5e-5;
  Json list = Json::array();
  std::int64_t number = 0;
  for (const Mesh& mesh : model.meshes)
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      if (number++ % stride == 0)
        for (std::size_t k = 0; k < 3; ++k)
          add_point(list, glm::dvec3(world_from_object * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1)), step);
  return list;
}

/// Its four near corners round the window, then the far ones.
Json frustum_world(const StageReport& report) {
  const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(report.frame.matrices.clip_from_world));
  Json corners = Json::array();
  const double low = static_cast<double>(report.life.limits.z_low);
  // Reversed depth has the near plane at the upper end.
  const bool reversed = report.frame.far_depth < 0.5f;
  for (const double z : {reversed ? 1.0 : low, reversed ? low : 1.0})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      const glm::dvec4 p = world_from_clip * glm::dvec4(x, y, z, 1);
      corners.push_back({p.x / p.w, p.y / p.w, p.z / p.w});
    }
  return corners;
}

Json scene(const StageReport& report, const Model& model) {
  const std::int64_t all = model.triangle_count(), stride = std::max<std::int64_t>(1, (all + kMostTriangles - 1) / kMostTriangles);
  Json out;
  out["view_from_world"] = Json::array();
  const glm::mat4& view = report.frame.matrices.view_from_world;
  for (int r = 0; r < 3; ++r) out["view_from_world"].push_back({view[0][r], view[1][r], view[2][r], view[3][r]});
  out["frustum_world"] = frustum_world(report);
  out["primitive_world"] = Json::array();
  for (const PrimitiveVertex& v : report.life.vertices)
    if (v.object) {
      const glm::vec4 p = report.frame.world_from_object * glm::vec4(v.object->value, 1);
      out["primitive_world"].push_back({p.x, p.y, p.z});
    }
  out["triangles_world"] = triangles_world(report, model, stride);
  out["triangles_all"] = all;
  out["triangles_shown"] = (all + stride - 1) / stride;
  return out;
}

/// "</" would end the element that holds the data; a slash may always be written "\/" in JSON.
std::string safe(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '/' && i > 0 && text[i - 1] == '<') out += '\\';
    out += text[i];
  }
  return out;
}

std::string replaced(const std::string& page, std::string_view mark, std::string_view with) {
  const std::size_t at = page.find(mark);
  return page.substr(0, at) + std::string(with) + page.substr(at + mark.size());
}

}  // namespace

std::string stages_page(const StageReport& report, const Model& model) {
  Json data{{"primitive", primitive_json(report)}};
  data["pixel"] = report.pixel ? pixel_json(report) : Json();
  data["cleared_depth_code"] = code_of_depth(report.frame.far_depth, report.frame.target.depth_format());
  data["scene"] = scene(report, model);
  data["maps"] = maps(report);

  std::string scripts;
  for (const std::string_view script : kStagesScripts) scripts += script;
  const std::string page = replaced(replaced(std::string(kStagesPage), "/*SCRIPT*/", scripts), "/*STYLE*/", kStagesStyle);
  // Names of files and meshes may hold any bytes; what is not UTF-8 is replaced.
  return replaced(page, "/*DATA*/", safe(data.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

}  // namespace tuberia::cli
