#include "reference/ray_tracer/traced_scene.hpp"

#include <algorithm>
#include <glm/matrix.hpp>
#include <map>
#include <utility>

#include "math/camera.hpp"
#include "reference/ray_tracer/exact_shape.hpp"
#include "scene/content/environment_picture.hpp"
#include "scene/content/object_content.hpp"
#include "scene/content/placement.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/content/shape_meshes.hpp"
#include "scene/description/check_scene.hpp"
#include "scene/sphere_mapping.hpp"

namespace tuberia::tracer {

using LookupPointer = std::shared_ptr<const TextureLookup>;

/// Puts a scene together; each picture is read once.
class TracedSceneBuilder {
 public:
  TracedSceneBuilder(SceneDescription scene, const TracedSceneOptions& options) : options_(options) { traced_.scene_ = std::move(scene); }

  Result<TracedScene> build(Workers& workers) && {
    if (const auto checked = check_scene(scene()); !checked) return checked.error();
    if (const auto ready = prepare_camera(); !ready) return ready.error();
    traced_.geometry_ = std::make_unique<Geometry>();
    for (const description::Object& object : scene().objects) {
      if (const auto added = add(object); !added) return added.error();
      traced_.end_of_object_.push_back(traced_.geometry_->count());
    }
    if (const auto ready = prepare_lights(); !ready) return ready.error();
    if (const auto ready = prepare_surroundings(); !ready) return ready.error();
    traced_.has_only_opaque_casters_ = std::all_of(traced_.parts_.begin(), traced_.parts_.end(), [&](const TracedScene::Part& part) {
      return scene().objects[static_cast<std::size_t>(part.object)].casts_shadow && !part.material.lets_light_through();
    });
    traced_.accelerator_ = make_accelerator(options_.accelerator, *traced_.geometry_, workers, options_.accelerator_settings);
    return std::move(traced_);
  }

 private:
  const SceneDescription& scene() const { return traced_.scene_; }

  Result<Nothing> prepare_camera();
  Result<Nothing> prepare_lights();
  Result<Nothing> prepare_surroundings();
  Result<Nothing> add(const description::Object& object);
  Result<Nothing> add_exact(const description::Object& object, std::shared_ptr<const Shape> shape);
  Result<Nothing> add_meshes(const description::Object& object);
  int add_part(const description::Object& object, SurfaceMaterial material);

  Result<LookupPointer> named_picture(const std::string& name);
  Result<LookupPointer> thrown_picture(const description::Light& light);
  LookupPointer own_picture(const std::shared_ptr<const Image<Rgba8>>& image, bool is_srgb);
  Result<SurfaceMaterial::Pictures> pictures_of(const description::Material& material);

