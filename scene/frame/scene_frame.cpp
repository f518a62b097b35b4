#include "scene/frame/scene_frame.hpp"

#include <algorithm>

#include "image/box_filter.hpp"
#include "pipeline/programs/programs.hpp"
#include "scene/content/placement.hpp"
#include "scene/environment/background.hpp"
#include "scene/frame/frame_environment.hpp"
#include "scene/frame/frame_shadows.hpp"
#include "scene/mesh_view.hpp"

namespace tuberia {

namespace {

bool is_opaque(const description::Material& material) { return material.alpha >= 1 && material.transmission == glm::vec3(0); }

/// What is clear lets through its share of what lies behind, each side of it once more: the far sides are drawn first.
void add_translucent(DrawCall draw, const description::Material& material, std::vector<DrawCall>& draws) {
  draw.state.depth.write = false;
  BlendState& blend = draw.state.blend;
  blend.mode = BlendMode::source_over;
  if (material.transmission == glm::vec3(0)) {
    draws.push_back(std::move(draw));
    return;
  }
  blend.mode = BlendMode::function;
  blend.colour = {.source = BlendFactor::source_alpha, .destination = BlendFactor::constant_colour};
  blend.alpha = {.source = BlendFactor::one_minus_destination_alpha, .destination = BlendFactor::one};
  blend.constant = {material.transmission.r, material.transmission.g, material.transmission.b, 1};
  for (const CullFace hidden : {CullFace::front, CullFace::back}) {
    draw.state.culling.cull = hidden;
    draws.push_back(draw);
  }
}

}  // namespace

/// The order of a frame. What a scene does not have costs it nothing.
Result<Image<Rgba32F>> SceneFrame::draw(Pipeline& pipeline) {
  passes_.clear();
  statistics_ = {};
  FrameLight light{.lights = {}, .ambient = scene_.ambient, .eye = eye_of(camera_), .environment = {}};

  // 1. What each light sees, for shadows.
  auto lights = draw_shadows(pipeline);
  if (!lights) return lights.error();
  light.lights = *std::move(lights);

  // 2. What surrounds the scene, which may be the scene itself.
  if (needs_environment()) {
    auto environment = draw_environment(pipeline, light);
    if (!environment) return Error{"environment: " + environment.error().message};
    light.environment = *std::move(environment);
  }

  // 3. What the observer sees: opaque things in any order, then what is behind all of them, then what lets that through.
  begin_pass("picture");
  const int samples = scene_.picture.supersampling;
  auto target = RenderTarget::create(size_.x * samples, size_.y * samples, ColourFormat::rgba32f, DepthFormat::d32f);
  if (!target) return target.error();
  const glm::vec3& background = scene_.picture.background;
  pipeline.clear(*target, {background.r, background.g, background.b, 1});
  const auto draws = draws_for(camera_, light, false);
  if (!draws) return draws.error();
  if (const auto drawn = draw_all(pipeline, *target, draws->opaque); !drawn) return drawn.error();
  if (light.environment.kind != EnvironmentMap::Kind::none && scene_.environment->shown) {
    const auto behind = Background::create(camera_);
    if (!behind) return behind.error();
    if (const auto drawn = draw_all(pipeline, *target, {behind->draw(light.environment)}); !drawn) return drawn.error();
  }
  if (const auto drawn = draw_all(pipeline, *target, draws->translucent); !drawn) return drawn.error();
  return samples == 1 ? target->linear_image() : box_filtered(target->linear_image(), samples);
}

Result<SceneFrame> SceneFrame::create(SceneDescription scene, FrameOptions options) {
  SceneFrame frame(std::move(scene), std::move(options));
  frame.size_ = frame.options_.size_pixels.value_or(glm::ivec2(frame.scene_.picture.width, frame.scene_.picture.height));
  const auto camera = camera_of(frame.scene_.camera, static_cast<double>(frame.size_.x) / frame.size_.y, frame.options_.time);
  if (!camera) return Error{"camera: " + camera.error().message};
  if (const auto matrices = camera_matrices(*camera); !matrices) return Error{"camera: " + matrices.error().message};
  frame.camera_ = *camera;
  if (const auto ready = frame.prepare_parts(); !ready) return ready.error();
  if (const auto ready = frame.prepare_textures(); !ready) return ready.error();
  return frame;
}

Result<Nothing> SceneFrame::prepare_parts() {
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    auto parts = parts_of(scene_, scene_.objects[i], warnings_);
    if (!parts) return parts.error();
    const glm::mat4 world_from_object = float_matrix_of(scene_.objects[i].transforms);
    for (FramePart& part : *parts) parts_.push_back({std::move(part), i, world_from_object});
  }
  return Nothing{};
}

Result<Nothing> SceneFrame::prepare_textures() {
  std::vector<std::string> names;
  for (const Part& part : parts_)
    for (std::string& name : textures_of(part.part.material)) names.push_back(std::move(name));
  for (const description::Light& light : scene_.lights)
    if (light.projection) names.push_back(light.projection->texture);
  for (const std::string& name : names) {
    if (textures_.contains(name)) continue;
    const description::Texture* described = find_texture(scene_, name);
    if (described == nullptr) return Error{"there is no texture '" + name + "'"};
    auto texture = frame_texture(scene_, *described);
    if (!texture) return texture.error();
    textures_.emplace(name, *std::move(texture));
  }
  return Nothing{};
}

