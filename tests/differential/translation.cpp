#include "tests/differential/translation.hpp"

#include <algorithm>

#include "pipeline/programs/fixed_function.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::differential {
namespace {

/// Both sides list their choices in the documents' order.
template <class To, class From>
constexpr To same(From choice) {
  return static_cast<To>(static_cast<int>(choice));
}

Rgba32F rgba(const glm::vec4& c) { return {c.r, c.g, c.b, c.a}; }

Sampler sampler_of(const oracle::Sampler& from) {
  Sampler sampler;
  sampler.texels = same<TexelFilter>(from.texels);
  sampler.mipmaps = same<MipmapFilter>(from.mipmaps);
  sampler.wrap_u = same<Wrap>(from.wrap_u);
  sampler.wrap_v = same<Wrap>(from.wrap_v);
  sampler.wrap_w = same<Wrap>(from.wrap_w);
  sampler.border = rgba(from.border);
  sampler.lod_bias = from.lod_bias;
  sampler.min_lod = from.min_lod;
  sampler.max_lod = from.max_lod;
  sampler.max_anisotropy = from.max_anisotropy;
  sampler.weights = same<FilterWeights>(from.weights);
  sampler.footprint = same<Footprint>(from.footprint);
  if (from.compare) sampler.compare = same<Compare>(*from.compare);
  return sampler;
}

/// One slice or face.
Image<Rgba8> codes_of(const oracle::Texture& texture, int slice) {
  Image<Rgba8> image(texture.width, texture.height);
  const std::size_t size = image.pixels().size();
  for (std::size_t i = 0; i < size; ++i) {
    const auto& t = texture.texels[static_cast<std::size_t>(slice) * size + i];
    image.pixels()[i] = {t[0], t[1], t[2], t[3]};
  }
  return image;
}

Texture made_texture(const oracle::Texture& from) {
  const auto encoding = from.is_srgb ? TextureEncoding::srgb : TextureEncoding::linear;
  if (from.is_depth) {
    Image<float> depths(from.width, from.height);
    std::copy(from.depths.begin(), from.depths.end(), depths.pixels().begin());
    return *Texture::create_depth(depths);
  }
  if (!from.floats.empty()) {
    Image<Rgba32F> floats(from.width, from.height);
    std::transform(from.floats.begin(), from.floats.end(), floats.pixels().begin(), rgba);
    return *Texture::create(floats, from.has_mipmaps);
  }
  std::vector<Image<Rgba8>> slices;
  for (int slice = 0; slice < from.slices; ++slice) slices.push_back(codes_of(from, slice));
  switch (from.kind) {
    case oracle::TextureKind::one_dimensional: return *Texture::create_1d(slices[0].pixels(), encoding, from.has_mipmaps);
    case oracle::TextureKind::three_dimensional: return *Texture::create_3d(slices, encoding, from.has_mipmaps);
    case oracle::TextureKind::cube:
      return *Texture::create_cube(std::span<const Image<Rgba8>, 6>(slices.data(), 6), encoding, from.has_mipmaps);
    case oracle::TextureKind::two_dimensional: break;
  }
  return *Texture::create(slices[0], encoding, from.has_mipmaps);
}

std::shared_ptr<const Texture> texture_of(const oracle::Texture& from) { return std::make_shared<const Texture>(made_texture(from)); }

Combine combine_of(const oracle::Combine& from) {
  Combine combine;
  combine.function = same<CombineFunction>(from.function);
  for (std::size_t i = 0; i < 3; ++i)
    combine.argument[i] = {same<CombineSource>(from.argument[i].source), same<CombineOperand>(from.argument[i].operand)};
  combine.scale = from.scale;
  return combine;
}

FragmentProgram units_of(const oracle::Program& program) {
  FixedFunctionUniforms uniforms;
  for (std::size_t k = 0; k < oracle::kTextureUnits; ++k) {
    const oracle::TextureUnit& unit = program.units[k];
    if (unit.texture == nullptr) continue;
    uniforms.units[k] = {texture_of(*unit.texture), sampler_of(unit.sampler), combine_of(unit.colour), combine_of(unit.alpha), rgba(unit.constant)};
  }
  return fixed_function(std::move(uniforms));
}

FragmentProgram program_of(const oracle::Program& program) {
  if (program.kind == oracle::ProgramKind::flat) return flat();
  if (program.kind == oracle::ProgramKind::gouraud) return gouraud();
  if (program.kind == oracle::ProgramKind::fixed_function) return units_of(program);
  TexturedUniforms uniforms;
  uniforms.texture = texture_of(*program.texture);
  uniforms.sampler = sampler_of(program.sampler);
  uniforms.tint = program.tint;
  uniforms.alpha_cutoff = program.alpha_cutoff;
  if (program.kind == oracle::ProgramKind::textured_gouraud) return textured_gouraud(std::move(uniforms));
  return textured(std::move(uniforms), program.cut_out);
}

void translate_texture_coordinates(const oracle::Draw& draw, TransformState& state) {
  state.view_from_world = draw.view_from_world;
  for (std::size_t k = 0; k < oracle::kTextureUnits; ++k) {
    for (std::size_t i = 0; i < 4; ++i) state.texture_units[k].source[i] = same<TexCoordSource>(draw.texcoord_units[k].source[i]);
    state.texture_units[k].plane = draw.texcoord_units[k].plane;
    state.texture_units[k].matrix = draw.texcoord_units[k].matrix;
  }
}

std::optional<Lighting> lighting_of(const std::optional<oracle::Lighting>& from) {
  if (!from) return {};
  Lighting lighting{.ambient = from->ambient, .diffuse = from->diffuse, .specular = from->specular, .shininess = from->shininess,
                    .alpha = from->alpha, .halfway = from->halfway, .two_sided = from->two_sided, .eye = from->eye, .lights = {},
                    .light_count = static_cast<int>(from->lights.size())};
  for (std::size_t i = 0; i < from->lights.size(); ++i) {
    const oracle::Light& light = from->lights[i];
    const Light::Kind kind = light.is_spot ? Light::Kind::spot : light.is_point ? Light::Kind::point : Light::Kind::directional;
    lighting.lights[i] = {kind, light.towards, light.intensity, same<Falloff>(light.falloff), light.falloff_distance, light.axis, light.cos_inner, light.cos_outer};
  }
  return lighting;
}

void translate_geometry(const oracle::Draw& draw, PipelineState& state) {
  state.transform.world_from_object = draw.world_from_object;
  state.transform.clip_from_world = draw.clip_from_world;
  state.transform.two_sided_colours = draw.two_sided_colours;
  state.transform.vertex_lighting = lighting_of(draw.vertex_lighting);
  state.transform.back_lighting = lighting_of(draw.back_lighting);
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
  raster.subpixel_bits = draw.subpixel_bits;
  raster.perspective = same<PerspectiveCorrection>(draw.perspective);
  raster.edge_arithmetic = same<EdgeArithmetic>(draw.edge_arithmetic);
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
  state.fog = {same<FogMode>(draw.fog.mode), rgba(draw.fog.colour), draw.fog.density, draw.fog.start, draw.fog.end, draw.fog.per_vertex};
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
    if (draw.has_colours) arrays.colours.push_back(v.colour);
    arrays.texcoords.push_back(v.texcoord);
    if (draw.has_unit_texcoords)
      for (std::size_t k = 0; k < oracle::kTextureUnits; ++k) arrays.unit_texcoords[k].push_back(v.unit_texcoord[k]);
    if (draw.has_normals) arrays.normals.push_back(v.normal);
    if (draw.two_sided_colours && draw.has_back_colours) arrays.back_colours.push_back(v.back_colour);
    if (draw.has_fog_coordinates) arrays.fog_coordinates.push_back(v.fog_coordinate);
    arrays.edge_flags.push_back(v.edge_flag ? 1 : 0);
  }
  return arrays;
}

