#include "scene/frame/frame_meshes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "math/transforms.hpp"
#include "scene/description/model_material.hpp"
#include "scene/frame/frame_textures.hpp"
#include "scene/load_model.hpp"
#include "scene/mesh_editing.hpp"
#include "scene/shapes/shapes.hpp"
#include "scene/sphere_mapping.hpp"
#include "scene/vertex_normals.hpp"

namespace tuberia {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

Result<Mesh> mesh_of(const SceneDescription&, const description::Plane& p) {
  return plane_mesh({.width = p.width, .depth = p.depth, .columns = p.segments.u, .rows = p.segments.v});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Cube& c) {
  return box_mesh({.width = c.size.x, .height = c.size.y, .depth = c.size.z, .segments = c.segments});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Sphere& s) {
  return sphere_mesh({.radius = s.radius, .slices = s.segments.u, .stacks = s.segments.v});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Cylinder& c) {
  return cylinder_mesh({.radius = c.radius, .height = c.height, .slices = c.segments.u, .stacks = c.segments.v, .caps = c.capped});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Cone& c) {
  return cone_mesh({.radius = c.radius, .height = c.height, .slices = c.segments.u, .stacks = c.segments.v, .caps = c.capped});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Torus& t) {
  return torus_mesh({.radius = t.ring_radius, .tube_radius = t.tube_radius, .slices = t.segments.u, .stacks = t.segments.v});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Disc& d) {
  return disc_mesh({.radius = d.radius, .slices = d.segments.u, .rings = d.segments.v});
}

Result<Mesh> mesh_of(const SceneDescription&, const description::Teapot& teapot) {
  auto mesh = teapot_mesh({.segments = teapot.segments});
  if (!mesh) return mesh;
  return teapot.size == 1 ? std::move(mesh) : transformed(*std::move(mesh), scaling(glm::dvec3(teapot.size)));
}

Result<Mesh> mesh_of(const SceneDescription&, const description::BezierPatches& shape) {
  BezierShape bezier{.patches = {}, .segments = shape.segments};
  for (const auto& points : shape.patches) bezier.patches.push_back({.points = points});
  return bezier_mesh(bezier);
}

/// Grid points are vertices; slopes are central differences, one-sided at the border.
Result<Mesh> mesh_of_heights(const description::HeightField& field) {
  const int columns = static_cast<int>(field.heights[0].size()) - 1, rows = static_cast<int>(field.heights.size()) - 1;
  const auto at = [&](int column, int row) {
    return field.height * field.heights[static_cast<std::size_t>(std::clamp(row, 0, rows))][static_cast<std::size_t>(std::clamp(column, 0, columns))];
  };
  const auto slope = [&](int column, int row, int across, int down, int cells) {
    const bool is_inside = across != 0 ? column > 0 && column < columns : row > 0 && row < rows;
    return (at(column + across, row + down) - at(column - across, row - down)) * cells / (is_inside ? 2 : 1);
  };
  return height_field_mesh({.width = field.width, .depth = field.depth, .columns = columns, .rows = rows}, [&](double u, double v) {
    const int column = static_cast<int>(u * columns + 0.5), row = static_cast<int>(v * rows + 0.5);
    return Height{.value = at(column, row), .slope_u = slope(column, row, 1, 0, columns), .slope_v = slope(column, row, 0, 1, rows)};
  });
}

Result<Mesh> mesh_of(const SceneDescription& scene, const description::HeightField& field) {
  if (!field.heights.empty()) return mesh_of_heights(field);
  const description::Texture* texture = find_texture(scene, field.texture);
  if (texture == nullptr) return Error{"there is no texture '" + field.texture + "'"};
  const auto picture = picture_of(scene, *texture);
  if (!picture) return picture.error();
  constexpr int kMostQuadrilaterals = 512;  // along a side; a larger picture is read at some of its texels
  return height_field_mesh({.width = field.width, .depth = field.depth, .columns = std::min(picture->width(), kMostQuadrilaterals),
                            .rows = std::min(picture->height(), kMostQuadrilaterals)}, *picture, field.height);
}

Result<Mesh> mesh_of(const SceneDescription&, const description::TriangleMesh& shape) {
  Mesh mesh;
  mesh.positions.assign(shape.positions.begin(), shape.positions.end());
  for (const glm::dvec3& normal : shape.normals) mesh.normals.push_back(normal == glm::dvec3(0) ? glm::vec3(0) : glm::vec3(glm::normalize(normal)));
  mesh.texcoords.assign(shape.texcoords.begin(), shape.texcoords.end());
  for (const glm::vec3& colour : shape.colours) mesh.colours.emplace_back(colour, 1);
  mesh.indices = shape.indices;
  if (mesh.normals.empty()) return with_vertex_normals(std::move(mesh));
  return mesh;
}

void move_to_unit_sphere(Model& model) {
  const glm::vec3 centre = model.bounds().centre();
  float radius = 0;
  for (const Mesh& mesh : model.meshes)
    for (const glm::vec3& position : mesh.positions) radius = std::max(radius, glm::distance(position, centre));
  const double factor = radius > 0 ? 1.0 / static_cast<double>(radius) : 1.0;
  const glm::mat4 unit_from_object = compose(scaling(glm::dvec3(factor)), translation(-glm::dvec3(centre)));
  for (Mesh& mesh : model.meshes) mesh = transformed(std::move(mesh), unit_from_object);
}

/// One texture of a model; null for the index -1.
Result<std::shared_ptr<const Texture>> model_texture(const Model& model, int index, TextureEncoding encoding) {
  if (index < 0) return std::shared_ptr<const Texture>();
  const ModelTexture& from = model.textures[static_cast<std::size_t>(index)];
  auto made = Texture::create(from.image, encoding);
  if (!made) return Error{"texture '" + from.name + "': " + made.error().message};
  return std::make_shared<const Texture>(*std::move(made));
}

/// A model's material, made once for all of its meshes.
Result<std::vector<FramePart>> materials_of_model(const SceneDescription& scene, const Model& model) {
  std::vector<FramePart> materials;
  for (const Material& own : model.materials) {
    auto texture = model_texture(model, own.texture, TextureEncoding::srgb);
    auto normals = model_texture(model, own.normal_texture, TextureEncoding::linear);
    if (!texture || !normals) return !texture ? texture.error() : normals.error();
    FramePart& part = materials.emplace_back(FramePart{.mesh = {}, .material = description_of(own, scene.environment.has_value())});
    part.own_texture = *texture;
    part.own_normals = *normals;
    part.alpha_cutoff = own.alpha_cutoff;
    if (part.own_normals) {
      part.material.bump.emplace();
      part.material.bump->kind = description::Bump::Kind::normal_map;
      part.material.bump->gain = static_cast<double>(own.normal_scale);
    }
  }
  return materials;
}

Result<std::vector<FramePart>> parts_of_model(const SceneDescription& scene, const description::ModelFile& shape, const description::Material& material,
                                              std::vector<std::string>& warnings) {
  auto model = load_model(file_of(scene, shape.file));
  if (!model) return model.error();
  warnings.insert(warnings.end(), model->warnings.begin(), model->warnings.end());
  if (shape.unit_size) move_to_unit_sphere(*model);
  auto own = shape.own_materials ? materials_of_model(scene, *model) : std::vector<FramePart>();
  if (!own) return own.error();
  std::vector<FramePart> parts;
  for (Mesh& mesh : model->meshes) {
    const auto index = static_cast<std::size_t>(mesh.material);
    FramePart part = index < own->size() ? (*own)[index] : FramePart{.mesh = {}, .material = material};
    if (mesh.texcoords.empty() && index < own->size()) {
      part.own_texture = part.own_normals = nullptr;
      part.material.bump.reset();
    }
    part.mesh = std::move(mesh);
    parts.push_back(std::move(part));
  }
  return parts;
}

Result<std::vector<FramePart>> shaped(const SceneDescription& scene, const description::Object& object, std::vector<std::string>& warnings) {
  const description::Material* named = find_material(scene, object.material);
  if (named == nullptr && !object.material.empty()) return Error{"there is no material '" + object.material + "'"};
  const description::Material material = named != nullptr ? *named : description::Material{};
  if (const auto* file = std::get_if<description::ModelFile>(&object.shape)) return parts_of_model(scene, *file, material, warnings);
  auto mesh = std::visit(
      [&](const auto& shape) -> Result<Mesh> {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, description::ModelFile>) return Error{"it is no mesh"};
        else return mesh_of(scene, shape);
      },
      object.shape);
  if (!mesh) return mesh.error();
  std::vector<FramePart> parts;
  parts.push_back({.mesh = *std::move(mesh), .material = material});
  return parts;
}

