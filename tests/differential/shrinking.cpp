#include "tests/differential/shrinking.hpp"

#include <functional>
#include <sstream>

namespace tuberia::differential {
namespace {

bool disagrees(const Scene& scene, Machines& machines) {
  std::string first;
  const Tally tally = compare(scene, machines, first);
  return tally.disagreements() > tally.refusals;  // a scene without vertices is refused, which is another matter
}

/// Keeps a change if the machines still disagree after it.
bool keep_if_wrong(Scene& scene, Machines& machines, const std::function<void(Scene&)>& change) {
  Scene changed = scene;
  change(changed);
  if (!disagrees(changed, machines)) return false;
  scene = std::move(changed);
  return true;
}

/// State back to its default, one part at a time.
void plain_state(Scene& scene, Machines& machines, std::size_t i) {
  using oracle::Draw;
  const Draw plain;
  const auto reset = [&](auto Draw::*member) {
    keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].*member = plain.*member; });
  };
  reset(&Draw::user_planes);
  reset(&Draw::viewport);
  reset(&Draw::scissor);
  reset(&Draw::near_depth);
  reset(&Draw::far_depth);
  reset(&Draw::cull);
  reset(&Draw::front_face);
  reset(&Draw::two_sided_colours);
  reset(&Draw::front_mode);
  reset(&Draw::back_mode);
  reset(&Draw::polygon_offset);
  reset(&Draw::flat_shading);
  reset(&Draw::subpixel_bits);
  reset(&Draw::perspective);
  reset(&Draw::edge_arithmetic);
  reset(&Draw::point_size_pixels);
  reset(&Draw::round_points);
  reset(&Draw::line_width_pixels);
  reset(&Draw::stipple);
  reset(&Draw::program);
  reset(&Draw::fog);
  reset(&Draw::has_fog_coordinates);
  reset(&Draw::alpha_test);
  reset(&Draw::alpha_to_coverage);
  reset(&Draw::stencil);
  reset(&Draw::depth_test);
  reset(&Draw::depth_write);
  reset(&Draw::blend);
  reset(&Draw::volume);
  reset(&Draw::texcoord_units);
  reset(&Draw::has_unit_texcoords);
  reset(&Draw::view_from_world);
  reset(&Draw::vertex_lighting);
  reset(&Draw::back_lighting);
  reset(&Draw::has_colours);
  reset(&Draw::has_back_colours);
  reset(&Draw::world_from_object);
  reset(&Draw::clip_from_world);
}

/// What is left of blending and the texture units after that.
void plain_parts(Scene& scene, Machines& machines, std::size_t i) {
  keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].blend.mask = {true, true, true, true}; });
  keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].blend.colour = {}; });
  keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].blend.alpha = {}; });
  keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].depth_test = oracle::Compare::always; });
  for (std::size_t k = 0; k < oracle::kTextureUnits; ++k) {
    keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].program.units[k] = {}; });
    keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].program.units[k].colour = {}; });
    keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].program.units[k].alpha = {}; });
  }
}

void fewer_vertices(Scene& scene, Machines& machines, std::size_t i) {
  keep_if_wrong(scene, machines, [&](Scene& s) {  // without indices
    oracle::Draw& draw = s.draws[i];
    std::vector<oracle::InputVertex> vertices;
    for (const std::uint32_t index : draw.indices) vertices.push_back(draw.vertices[index]);
    if (!vertices.empty()) draw.vertices = vertices;
    draw.indices.clear();
  });
  if (!scene.draws[i].indices.empty()) return;
  for (const std::size_t step : {3u, 2u, 1u})
    for (std::size_t at = 0; at + step <= scene.draws[i].vertices.size();)
      if (!keep_if_wrong(scene, machines, [&](Scene& s) {
            auto& vertices = s.draws[i].vertices;
            vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(at), vertices.begin() + static_cast<std::ptrdiff_t>(at + step));
          }))
        at += step;
  for (std::size_t v = 0; v < scene.draws[i].vertices.size(); ++v)
    keep_if_wrong(scene, machines, [&](Scene& s) { s.draws[i].vertices[v].colour = glm::vec4(1); });
}