  TracedSceneOptions options_;
  TracedScene traced_;
  glm::dvec3 eye_{0};
  std::map<std::string, LookupPointer, std::less<>> named_;
  std::map<const Image<Rgba8>*, LookupPointer> own_;
};

namespace {

/// Coordinates by the direction from the middle of the object are exact; so are those by the normals of a sphere, which are the same.
/// Other shapes get theirs as the pipeline does, at the vertices of a mesh.
bool has_exact_coordinates(const description::Object& object, const description::Mapping& mapping) {
  return mapping.kind == description::Mapping::Kind::surface || mapping.of_positions || std::holds_alternative<description::Sphere>(object.shape);
}

bool needs_texcoords(const description::Material& material) {
  const bool has_pattern = material.pattern && (material.pattern->kind == description::Pattern::Kind::checker ||
                                                material.pattern->kind == description::Pattern::Kind::random_squares);
  return !material.texture.empty() || has_pattern;
}

Result<LookupPointer> lookup_of(const SceneDescription& scene, const description::Texture& texture, const TextureRules& rules) {
  const auto picture = texture_picture(scene, texture);
  if (!picture) return picture.error();
  auto lookup = std::make_shared<TextureLookup>(*picture, rules);
  if (texture.level_colours) lookup->colour_levels();
  return LookupPointer(std::move(lookup));
}

Error error_at(const std::string& name, const Error& error) { return {name + ": " + error.message}; }

}  // namespace

Result<TracedScene> TracedScene::create(SceneDescription scene, Workers& workers, const TracedSceneOptions& options) {
  return TracedSceneBuilder(std::move(scene), options).build(workers);
}

glm::dvec3 TracedScene::background(const glm::dvec3& direction, bool seen_directly) const noexcept {
  const bool is_seen = surroundings_.radiance && (!seen_directly || scene_.environment->shown);
  return is_seen ? surroundings_.radiance(direction) : glm::dvec3(scene_.picture.background);
}

Result<Nothing> TracedSceneBuilder::prepare_camera() {
  const auto camera = camera_of(scene().camera, static_cast<double>(scene().picture.width) / scene().picture.height, options_.time);
  if (!camera) return error_at("camera", camera.error());
  if (const auto matrices = camera_matrices(*camera); !matrices) return error_at("camera", matrices.error());
  eye_ = camera->projection == Projection::perspective ? camera->eye : glm::dvec3(eye_of(*camera));
  return Nothing{};
}

Result<Nothing> TracedSceneBuilder::prepare_lights() {
  for (std::size_t i = 0; i < scene().lights.size(); ++i) {
    const description::Light& light = scene().lights[i];
    const std::string name = "light " + std::to_string(i) + (light.name.empty() ? "" : " '" + light.name + "'");
    auto picture = thrown_picture(light);
    if (!picture) return error_at(name, picture.error());
    const auto sources = LightSource::all_of(light, *std::move(picture));
    if (!sources) return error_at(name, sources.error());
    traced_.lights_.insert(traced_.lights_.end(), sources->begin(), sources->end());
  }
  return Nothing{};
}

/// Of an environment that is rendered from the scene rays meet the objects themselves.
Result<Nothing> TracedSceneBuilder::prepare_surroundings() {
  if (!scene().environment || scene().environment->source == description::Environment::Source::rendered) return Nothing{};
  auto picture = environment_picture(scene(), *scene().environment);
  if (!picture) return error_at("environment", picture.error());
  traced_.surroundings_ = turned(surroundings_of(*std::move(picture)), source_from_world(*scene().environment));
  return Nothing{};
}

Result<Nothing> TracedSceneBuilder::add(const description::Object& object) {
  const auto material = material_of(scene(), object);
  if (!material) return error_at(name_of_object(scene(), object), material.error());
  const bool is_smooth = object.normals == description::Normals::exact && has_exact_coordinates(object, material->mapping);
  const bool is_wanted = options_.surfaces == SurfaceKind::exact && is_smooth;
  const bool has_no_mesh = may_have_no_mesh(object.shape) && !mesh_of_shape(scene(), object.shape);
  if (is_wanted || has_no_mesh) {
    auto shape = exact_shape(object.shape);
    if (!shape) return error_at(name_of_object(scene(), object), shape.error());
    if (*shape != nullptr) return add_exact(object, *std::move(shape));
  }
  return add_meshes(object);
}

Result<Nothing> TracedSceneBuilder::add_exact(const description::Object& object, std::shared_ptr<const Shape> shape) {
  const auto material = material_of(scene(), object);
  auto pictures = pictures_of(*material);
  if (!pictures) return error_at(name_of_object(scene(), object), pictures.error());
  const glm::dmat4 world_from_object = matrix_of(object.transforms);
  const description::Mapping& mapping = material->mapping;
  SurfaceMaterial surface(*material, *std::move(pictures), eye_);
  surface.set_repeat(mapping.repeat);
  if (mapping.kind == description::Mapping::Kind::sphere) {
    auto globe = sphere_mapping({.pole = mapping.pole, .equator = mapping.equator}, true);
    if (!globe) return error_at(name_of_object(scene(), object), globe.error());
    surface.set_globe({.object_from_world = glm::inverse(world_from_object), .coordinates = std::move(globe->coordinates)});
  }
  traced_.geometry_->add_shape(std::move(shape), world_from_object, add_part(object, std::move(surface)));
  return Nothing{};
}

Result<Nothing> TracedSceneBuilder::add_meshes(const description::Object& object) {
  const auto parts = content_of(scene(), object, traced_.warnings_);
  if (!parts) return parts.error();
  for (const ContentPart& part : *parts) {
    if (part.mesh.texcoords.empty() && needs_texcoords(part.material))
      return Error{name_of_object(scene(), object) + ": its material goes by texture coordinates, but its mesh has none"};
    auto pictures = pictures_of(part.material);
    if (!pictures) return error_at(name_of_object(scene(), object), pictures.error());
    if (part.own_texture != nullptr) {
      pictures->colour = own_picture(part.own_texture, true);
      pictures->texel_distance.reset();
    }
    if (part.own_normals != nullptr) pictures->relief = own_picture(part.own_normals, false);
    pictures->alpha_cutoff = static_cast<double>(part.alpha_cutoff);
    traced_.geometry_->add_mesh(part.mesh, matrix_of(object.transforms), add_part(object, SurfaceMaterial(part.material, *std::move(pictures), eye_)));
  }
  return Nothing{};
}

int TracedSceneBuilder::add_part(const description::Object& object, SurfaceMaterial material) {
  traced_.parts_.push_back({.material = std::move(material), .object = static_cast<int>(&object - scene().objects.data())});
  return static_cast<int>(traced_.parts_.size()) - 1;
}

/// Null for no name.
Result<LookupPointer> TracedSceneBuilder::named_picture(const std::string& name) {
  LookupPointer& known = named_[name];
  if (name.empty() || known != nullptr) return known;
  const description::Texture* texture = find_texture(scene(), name);
  if (texture == nullptr) return Error{"there is no texture '" + name + "'"};
  auto lookup = lookup_of(scene(), *texture, rules_of(*texture));
  if (lookup) known = *lookup;
  return lookup;
}

/// As the texture is filtered, but what lies beyond a slide's edge is not in it.
Result<LookupPointer> TracedSceneBuilder::thrown_picture(const description::Light& light) {
  if (!light.projection) return LookupPointer();
  const description::Texture& texture = *find_texture(scene(), light.projection->texture);
  TextureRules rules = rules_of(texture);
  rules.wrap = description::Texture::Wrap::clamp;
  rules.anisotropy = 1;
  return lookup_of(scene(), texture, rules);
}

LookupPointer TracedSceneBuilder::own_picture(const std::shared_ptr<const Image<Rgba8>>& image, bool is_srgb) {
  LookupPointer& known = own_[image.get()];
  if (known == nullptr) known = std::make_shared<TextureLookup>(TexturePicture{.codes = *image, .is_srgb = is_srgb, .light = {}}, TextureRules{});
  return known;
}

Result<SurfaceMaterial::Pictures> TracedSceneBuilder::pictures_of(const description::Material& material) {
  const auto colour = named_picture(material.texture), relief = named_picture(material.bump ? material.bump->texture : "");
  if (!colour || !relief) return !colour ? colour.error() : relief.error();
  SurfaceMaterial::Pictures pictures{.colour = *colour, .relief = *relief};
  if (const description::Texture* texture = find_texture(scene(), material.texture); texture && texture->level_rule == description::Texture::LevelRule::distance)
    pictures.texel_distance = texture->texel_distance;
  return pictures;
}

}  // namespace tuberia::tracer
