#include "tests/fuzz/raster_input.hpp"

#include <algorithm>

#include "pipeline/programs/fixed_function.hpp"
#include "pipeline/programs/programs.hpp"
#include "tests/support/random.hpp"

namespace tuberia::fuzz {
namespace {

constexpr int kMostVertices = 18;

glm::vec4 four_numbers(Bytes& bytes) {
  glm::vec4 v;
  for (int i = 0; i < 4; ++i) v[i] = bytes.number();
  return v;
}

Rgba32F colour(Bytes& bytes) { return {bytes.share(), bytes.share(), bytes.share(), bytes.share()}; }

/// Byte 255 names the value after an enumeration's last one, which must be refused.
template <class Enumeration>
Enumeration almost(Bytes& bytes, Enumeration last) {
  const int count = static_cast<int>(last) + 1, byte = bytes.below(256);
  return static_cast<Enumeration>(byte == 255 ? count : byte % count);
}

void choose_target(Bytes& bytes, RasterInput& in) {
  constexpr std::array<int, 6> kSamples{1, 1, 1, 2, 4, 16};
  in.target = {.width = bytes.between(1, 72), .height = bytes.between(1, 40), .colour = bytes.one_of<ColourFormat>(4),
               .depth = bytes.one_of<DepthFormat>(3), .stencil = bytes.flag(), .samples = kSamples[static_cast<std::size_t>(bytes.below(6))]};
  in.clear = {.colour = colour(bytes), .depth = bytes.share()};
  if (in.target.stencil) in.clear.stencil = bytes.byte();
}

void choose_geometry(Bytes& bytes, PipelineState& s) {
  s.assembly.topology = almost(bytes, Topology::points);
  s.clipping.volume = bytes.one_of<ClipVolume>(2);
  s.clipping.user_plane_count = bytes.below(4) == 0 ? bytes.below(9) : 0;
  for (int i = 0; i < s.clipping.user_plane_count; ++i) s.clipping.user_planes[static_cast<std::size_t>(i)] = glm::dvec4(four_numbers(bytes));
  if (bytes.flag()) s.viewport.viewport = Viewport{bytes.between(-40, 80), bytes.between(-40, 60), bytes.between(0, 90), bytes.between(0, 90)};
  if (bytes.flag()) s.viewport.depth_range = {bytes.share(), bytes.share()};
  s.culling = {almost(bytes, Winding::clockwise), almost(bytes, CullFace::front)};
  RasterizationState& r = s.rasterization;
  if (bytes.flag()) r.scissor = PixelRect{bytes.between(-20, 80), bytes.between(-20, 60), bytes.between(-20, 90), bytes.between(-20, 90)};
  r.flat_shading = bytes.flag();
  if (bytes.below(3) == 0) {
    r.front_mode = almost(bytes, PolygonMode::point);
    r.back_mode = almost(bytes, PolygonMode::point);
  }
  if (bytes.below(3) == 0) r.polygon_offset = {bytes.number(), bytes.number(), bytes.number(), bytes.flag(), bytes.flag(), bytes.flag()};
  if (bytes.flag()) r.point = {bytes.number(), bytes.flag()};
  if (bytes.flag()) r.line.width_pixels = bytes.number();
  if (bytes.flag()) r.line.stipple = StipplePattern{static_cast<std::uint16_t>(bytes.between(0, 65535)), bytes.between(1, 256)};
}

StencilFace stencil_face(Bytes& bytes) {
  const auto operation = [&] { return almost(bytes, StencilOperation::decrement_wrap); };
  return {almost(bytes, Compare::always), bytes.byte(), bytes.byte(), bytes.byte(), operation(), operation(), operation()};
}

BlendFunction blend_function(Bytes& bytes) {
  return {almost(bytes, BlendFactor::source_alpha_saturate), almost(bytes, BlendFactor::source_alpha_saturate), almost(bytes, BlendEquation::max)};
}

void choose_output(Bytes& bytes, PipelineState& s) {
  if (bytes.below(4) == 0)
    s.fog = {almost(bytes, FogMode::exp2), colour(bytes), bytes.number(), bytes.number(), bytes.number()};
  if (bytes.below(4) == 0) s.alpha_test = {almost(bytes, Compare::always), bytes.number()};
  s.multisampling.alpha_to_coverage = bytes.below(4) == 0;
  if (bytes.below(4) == 0) s.stencil = {bytes.flag(), stencil_face(bytes), stencil_face(bytes)};
  if (bytes.flag()) s.depth = {almost(bytes, Compare::always), bytes.flag()};
  if (bytes.flag()) {
    s.blend = {almost(bytes, BlendMode::function), bytes.below(8) != 0, blend_function(bytes), blend_function(bytes), colour(bytes)};
    if (bytes.below(4) == 0) s.blend.logic = almost(bytes, LogicOperation::set);
    s.blend.mask = {bytes.below(4) != 0, bytes.below(4) != 0, bytes.below(4) != 0, bytes.below(4) != 0};
  }
}

Image<Rgba8> texels(test::Random& random, int width, int height) {
  Image<Rgba8> image(width, height);
  for (Rgba8& texel : image.pixels()) {
    const std::uint64_t bits = random.u64();
    texel = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8), static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(bits >> 24)};
  }
  return image;
}