template <class T>
void tell_if(std::ostream& out, const char* name, const T& value, const T& plain) {
  if (value != plain) out << "  " << name << " " << +static_cast<std::conditional_t<std::is_enum_v<T>, int, T>>(value) << "\n";
}

void describe_geometry(std::ostream& out, const oracle::Draw& d) {
  const oracle::Draw p;
  out << "draw: topology " << static_cast<int>(d.topology) << ", positions in space " << static_cast<int>(d.space) << "\n";
  tell_if(out, "volume", d.volume, p.volume);
  for (const auto& plane : d.user_planes) out << "  user plane " << plane.x << " " << plane.y << " " << plane.z << " " << plane.w << "\n";
  if (d.viewport) out << "  viewport " << d.viewport->x << " " << d.viewport->y << " " << d.viewport->width << " " << d.viewport->height << "\n";
  if (d.scissor) out << "  scissor " << d.scissor->left << " " << d.scissor->top << " " << d.scissor->right << " " << d.scissor->bottom << "\n";
  tell_if(out, "near_depth", d.near_depth, p.near_depth);
  tell_if(out, "far_depth", d.far_depth, p.far_depth);
  tell_if(out, "front_face", d.front_face, p.front_face);
  tell_if(out, "cull", d.cull, p.cull);
  tell_if(out, "two_sided_colours", d.two_sided_colours, p.two_sided_colours);
  tell_if(out, "front_mode", d.front_mode, p.front_mode);
  tell_if(out, "back_mode", d.back_mode, p.back_mode);
  const auto& o = d.polygon_offset;
  if (o.factor != 0 || o.units != 0)
    out << "  offset factor " << o.factor << " units " << o.units << " clamp " << o.clamp << " fill " << o.fill << " line " << o.line << " point " << o.point << "\n";
  tell_if(out, "flat_shading", d.flat_shading, p.flat_shading);
  tell_if(out, "subpixel_bits", d.subpixel_bits, p.subpixel_bits);
  tell_if(out, "perspective", d.perspective, p.perspective);
  tell_if(out, "edge_arithmetic", d.edge_arithmetic, p.edge_arithmetic);
  tell_if(out, "point_size", d.point_size_pixels, p.point_size_pixels);
  tell_if(out, "round", d.round_points, p.round_points);
  tell_if(out, "line_width", d.line_width_pixels, p.line_width_pixels);
  if (d.stipple) out << "  stipple " << d.stipple->bits << " factor " << d.stipple->factor << "\n";
}

void describe_lighting(std::ostream& out, const char* name, const std::optional<oracle::Lighting>& lighting) {
  if (!lighting) return;
  const auto triple = [&](const char* what, const glm::vec3& v) { out << " " << what << " " << v.x << " " << v.y << " " << v.z; };
  out << "  " << name << ": halfway " << lighting->halfway << " two-sided " << lighting->two_sided << " shininess " << lighting->shininess;
  triple("ambient", lighting->ambient);
  triple("diffuse", lighting->diffuse);
  triple("specular", lighting->specular);
  triple("eye", lighting->eye);
  for (const oracle::Light& light : lighting->lights) {
    triple(light.is_point ? "; light at" : "; light from", light.towards);
    triple("of", light.intensity);
    out << " falloff " << static_cast<int>(light.falloff) << " with " << light.falloff_distance;
    if (light.is_spot) triple("along", light.axis), out << " within cosines " << light.cos_inner << " and " << light.cos_outer;
  }
  out << "\n";
}

