#include "tests/differential/translation.hpp"

#include "pipeline/programs/programs.hpp"
#include "tests/differential/random_state.hpp"

namespace tuberia::differential {
namespace {

/// Both sides list their choices in the documents' order.
template <class To, class From>
constexpr To same(From choice) {
  return static_cast<To>(static_cast<int>(choice));
}

Rgba32F rgba(const glm::vec4& c) { return {c.r, c.g, c.b, c.a}; }

FragmentProgram program_of(const oracle::Program& program) {
  if (program.kind == oracle::ProgramKind::flat) return flat();
  if (program.kind == oracle::ProgramKind::gouraud) return gouraud();
  Image<Rgba8> image(program.texture->width, program.texture->height);
  for (std::size_t i = 0; i < program.texture->texels.size(); ++i) {
    const auto& t = program.texture->texels[i];
    image.pixels()[i] = {t[0], t[1], t[2], t[3]};
  }
  const auto encoding = program.texture->is_srgb ? TextureEncoding::srgb : TextureEncoding::linear;
  TexturedUniforms uniforms;
  uniforms.texture = std::make_shared<const Texture>(*Texture::create(image, encoding, false));
  uniforms.sampler = {.texels = same<TexelFilter>(program.sampler.texels),
                      .mipmaps = MipmapFilter::none,
                      .wrap_u = same<Wrap>(program.sampler.wrap_u),
                      .wrap_v = same<Wrap>(program.sampler.wrap_v),
                      .border = rgba(program.sampler.border)};
  uniforms.tint = program.tint;
  uniforms.alpha_cutoff = program.alpha_cutoff;
  if (program.kind == oracle::ProgramKind::textured_gouraud) return textured_gouraud(std::move(uniforms));
  return textured(std::move(uniforms), program.cut_out);
}

void translate_geometry(const oracle::Draw& draw, PipelineState& state) {
  state.transform.clip_from_world = draw.clip_from_object;
  state.transform.two_sided_colours = draw.two_sided_colours;
  state.assembly.topology = same<Topology>(draw.topology);
  state.clipping.volume = same<ClipVolume>(draw.volume);
  for (const glm::dvec4& plane : draw.user_planes)
    state.clipping.user_planes[static_cast<std::size_t>(state.clipping.user_plane_count++)] = plane;
  if (draw.viewport) state.viewport.viewport = Viewport{draw.viewport->x, draw.viewport->y, draw.viewport->width, draw.viewport->height};
  state.viewport.depth_range = {draw.near_depth, draw.far_depth};
  state.culling = {same<Winding>(draw.front_face), same<CullFace>(draw.cull)};
  RasterizationState& raster = state.rasterization;
  if (draw.scissor) raster.scissor = PixelRect{draw.scissor->left, draw.scissor->top, draw.scissor->right, draw.scissor->bottom};
  raster.flat_shading = draw.flat_shading;
  raster.front_mode = same<PolygonMode>(draw.front_mode);
  raster.back_mode = same<PolygonMode>(draw.back_mode);
  const oracle::PolygonOffset& offset = draw.polygon_offset;
  raster.polygon_offset = {offset.factor, offset.units, offset.clamp, offset.fill, offset.line, offset.point};
  raster.point = {draw.point_size_pixels, draw.round_points};
  raster.line.width_pixels = draw.line_width_pixels;
  if (draw.stipple) raster.line.stipple = StipplePattern{draw.stipple->bits, draw.stipple->factor};
}

StencilFace face_of(const oracle::StencilFace& face) {
  return {same<Compare>(face.test), face.reference, face.read_mask, face.write_mask,
          same<StencilOperation>(face.fail), same<StencilOperation>(face.depth_fail), same<StencilOperation>(face.pass)};
}

BlendFunction function_of(const oracle::BlendFunction& f) {
  return {same<BlendFactor>(f.source), same<BlendFactor>(f.destination), same<BlendEquation>(f.equation)};
}

void translate_fragments(const oracle::Draw& draw, PipelineState& state) {
  state.fog = {same<FogMode>(draw.fog.mode), rgba(draw.fog.colour), draw.fog.density, draw.fog.start, draw.fog.end};
  state.alpha_test = {same<Compare>(draw.alpha_test), draw.alpha_reference};
  state.multisampling.alpha_to_coverage = draw.alpha_to_coverage;
  state.stencil = {draw.stencil.enabled, face_of(draw.stencil.front), face_of(draw.stencil.back)};
  state.depth = {same<Compare>(draw.depth_test), draw.depth_write};
  const auto& mask = draw.blend.mask;
  state.blend = {same<BlendMode>(draw.blend.mode), draw.blend.write, function_of(draw.blend.colour), function_of(draw.blend.alpha),
                 rgba(draw.blend.constant), same<LogicOperation>(draw.blend.logic), {mask[0], mask[1], mask[2], mask[3]}};
}

}  // namespace

MeshArrays arrays_of(const oracle::Draw& draw) {
  MeshArrays arrays;
  arrays.indices = draw.indices;
  for (const oracle::InputVertex& v : draw.vertices) {
    if (draw.space == oracle::PositionSpace::object) arrays.positions.emplace_back(v.position);
    if (draw.space == oracle::PositionSpace::clip) arrays.clip_positions.push_back(v.position);
    if (draw.space == oracle::PositionSpace::screen) arrays.screen_positions.push_back({v.screen_x, v.screen_y, v.screen_depth, v.position.w});
    arrays.colours.push_back(v.colour);
    arrays.texcoords.push_back(v.texcoord);
    if (draw.two_sided_colours) arrays.back_colours.push_back(v.back_colour);
    if (draw.has_fog_coordinates) arrays.fog_coordinates.push_back(v.fog_coordinate);
    if (kEnabled.polygon_modes) arrays.edge_flags.push_back(v.edge_flag ? 1 : 0);
  }
  return arrays;
}

DrawCall translated(const oracle::Draw& draw, const MeshArrays& arrays) {
  DrawCall call;
  call.mesh = {.positions = arrays.positions, .clip_positions = arrays.clip_positions, .screen_positions = arrays.screen_positions,
               .normals = {}, .texcoords = arrays.texcoords, .colours = arrays.colours, .custom = {},
               .back_colours = arrays.back_colours, .unit_texcoords = {}, .fog_coordinates = arrays.fog_coordinates,
               .edge_flags = arrays.edge_flags, .indices = arrays.indices};
  call.program = program_of(draw.program);
  translate_geometry(draw, call.state);
  translate_fragments(draw, call.state);
  call.count_fragments = true;
  return call;
}

}  // namespace tuberia::differential
