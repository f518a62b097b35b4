#include <array>
#include <glm/geometric.hpp>

#include "scene/description/scene_keys.hpp"

namespace tuberia::description {
namespace {

constexpr std::array<std::string_view, 9> kTextureSources{"file", "checker", "random-squares", "gradient", "planet", "planet-heights", "bricks", "brick-heights", "stud-heights"};
constexpr std::array<std::string_view, 2> kEncodings{"srgb", "linear"};
constexpr std::array<std::string_view, 4> kFilters{"nearest", "bilinear", "mipmap-nearest", "trilinear"};
constexpr std::array<std::string_view, 3> kWraps{"repeat", "clamp", "mirror"};
constexpr std::array<std::string_view, 2> kLevelRules{"derivatives", "distance"}, kFacets{"beckmann", "gaussian"};
constexpr std::array<std::string_view, 4> kPatterns{"checker", "random-squares", "wood", "marble"};
constexpr std::array<std::string_view, 2> kMappings{"surface", "sphere"};
constexpr std::array<std::string_view, 5> kBumps{"height-texture", "normal-map", "waves", "orange", "rough"};
constexpr std::array<std::string_view, 5> kReflections{"lambert", "phong", "blinn-phong", "weighted-phong", "cook-torrance"};

void pattern_keys(Keys& keys, Pattern& pattern) {
  keys.choice({"type", "checker and random-squares: of texture coordinates; wood and marble: of the point in space", true}, pattern.kind, kPatterns);
  const bool is_solid = pattern.kind == Pattern::Kind::wood || pattern.kind == Pattern::Kind::marble;
  keys.colour({"first", "one of its colours; random-squares: one end of each channel's range"}, pattern.first);
  keys.colour({"second", "the other"}, pattern.second);
  keys.number({"scale", "squares, rings or veins along one unit"}, pattern.scale, above(0));
  keys.where("type is not checker", pattern.kind != Pattern::Kind::checker, [&] { keys.seed({"seed", "of what is random in it"}, pattern.seed); });
  keys.where("type is wood or marble", is_solid, [&] {
    keys.number({"turbulence", "how far noise moves the rings, in rings"}, pattern.turbulence, at_least(0));
    keys.list({"placement", "steps that place the block in the world that the object is carved from"}, pattern.placement, transform_keys);
  });
}

void mapping_keys(Keys& keys, Mapping& mapping) {
  keys.choice({"type", "where texture coordinates come from: the surface itself, or the direction of its normal"}, mapping.kind, kMappings);
  keys.where("type is sphere", mapping.kind == Mapping::Kind::sphere, [&] {
    keys.vector({"pole", "the direction of the picture's upper edge, object space"}, mapping.pole);
    keys.vector({"equator", "the direction of u = 0, perpendicular to the pole"}, mapping.equator);
    keys.flag({"of_positions", "the direction from the origin instead of the normal's, for what is not round"}, mapping.of_positions);
    const bool are_directions = mapping.pole != glm::dvec3(0) && mapping.equator != glm::dvec3(0);
    keys.require("pole", mapping.pole != glm::dvec3(0), "is no direction");
    keys.require("equator", mapping.equator != glm::dvec3(0), "is no direction");
    keys.require("equator", !are_directions || std::abs(glm::dot(glm::normalize(mapping.pole), glm::normalize(mapping.equator))) < 1e-6,
                 "is not perpendicular to the pole");
  });
  keys.pair({"repeat", "how many times the picture lies along u and v"}, mapping.repeat, {});
  keys.require("repeat", mapping.repeat.x != 0 && mapping.repeat.y != 0, "is 0");
}

void bump_keys(Keys& keys, Bump& bump) {
  keys.choice({"type", "a picture of heights or of normals, or heights in closed form", true}, bump.kind, kBumps);
  const bool is_picture = bump.kind == Bump::Kind::height_texture || bump.kind == Bump::Kind::normal_map;
  const bool is_random = bump.kind == Bump::Kind::orange || bump.kind == Bump::Kind::rough;
  keys.where("type is height-texture or normal-map", is_picture, [&] { keys.name({"texture", "one of `textures`", true}, bump.texture, NameOf::texture); });
  keys.number({"gain", "more than 1 exaggerates, less flattens, negative inverts"}, bump.gain);
  keys.where("type is waves, orange or rough", !is_picture, [&] { keys.number({"scale", "waves or dimples along one unit of u and v"}, bump.scale, above(0)); });
  keys.where("type is orange or rough", is_random, [&] { keys.seed({"seed", "of what is random in it"}, bump.seed); });
}

/// An ambient constant that is not said is the diffuse one.
void ambient_key(Keys& keys, Material& material) {
  glm::vec3 ambient = material.ambient.value_or(material.diffuse);
  keys.colour({"ambient", "ka; unless said, as `diffuse`"}, ambient);
  material.ambient = ambient == material.diffuse ? std::nullopt : std::optional(ambient);
}

}  // namespace

void texture_keys(Keys& keys, Texture& texture) {
  using Source = Texture::Source;
  const auto is_made_of = [&](Source source) { return texture.source == source; };
  keys.choice({"source", "a file, or a picture that is made"}, texture.source, kTextureSources);
  keys.where("source is file", is_made_of(Source::file), [&] {
    keys.text({"file", "beside the scene file", true}, texture.file);
    keys.choice({"encoding", "of its 8-bit codes"}, texture.encoding, kEncodings);
  });
  keys.where("source is not file", !is_made_of(Source::file), [&] { keys.whole({"size", "texels each way; planets are twice as wide"}, texture.size, 1, 4096); });
  const bool has_colours = is_made_of(Source::checker) || is_made_of(Source::random_squares) || is_made_of(Source::gradient);
  keys.where("source is checker, random-squares or gradient", has_colours, [&] {
    keys.colour({"first", "one of its colours; random-squares: one end of each channel's range"}, texture.first, within(0, 1));
    keys.colour({"second", "the other"}, texture.second, within(0, 1));
  });
  const bool has_bricks = is_made_of(Source::bricks) || is_made_of(Source::brick_heights);
  const bool has_squares = is_made_of(Source::checker) || is_made_of(Source::random_squares) || is_made_of(Source::stud_heights) || has_bricks;
  keys.where("source is checker, random-squares, bricks, brick-heights or stud-heights", has_squares, [&] {
    keys.whole({"squares", "or courses of bricks (an even number), or studs: how many, each way"}, texture.squares, 1, 4096);
    keys.require("squares", !has_bricks || texture.squares % 2 == 0, "is odd, but courses of bricks must be even");
  });
  const bool is_random = is_made_of(Source::random_squares) || is_made_of(Source::planet) || is_made_of(Source::planet_heights) || is_made_of(Source::bricks);
  keys.where("source is random-squares, planet, planet-heights or bricks", is_random, [&] { keys.seed({"seed", "of what is random in it"}, texture.seed); });
  keys.flag({"level_colours", "each mipmap level in a colour of its own, which shows which one is read"}, texture.level_colours);
  keys.choice({"filter", "how texels become a colour"}, texture.filter, kFilters);
  keys.number({"anisotropy", "samples along a pixel's footprint, at most"}, texture.anisotropy, within(1, 16));
  keys.choice({"wrap", "what lies outside"}, texture.wrap, kWraps);
  keys.choice({"level_rule", "which mipmap level: by a pixel's size on the texture, or by the distance d, log2(d / texel_distance)"}, texture.level_rule, kLevelRules);
  keys.where("level_rule is distance", texture.level_rule == Texture::LevelRule::distance,
             [&] { keys.number({"texel_distance", "where a texel is as large as a pixel, world units"}, texture.texel_distance, above(0)); });
}

void material_keys(Keys& keys, Material& material) {
  using Model = Reflection;
  keys.choice({"model", "how light is reflected"}, material.model, kReflections);
  const bool has_exponent = material.model == Model::phong || material.model == Model::blinn_phong || material.model == Model::weighted_phong;
  const bool is_cook_torrance = material.model == Model::cook_torrance;
  keys.colour({"diffuse", "kd, times the texture or pattern"}, material.diffuse);
  ambient_key(keys, material);
  keys.where("model is not lambert", material.model != Model::lambert, [&] { keys.colour({"specular", "ks"}, material.specular); });
  keys.where("model is phong, blinn-phong or weighted-phong", has_exponent, [&] { keys.number({"exponent", "n of the highlight"}, material.exponent, at_least(0)); });
  keys.where("model is cook-torrance", is_cook_torrance, [&] {
    keys.number({"roughness", "m, the root mean square slope of the facets"}, material.roughness, within(1e-3, 1e3));
    keys.choice({"facets", "how many are tilted by an angle"}, material.facets, kFacets);
    keys.flag({"divided_by_pi", "as the notes print it; false: by 4, as later derived"}, material.divided_by_pi);
  });
  keys.colour({"transmission", "kt, times the light from behind, refracted where rays are traced"}, material.transmission);
  const bool lets_through = material.transmission != glm::vec3(0);
  keys.where("model is weighted-phong or cook-torrance, or transmission is not 0", is_cook_torrance || material.model == Model::weighted_phong || lets_through,
             [&] { keys.colour({"refractive_index", "of Fresnel's formula, each channel; the mean of them bends traced rays"}, material.refractive_index, within(1e-3, 1e3)); });
  keys.where("transmission is not 0", lets_through,
             [&] { keys.number({"shadow_density", "light that goes straight through is multiplied by exp(-shadow_density times the world units inside)"}, material.shadow_density, at_least(0)); });
  keys.name({"texture", "of kd; one of `textures`"}, material.texture, NameOf::texture);
  keys.object({"pattern", "of kd, where there is no texture"}, material.pattern, pattern_keys);
  keys.require("pattern", !material.pattern || material.texture.empty(), "is there beside a texture");
  keys.object({"mapping", "of texture coordinates"}, material.mapping, mapping_keys);
  keys.object({"bump", "relief that only normals know of"}, material.bump, bump_keys);
  keys.colour({"mirror", "kps, times the environment in the mirror direction, or what rays meet there"}, material.mirror);
  keys.number({"alpha", "opacity"}, material.alpha, within(0, 1));
  keys.flag({"two_sided", "the side that faces the eye is lit"}, material.two_sided);
}

}  // namespace tuberia::description