void describe_program(std::ostream& out, const oracle::Draw& d) {
  const oracle::Draw p;
  tell_if(out, "program", d.program.kind, p.program.kind);
  if (d.program.texture != nullptr) {
    const auto& s = d.program.sampler;
    out << "  texture " << d.program.texture->width << "x" << d.program.texture->height << " srgb " << d.program.texture->is_srgb << " filter "
        << static_cast<int>(s.texels) << " mipmaps " << static_cast<int>(s.mipmaps) << " anisotropy " << s.max_anisotropy << " lod " << s.lod_bias << " in " << s.min_lod << " to " << s.max_lod << " wraps " << static_cast<int>(s.wrap_u) << " " << static_cast<int>(s.wrap_v) << " cut out "
        << d.program.cut_out << " below " << d.program.alpha_cutoff << "\n";
  }
  for (const auto& unit : d.program.units) {
    if (unit.texture == nullptr) continue;
    const auto& s = unit.sampler;
    out << "  unit: texture kind " << static_cast<int>(unit.texture->kind) << " " << unit.texture->width << "x" << unit.texture->height
        << "x" << unit.texture->slices << " srgb " << unit.texture->is_srgb << " depth " << unit.texture->is_depth << " filter "
        << static_cast<int>(s.texels) << " mipmaps " << static_cast<int>(s.mipmaps) << " anisotropy " << s.max_anisotropy << " lod " << s.lod_bias << " in " << s.min_lod << " to " << s.max_lod << " wraps " << static_cast<int>(s.wrap_u) << " "
        << static_cast<int>(s.wrap_v) << " " << static_cast<int>(s.wrap_w) << " compare " << (s.compare ? static_cast<int>(*s.compare) : -1)
        << " colour " << static_cast<int>(unit.colour.function) << " alpha " << static_cast<int>(unit.alpha.function) << "\n";
  }
}

void describe_fragments(std::ostream& out, const oracle::Draw& d) {
  const oracle::Draw p;
  if (d.fog.mode != p.fog.mode)
    out << "  fog " << static_cast<int>(d.fog.mode) << " density " << d.fog.density << " " << d.fog.start << " to " << d.fog.end
        << " own coordinates " << d.has_fog_coordinates << "\n";
  tell_if(out, "alpha_test", d.alpha_test, p.alpha_test);
  tell_if(out, "alpha_reference", d.alpha_reference, p.alpha_reference);
  tell_if(out, "alpha_to_coverage", d.alpha_to_coverage, p.alpha_to_coverage);
  if (d.stencil.enabled)
    for (const auto& f : {d.stencil.front, d.stencil.back})
      out << "  stencil test " << static_cast<int>(f.test) << " reference " << int{f.reference} << " masks " << int{f.read_mask} << " "
          << int{f.write_mask} << " operations " << static_cast<int>(f.fail) << " " << static_cast<int>(f.depth_fail) << " "
          << static_cast<int>(f.pass) << "\n";
  tell_if(out, "depth_test", d.depth_test, p.depth_test);
  tell_if(out, "depth_write", d.depth_write, p.depth_write);
  const auto& b = d.blend;
  tell_if(out, "blend mode", b.mode, p.blend.mode);
  tell_if(out, "colour write", b.write, p.blend.write);
  if (b.mode == oracle::BlendMode::function)
    for (const auto& f : {b.colour, b.alpha})
      out << "  function " << static_cast<int>(f.source) << " " << static_cast<int>(f.destination) << " " << static_cast<int>(f.equation) << "\n";
  tell_if(out, "logic", b.logic, p.blend.logic);
  if (b.mask != p.blend.mask) out << "  mask " << b.mask[0] << b.mask[1] << b.mask[2] << b.mask[3] << "\n";
}

void describe_vertices(std::ostream& out, const oracle::Draw& d) {
  const oracle::TexCoordUnit plain_unit;
  for (const auto& unit : d.texcoord_units) {
    if (unit.matrix == plain_unit.matrix && unit.source == plain_unit.source) continue;
    out << "  texture coordinates from " << static_cast<int>(unit.source[0]) << static_cast<int>(unit.source[1])
        << static_cast<int>(unit.source[2]) << static_cast<int>(unit.source[3]) << ", matrix";
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) out << " " << unit.matrix[column][row];
    out << "\n";
  }
  if (d.has_unit_texcoords) out << "  own texture coordinates for each unit\n";
  for (const auto& v : d.vertices) {
    if (d.space == oracle::PositionSpace::screen) out << "  vertex " << v.screen_x << " " << v.screen_y << " " << v.screen_depth << " w " << v.position.w;
    else out << "  vertex " << v.position.x << " " << v.position.y << " " << v.position.z << " " << v.position.w;
    out << "  colour " << v.colour.r << " " << v.colour.g << " " << v.colour.b << " " << v.colour.a << " texcoord " << v.texcoord.x << " "
        << v.texcoord.y << " flag " << v.edge_flag;
    if (d.has_normals) out << " normal " << v.normal.x << " " << v.normal.y << " " << v.normal.z;
    out << "\n";
  }
  if (!d.indices.empty()) out << "  indices";
  for (const std::uint32_t index : d.indices) out << " " << index;
  out << "\n";
}