ClearCommand translated(const oracle::Clear& clear) {
  ClearCommand command{.depth = clear.depth, .stencil = clear.stencil,
                       .colour_mask = {clear.mask[0], clear.mask[1], clear.mask[2], clear.mask[3]}, .stencil_write_mask = clear.stencil_write_mask};
  if (clear.colour) command.colour = rgba(*clear.colour);
  if (clear.scissor) command.scissor = PixelRect{clear.scissor->left, clear.scissor->top, clear.scissor->right, clear.scissor->bottom};
  return command;
}

DrawCall translated(const oracle::Draw& draw, const MeshArrays& arrays) {
  DrawCall call;
  call.mesh = {.positions = arrays.positions, .clip_positions = arrays.clip_positions, .screen_positions = arrays.screen_positions,
               .normals = arrays.normals, .texcoords = arrays.texcoords, .colours = arrays.colours, .custom = {},
               .back_colours = arrays.back_colours, .unit_texcoords = {arrays.unit_texcoords[0], arrays.unit_texcoords[1], arrays.unit_texcoords[2], arrays.unit_texcoords[3]},
                .fog_coordinates = arrays.fog_coordinates,
               .edge_flags = arrays.edge_flags, .indices = arrays.indices};
  call.program = program_of(draw.program);
  translate_texture_coordinates(draw, call.state.transform);
  translate_geometry(draw, call.state);
  translate_fragments(draw, call.state);
  return call;
}

}  // namespace tuberia::differential
