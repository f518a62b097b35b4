#include "bench/peers/tuberia_peer.hpp"

#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "math/transforms.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench {
namespace {

Sampler sampler_of(Filter filter) {
  Sampler sampler;
  const bool nearest = filter == Filter::nearest || filter == Filter::nearest_mipmap_nearest;
  sampler.texels = nearest ? TexelFilter::nearest : TexelFilter::bilinear;
  switch (filter) {
    case Filter::nearest_mipmap_nearest:
    case Filter::linear_mipmap_nearest: sampler.mipmaps = MipmapFilter::nearest; break;
    case Filter::linear_mipmap_linear: sampler.mipmaps = MipmapFilter::linear; break;
    default: sampler.mipmaps = MipmapFilter::none;
  }
  return sampler;
}

tuberia::Lighting lighting_of(const Workload& workload) {
  tuberia::Lighting lighting;
  lighting.ambient = kLighting.ambient;
  lighting.diffuse = kLighting.diffuse;
  lighting.specular = glm::vec3(workload.specular ? kLighting.specular : 0.0f);
  lighting.shininess = kLighting.shininess;
  lighting.eye = {0, 0, 1e6f};  // OpenGL's eye is infinitely far away unless asked
  lighting.lights[0].towards = glm::normalize(kLighting.to_light);
  return lighting;
}

}  // namespace

Result<Nothing> TuberiaPeer::prepare(const Workload& workload) {
  auto target = RenderTarget::create(workload.width_pixels, workload.height_pixels);
  if (!target) return target.error();
  target_.emplace(*std::move(target));
  depth_only_ = workload.depth_only;
  take_mesh(workload.mesh);
  if (workload.filter != Filter::none) take_textures(workload.texture_size_texels);
  draws_.clear();
  const std::size_t count = indices_.size(), split = std::min<std::size_t>(workload.mesh.second_texture_begins, count);
  if (split > 0) draws_.push_back(draw_of(workload, 0, std::span(indices_).first(split)));
  if (split < count) draws_.push_back(draw_of(workload, 1, std::span(indices_).subspan(split)));
  return Nothing{};
}

void TuberiaPeer::clear() {
  if (depth_only_) target_->clear_depth(1, pipeline_.workers());
  else pipeline_.clear(*target_, {0, 0, 0, 0});
}

void TuberiaPeer::frame() {
  clear();
  for (const DrawCall& draw : draws_) {
    const auto drawn = pipeline_.draw(*target_, draw);
    if (!drawn) std::abort();
  }
}

Image<Rgba8> TuberiaPeer::picture() {
  if (!depth_only_) return target_->colour_image();
  const Image<float> depth = target_->depth_image();
  Image<Rgba8> grey(depth.width(), depth.height());
  for (std::size_t i = 0; i < grey.pixels().size(); ++i) {
    const auto code = static_cast<std::uint8_t>(depth.pixels()[i] * 255.0f + 0.5f);
    grey.pixels()[i] = {code, code, code, 255};
  }
  return grey;
}

void TuberiaPeer::take_mesh(const WorkloadMesh& mesh) {
  positions_ = mesh.positions;
  normals_ = mesh.normals;
  texcoords_ = mesh.texture_coordinates;
  indices_ = mesh.indices;
  colours_.clear();
  for (const Rgba8& c : mesh.colours) colours_.push_back(glm::vec4(c.r, c.g, c.b, c.a) / 255.0f);
}

void TuberiaPeer::take_textures(int size_texels) {
  if (!textures_.empty() && textures_.front()->level(0).width == size_texels) return;
  textures_.clear();
  for (const Image<Rgba8>& image : workload_textures(size_texels))
    textures_.push_back(std::make_shared<const Texture>(*Texture::create(image, TextureEncoding::linear)));
}

DrawCall TuberiaPeer::draw_of(const Workload& workload, std::size_t texture, std::span<const std::uint32_t> indices) const {
  DrawCall draw;
  draw.mesh = {.positions = positions_, .normals = normals_, .texcoords = texcoords_, .colours = colours_,
               .custom = {}, .indices = indices};
  PipelineState& state = draw.state;
  state.transform.world_from_object = workload.view_from_object;  // the lights are given in view space
  state.transform.clip_from_world = workload.clip_from_view;
  if (workload.lit) {
    state.transform.vertex_lighting = lighting_of(workload);
    draw.mesh.colours = {};  // OpenGL's materials replace them
  }
  state.culling.cull = workload.cull_back ? CullFace::back : CullFace::none;
  state.depth = workload.depth_test ? DepthState{.test = Compare::less, .write = !workload.blend} : kDepthOff;
  state.blend = {.mode = workload.blend ? BlendMode::source_over : BlendMode::replace, .write = !workload.depth_only};

  if (workload.filter != Filter::none) {
    const TexturedUniforms uniforms{.texture = textures_[texture], .sampler = sampler_of(workload.filter)};
    draw.program = workload.lit ? textured_gouraud(uniforms) : textured(uniforms);
  } else {
    draw.program = workload.flat || workload.depth_only ? flat() : gouraud();
  }
  return draw;
}

Result<std::unique_ptr<Peer>> make_tuberia_peer(int threads, InstructionSet instruction_set, Precision precision) {
  if (threads < 1) return Error{"the number of threads is " + std::to_string(threads) + ", less than 1"};
  return std::unique_ptr<Peer>(std::make_unique<TuberiaPeer>(threads, instruction_set, precision));
}

}  // namespace tuberia::bench