void describe(std::ostream& out, const oracle::Clear& clear) {
  out << "after the first draw a clear: mask " << clear.mask[0] << clear.mask[1] << clear.mask[2] << clear.mask[3];
  if (clear.colour) out << " colour " << clear.colour->r << " " << clear.colour->g << " " << clear.colour->b << " " << clear.colour->a;
  if (clear.depth) out << " depth " << *clear.depth;
  if (clear.stencil) out << " stencil " << int{*clear.stencil} << " mask " << int{clear.stencil_write_mask};
  if (clear.scissor) out << " scissor " << clear.scissor->left << " " << clear.scissor->top << " " << clear.scissor->right << " " << clear.scissor->bottom;
  out << "\n";
}

void describe(std::ostream& out, const oracle::Draw& draw) {
  describe_geometry(out, draw);
  describe_lighting(out, "lighting", draw.vertex_lighting);
  describe_lighting(out, "lighting of backs", draw.back_lighting);
  describe_program(out, draw);
  describe_fragments(out, draw);
  describe_vertices(out, draw);
}

}  // namespace

Scene shrunk(Scene scene, Machines& machines) {
  keep_if_wrong(scene, machines, [](Scene& s) { s.clear.reset(); });
  for (std::size_t i = scene.draws.size(); i-- > 0 && scene.draws.size() > 1;)
    keep_if_wrong(scene, machines, [&](Scene& s) { s.draws.erase(s.draws.begin() + static_cast<std::ptrdiff_t>(i)); });
  for (std::size_t i = 0; i < scene.draws.size(); ++i) {
    fewer_vertices(scene, machines, i);
    plain_state(scene, machines, i);
    plain_parts(scene, machines, i);
    fewer_vertices(scene, machines, i);
  }
  keep_if_wrong(scene, machines, [](Scene& s) { s.target.samples = 1; });
  keep_if_wrong(scene, machines, [](Scene& s) { s.threads = 1; });
  keep_if_wrong(scene, machines, [](Scene& s) { s.instruction_set = InstructionSet::baseline; });
  keep_if_wrong(scene, machines, [](Scene& s) { s.target.colour = oracle::ColourFormat::rgba8; });
  return scene;
}

std::string described(const Scene& scene) {
  std::ostringstream out;
  out.precision(9);
  const TargetDescription& t = scene.target;
  out << "target " << t.width << "x" << t.height << ", " << t.samples << " samples, colour format " << static_cast<int>(t.colour)
      << ", depth format " << static_cast<int>(t.depth) << ", stencil " << t.has_stencil << "; cleared to " << t.clear_colour.r << " "
      << t.clear_colour.g << " " << t.clear_colour.b << " " << t.clear_colour.a << ", depth " << t.clear_depth << ", stencil "
      << int{t.clear_stencil} << "; " << (scene.is_counted ? "counted, " : "uncounted, ") << scene.threads << " threads, " << name_of(scene.instruction_set) << "\n";
  if (scene.clear) describe(out, *scene.clear);
  for (const oracle::Draw& draw : scene.draws) describe(out, draw);
  return out.str();
}

std::string explained(const Scene& scene, Machines& machines) {
  std::string first;
  const Scene small = disagrees(scene, machines) ? shrunk(scene, machines) : scene;
  compare(small, machines, first);
  return first + "\n" + described(small);
}

}  // namespace tuberia::differential
