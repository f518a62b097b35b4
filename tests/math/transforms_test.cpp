#include "math/transforms.hpp"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace tuberia {

namespace {

constexpr double kSixtyDegrees = std::numbers::pi / 3.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Vector>
void check_near(const Vector& actual, const Vector& expected, double margin) {
  for (int i = 0; i < Vector::length(); ++i) CHECK(actual[i] == Approx(expected[i]).margin(margin));
}

// The z in ndc of a point on the view axis.
double ndc_depth(const glm::mat4& clip_from_view, double distance) {
  const glm::vec4 clip = clip_from_view * glm::vec4(0, 0, -distance, 1);
  return clip.z / clip.w;
}

}  // namespace

// notes 15.1
TEST_CASE("transforms: the look-at basis of the notes", "[math]") {
  const glm::dvec3 eye(3, 4, 5);
  const auto basis = camera_basis(eye, {0, 0, 0}, {0, 1, 0});
  REQUIRE(basis.ok());
  check_near(basis->w, glm::dvec3(0.42426, 0.56569, 0.70711), 1e-5);
  check_near(basis->u, glm::dvec3(0.85749, 0, -0.51450), 1e-5);
  check_near(basis->v, glm::dvec3(-0.29104, 0.82462, -0.48507), 1e-5);
  const glm::mat4 view = view_from_world(*basis, eye);
  check_near(view * glm::vec4(3, 4, 5, 1), glm::vec4(0, 0, 0, 1), 1e-6);
  check_near(view * glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, -7.07107f, 1), 1e-5);
}

TEST_CASE("transforms: a basis without a direction is refused by name", "[math][bad-input]") {
  const auto message = [](const glm::dvec3& eye, const glm::dvec3& poi, const glm::dvec3& up) {
    const auto basis = camera_basis(eye, poi, up);
    REQUIRE_FALSE(basis.ok());
    return basis.error().message;
  };
  CHECK_THAT(message({1, 2, 3}, {1, 2, 3}, {0, 1, 0}), Catch::Contains("eye and point_of_interest are both (1, 2, 3)"));
  CHECK_THAT(message({0, 5, 0}, {0, 0, 0}, {0, 2, 0}), Catch::Contains("up (0, 2, 0) is parallel"));
  CHECK_THAT(message({0, 5, 0}, {0, 0, 0}, {0, -1, 0}), Catch::Contains("parallel"));
  CHECK_THAT(message({0, 0, 5}, {0, 0, 0}, {0, 0, 0}), Catch::Contains("no direction"));
  CHECK_THAT(message({kNaN, 0, 5}, {0, 0, 0}, {0, 1, 0}), Catch::Contains("eye"));
  CHECK_THAT(message({0, 0, 5}, {0, kInfinity, 0}, {0, 1, 0}), Catch::Contains("point_of_interest"));
  CHECK_THAT(message({0, 0, 5}, {0, 0, 0}, {0, kNaN, 0}), Catch::Contains("up"));
}

// notes 15.2
TEST_CASE("transforms: the perspective view of the notes", "[math]") {
  const auto view = perspective_volume(kSixtyDegrees, 4.0 / 3.0, 1, 10);
  REQUIRE(view.ok());
  CHECK(view->top == Approx(0.57735).margin(1e-5));
  CHECK(view->right == Approx(0.76980).margin(1e-5));
  CHECK(view->bottom == -view->top);
  CHECK(view->left == -view->right);

  const auto clip_from_view = perspective(kSixtyDegrees, 4.0 / 3.0, 1, 10, ClipVolume::minus_w_to_w);
  REQUIRE(clip_from_view.ok());
  CHECK(ndc_depth(*clip_from_view, 1) == Approx(-1.0).margin(1e-6));
  CHECK(ndc_depth(*clip_from_view, 2) == Approx(0.11111).margin(1e-5));
  CHECK(ndc_depth(*clip_from_view, 5) == Approx(0.77778).margin(1e-5));
  CHECK(ndc_depth(*clip_from_view, 10) == Approx(1.0).margin(1e-6));
}

