// Lesson 7: a mirror without ray tracing. The surroundings are six pictures, the faces of a cube map; a shiny fragment
// looks up what lies in the direction r = 2 (n.v) n - v [A 1.4]. That is right for surroundings that are far away, like
// this sky. The same map, drawn behind the teapot, shows what it reflects.

#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/surface.hpp"
#include "scene/environment/background.hpp"
#include "scene/environment/environment_maps.hpp"
#include "scene/environment/sky.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shapes/shapes.hpp"

using namespace tuberia;

int main() {
  const EnvironmentMap sky = *cube_map(cube_of(sky_surroundings({}), 256));
  const Mesh teapot = *teapot_mesh({.segments = 16});
  const glm::dvec3 eye(3, 3.2, 8);
  const Camera camera{.eye = eye, .point_of_interest = {0.2, 1.5, 0}, .view = *perspective_volume(0.6, 1.5, 1, 100)};

  SurfaceUniforms silver;
  silver.reflection = {.ambient = glm::vec3(0), .diffuse = glm::vec3(0.02f)};
  silver.lights.push_back({.light = {.towards = glm::normalize(glm::vec3(0.3f, 0.5f, -0.8f))}});  // where the sky's sun is
  silver.eye = eye;
  silver.environment = sky;
  silver.mirror = {0.9f, 0.88f, 0.83f};
  silver.two_sided = true;  // the inside shows through the gap below the lid

  RenderTarget target = *RenderTarget::create({.width = 720, .height = 480, .colour = ColourFormat::srgb8, .samples = 4});
  Pipeline pipeline;
  const Background background = *Background::create(camera);
  if (!pipeline.draw(target, background.draw(sky))) return 1;
  DrawCall draw{.mesh = mesh_view(teapot), .program = surface(silver), .state = {}};
  draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
  if (!pipeline.draw(target, draw)) return 1;
  std::filesystem::create_directories("out");
  return write_image("out/environment.png", target.colour_image()) ? 0 : 1;
}
