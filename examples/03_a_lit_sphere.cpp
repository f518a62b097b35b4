// Lesson 3: light. Four spheres, each with one term more of the local model [B 2]: ambient light alone shows a
// flat disc; diffuse reflection shows that it is round; a highlight shows how smooth it is, wide on a dull
// surface and narrow on a polished one.

#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shapes/shapes.hpp"

using namespace tuberia;

int main() {
  // What is there: a sphere, a lamp to the upper left behind the viewer, and a camera.
  const Mesh ball = *sphere_mesh({.radius = 1});
  const glm::dvec3 eye(0, 0, 12);
  const Camera camera{.eye = eye, .view = *perspective_volume(0.22, 3.6, 5, 20)};
  Lighting lighting;
  lighting.ambient = {0.05f, 0.08f, 0.12f};
  lighting.eye = eye;
  lighting.lights[0] = {.kind = Light::Kind::point, .towards = {-6, 6, 8}};

  // The four materials. Colours are linear intensities; the target encodes them for the screen.
  struct Terms {
    glm::vec3 diffuse, specular;
    float exponent;
  };
  const glm::vec3 blue(0.15f, 0.35f, 0.7f);
  const Terms materials[] = {{{0, 0, 0}, {0, 0, 0}, 1}, {blue, {0, 0, 0}, 1}, {blue, glm::vec3(0.4f), 8}, {blue, glm::vec3(0.7f), 80}};

  RenderTarget target = *RenderTarget::create({.width = 900, .height = 250, .colour = ColourFormat::srgb8, .samples = 4});
  Pipeline pipeline;
  pipeline.clear(target, {0.01f, 0.01f, 0.015f, 1});
  double x = -3.45;
  for (const Terms& material : materials) {
    lighting.diffuse = material.diffuse;
    lighting.specular = material.specular;
    lighting.shininess = material.exponent;
    DrawCall draw{.mesh = mesh_view(ball), .program = phong(lighting), .state = {}};
    draw.state.transform.world_from_object = translation({x, 0, 0});
    draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
    if (!pipeline.draw(target, draw)) return 1;
    x += 2.3;
  }
  std::filesystem::create_directories("out");
  return write_image("out/a_lit_sphere.png", target.colour_image()) ? 0 : 1;
}
