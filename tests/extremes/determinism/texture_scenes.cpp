// Textures of every kind and filter, and light at vertices and fragments.

#include <array>

#include "pipeline/programs/fixed_function.hpp"
#include "pipeline/programs/programs.hpp"
#include "tests/extremes/determinism/scene.hpp"
#include "tests/support/random.hpp"
#include "tests/support/shapes.hpp"

namespace tuberia::determinism {

namespace {

/// The same triangles with vertices of their own.
test::Mesh without_indices(const test::Mesh& mesh) {
  test::Mesh all;
  const auto take = [&](const auto& from, auto& to) {
    for (const std::uint32_t i : mesh.indices)
      if (!from.empty()) to.push_back(from[i]);
  };
  take(mesh.positions, all.positions), take(mesh.normals, all.normals), take(mesh.texcoords, all.texcoords), take(mesh.colours, all.colours);
  return all;
}

Image<Rgba8> noise(int width, int height, std::uint64_t seed) {
  test::Random random(seed);
  const auto code = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  Image<Rgba8> image(width, height);
  for (Rgba8& p : image.pixels()) p = {code(), code(), code(), code()};
  return image;
}

std::shared_ptr<const Texture> cube_of_noise() {
  std::array<Image<Rgba8>, 6> faces;
  for (std::size_t i = 0; i < 6; ++i) faces[i] = noise(16, 16, 80 + i);
  return std::make_shared<const Texture>(*Texture::create_cube(faces, TextureEncoding::linear));
}

const glm::dvec3 kEye{1.5, 1.25, 2.5};

PipelineState seen_from_the_eye() {
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world(kEye, 4.0 / 3.0);
  state.transform.view_from_world = view_from_world(*camera_basis(kEye, {0, 0, 0}, {0, 1, 0}), kEye);
  return state;
}

test::Mesh endless_floor(float repeats) {
  return without_indices(test::rectangle({-30, -1, -30}, {0, 0, 60}, {60, 0, 0}, {0, 1, 0}, repeats));
}

/// A floor to the horizon, trilinear, and one above it like a ceiling, 16 times anisotropic.
Scene mipmapped_and_anisotropic() {
  const auto texture = test::texture_of(noise(67, 41, 71), TextureEncoding::srgb);
  Layer floor{.mesh = endless_floor(40), .program = textured({.texture = texture, .sampler = {}}), .state = seen_from_the_eye()};
  Layer ceiling{.mesh = endless_floor(30), .program = textured({.texture = texture, .sampler = {.wrap_u = Wrap::mirror, .max_anisotropy = 16}}),
                .state = seen_from_the_eye()};
  ceiling.state.transform.world_from_object = translation({0, 3.5, 0});
  return {.name = "mipmapped-anisotropic", .target = {.width = 200, .height = 150, .colour = ColourFormat::srgb8}, .layers = {floor, ceiling}};
}

/// A sphere in a room of noise, by two units: a cube map by reflection and a texture with borders.
Scene texture_units() {
  FixedFunctionUniforms uniforms;
  uniforms.units[0] = {.texture = cube_of_noise(), .sampler = {.max_anisotropy = 4}};
  uniforms.units[1] = {.texture = test::texture_of(noise(9, 30, 72)),
                       .sampler = {.mipmaps = MipmapFilter::nearest, .wrap_u = Wrap::border, .wrap_v = Wrap::mirror, .border = {0.5f, 0.25f, 1, 0.5f}}};
  uniforms.units[1].colour.function = CombineFunction::add_signed;
  Layer ball{.mesh = without_indices(test::sphere(20)), .program = fixed_function(uniforms), .state = seen_from_the_eye()};
  ball.state.transform.texture_units[0].source = {TexCoordSource::reflection_map, TexCoordSource::reflection_map, TexCoordSource::reflection_map, TexCoordSource::vertex};
  ball.state.transform.texture_units[1].source = {TexCoordSource::sphere_map, TexCoordSource::eye_linear, TexCoordSource::vertex, TexCoordSource::vertex};
  ball.state.transform.texture_units[1].plane[1] = {0.5f, 2, -0.25f, 0.5f};
  return {.name = "texture-units", .target = {.width = 200, .height = 150, .colour = ColourFormat::rgba32f}, .layers = {ball}};
}

/// Spheres: lit at the vertices, at the fragments, and at the fragments of a texture that has holes.
Scene lit() {
  Lighting light{.specular = glm::vec3(0.5f), .shininess = 20.5f, .eye = glm::vec3(kEye), .light_count = 2};
  light.lights[0].towards = {0, 0.8f, 0.6f};
  light.lights[1] = {.kind = Light::Kind::point, .towards = {-2, 1, 1}, .intensity = {0.2f, 0.3f, 0.9f}};
  const test::Mesh ball = without_indices(test::sphere(16));
  Layer vertices{.mesh = ball, .program = gouraud(), .state = seen_from_the_eye()}, fragments = vertices, holes = vertices;
  vertices.state.transform.vertex_lighting = light;
  vertices.state.transform.world_from_object = translation({-1.5, 0, -0.5});
  fragments.program = phong(light);
  holes.program = textured_lit({.texture = test::texture_of(noise(32, 32, 73)), .sampler = {}, .lighting = light, .alpha_cutoff = 0.4f}, true);
  holes.state.transform.world_from_object = translation({1.5, 0, -1.5});
  return {.name = "lit", .target = {.width = 200, .height = 150, .colour = ColourFormat::rgba32f, .depth = DepthFormat::d16}, .layers = {vertices, fragments, holes}};
}

}  // namespace

std::vector<Scene> texture_scenes() { return {mipmapped_and_anisotropic(), texture_units(), lit()}; }

}  // namespace tuberia::determinism
