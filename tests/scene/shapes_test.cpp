// Shapes: what all of them promise, and what each is.

#include "scene/shapes/shapes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/scene/mesh_measures.hpp"

namespace tuberia {
namespace {

constexpr double kShapePi = std::numbers::pi;

Height hills(double u, double v) {
  return {.value = 0.1 * std::sin(9 * u) * v, .slope_u = 0.9 * std::cos(9 * u) * v, .slope_v = 0.1 * std::sin(9 * u)};
}

std::vector<Mesh> all_shapes() {
  return {*plane_mesh({.width = 3, .depth = 2, .columns = 5, .rows = 4}),
          *box_mesh({.width = 1, .height = 2, .depth = 3, .segments = 3}),
          *disc_mesh({.radius = 2, .slices = 17, .rings = 3}),
          *sphere_mesh({.radius = 2, .slices = 13, .stacks = 7}),
          *cylinder_mesh({.radius = 0.5, .height = 3, .slices = 11, .stacks = 2}),
          *cone_mesh({.radius = 1.5, .height = 2, .slices = 19, .stacks = 3}),
          *cone_mesh({.radius = 1.5, .top_radius = 0.5, .height = 2, .slices = 19, .stacks = 3}),
          *torus_mesh({.radius = 2, .tube_radius = 0.5, .slices = 21, .stacks = 9}),
          *teapot_mesh({.segments = 6}),
          *height_field_mesh({.width = 2, .depth = 3, .columns = 12, .rows = 9}, hills),
          *zigzag_mesh({.flanks = 5, .strips_per_flank = 3})};
}

std::string refusal_of(const Result<Mesh>& mesh) { return mesh ? "(accepted)" : mesh.error().message; }

}  // namespace

TEST_CASE("shapes: every vertex has all attributes, unit normals along bitangent x tangent", "[B20][A10]") {
  for (const Mesh& mesh : all_shapes()) {
    CAPTURE(mesh.name);
    const std::size_t count = mesh.positions.size();
    REQUIRE(mesh.normals.size() == count);
    REQUIRE(mesh.tangents.size() == count);
    REQUIRE(mesh.bitangents.size() == count);
    REQUIRE(mesh.texcoords.size() == count);
    REQUIRE(mesh.triangle_count() > 0);
    double worst_length = 0, worst_direction = 1;
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3 normal(mesh.normals[i]), outside = glm::cross(glm::dvec3(mesh.bitangents[i]), glm::dvec3(mesh.tangents[i]));
      worst_length = std::max(worst_length, std::abs(glm::length(normal) - 1));
      if (glm::length(outside) > 1e-6) worst_direction = std::min(worst_direction, glm::dot(glm::normalize(outside), normal));
      CHECK(mesh.texcoords[i] == glm::clamp(mesh.texcoords[i], 0.0f, 1.0f));
    }
    CHECK(worst_length < 1e-6);
    CHECK(worst_direction > 1 - 1e-6);
  }
}

TEST_CASE("shapes: triangles are counter-clockwise seen from where their normals point", "[scene]") {
  for (const Mesh& mesh : all_shapes()) {
    CAPTURE(mesh.name);
    for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) {
      const auto [a, b, c] = test::corners_of(mesh, i);
      const glm::dvec3 facet = glm::cross(b - a, c - a);
      REQUIRE(glm::length(facet) > 0);
      for (int k = 0; k < 3; ++k)
        REQUIRE(glm::dot(facet, glm::dvec3(mesh.normals[mesh.indices[3 * i + static_cast<std::size_t>(k)]])) > 0);
    }
  }
}

