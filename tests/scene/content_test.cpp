// What a description stands for: placements, lights, surroundings and parts.

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "scene/content/environment_picture.hpp"
#include "scene/content/light_points.hpp"
#include "scene/content/object_content.hpp"
#include "scene/content/placement.hpp"
#include "scene/content/polygon_mesh.hpp"
#include "scene/content/texture_picture.hpp"
#include "scene/description/check_scene.hpp"
#include "scene/description/read_scene.hpp"
#include "tests/image/temporary_folder.hpp"
#include "tests/scene/every_key.hpp"

namespace tuberia {
namespace {

using description::Transform;

SceneDescription content_scene(const std::string& text) {
  const auto scene = scene_from_json(text, "scene.json");
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

double largest_entry(const glm::dmat4& matrix) {
  double largest = 0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
  return largest;
}

Transform random_step(std::mt19937& random) {
  const auto number = [&] { return std::uniform_real_distribution<double>(-2, 2)(random); };
  Transform step{.kind = static_cast<Transform::Kind>(random() % 4), .vector = {number(), number(), number()}, .degrees = 90 * number()};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) step.matrix[column][row] = number();
  return step;
}

}  // namespace

TEST_CASE("content: steps are done in their order, the first one first", "[scene][content]") {
  const glm::dmat4 matrix = matrix_of({{.kind = Transform::Kind::scale, .vector = {2, 3, 4}}, {.kind = Transform::Kind::rotate, .vector = {0, 0, 5}, .degrees = 90},
                                       {.kind = Transform::Kind::translate, .vector = {10, 20, 30}}});
  CHECK(glm::distance(matrix * glm::dvec4(1, 0, 0, 1), glm::dvec4(10, 22, 30, 1)) < 1e-14);
  CHECK(glm::distance(matrix * glm::dvec4(0, 1, 1, 1), glm::dvec4(7, 20, 34, 1)) < 1e-14);
  CHECK(matrix_of({}) == glm::dmat4(1));
  CHECK(matrix_of({{.kind = Transform::Kind::rotate, .vector = {0, 0, 0}, .degrees = 30}}) == glm::dmat4(1));  // set by hand: no axis, no turn
}

TEST_CASE("content: placements in float are those in double, rounded", "[scene][content]") {
  const unsigned seed = 1;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Transform> steps;
    for (unsigned i = 0; i < 1 + random() % 4; ++i) steps.push_back(random_step(random));
    const glm::dmat4 exact = matrix_of(steps);
    CHECK(largest_entry(glm::dmat4(float_matrix_of(steps)) - exact) < 1e-5 * std::max(largest_entry(exact), 1.0));
  }
}

TEST_CASE("content: an area's points are the middles of its parts", "[B01][scene][content]") {
  const SceneDescription scene = content_scene(R"({"lights": [{"type": "area", "position": [1, 2, 3], "edge_u": [3, 0, 0], "edge_v": [0, 0, 6], "samples": 3}]})");
  const auto points = points_of_area(scene.lights[0]);
  REQUIRE(points.size() == 9);
  CHECK(glm::distance(points[0], glm::dvec3(0, 2, 1)) < 1e-14);
  CHECK(glm::distance(points[2], glm::dvec3(2, 2, 1)) < 1e-14);
  CHECK(glm::distance(points[4], glm::dvec3(1, 2, 3)) < 1e-14);
  CHECK(glm::distance(points[6], glm::dvec3(0, 2, 5)) < 1e-14);
}

TEST_CASE("content: surroundings turn with their environment, but not those drawn from the scene", "[scene][content]") {
  description::Environment environment;
  environment.rotation_degrees = 90;
  // Seen from above they turn counter-clockwise: what was at +x is at -z.
  CHECK(glm::distance(source_from_world(environment) * glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0)) < 1e-6);
  environment.source = description::Environment::Source::rendered;
  CHECK(source_from_world(environment) == glm::dmat3(1));
  CHECK_FALSE(environment_picture({}, environment).ok());
}

TEST_CASE("content: heights are not rounded to codes, colours are", "[scene][content]") {
  const SceneDescription scene = content_scene(R"({"textures": {"slope": {"source": "gradient", "size": 1000}, "squares": {"source": "checker", "size": 8}}})");
  const auto slope = texture_picture(scene, scene.textures[0]), squares = texture_picture(scene, scene.textures[1]);
  REQUIRE((slope.ok() && squares.ok()));
  CHECK(slope->codes.empty());
  CHECK(slope->light.at(500, 3).r == 1 - 500.5f / 1000);
  CHECK(squares->light.empty());
  CHECK(squares->is_srgb);
  CHECK(light_of(*squares).at(0, 0) == Rgba32F{1, 1, 1, 1});
}

TEST_CASE("content: a polygon's image covers the rectangle around it", "[scene][content]") {
  // Seen from the front, +x, right is -z and down is -y.
  const auto mesh = polygon_mesh({.outline = {{1, 0, 0}, {1, 2, 0}, {1, 2, -4}, {1, 1, -4}}, .holes = {}});
  const auto turned = polygon_mesh({.outline = {{1, 1, -4}, {1, 2, -4}, {1, 2, 0}, {1, 0, 0}}, .holes = {}});
  REQUIRE((mesh.ok() && turned.ok()));
  CHECK(mesh->normals[0] == glm::vec3(-1, 0, 0));
  CHECK(turned->normals[0] == glm::vec3(1, 0, 0));
  CHECK(turned->texcoords == std::vector<glm::vec2>{{1, 0.5f}, {1, 0}, {0, 0}, {0, 1}});
  CHECK(mesh->texcoords == std::vector<glm::vec2>{{1, 1}, {1, 0}, {0, 0}, {0, 0.5f}});
  CHECK(mesh->indices == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
  CHECK_FALSE(polygon_mesh({}).ok());
}

TEST_CASE("content: scenes that a file can say pass as scenes made by hand", "[scene][content]") {
  for (const std::string text : {"{}", kEveryKey, kOtherKeys, kPanorama, kRendered}) {
    const auto checked = check_scene(content_scene(text));
    CAPTURE(text, checked.ok() ? "" : checked.error().message);
    CHECK(checked.ok());
  }
  SceneDescription scene;
  scene.picture.exposure_stops = std::nan("");
  CHECK(one_line_naming(check_scene(scene).error().message, "image.exposure_stops is nan"));
  scene = content_scene(kEveryKey);
  std::get<description::HeightField>(scene.objects[9].shape).heights[1].pop_back();
  CHECK(one_line_naming(check_scene(scene).error().message, "objects[9].shape.heights[1] is a list of 2"));
  scene = content_scene(kEveryKey);
  scene.lights[0].projection->texture.clear();
  CHECK(one_line_naming(check_scene(scene).error().message, "lights[0].projection.texture is empty"));
}

}  // namespace tuberia