std::shared_ptr<const Texture> texture(Bytes& bytes, bool rectangles_only) {
  const int kind = rectangles_only ? 0 : bytes.below(6);
  const int width = 1 + bytes.below(64), height = 1 + bytes.below(64);
  const auto encoding = bytes.one_of<TextureEncoding>(2);
  const bool with_mipmaps = bytes.flag();
  test::Random random(bytes.byte());
  const auto made = [&]() -> Result<Texture> {
    if (kind == 1) {
      const Image<Rgba8> row = texels(random, width, 1);
      return Texture::create_1d(row.pixels(), encoding, with_mipmaps);
    }
    if (kind == 2) {
      const int size = 1 + height % 8;
      std::vector<Image<Rgba8>> slices;
      for (int i = 0; i < 1 + width % 5; ++i) slices.push_back(texels(random, size, size));
      return Texture::create_3d(slices, encoding, with_mipmaps);
    }
    if (kind == 3) {
      const int size = 1 + width % 16;
      const std::array<Image<Rgba8>, 6> faces{texels(random, size, size), texels(random, size, size), texels(random, size, size),
                                              texels(random, size, size), texels(random, size, size), texels(random, size, size)};
      return Texture::create_cube(faces, encoding, with_mipmaps);
    }
    if (kind == 4) {
      Image<float> depths(width, height);
      for (float& depth : depths.pixels()) depth = random.between(-0.1f, 1.1f);
      return Texture::create_depth(depths);
    }
    if (kind == 5) {
      Image<Rgba32F> intensities(width, height);
      for (Rgba32F& texel : intensities.pixels()) texel = {random.between(-9, 9), random.between(0, 1e30f), random.between(0, 1), random.between(0, 1)};
      return Texture::create(intensities, with_mipmaps);
    }
    return Texture::create(texels(random, width, height), encoding, with_mipmaps);
  }();
  return made ? std::make_shared<const Texture>(*made) : nullptr;
}

Sampler sampler(Bytes& bytes) {
  Sampler s{.texels = bytes.one_of<TexelFilter>(2), .mipmaps = bytes.one_of<MipmapFilter>(3), .wrap_u = bytes.one_of<Wrap>(4),
            .wrap_v = bytes.one_of<Wrap>(4), .wrap_w = bytes.one_of<Wrap>(4), .border = colour(bytes)};
  if (bytes.below(4) == 0) {
    s.lod_bias = bytes.number();
    s.min_lod = bytes.number();
    s.max_lod = bytes.number();
  }
  s.max_anisotropy = static_cast<float>(1 + bytes.below(16));
  if (bytes.below(4) == 0) s.compare = bytes.one_of<Compare>(8);
  return s;
}

Combine combine(Bytes& bytes) {
  Combine c;
  c.function = bytes.one_of<CombineFunction>(8);
  for (CombineArgument& argument : c.argument) argument = {bytes.one_of<CombineSource>(4), bytes.one_of<CombineOperand>(4)};
  c.scale = 1 << bytes.below(4);
  return c;
}

