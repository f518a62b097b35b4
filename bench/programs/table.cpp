#include "bench/programs/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assertion.hpp"
#include "math/transforms.hpp"
#include "pipeline/programs/fixed_function.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench {
namespace {

constexpr int kTextureSize = 256;

/// Hills and dales, so that neither texels nor depths are all alike.
float height_at(int x, int y) {
  const auto wave = [](int i) { return std::sin(static_cast<float>(i) * 0.0982f); };
  return 0.5f + 0.3f * wave(x) * wave(y);
}

std::shared_ptr<const Texture> picture(TextureEncoding encoding) {
  Image<Rgba8> image(kTextureSize, kTextureSize);
  for (int y = 0; y < kTextureSize; ++y)
    for (int x = 0; x < kTextureSize; ++x) {
      const auto code = static_cast<std::uint8_t>(255 * height_at(x, y));
      image.at(x, y) = {code, static_cast<std::uint8_t>(255 - code), static_cast<std::uint8_t>(x ^ y), 255};
    }
  return std::make_shared<const Texture>(*Texture::create(image, encoding));
}

std::shared_ptr<const Texture> colours() { return picture(TextureEncoding::srgb); }

/// The colours at a quarter of their size: an environment that even a gentle relief magnifies. Where relief is so steep
/// that neighbours mirror places far apart, look-ups read two levels and miss the cache, whatever the program.
constexpr int kEnvironmentLevel = 2;

std::shared_ptr<const Texture> environment_picture() {
  return std::make_shared<const Texture>(*Texture::create(colours()->level_image(kEnvironmentLevel), TextureEncoding::srgb));
}

std::shared_ptr<const Texture> environment_cube() {
  const Image<Rgba8> face = colours()->level_image(kEnvironmentLevel);
  const std::array<Image<Rgba8>, 6> faces{face, face, face, face, face, face};
  return std::make_shared<const Texture>(*Texture::create_cube(faces, TextureEncoding::srgb));
}

std::shared_ptr<const Texture> depths() {
  Image<float> image(kTextureSize, kTextureSize);
  for (int y = 0; y < kTextureSize; ++y)
    for (int x = 0; x < kTextureSize; ++x) image.at(x, y) = height_at(x, y);
  return std::make_shared<const Texture>(*Texture::create_depth(image));
}

Lighting lighting() {
  Lighting light{.specular = glm::vec3(0.5f), .eye = {0, 0, 3}};
  light.lights[0].towards = {0.48f, 0.6f, 0.64f};
  return light;
}

/// Of the square's 18 units 8 fill a map, seen along z.
constexpr float kTexel = 8.0f / kTextureSize;
glm::mat4 map_from_world() { return compose(translation({0.5, 0.5, 0.5}), scaling({0.125, 0.125, 0.125})); }

void add_model(SurfaceUniforms& surface, Reflection model) {
  surface.reflection.model = model;
  surface.reflection.specular = glm::vec3(0.5f);
}

void add_bump(SurfaceUniforms& surface, BumpMap::Kind kind) {
  surface.bump.kind = kind;
  surface.bump.gain = 0.01f;
  if (kind == BumpMap::Kind::height_texture || kind == BumpMap::Kind::normal_map) surface.bump.texture = picture(TextureEncoding::linear);
}

void add_environment(SurfaceUniforms& surface, EnvironmentMap::Kind kind) {
  surface.environment.kind = kind;
  surface.environment.texture = kind == EnvironmentMap::Kind::cube ? environment_cube() : environment_picture();
  surface.mirror = glm::vec3(0.3f);
}

void add_shadow(SurfaceUniforms& surface, int taps) {
  surface.lights[0].shadow = ShadowMap{.depths = depths(), .map_from_world = map_from_world(), .texel_right = {kTexel, 0, 0}, .texel_down = {0, kTexel, 0}, .taps = taps};
}

}  // namespace

std::vector<NamedProgram> named_programs() {
  const TexturedUniforms textures{.texture = colours(), .sampler = {}};
  FixedFunctionUniforms one_unit;
  one_unit.units[0].texture = textures.texture;
  std::vector<NamedProgram> programs{{"flat", flat()}, {"gouraud", gouraud()}, {"gouraud, lit vertices", gouraud()}, {"dot_product", dot_product(lighting())},
                                     {"phong", phong(lighting())}, {"textured", textured(textures)}, {"textured_gouraud", textured_gouraud(textures)},
                                     {"textured_lit", textured_lit({.texture = textures.texture, .sampler = {}, .lighting = lighting()})},
                                     {"fixed_function, one unit", fixed_function(one_unit)}};
  programs[2].transform.vertex_lighting = lighting();
  programs[3].transform.vertex_cosines = lighting();
  return programs;
}