/// The normals that the object wants, and what its material needs.
Result<Mesh> finished(Mesh mesh, const description::Object& object, const description::Material& material) {
  if (object.normals == description::Normals::facet) mesh = with_facet_normals(std::move(mesh));
  if (object.normals == description::Normals::averaged) {
    auto averaged = with_vertex_normals(std::move(mesh), {.crease_angle_radians = object.crease_degrees * kRadiansPerDegree});
    if (!averaged) return averaged;
    mesh = *std::move(averaged);
  }
  const description::Mapping& mapping = material.mapping;
  if (mapping.kind == description::Mapping::Kind::sphere) {
    const auto sphere = sphere_mapping({.pole = mapping.pole, .equator = mapping.equator}, mapping.of_positions);
    if (!sphere) return sphere.error();
    auto mapped = with_texture_mapping(std::move(mesh), *sphere);
    if (!mapped) return mapped;
    mesh = *std::move(mapped);
  }
  if (material.bump && mesh.tangents.empty()) {
    auto with = with_tangents(std::move(mesh));
    if (!with) return with;
    mesh = *std::move(with);
  }
  return mapping.repeat == glm::dvec2(1) ? Result<Mesh>(std::move(mesh)) : with_repeated_texture(std::move(mesh), mapping.repeat);
}

}  // namespace

