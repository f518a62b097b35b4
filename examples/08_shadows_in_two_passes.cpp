// Lesson 8: shadows. What a light does not see lies in its shadow. So the scene is drawn twice by the same pipeline: first
// from the lamp, keeping only depths; then from the eye, and each fragment asks whether it is farther from the lamp than
// the depth kept there [A 1.3].

#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"
#include "pipeline/programs/surface.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shadows/shadow_pass.hpp"
#include "scene/shapes/shapes.hpp"

using namespace tuberia;

int main() {
  const Mesh floor = *plane_mesh({.width = 12, .depth = 12}), ball = *sphere_mesh({.radius = 0.55});
  const Mesh ring = *torus_mesh({.radius = 1.2, .tube_radius = 0.35});
  const glm::dvec3 eye(4, 5, 9);
  const Camera camera{.eye = eye, .point_of_interest = {0, 0.8, 0}, .view = *perspective_volume(0.55, 1.5, 1, 100)};
  const Light lamp{.kind = Light::Kind::point, .towards = {-2.5f, 8, 2.5f}};

  // Three draws; their programs come with the shadow map.
  std::vector<DrawCall> draws(3);
  draws[0].mesh = mesh_view(floor);
  draws[1].mesh = mesh_view(ring);
  draws[1].state.transform.world_from_object = translation({0, 1.7, 0}) * rotation({1, 0, 0.4}, 1.2);
  draws[2].mesh = mesh_view(ball);
  draws[2].state.transform.world_from_object = translation({1.9, 0.55, 1});
  for (DrawCall& draw : draws) {
    draw.program = flat();
    draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
  }

  // Pass 1: as the lamp sees it.
  Pipeline pipeline;
  const Bounds scene{.lower = {-6, 0, -6}, .upper = {6, 3.3f, 6}};
  const LightView view = *light_view(lamp, scene);
  ShadowMap shadow = *draw_shadow_map(pipeline, draws, view, {.size = 2048});
  shadow.taps = 3;  // softens the edges a little

  // Pass 2: as the eye sees it.
  SurfaceUniforms matt;
  matt.lights.push_back({.light = lamp, .shadow = shadow});
  matt.eye = eye;
  const glm::vec3 colours[] = {{0.6f, 0.58f, 0.5f}, {0.75f, 0.25f, 0.15f}, {0.2f, 0.45f, 0.75f}};
  RenderTarget target = *RenderTarget::create({.width = 720, .height = 480, .colour = ColourFormat::srgb8, .samples = 4});
  pipeline.clear(target, {0.02f, 0.025f, 0.035f, 1});
  for (std::size_t i = 0; i < 3; ++i) {
    matt.reflection = {.ambient = colours[i], .diffuse = colours[i]};
    draws[i].program = surface(matt);
    if (!pipeline.draw(target, draws[i])) return 1;
  }
  std::filesystem::create_directories("out");
  return write_image("out/shadows_in_two_passes.png", target.colour_image()) ? 0 : 1;
}
