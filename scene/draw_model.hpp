#pragma once
// A model from a file as draw calls: what its materials require, and nothing more.

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "math/camera.hpp"
#include "pipeline/draw_call.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"
#include "scene/model.hpp"

namespace tuberia {

/// How a model's surfaces are shown. automatic: textured and lit where there is a texture, Gouraud
/// where there are vertex colours, Blinn-Phong otherwise.
enum class Shading { automatic, flat, gouraud, phong, blinn, textured, textured_lit, textured_gouraud, dot_product };

std::string_view name_of(Shading) noexcept;
std::optional<Shading> shading_named(std::string_view name) noexcept;
/// All names, in the order of the enumeration.
std::vector<std::string_view> shading_names();

/// How a mesh is shown when its model is to be shown so: never automatic, and textured only where the
/// mesh has a texture and coordinates for it.
Shading shading_of(const Model& model, const Mesh& mesh, Shading wanted);
constexpr bool is_textured(Shading shading) noexcept {
  return shading == Shading::textured || shading == Shading::textured_lit || shading == Shading::textured_gouraud;
}

struct ModelView {
  glm::mat4 world_from_object{1.0f};
  CameraMatrices camera;
  glm::vec3 eye{0, 0, 1};   // world space
  Shading shading = Shading::automatic;
  Sampler sampler;
  bool lit_at_vertices = false;  // what is lit at its fragments otherwise, but for cut-out textures
  bool cull_back = false;   // models of files are often open or wound the other way round
  ClipVolume clip_volume = ClipVolume::minus_w_to_w;
  bool reversed_depth = false;
  RasterizationState rasterization{};  // of all draws: the ways to rasterize less exactly, for speed
  FogState fog{};
  NormalInterpolation normals = NormalInterpolation::renormalized;
};

/// A model with its textures made ready. Refers to the model, which must outlive it.
class DrawableModel {
 public:
  /// Error when a texture is too large, or no mesh has what `textured` shading asks for.
  static Result<DrawableModel> create(const Model& model);

  /// A draw for each mesh: opaque ones first, then translucent ones, without depth writes, in the
  /// order of the file. Meshes without texture coordinates are not textured, whatever `shading` says.
  std::vector<DrawCall> draws(const ModelView& view) const;

 private:
  explicit DrawableModel(const Model& model) : model_(&model) {}
  DrawCall draw_of(const Mesh& mesh, const ModelView& view, Shading shading) const;

  const Model* model_;
  std::vector<std::shared_ptr<const Texture>> textures_;
};

}  // namespace tuberia