TEST_CASE("transforms: the window's corners land on the corners of ndc", "[math]") {
  const ViewVolume off_axis{.left = -0.5, .right = 1.5, .bottom = -0.25, .top = 0.75, .near_distance = 2,
                            .far_distance = 20};
  const auto project = GENERATE(&frustum, &orthographic);
  const auto clip_from_view = project(off_axis, ClipVolume::minus_w_to_w, false);
  REQUIRE(clip_from_view.ok());
  const glm::vec4 lower_left = *clip_from_view * glm::vec4(-0.5f, -0.25f, -2, 1);
  const glm::vec4 upper_right = *clip_from_view * glm::vec4(1.5f, 0.75f, -2, 1);
  check_near(lower_left / lower_left.w, glm::vec4(-1, -1, -1, 1), 1e-6);
  check_near(upper_right / upper_right.w, glm::vec4(1, 1, -1, 1), 1e-6);
  CHECK(lower_left.w > 0.0f);
}

TEST_CASE("transforms: near and far get the ends of z of every convention", "[math]") {
  const ViewVolume view{.near_distance = 0.5, .far_distance = 50};
  for (const auto project : {&frustum, &orthographic})
    for (const ClipVolume volume : {ClipVolume::minus_w_to_w, ClipVolume::zero_to_w})
      for (const bool reversed : {false, true}) {
        const auto matrix = project(view, volume, reversed);
        REQUIRE(matrix.ok());
        const double low = volume == ClipVolume::zero_to_w ? 0.0 : -1.0;
        CHECK(ndc_depth(*matrix, 0.5) == Approx(reversed ? 1.0 : low).margin(1e-6));
        CHECK(ndc_depth(*matrix, 50) == Approx(reversed ? low : 1.0).margin(1e-6));
        CHECK((ndc_depth(*matrix, 10) < ndc_depth(*matrix, 11)) == !reversed);
      }
}

TEST_CASE("transforms: an infinite far plane is the limit of far ones", "[math]") {
  const auto matrix = perspective(kSixtyDegrees, 1, 0.1, kInfinity, ClipVolume::zero_to_w, true);
  REQUIRE(matrix.ok());
  CHECK(ndc_depth(*matrix, 0.1) == Approx(1.0).margin(1e-6));
  CHECK(ndc_depth(*matrix, 1e30) > 0.0);
  CHECK(ndc_depth(*matrix, 1e30) == Approx(0.0).margin(1e-6));
}

// rules, case 32
TEST_CASE("transforms: reversed float depth orders what a 24-bit buffer ties", "[math]") {
  const auto usual = perspective(kSixtyDegrees, 1, 0.1, 1e4, ClipVolume::zero_to_w);
  const auto reversed = perspective(kSixtyDegrees, 1, 0.1, 1e4, ClipVolume::zero_to_w, true);
  REQUIRE(usual.ok());
  REQUIRE(reversed.ok());
  const auto code24 = [&](double distance) { return std::floor(ndc_depth(*usual, distance) * 16777215.0 + 0.5); };
  CHECK(code24(1000) == code24(1000.05));
  CHECK(static_cast<float>(ndc_depth(*reversed, 1000)) > static_cast<float>(ndc_depth(*reversed, 1000.05)));
}

TEST_CASE("transforms: bad view parameters are refused by name and value", "[math][bad-input]") {
  const auto perspective_message = [](double fovy, double aspect, double n, double f) {
    const auto matrix = perspective(fovy, aspect, n, f, ClipVolume::minus_w_to_w);
    REQUIRE_FALSE(matrix.ok());
    return matrix.error().message;
  };
  CHECK(perspective_message(0, 1, 1, 10) == "fovy_radians is 0, but must be greater than 0 and less than pi");
  CHECK_THAT(perspective_message(3.2, 1, 1, 10), Catch::Contains("fovy_radians is 3.2"));
  CHECK_THAT(perspective_message(kNaN, 1, 1, 10), Catch::Contains("fovy_radians is"));
  CHECK_THAT(perspective_message(1, 0, 1, 10), Catch::Contains("aspect is 0"));
  CHECK_THAT(perspective_message(1, 1, 0, 10), Catch::Contains("near_distance is 0"));
  CHECK_THAT(perspective_message(1, 1, -1, 10), Catch::Contains("near_distance is -1"));
  CHECK_THAT(perspective_message(1, 1, 1, 1), Catch::Contains("far_distance is 1"));
  CHECK_THAT(perspective_message(1, 1, 1, kNaN), Catch::Contains("far_distance is"));

  const auto volume_message = [](const auto project, const ViewVolume& view) {
    const auto matrix = project(view, ClipVolume::minus_w_to_w, false);
    REQUIRE_FALSE(matrix.ok());
    return matrix.error().message;
  };
  for (const auto project : {&frustum, &orthographic}) {
    CHECK_THAT(volume_message(project, {.left = 2, .right = 2}), Catch::Contains("right is 2"));
    CHECK_THAT(volume_message(project, {.bottom = 1, .top = -1}), Catch::Contains("top is -1"));
    CHECK_THAT(volume_message(project, {.left = -kInfinity}), Catch::Contains("left is -inf"));
    CHECK_THAT(volume_message(project, {.near_distance = 5, .far_distance = 4}), Catch::Contains("far_distance is 4"));
  }
  CHECK_THAT(volume_message(&orthographic, {.far_distance = kInfinity}), Catch::Contains("far_distance is inf"));
  CHECK(orthographic({.near_distance = -1, .far_distance = 1}, ClipVolume::minus_w_to_w).ok());
}

