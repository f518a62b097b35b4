#include <algorithm>

#include "examples/tuberia/stage_text.hpp"
#include "examples/tuberia/stage_words.hpp"

namespace tuberia::cli {
namespace {

using Json = nlohmann::ordered_json;

Json colour(const Rgba32F& c) { return {c.r, c.g, c.b, c.a}; }
Json rectangle(const PixelRect& r) { return {{"left", r.left}, {"top", r.top}, {"right", r.right}, {"bottom", r.bottom}}; }
Json clip(const ClipPosition& p) { return {p.x, p.y, p.z, p.w}; }

Json contents(const SampleContents& s) {
  Json out{{"colour_linear", colour(s.colour)}};
  if (s.codes) out["colour_codes"] = {s.codes->r, s.codes->g, s.codes->b, s.codes->a};
  out["depth_code"] = s.depth;
  if (s.stencil) out["stencil"] = *s.stencil;
  return out;
}

Json sample(const FragmentRecord& fragment, const SampleRecord& s, const RecordedDraw& draw) {
  Json out{{"sample", s.sample}, {"depth_screen", s.depth_value}};
  out["depth_code"] = s.depth_code ? Json(*s.depth_code) : Json();
  out["lived"] = !s.died_at;
  out["died_at"] = s.died_at ? Json(name_of(*s.died_at)) : Json();
  out["fate"] = fate_of(fragment, s, draw);
  out["before"] = contents(s.before);
  out["after"] = contents(s.after);
  return out;
}

Json fragment(const FragmentRecord& f, const RecordedDraw& draw) {
  Json out{{"x_pixels", f.x}, {"y_pixels", f.y}, {"draw", f.draw}, {"primitive", f.primitive}, {"back_face", f.is_back}};
  out["vertices_of_mesh"] = f.vertex;
  out["weights_screen"] = f.weight;
  out["weights_perspective"] = f.perspective;
  out["colour_program_linear"] = f.colour ? colour(*f.colour) : Json();
  out["stages"] = Json::array();
  for (const Stage stage : f.stages) out["stages"].push_back(name_of(stage));
  out["lived"] = f.reached_the_target();
  out["samples"] = Json::array();
  for (const SampleRecord& s : f.samples) out["samples"].push_back(sample(f, s, draw));
  return out;
}

Json draw_state(const RecordedDraw& draw) {
  const OutputState& o = draw.output;
  return {{"program", draw.program}, {"depth_test", sign_of(o.depth.test)}, {"depth_write", o.depth.write},
          {"alpha_test", sign_of(o.alpha_test.test)}, {"alpha_reference", o.alpha_test.reference}, {"stencil_enabled", o.stencil.enabled},
          {"blend_write", o.blend.write}};
}

Json vertices(const PrimitiveLife& life) {
  Json out = Json::array();
  for (const PrimitiveVertex& v : life.vertices) {
    Json one{{"number_in_mesh", v.number}};
    one["object"] = v.object ? Json{v.object->value.x, v.object->value.y, v.object->value.z} : Json();
    one["clip"] = clip(v.clip);
    one["outside_of"] = planes_of(v.outcode);
    one["beyond_view_borders"] = view_borders_of(v.clip, life.limits);
    out.push_back(std::move(one));
  }
  return out;
}

Json corners(const PrimitiveLife& life) {
  Json out = Json::array();
  const auto named = named_attributes(life.attributes);
  for (const PrimitiveCorner& c : life.corners) {
    Json one{{"made_by_clipping", c.is_new}, {"slot", c.slot}, {"weights_of_vertices", c.weight}, {"clip", clip(c.clip)}, {"ndc", c.ndc},
             {"screen_units", {c.x_units, c.y_units}}, {"screen_pixels", {c.x_units / 256.0, c.y_units / 256.0}}, {"depth_screen", c.depth}};
    one["attributes"] = Json::object();
    for (const NamedAttribute& attribute : named) {
      if (c.attributes.empty()) continue;
      const auto first = c.attributes.begin() + attribute.offset;
      one["attributes"][attribute.name] = std::vector<float>(first, first + attribute.scalars);
    }
    out.push_back(std::move(one));
  }
  return out;
}

Json piece(const PrimitiveLife& life, const PrimitivePiece& p) {
  const std::vector<std::size_t> used(p.corner.begin(), p.corner.begin() + p.corner_count);
  Json out{{"corners", used}, {"twice_area_square_units", p.twice_area}, {"area_pixels", std::abs(static_cast<double>(p.twice_area)) / 131072},
           {"front_face", p.is_front}, {"drawn", p.verdict == PrimitivePiece::Verdict::drawn}, {"verdict", words_of(p.verdict)}};
  if (!p.set_up) return out;
  out["bounds_pixels"] = rectangle({p.set_up->left, p.set_up->top, p.set_up->right + 1, p.set_up->bottom + 1});
  out["affine"] = p.set_up->perspective == kIsAffine;
  out["tiles"] = p.tiles;
  out["blocks"] = p.blocks;
  out["edges"] = Json::array();
  for (std::size_t k = 0; k < 3 && !p.shape; ++k) {
    const EdgeWords edge = edge_of(life, p, k);
    out["edges"].push_back({{"from", p.clockwise[(k + 1) % 3]}, {"to", p.clockwise[(k + 2) % 3]}, {"per_x", edge.per_x}, {"per_y", edge.per_y},
                            {"kind", edge.kind}, {"owns_its_centres", edge.top_left}});
  }
  return out;
}

Json frame(const StageReport& report) {
  const RenderTarget& target = report.frame.target;
  return {{"caption", report.caption}, {"width_pixels", target.width()}, {"height_pixels", target.height()},
          {"colour_format", name_of(target.colour_format())}, {"depth_format", name_of(target.depth_format())},
          {"draws", report.frame.draws.size()}, {"primitives", report.first_primitive.back()}};
}

}  // namespace

Json primitive_json(const StageReport& report) {
  const PrimitiveLife& life = report.life;
  const auto draw = static_cast<std::size_t>(report.draw);
  Json out{{"frame", frame(report)}, {"primitive_of_frame", report.first_primitive[draw] + report.primitive}, {"draw", report.draw},
           {"primitive_of_draw", report.primitive}, {"mesh", report.mesh_of_draw[draw]}, {"state", draw_state(life.draw)}};
  out["viewport_pixels"] = {{"x", life.viewport.x}, {"y", life.viewport.y}, {"width", life.viewport.width_pixels}, {"height", life.viewport.height_pixels}};
  out["clip_limits"] = {{"guard_x", life.limits.guard_x}, {"guard_y", life.limits.guard_y}, {"z_low", life.limits.z_low}};
  out["vertices"] = vertices(life);
  out["clipping"] = words_of(life.clip);
  out["corners"] = corners(life);
  out["triangles"] = Json::array();
  for (const PrimitivePiece& p : life.pieces) out["triangles"].push_back(piece(life, p));
  const FragmentFates& fates = life.fates;
  out["fates"] = {{"covered", fates.covered}, {"discarded", fates.discarded}, {"failed_alpha", fates.failed_alpha},
                  {"failed_depth", fates.failed_depth}, {"reached", fates.reached}};
  out["covered_pixels"] = rectangle(life.covered);
  out["window_pixels"] = rectangle(report.window);
  out["fragments_in_window"] = Json::array();
  for (const FragmentRecord& f : life.fragments) {
    out["fragments_in_window"].push_back(fragment(f, life.draw));
    out["fragments_in_window"].back()["draw"] = report.draw;  // the recorder saw only this one
    out["fragments_in_window"].back()["slots"] = f.slot;
  }
  return out;
}

Json pixel_json(const StageReport& report) {
  const PixelHistory& pixel = *report.pixel;
  Json out{{"frame", frame(report)}, {"x_pixels", pixel.x}, {"y_pixels", pixel.y}};
  out["cleared_to"] = Json::array();
  for (const SampleContents& s : pixel.initial) out["cleared_to"].push_back(contents(s));
  out["draws"] = Json::array();
  for (const RecordedDraw& draw : pixel.draws) out["draws"].push_back(draw_state(draw));
  out["fragments"] = Json::array();
  for (const FragmentRecord& f : pixel.fragments) out["fragments"].push_back(fragment(f, pixel.draws[static_cast<std::size_t>(f.draw)]));
  return out;
}

}  // namespace tuberia::cli