TEST_CASE("shapes: bodies are closed to the last bit, flat ones are open", "[scene]") {
  for (const Mesh& mesh : all_shapes()) {
    CAPTURE(mesh.name);
    const bool body = mesh.name == "box" || mesh.name == "sphere" || mesh.name == "cylinder" || mesh.name == "cone" || mesh.name == "torus";
    CHECK(test::border_edges(mesh).empty() == body);
  }
  for (int slices = 3; slices < 60; ++slices) {
    CAPTURE(slices);
    CHECK(test::border_edges(*sphere_mesh({.radius = 0.7, .slices = slices, .stacks = slices / 2 + 1})).empty());
    CHECK(test::border_edges(*torus_mesh({.slices = slices, .stacks = slices})).empty());
    CHECK(test::border_edges(*cone_mesh({.radius = 0.3, .slices = slices, .stacks = slices / 3})).empty());
  }
  CHECK(test::border_edges(*cylinder_mesh({.slices = 9, .caps = false})).size() == 18);
}

TEST_CASE("shapes: fine ones have the volume and area of the ideal ones", "[scene]") {
  const auto close = [](double value) { return Approx(value).epsilon(2e-3); };
  CHECK(test::volume(*box_mesh({.width = 1, .height = 2, .depth = 3})) == Approx(6));
  CHECK(test::volume(*sphere_mesh({.radius = 2, .slices = 128, .stacks = 64})) == close(4.0 / 3 * kShapePi * 8));
  CHECK(test::volume(*cylinder_mesh({.radius = 2, .height = 3, .slices = 128})) == close(kShapePi * 12));
  CHECK(test::volume(*cone_mesh({.radius = 2, .height = 3, .slices = 128})) == close(kShapePi * 4));
  CHECK(test::volume(*torus_mesh({.radius = 2, .tube_radius = 0.5, .slices = 128, .stacks = 128})) == close(2 * kShapePi * 2 * kShapePi * 0.25));
  CHECK(test::area(*disc_mesh({.radius = 2, .slices = 128})) == close(kShapePi * 4));
  CHECK(test::area(*plane_mesh({.width = 3, .depth = 2, .columns = 7, .rows = 3})) == Approx(6));
}

TEST_CASE("shapes: normals are those of the ideal surface", "[scene]") {
  const Mesh sphere = *sphere_mesh({.radius = 2, .slices = 9, .stacks = 5});
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) CHECK(glm::distance(sphere.normals[i], sphere.positions[i] / 2.0f) < 1e-6f);

  // A torus is where (sqrt(x^2 + z^2) - R)^2 + y^2 = r^2: its normal is the gradient.
  const Mesh torus = *torus_mesh({.radius = 2, .tube_radius = 0.5, .slices = 9, .stacks = 7});
  for (std::size_t i = 0; i < torus.positions.size(); ++i) {
    const glm::dvec3 p(torus.positions[i]);
    const double axis_distance = std::hypot(p.x, p.z), from_circle = axis_distance - 2;
    CHECK(std::hypot(from_circle, p.y) == Approx(0.5));
    const glm::dvec3 gradient(from_circle * p.x / axis_distance, p.y, from_circle * p.z / axis_distance);
    CHECK(glm::dot(glm::normalize(gradient), glm::dvec3(torus.normals[i])) == Approx(1));
  }

  // On a cone they lean upwards by the angle of its side, everywhere, at the apex too.
  const Mesh cone = *cone_mesh({.radius = 3, .height = 4, .slices = 8, .stacks = 2, .caps = false});
  for (const glm::vec3& normal : cone.normals) CHECK(normal.y == Approx(0.6));
}

