#include <cmath>

#include "tests/differential/random_state.hpp"

namespace tuberia::differential {
namespace {

glm::vec3 random_triple(Dice& dice, float least, float most) { return {dice.between(least, most), dice.between(least, most), dice.between(least, most)}; }

/// Mostly unit; along an axis, so that cosines are 0 exactly; or of any length.
glm::vec3 random_direction(Dice& dice) {
  glm::vec3 v = random_triple(dice, -1, 1);
  if (dice.one_in(6)) v = {static_cast<float>(dice.below(3) - 1), static_cast<float>(dice.below(3) - 1), 0};
  const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return dice.one_in(5) || length == 0 ? v : v / length;
}

/// Points may fall off, and be spots: with wide, narrow and no edges.
void give_distance_and_cone(Dice& dice, oracle::Light& light) {
  light.falloff = static_cast<oracle::Falloff>(dice.below(3));
  constexpr float kDistances[] = {0, 1e-3f, 0.5f, 1, 4};
  light.falloff_distance = kDistances[dice.below(5)];
  light.is_spot = dice.one_in(2);
  light.axis = random_direction(dice);
  light.cos_outer = dice.one_in(6) ? -1 : dice.between(-0.5f, 0.95f);
  light.cos_inner = dice.one_in(4) ? light.cos_outer : dice.between(light.cos_outer, 1);
}

oracle::Lighting lighting_at_random(Dice& dice) {
  oracle::Lighting lighting;
  lighting.ambient = random_triple(dice, 0, 0.3f);
  lighting.diffuse = random_triple(dice, 0, 1);
  if (dice.one_in(2)) lighting.specular = random_triple(dice, 0, 1);
  constexpr float kExponents[] = {0, 0.5f, 1, 5, 32, 200};
  lighting.shininess = kExponents[dice.below(6)];
  lighting.alpha = dice.one_in(2) ? 1 : dice.between(0, 1);
  lighting.halfway = dice.one_in(2);
  lighting.two_sided = dice.one_in(3);
  lighting.eye = random_triple(dice, -3, 3);
  for (std::int64_t i = dice.one_in(10) ? 0 : 1 + dice.below(4); i > 0; --i) {
    oracle::Light light;
    light.is_point = dice.one_in(2);
    light.towards = light.is_point ? random_triple(dice, -3, 3) : random_direction(dice);
    light.intensity = random_triple(dice, 0, dice.one_in(4) ? 2.0f : 0.8f);
    if (light.is_point && dice.one_in(2)) give_distance_and_cone(dice, light);
    lighting.lights.push_back(light);
  }
  return lighting;
}

}  // namespace

void give_normals(Dice& dice, oracle::Draw& draw) {
  draw.has_normals = true;
  for (oracle::InputVertex& v : draw.vertices) {
    for (int i = 0; i < 3; ++i) v.normal[i] = dice.one_in(6) ? 0 : dice.between(-1, 1);
    if (dice.one_in(10)) v.normal *= std::exp2(static_cast<float>(dice.below(250)) - 140);
    if (dice.one_in(30)) v.normal = glm::vec3(0);
  }
}

void random_lighting(Dice& dice, oracle::Draw& draw) {
  if (!draw.has_normals) give_normals(dice, draw);
  if (!dice.one_in(5)) draw.vertex_lighting = lighting_at_random(dice);
  if (dice.one_in(2)) draw.back_lighting = lighting_at_random(dice);
  // Of clip positions this matrix turns the normals all the same.
  if (draw.space == oracle::PositionSpace::clip && dice.one_in(4))
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) draw.world_from_object[column][row] = dice.between(-1, 1);
}

}  // namespace tuberia::differential