SurfaceUniforms base_surface() {
  SurfaceUniforms surface{.reflection = {.model = Reflection::lambert}, .eye = {0, 0, 3}};
  surface.lights.push_back({.light = {.towards = {0.48f, 0.6f, 0.64f}}});
  return surface;
}

std::vector<Technique> techniques() {
  using Surface = SurfaceUniforms;
  return {
      {"phong", [](Surface& s) { add_model(s, Reflection::phong); }},
      {"blinn_phong", [](Surface& s) { add_model(s, Reflection::blinn_phong); }},
      {"weighted_phong", [](Surface& s) { add_model(s, Reflection::weighted_phong); }},
      {"cook_torrance", [](Surface& s) { add_model(s, Reflection::cook_torrance); }},
      {"second light, a spot", [](Surface& s) { s.lights.push_back({.light = {.kind = Light::Kind::spot, .towards = {1, 1, 3}, .falloff = Falloff::inverse_square, .cos_outer = 0}}); }},
      {"hue kept", [](Surface& s) { s.overflow = Overflow::hue_preserving; }},
      {"texture", [](Surface& s) { s.colour.texture = colours(); }},
      {"checker", [](Surface& s) { s.colour.pattern.kind = Pattern::Kind::checker; }},
      {"random squares", [](Surface& s) { s.colour.pattern.kind = Pattern::Kind::random_squares; }},
      {"wood", [](Surface& s) { s.colour.pattern.kind = Pattern::Kind::wood; }},
      {"marble", [](Surface& s) { s.colour.pattern.kind = Pattern::Kind::marble; }},
      {"bump texture", [](Surface& s) { add_bump(s, BumpMap::Kind::height_texture); }},
      {"normal map", [](Surface& s) { add_bump(s, BumpMap::Kind::normal_map); }},
      {"waves", [](Surface& s) { add_bump(s, BumpMap::Kind::waves); }},
      {"orange", [](Surface& s) { add_bump(s, BumpMap::Kind::orange); }},
      {"environment cube", [](Surface& s) { add_environment(s, EnvironmentMap::Kind::cube); }},
      {"environment sphere", [](Surface& s) { add_environment(s, EnvironmentMap::Kind::sphere); }},
      {"environment panorama", [](Surface& s) { add_environment(s, EnvironmentMap::Kind::panorama); }},
      {"shadow, 1 tap", [](Surface& s) { add_shadow(s, 1); }},
      {"shadow, 2x2 taps", [](Surface& s) { add_shadow(s, 2); }},
      {"shadow, 3x3 taps", [](Surface& s) { add_shadow(s, 3); }},
      {"projected texture", [](Surface& s) { s.lights[0].projected = ProjectedTexture{.texture = colours(), .map_from_world = map_from_world()}; }},
  };
}

std::vector<Combination> combinations() {
  return {
      {{"blinn_phong", "texture"}},
      {{"phong", "texture", "shadow, 2x2 taps"}},
      {{"blinn_phong", "bump texture"}},
      {{"blinn_phong", "texture", "bump texture"}},
      {{"texture", "environment cube"}},
      {{"bump texture", "environment cube"}},
      {{"cook_torrance", "marble", "environment panorama"}},
      {{"blinn_phong", "texture", "bump texture", "environment cube"}},
      {{"cook_torrance", "texture", "bump texture", "environment cube", "shadow, 3x3 taps", "hue kept"}},
  };
}

SurfaceUniforms surface_with(const std::vector<std::string>& names) {
  SurfaceUniforms surface = base_surface();
  for (const Technique& technique : techniques())
    if (std::find(names.begin(), names.end(), technique.name) != names.end()) technique.add(surface);
  return surface;
}

std::string name_of(const Combination& combination) {
  std::string name;
  for (const std::string& technique : combination.techniques) name += (name.empty() ? "" : " + ") + technique;
  return name;
}

}  // namespace tuberia::bench
