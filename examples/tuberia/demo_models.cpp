#include "examples/tuberia/demo_models.hpp"

namespace tuberia::cli {
namespace {

Image<Rgba8> checker(Rgba8 even, Rgba8 odd) {
  Image<Rgba8> image(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) image.at(x, y) = (x / 8 + y / 8) % 2 == 0 ? even : odd;
  return image;
}

Material material(const char* name, glm::vec4 colour, int texture = -1, float alpha_cutoff = 0) {
  return {.name = name, .base_colour = colour, .texture = texture, .two_sided = true, .alpha_cutoff = alpha_cutoff};
}

/// One textured triangle: a corner behind the eye, another beyond the right border of the view.
Demo clipped() {
  Demo demo{.name = "clipped", .caption = "A textured triangle that the near plane and the view's border cut.", .model = {}, .options = {}};
  Mesh mesh;
  mesh.name = "triangle";
  mesh.positions = {{-1.5f, -0.8f, 0}, {3.7f, -0.5f, -1}, {0.1f, 0.9f, 4.5f}};
  mesh.normals.assign(3, glm::normalize(glm::vec3(0, 0.95f, -0.3f)));
  mesh.texcoords = {{0, 1}, {1, 1}, {0.5f, 0}};
  mesh.indices = {0, 1, 2};
  demo.model.meshes = {mesh};
  demo.model.materials = {material("checker", glm::vec4(1), 0)};
  demo.model.textures = {{.name = "checker", .image = checker({250, 214, 90, 255}, {40, 84, 160, 255})}};
  demo.options.width_pixels = 72;
  demo.options.height_pixels = 48;
  demo.options.shading = Shading::textured;
  demo.options.camera.eye = {0, 0, 3};
  demo.options.camera.look_at = {0, 0, 0};
  demo.options.camera.fovy_degrees = 57;
  demo.options.camera.near_distance = 0.5;
  return demo;
}

Mesh layer(const char* name, float z, float left, int material_number) {
  Mesh mesh;
  mesh.name = name;
  mesh.positions = {{left, -1, z}, {left + 2, -1, z}, {left + 2, 1, z}, {left, 1, z}};
  mesh.normals.assign(4, glm::vec3(0, 0, 1));
  mesh.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = material_number;
  return mesh;
}

/// Five squares over each other: two are kept, one has holes, one is hidden, one is translucent.
Demo layers() {
  Demo demo{.name = "layers", .caption = "Five squares over each other: kept, nearer, with holes, hidden, translucent.", .model = {}, .options = {}};
  demo.model.meshes = {layer("far", -1, -1.4f, 0), layer("nearer", -0.5f, -1.1f, 1), layer("holes", 0, -0.9f, 2), layer("hidden", -0.8f, -0.8f, 3),
                       layer("glass", 0.5f, -0.6f, 4)};
  demo.model.materials = {material("red", {0.8f, 0.1f, 0.1f, 1}), material("green", {0.1f, 0.6f, 0.2f, 1}), material("holes", glm::vec4(1), 0, 0.5f),
                          material("blue", {0.1f, 0.2f, 0.8f, 1}), material("glass", {0.9f, 0.9f, 1, 0.4f})};
  demo.model.textures = {{.name = "holes", .image = checker({240, 230, 210, 255}, {240, 230, 210, 64})}};
  demo.options.width_pixels = 72;
  demo.options.height_pixels = 48;
  demo.options.camera.azimuth_degrees = demo.options.camera.elevation_degrees = 0;
  return demo;
}

}  // namespace

std::vector<std::string> demo_names() { return {"clipped", "layers"}; }

Demo demo_named(const std::string& name) { return name == "clipped" ? clipped() : layers(); }

}  // namespace tuberia::cli