TEST_CASE("shapes: tangents are the derivatives of position by the texture coordinates", "[A10]") {
  // Along a column or row of a fine net, differences of neighbours approach them.
  const auto check = [](const Mesh& mesh, int columns, int rows) {
    CAPTURE(mesh.name);
    const auto at = [&](int column, int row) { return static_cast<std::size_t>(row * (columns + 1) + column); };
    const auto difference = [&](const std::vector<glm::vec3>& values, std::size_t from, std::size_t to) {
      return glm::dvec3(values[to]) - glm::dvec3(values[from]);
    };
    for (int row = 1; row < rows; row += 5)
      for (int column = 1; column < columns; column += 7) {
        const std::size_t here = at(column, row);
        const glm::dvec3 du = difference(mesh.positions, at(column - 1, row), at(column + 1, row)) * (0.5 * columns);
        const glm::dvec3 dv = difference(mesh.positions, at(column, row - 1), at(column, row + 1)) * (0.5 * rows);
        CHECK(glm::distance(du, glm::dvec3(mesh.tangents[here])) < 1e-3 * glm::length(du) + 1e-3);
        CHECK(glm::distance(dv, glm::dvec3(mesh.bitangents[here])) < 1e-3 * glm::length(dv) + 1e-3);
      }
  };
  check(*plane_mesh({.width = 3, .columns = 20, .rows = 30}), 20, 30);
  check(*sphere_mesh({.slices = 256, .stacks = 128}), 256, 128);
  check(*torus_mesh({.slices = 256, .stacks = 256}), 256, 256);
  check(*cylinder_mesh({.slices = 256, .stacks = 20}), 256, 20);
  check(*cone_mesh({.slices = 256, .stacks = 20}), 256, 20);
  check(*height_field_mesh({.columns = 256, .rows = 256}, hills), 256, 256);
}

TEST_CASE("shapes: images run around from +x to -z, and from above to below", "[scene]") {
  const Mesh sphere = *sphere_mesh({.slices = 8, .stacks = 4});
  const auto position_at = [](const Mesh& mesh, glm::vec2 texcoord) {
    for (std::size_t i = 0; i < mesh.texcoords.size(); ++i)
      if (glm::distance(mesh.texcoords[i], texcoord) < 1e-6f) return mesh.positions[i];
    return glm::vec3(std::numeric_limits<float>::quiet_NaN());
  };
  CHECK(position_at(sphere, {0, 0.5f}) == glm::vec3(1, 0, 0));
  CHECK(position_at(sphere, {0.25f, 0.5f}) == glm::vec3(0, 0, -1));
  CHECK(position_at(sphere, {0.5f, 0.5f}) == glm::vec3(-1, 0, 0));
  CHECK(position_at(sphere, {0.75f, 0.5f}) == glm::vec3(0, 0, 1));
  CHECK(position_at(sphere, {1, 0.5f}) == glm::vec3(1, 0, 0));
  CHECK(position_at(sphere, {0.0625f, 0}) == glm::vec3(0, 1, 0));
  const Mesh plane = *plane_mesh();
  CHECK(position_at(plane, {0, 0}) == glm::vec3(-1, 0, -1));
  CHECK(position_at(plane, {1, 1}) == glm::vec3(1, 0, 1));
}

TEST_CASE("shapes: the circle is symmetric to the last bit", "[exact]") {
  for (const int steps : {1, 3, 4, 5, 8, 12, 48, 1000}) {
    for (int step = 0; step <= steps; ++step) {
      const glm::dvec2 point = point_on_unit_circle(step, steps), mirrored = point_on_unit_circle(steps - step, steps);
      CHECK(point.x == mirrored.x);
      CHECK(point.y == -mirrored.y);
      CHECK(glm::length(point) == Approx(1).epsilon(1e-15));
      CHECK(std::atan2(point.y, point.x) == Approx(std::remainder(2 * kShapePi * step / steps, 2 * kShapePi)).margin(1e-14));
    }
    CHECK(point_on_unit_circle(steps, steps) == glm::dvec2(1, 0));
    CHECK(point_on_unit_circle(-steps, 4 * steps) == glm::dvec2(0, -1));
  }
}

