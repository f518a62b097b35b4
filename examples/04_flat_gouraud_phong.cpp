// Lesson 4: shading. The same coarse torus three times: one intensity for each polygon [B 3.1]; intensities
// at the vertices, interpolated (Gouraud) [B 3.2]; normals interpolated, and the light reckoned at every pixel
// (Phong) [B 3.3]. The outline stays coarse in all three. Look for the highlight: facets break it up, Gouraud
// smears it where it falls between vertices, Phong keeps it.

#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shapes/shapes.hpp"
#include "scene/vertex_normals.hpp"

using namespace tuberia;

int main() {
  const Mesh smooth = *torus_mesh({.radius = 0.9, .tube_radius = 0.4, .slices = 20, .stacks = 10});
  const Mesh facets = with_facet_normals(smooth);  // a normal of its own for each plane
  const glm::dvec3 eye(0, 7, 9);
  const Camera camera{.eye = eye, .view = *perspective_volume(0.25, 3, 5, 20)};

  Lighting lighting;
  lighting.ambient = {0.06f, 0.03f, 0.02f};
  lighting.diffuse = {0.7f, 0.3f, 0.12f};
  lighting.specular = glm::vec3(0.6f);
  lighting.shininess = 30;
  lighting.eye = eye;
  lighting.lights[0] = {.kind = Light::Kind::point, .towards = {-8, 12, 6}};

  RenderTarget target = *RenderTarget::create({.width = 900, .height = 300, .colour = ColourFormat::srgb8, .samples = 4});
  Pipeline pipeline;
  pipeline.clear(target, {0.01f, 0.012f, 0.015f, 1});
  for (const int number : {0, 1, 2}) {
    DrawCall draw;
    draw.mesh = mesh_view(number == 0 ? facets : smooth);
    draw.program = number == 2 ? phong(lighting) : gouraud();
    if (number != 2) draw.state.transform.vertex_lighting = lighting;   // lit at the vertices ...
    draw.state.rasterization.flat_shading = number == 0;                // ... and the first one counts for all
    draw.state.transform.world_from_object = translation({(number - 1) * 2.8, 0, 0});
    draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
    if (!pipeline.draw(target, draw)) return 1;
  }
  std::filesystem::create_directories("out");
  return write_image("out/flat_gouraud_phong.png", target.colour_image()) ? 0 : 1;
}