Result<std::vector<FramePart>> parts_of(const SceneDescription& scene, const description::Object& object, std::vector<std::string>& warnings) {
  auto parts = shaped(scene, object, warnings);
  if (!parts) return Error{name_of_object(scene, object) + ": " + parts.error().message};
  for (FramePart& part : *parts) {
    auto mesh = finished(std::move(part.mesh), object, part.material);
    if (!mesh) return Error{name_of_object(scene, object) + ": " + mesh.error().message};
    part.mesh = *std::move(mesh);
    const bool reads_colours = object.shading == description::Shading::flat || object.shading == description::Shading::gouraud;
    if (!part.mesh.colours.empty() && !reads_colours)
      warnings.push_back(name_of_object(scene, object) + ": the colours at its vertices are seen with flat and gouraud shading only");
  }
  return parts;
}

glm::mat4 matrix_of(const std::vector<description::Transform>& steps) noexcept {
  using Kind = description::Transform::Kind;
  glm::mat4 world_from_object(1.0f);
  for (const description::Transform& step : steps) {
    const glm::mat4 next = step.kind == Kind::translate ? translation(step.vector)
                           : step.kind == Kind::rotate  ? rotation(step.vector, step.degrees * kRadiansPerDegree)
                           : step.kind == Kind::scale   ? scaling(step.vector)
                                                        : glm::mat4(step.matrix);
    world_from_object = compose(next, world_from_object);
  }
  return world_from_object;
}

std::string name_of_object(const SceneDescription& scene, const description::Object& object) {
  const auto index = static_cast<std::size_t>(&object - scene.objects.data());
  return "object " + std::to_string(index) + (object.name.empty() ? "" : " '" + object.name + "'");
}

}  // namespace tuberia