TEST_CASE("transforms: a quarter turn about each axis moves the next axis to the one after it", "[math]") {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 about(0.0);
    about[axis] = 2.0;
    glm::vec4 source(0.0f), target(0.0f);
    source[(axis + 1) % 3] = 1.0f;
    target[(axis + 2) % 3] = 1.0f;
    check_near(rotation(about, std::numbers::pi / 2) * source, target, 1e-6);
  }
  CHECK(rotation({0, 0, 0}, 1.0) == glm::mat4(1.0f));
}

TEST_CASE("transforms: composed matrices apply the right one first", "[math]") {
  const glm::mat4 move_then_scale = compose(scaling({2, 3, 4}), translation({1, 1, 1}));
  CHECK(move_then_scale * glm::vec4(0, 0, 0, 1) == glm::vec4(2, 3, 4, 1));
  CHECK(compose(translation({1, 1, 1}), scaling({2, 3, 4})) * glm::vec4(0, 0, 0, 1) == glm::vec4(1, 1, 1, 1));
}

TEST_CASE("transforms: transformed normals stay perpendicular, mirrored or not", "[math]") {
  const double mirror = GENERATE(1.0, -1.0);
  const glm::mat4 model = compose(rotation({1, 2, 3}, 0.7), scaling({2 * mirror, 0.25, 5}));
  const glm::mat3 normals = normal_matrix(model), linear(model);
  const glm::vec3 tangent(1, -2, 0.5f), bitangent(0.25f, 1, 3);
  const glm::vec3 normal = glm::normalize(normals * glm::cross(tangent, bitangent));
  CHECK(glm::dot(normal, glm::normalize(linear * tangent)) == Approx(0.0).margin(1e-6));
  CHECK(glm::dot(normal, glm::normalize(linear * bitangent)) == Approx(0.0).margin(1e-6));
}

TEST_CASE("transforms: the normal matrix of a rotation is the rotation", "[math]") {
  const glm::mat4 turn = rotation({-1, 0.5, 2}, 1.1);
  for (int column = 0; column < 3; ++column)
    check_near(normal_matrix(turn)[column], glm::vec3(turn[column]), 1e-6);
}

TEST_CASE("transforms: a singular matrix gives finite normals", "[math]") {
  // Flattened to the plane z = 0: what can still be seen of any surface faces along z.
  const glm::mat3 flat = normal_matrix(scaling({2, 3, 0}));
  CHECK(flat * glm::vec3(0, 0, 1) == glm::vec3(0, 0, 1));
  CHECK(normal_matrix(scaling({2, 0, 0})) == glm::mat3(1.0f));
  CHECK(normal_matrix(scaling({0, 0, 0})) == glm::mat3(1.0f));
  for (const double factor : {1e-30, 1e-10, 1e10, 1e30}) {
    const glm::mat3 normals = normal_matrix(scaling({factor, factor, factor}));
    CHECK(std::isnormal(normals[0][0]));
    CHECK(normals[0][0] == Approx(1.0 / factor).epsilon(1e-6));
  }
}

}  // namespace tuberia
