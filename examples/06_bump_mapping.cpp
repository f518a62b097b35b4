// Lesson 6: relief that is not there. A height over the surface, given as a function of its texture coordinates, tilts the
// normals, and the light does the rest: n' is along t'_u x t'_v with t' = t + (the height's slope) n [A 1.2]. The mesh
// brings the tangents t_u and t_v. The outlines stay those of a smooth sphere: no vertex has moved [B 4.2.1].

#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/surface.hpp"
#include "scene/mesh_editing.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shapes/shapes.hpp"

using namespace tuberia;

int main() {
  const Mesh ball = *with_repeated_texture(*sphere_mesh({.slices = 64, .stacks = 32}), {2, 1});  // as long around as from pole to pole
  const glm::dvec3 eye(0, 0, 12);
  const Camera camera{.eye = eye, .view = *perspective_volume(0.22, 3.6, 5, 20)};

  SurfaceUniforms surface_of_ball;
  surface_of_ball.reflection = {.ambient = {0.8f, 0.4f, 0.1f}, .diffuse = {0.9f, 0.42f, 0.06f}, .specular = glm::vec3(0.35f), .exponent = 30};
  surface_of_ball.lights.push_back({.light = {.kind = Light::Kind::point, .towards = {-6, 6, 8}}});
  surface_of_ball.eye = eye;

  // Heights in world units are the gain times the function.
  const BumpMap reliefs[] = {{},
                             {.kind = BumpMap::Kind::waves, .texture = {}, .sampler = {}, .gain = 0.02f, .scale = 6},
                             {.kind = BumpMap::Kind::orange, .texture = {}, .sampler = {}, .gain = 0.03f, .scale = 24},
                             {.kind = BumpMap::Kind::rough, .texture = {}, .sampler = {}, .gain = 0.03f, .scale = 24}};
  RenderTarget target = *RenderTarget::create({.width = 900, .height = 250, .colour = ColourFormat::srgb8, .samples = 4});
  Pipeline pipeline;
  pipeline.clear(target, {0.01f, 0.012f, 0.02f, 1});
  double x = -3.45;
  for (const BumpMap& relief : reliefs) {
    surface_of_ball.bump = relief;
    DrawCall draw{.mesh = mesh_view(ball), .program = surface(surface_of_ball), .state = {}};
    draw.state.transform.world_from_object = translation({x, 0, 0});
    draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
    if (!pipeline.draw(target, draw)) return 1;
    x += 2.3;
  }
  std::filesystem::create_directories("out");
  return write_image("out/bump_mapping.png", target.colour_image()) ? 0 : 1;
}