Bounds SceneFrame::bounds() const {
  Bounds box;
  for (const Part& part : parts_)
    for (const glm::vec3& position : part.part.mesh.positions) box.add(glm::vec3(part.world_from_object * glm::vec4(position, 1)));
  return box;
}

bool SceneFrame::needs_environment() const {
  const auto is_mirror = [](const Part& part) { return part.part.material.mirror != glm::vec3(0); };
  return scene_.environment && (scene_.environment->shown || std::any_of(parts_.begin(), parts_.end(), is_mirror));
}

std::int64_t SceneFrame::triangle_count() const noexcept {
  std::int64_t count = 0;
  for (const Part& part : parts_) count += part.part.mesh.triangle_count();
  return count;
}

DrawCall SceneFrame::draw_of(const Part& part, const Camera& camera) const {
  DrawCall draw;
  draw.mesh = mesh_view(part.part.mesh);
  draw.state.transform.world_from_object = part.world_from_object;
  if (const auto matrices = camera_matrices(camera)) draw.state.transform.clip_from_world = matrices->clip_from_world;
  draw.state.clipping.volume = camera.clip_volume;
  return draw;
}

std::vector<DrawCall> SceneFrame::casters() const {
  std::vector<DrawCall> draws;
  for (const Part& part : parts_) {
    if (!scene_.objects[part.object].casts_shadow || !is_opaque(part.part.material)) continue;
    DrawCall& draw = draws.emplace_back(draw_of(part, camera_));
    const bool is_cut_out = part.part.alpha_cutoff > 0 && part.part.own_texture != nullptr;
    draw.program = is_cut_out ? textured({.texture = part.part.own_texture, .sampler = {}, .tint = glm::vec4(1), .alpha_cutoff = part.part.alpha_cutoff}, true) : gouraud();
  }
  return draws;
}

/// Translucent things do not hide each other; they are drawn in the order of the file.
Result<SceneFrame::Draws> SceneFrame::draws_for(const Camera& camera, const FrameLight& light, bool is_environment) const {
  Draws draws;
  for (const Part& part : parts_) {
    const description::Object& object = scene_.objects[part.object];
    if (is_environment && !object.seen_in_environment) continue;
    DrawCall draw = draw_of(part, camera);
    if (const auto set = set_material(draw, part.part, object.shading, textures_, light); !set)
      return Error{name_of_object(scene_, object) + ": " + set.error().message};
    if (part.part.alpha_cutoff > 0) draw.state.alpha_test = {.test = Compare::greater_equal, .reference = part.part.alpha_cutoff};
    if (is_opaque(part.part.material)) draws.opaque.push_back(std::move(draw));
    else add_translucent(std::move(draw), part.part.material, draws.translucent);
  }
  return draws;
}

Result<Nothing> SceneFrame::draw_all(Pipeline& pipeline, RenderTarget& target, const std::vector<DrawCall>& draws) {
  for (const DrawCall& draw : draws) {
    const auto drawn = pipeline.draw(target, draw);
    if (!drawn) return drawn.error();
    statistics_ += *drawn;
  }
  return Nothing{};
}

Result<std::vector<SurfaceLight>> SceneFrame::draw_shadows(Pipeline& pipeline) {
  const auto casts = [](const description::Light& light) { return light.shadow || light.projection; };
  const bool is_needed = std::any_of(scene_.lights.begin(), scene_.lights.end(), casts);
  const std::vector<DrawCall> in_the_way = is_needed ? casters() : std::vector<DrawCall>();
  const Bounds seen = is_needed ? bounds() : Bounds();
  std::vector<SurfaceLight> all;
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const description::Light& light = scene_.lights[i];
    const std::string name = "light " + std::to_string(i) + (light.name.empty() ? "" : " '" + light.name + "'");
    if (light.shadow && !in_the_way.empty()) begin_pass("shadows of " + name);
    auto lights = lights_with_shadows(pipeline, light, in_the_way, seen, textures_);
    if (!lights) return Error{name + ": " + lights.error().message};
    std::move(lights->begin(), lights->end(), std::back_inserter(all));
  }
  return all;
}

Result<EnvironmentMap> SceneFrame::draw_environment(Pipeline& pipeline, const FrameLight& light) {
  begin_pass("environment");
  return environment_map_of(scene_, *scene_.environment, camera_, pipeline, [&](Pipeline& same, RenderTarget& target, const Camera& camera) -> Result<Nothing> {
    FrameLight seen = light;
    seen.eye = eye_of(camera);
    const auto draws = draws_for(camera, seen, true);
    if (!draws) return draws.error();
    if (const auto drawn = draw_all(same, target, draws->opaque); !drawn) return drawn;
    return draw_all(same, target, draws->translucent);
  });
}

void SceneFrame::begin_pass(const std::string& name) {
  passes_.push_back(name);
  if (options_.progress) options_.progress(name);
}

}  // namespace tuberia
