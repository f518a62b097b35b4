// Lesson 9: everything at once. The teapot has a wavy relief, mirrors the sky that it stands under, and throws a shadow on a
// chequered floor. Each technique changes one term of the local model or adds one: the pattern is kd, relief turns the
// normal, the shadow map is the light's visibility, and the environment is one more light, seen in the mirror direction.

#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera_motions.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"
#include "pipeline/programs/surface.hpp"
#include "scene/environment/background.hpp"
#include "scene/environment/environment_maps.hpp"
#include "scene/environment/sky.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shadows/shadow_pass.hpp"
#include "scene/shapes/shapes.hpp"

using namespace tuberia;

int main() {
  const Mesh teapot = *teapot_mesh({.segments = 24}), floor = *plane_mesh({.width = 400, .depth = 400});
  Camera camera{.eye = {0, 1.9, 12}, .point_of_interest = {0.2, 1.9, 0}, .view = *perspective_volume(0.5, 1.5, 1, 400)};
  camera = *orbit(camera, {.right = 0.35, .up = 0.12, .vertical = glm::dvec3(0, 1, 0)});

  // The sun of the sky is also the lamp that throws the shadow.
  const Sky sky{.towards_sun = {-0.6, 0.7, 0.5}};
  const EnvironmentMap surroundings = *cube_map(cube_of(sky_surroundings(sky), 256));
  const Light sun{.towards = glm::vec3(glm::normalize(sky.towards_sun)), .intensity = {1.0f, 0.93f, 0.8f}};

  std::vector<DrawCall> draws(2);
  draws[0].mesh = mesh_view(floor);
  draws[1].mesh = mesh_view(teapot);
  for (DrawCall& draw : draws) {
    draw.program = flat();
    draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
  }
  Pipeline pipeline;
  const Bounds lit{.lower = {-8, 0, -8}, .upper = {8, 3.2f, 8}};  // the teapot, and where its shadow falls
  ShadowMap shadow = *draw_shadow_map(pipeline, draws, *light_view(sun, lit), {.size = 2048});
  shadow.taps = 3;

  SurfaceUniforms common;
  common.lights.push_back({.light = sun, .shadow = shadow});
  common.ambient_light = {0.25f, 0.3f, 0.38f};
  common.eye = camera.eye;

  SurfaceUniforms stone = common;
  stone.colour.pattern = {.kind = Pattern::Kind::checker, .first = {0.75f, 0.72f, 0.65f}, .second = {0.16f, 0.17f, 0.2f}, .scale = 400};
  draws[0].program = surface(stone);

  SurfaceUniforms glaze = common;
  glaze.reflection = {.model = Reflection::blinn_phong, .ambient = {0.5f, 0.13f, 0.08f}, .diffuse = {0.5f, 0.13f, 0.08f},
                      .specular = glm::vec3(0.6f), .exponent = 120};
  glaze.bump = {.kind = BumpMap::Kind::waves, .texture = {}, .sampler = {}, .gain = 0.02f, .scale = 12};
  glaze.environment = surroundings;
  glaze.mirror = glm::vec3(0.25f);
  glaze.two_sided = true;
  draws[1].program = surface(glaze);

  RenderTarget target = *RenderTarget::create({.width = 960, .height = 640, .colour = ColourFormat::srgb8, .samples = 4});
  const Background background = *Background::create(camera);
  if (!pipeline.draw(target, background.draw(surroundings))) return 1;
  for (const DrawCall& draw : draws)
    if (!pipeline.draw(target, draw)) return 1;
  std::filesystem::create_directories("out");
  return write_image("out/the_teapot.png", target.colour_image()) ? 0 : 1;
}
