#include "scene/draw_model.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "pipeline/programs/programs.hpp"

namespace tuberia {
namespace {

constexpr std::array<std::string_view, 9> kNames{"auto", "flat", "gouraud", "phong", "blinn", "textured", "textured-lit", "textured-gouraud", "dot-product"};

const Material& material_of(const Model& model, const Mesh& mesh) {
  static const Material kPlain{};
  const auto index = static_cast<std::size_t>(mesh.material);
  return mesh.material >= 0 && index < model.materials.size() ? model.materials[index] : kPlain;
}

/// A key light above the viewer's left shoulder, a weak fill from the right, and some ambient
/// light, all white: a photographer's plainest set-up.
Lighting lighting_of(const Material& material, const ModelView& view) {
  const glm::mat3 world_from_view = glm::transpose(glm::mat3(view.camera.view_from_world));
  Lighting lighting;
  const glm::vec3 diffuse(material.base_colour);
  lighting.ambient = 0.12f * diffuse;
  lighting.diffuse = diffuse;
  if (material.shininess > 0) lighting.specular = 0.6f * material.specular;
  lighting.shininess = material.shininess;
  lighting.alpha = material.base_colour.a;
  lighting.halfway = view.shading != Shading::phong;
  lighting.two_sided = true;
  lighting.eye = view.eye;
  lighting.lights[0] = {Light::Kind::directional, world_from_view * glm::normalize(glm::vec3(-0.5f, 0.8f, 0.9f)), glm::vec3(0.82f)};
  lighting.lights[1] = {Light::Kind::directional, world_from_view * glm::normalize(glm::vec3(0.9f, 0.1f, 0.5f)), glm::vec3(0.2f)};
  lighting.light_count = 2;
  lighting.normals = view.normals;
  return lighting;
}

/// A surface that its file does not describe still gets a highlight, so that its shape shows.
Lighting with_default_highlight(Lighting lighting, const Material& material) {
  if (material.shininess > 0 || material.texture >= 0) return lighting;
  lighting.specular = glm::vec3(0.25f);
  lighting.shininess = 40;
  return lighting;
}

/// The same with its light computed at the vertices, where that can be.
Shading lit_at_vertices(Shading shading, const Material& material) {
  if (shading == Shading::phong || shading == Shading::blinn) return Shading::gouraud;
  return shading == Shading::textured_lit && !(material.alpha_cutoff > 0) ? Shading::textured_gouraud : shading;
}

}  // namespace

std::string_view name_of(Shading shading) noexcept { return kNames[static_cast<std::size_t>(shading)]; }

std::optional<Shading> shading_named(std::string_view name) noexcept {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Shading>(found - kNames.begin());
}

std::vector<std::string_view> shading_names() { return {kNames.begin(), kNames.end()}; }

Shading shading_of(const Model& model, const Mesh& mesh, Shading wanted) {
  const bool has_texture = !mesh.texcoords.empty() && material_of(model, mesh).texture >= 0;
  if (wanted == Shading::automatic) {
    if (has_texture) return Shading::textured_lit;
    return mesh.colours.empty() ? Shading::blinn : Shading::gouraud;
  }
  return is_textured(wanted) && !has_texture ? Shading::blinn : wanted;
}

Result<DrawableModel> DrawableModel::create(const Model& model) {
  DrawableModel drawable(model);
  for (const ModelTexture& image : model.textures) {
    auto texture = Texture::create(image.image, TextureEncoding::srgb);
    if (!texture) return Error{"texture '" + image.name + "': " + texture.error().message};
    drawable.textures_.push_back(std::make_shared<const Texture>(*std::move(texture)));
  }
  return drawable;
}

DrawCall DrawableModel::draw_of(const Mesh& mesh, const ModelView& view, Shading shading) const {
  const Material& material = material_of(*model_, mesh);
  const Lighting lighting = with_default_highlight(lighting_of(material, view), material);
  DrawCall draw;
  draw.mesh = {.positions = mesh.positions, .normals = mesh.normals, .texcoords = mesh.texcoords,
               .colours = mesh.colours, .custom = {}, .indices = mesh.indices};
  draw.state.transform.world_from_object = view.world_from_object;
  draw.state.transform.clip_from_world = view.camera.clip_from_world;
  draw.state.clipping.volume = view.clip_volume;
  draw.state.culling.cull = view.cull_back && !material.two_sided ? CullFace::back : CullFace::none;
  draw.state.rasterization = view.rasterization;
  draw.state.fog = view.fog;
  if (view.reversed_depth) draw.state.depth.test = Compare::greater;
  const bool cut_out = material.alpha_cutoff > 0;
  switch (shading) {
    case Shading::flat:
    case Shading::gouraud:
      draw.state.transform.vertex_lighting = lighting;
      draw.program = shading == Shading::flat ? flat() : gouraud();
      break;
    case Shading::dot_product:
      draw.state.transform.vertex_cosines = lighting;
      draw.program = dot_product(lighting);
      break;
    case Shading::textured:
      draw.program = textured({.texture = textures_[static_cast<std::size_t>(material.texture)], .sampler = view.sampler,
                               .tint = material.base_colour, .alpha_cutoff = material.alpha_cutoff}, cut_out);
      break;
    case Shading::textured_gouraud:
      draw.state.transform.vertex_lighting = lighting;
      draw.program = textured_gouraud({.texture = textures_[static_cast<std::size_t>(material.texture)], .sampler = view.sampler});
      break;
    case Shading::textured_lit: {
      // The texture is tinted once, by the lighting's diffuse colour.
      TexturedLitUniforms uniforms{.texture = textures_[static_cast<std::size_t>(material.texture)], .sampler = view.sampler,
                                   .tint = glm::vec4(1), .lighting = lighting, .alpha_cutoff = material.alpha_cutoff};
      draw.program = textured_lit(std::move(uniforms), cut_out);
      break;
    }
    default: draw.program = phong(lighting);
  }
  return draw;
}

std::vector<DrawCall> DrawableModel::draws(const ModelView& view) const {
  std::vector<DrawCall> opaque, translucent;
  for (const Mesh& mesh : model_->meshes) {
    const Shading shading = shading_of(*model_, mesh, view.shading);
    DrawCall draw = draw_of(mesh, view, view.lit_at_vertices ? lit_at_vertices(shading, material_of(*model_, mesh)) : shading);
    if (material_of(*model_, mesh).base_colour.a < 1) {
      draw.state.blend.mode = BlendMode::source_over;
      draw.state.depth.write = false;
      translucent.push_back(std::move(draw));
    } else {
      opaque.push_back(std::move(draw));
    }
  }
  std::move(translucent.begin(), translucent.end(), std::back_inserter(opaque));
  return opaque;
}

}  // namespace tuberia