TEST_CASE("shapes: a height field takes its heights from a function or a picture", "[scene]") {
  // A ramp of 4 texels, 0 to 255: linear between the outer texel centres.
  Image<Rgba8> ramp(4, 1);
  for (int x = 0; x < 4; ++x) ramp.at(x, 0).r = static_cast<std::uint8_t>(85 * x);
  const Mesh field = *height_field_mesh({.width = 8, .columns = 8, .rows = 1}, ramp, 3.0);
  CHECK(field.positions[0].y == 0);                 // beyond the first centre
  CHECK(field.positions[1].y == Approx(0));         // on it
  CHECK(field.positions[4].y == Approx(1.5));       // in the middle
  CHECK(field.positions[7].y == Approx(3));
  CHECK(field.tangents[4].y == Approx(4));          // a whole texel in height for each texel along u
  CHECK(field.normals[4].x == Approx(-4 / std::hypot(4, 8)));

  Image<Rgba32F> deep(2, 2, {.r = -2.5f});
  CHECK(height_field_mesh({}, deep, 2.0)->positions[7].y == -5);
}

TEST_CASE("shapes: senseless parameters are refused by name", "[scene]") {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  CHECK(refusal_of(sphere_mesh({.radius = -1})) == "sphere: radius is -1, but must be finite and greater than 0");
  CHECK(refusal_of(sphere_mesh({.radius = kNaN})) == "sphere: radius is nan, but must be finite and greater than 0");
  CHECK(refusal_of(sphere_mesh({.slices = 0})) == "sphere: slices is 0, but must be between 3 and 16384");
  CHECK(refusal_of(sphere_mesh({.stacks = 1})) == "sphere: stacks is 1, but must be between 2 and 16384");
  CHECK(refusal_of(sphere_mesh({.slices = 16384, .stacks = 16384})) == "sphere: slices * stacks is 268435456, but must be at most 16777216");
  CHECK(refusal_of(plane_mesh({.width = 0})) == "plane: width is 0, but must be finite and greater than 0");
  CHECK(refusal_of(plane_mesh({.rows = -3})) == "plane: rows is -3, but must be between 1 and 16384");
  CHECK(refusal_of(box_mesh({.height = kInfinity})) == "box: height is inf, but must be finite and greater than 0");
  CHECK(refusal_of(disc_mesh({.slices = 2})) == "disc: slices is 2, but must be between 3 and 16384");
  CHECK(refusal_of(cylinder_mesh({.height = -2})) == "cylinder: height is -2, but must be finite and greater than 0");
  CHECK(refusal_of(cone_mesh({.top_radius = -0.5})) == "cone: top_radius is -0.5, but must be finite and at least 0");
  CHECK(refusal_of(torus_mesh({.radius = 1, .tube_radius = 1})) == "torus: tube_radius is 1, but must be less than radius");
  CHECK(refusal_of(teapot_mesh({.segments = 0})) == "teapot: Bezier surface: segments is 0, but must be between 1 and 16384");
  CHECK(refusal_of(zigzag_mesh({.flanks = 0})) == "zigzag: flanks is 0, but must be between 1 and 16384");
  CHECK(refusal_of(bezier_mesh({})) == "Bezier surface: there are no patches");
  BezierPatch lost;
  lost.points[5].y = kNaN;
  CHECK(refusal_of(bezier_mesh({.patches = {{}, lost}})) == "Bezier surface: patch 1 has a control point that is not finite");
  CHECK(refusal_of(bezier_mesh({.patches = {{.texcoord_to = {0, 1}}}})) == "Bezier surface: patch 0 has an empty rectangle of texture coordinates");
  CHECK(refusal_of(height_field_mesh({}, [](double, double) { return Height{.value = kInfinity}; })) ==
        "height field: a height is inf, but must be finite, and so must be its slopes");
  CHECK(refusal_of(height_field_mesh({}, Image<Rgba8>(), 1)) == "height field: the picture is empty");
  CHECK(refusal_of(height_field_mesh({}, Image<Rgba8>(2, 2), kNaN)) == "height field: tallest is nan, but must be finite");
}

}  // namespace tuberia