FragmentProgram program(Bytes& bytes) {
  const int kind = bytes.below(6);
  if (kind == 0) return flat();
  if (kind == 1) return gouraud();
  if (kind == 2) return phong(Lighting{.specular = glm::vec3(bytes.share()), .shininess = bytes.number(), .halfway = bytes.flag(), .two_sided = bytes.flag()});
  if (kind == 3 || kind == 4) {
    const TexturedUniforms uniforms{.texture = texture(bytes, true), .sampler = sampler(bytes), .tint = four_numbers(bytes), .alpha_cutoff = bytes.share()};
    return kind == 3 ? textured(uniforms, bytes.flag()) : textured_gouraud(uniforms);
  }
  FixedFunctionUniforms uniforms;
  const int count = bytes.below(3);
  for (int i = 0; i < count; ++i)
    uniforms.units[static_cast<std::size_t>(i)] = {texture(bytes, false), sampler(bytes), combine(bytes), combine(bytes), colour(bytes)};
  return fixed_function(uniforms);
}

void choose_transform(Bytes& bytes, TransformState& t) {
  for (glm::mat4* matrix : {&t.world_from_object, &t.clip_from_world, &t.view_from_world})
    if (bytes.below(3) == 0)
      for (int column = 0; column < 4; ++column) (*matrix)[column] = four_numbers(bytes);
  if (bytes.below(4) == 0) t.vertex_lighting = Lighting{.specular = glm::vec3(bytes.share()), .shininess = bytes.number()};
  t.two_sided_colours = bytes.below(4) == 0;
  for (TexCoordUnit& unit : t.texture_units)
    if (bytes.below(6) == 0)
      for (std::size_t i = 0; i < 4; ++i) {
        unit.source[i] = almost(bytes, TexCoordSource::normal_map);
        unit.plane[i] = four_numbers(bytes);
      }
}

void add_vertices(Bytes& bytes, RasterInput& in) {
  in.is_object_space = bytes.below(4) == 0;
  const bool has_flags = bytes.below(4) == 0, has_fog = bytes.below(4) == 0, has_indices = bytes.below(4) == 0;
  const bool has_units = bytes.flag();
  const int count = bytes.below(kMostVertices + 1);
  for (int i = 0; i < count; ++i) {
    const glm::vec4 p = four_numbers(bytes);
    in.clip_positions.push_back(p);
    in.positions.emplace_back(p.x, p.y, p.z);
  }
  for (int i = 0; i < count; ++i) {
    in.colours.push_back(four_numbers(bytes));
    in.normals.emplace_back(bytes.number(), bytes.number(), bytes.number());
    in.texcoords.emplace_back(bytes.number(), bytes.number());
    if (has_units) in.unit_texcoords.push_back(four_numbers(bytes));
    if (has_fog) in.fog_coordinates.push_back(bytes.number());
    if (has_flags) in.edge_flags.push_back(bytes.byte() & 1);
    if (has_indices) in.indices.push_back(static_cast<std::uint32_t>(bytes.below(i % 8 == 7 ? kMostVertices : count)));
  }
}

}  // namespace

RasterInput raster_input(Bytes& bytes) {
  RasterInput in;
  choose_target(bytes, in);
  choose_geometry(bytes, in.state);
  choose_output(bytes, in.state);
  add_vertices(bytes, in);
  in.program = program(bytes);
  choose_transform(bytes, in.state.transform);
  return in;
}

DrawCall RasterInput::call() const {
  DrawCall draw{.mesh = {.normals = normals, .texcoords = texcoords, .colours = colours, .fog_coordinates = fog_coordinates,
                         .edge_flags = edge_flags, .indices = indices},
                .program = program, .state = state};
  if (is_object_space) draw.mesh.positions = positions;
  else draw.mesh.clip_positions = clip_positions;
  for (auto& unit : draw.mesh.unit_texcoords) unit = unit_texcoords;
  return draw;
}

}  // namespace tuberia::fuzz
