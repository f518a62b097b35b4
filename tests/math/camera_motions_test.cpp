// How a camera is moved, and what each motion keeps.

#include "math/camera_motions.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace tuberia {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Camera notes_camera() {
  return {.eye = {3, 4, 5}, .point_of_interest = {0, 0, 0}, .up = {0, 1, 0}, .view = *perspective_volume(1.0, 4.0 / 3, 1, 10)};
}

void check_close(const glm::dvec3& actual, const glm::dvec3& expected, double margin) {
  CAPTURE(actual.x, actual.y, actual.z, expected.x, expected.y, expected.z);
  CHECK(glm::distance(actual, expected) < margin);
}

/// Orthonormal, looking at the point of interest, and the same as eye, point and up say.
void check_sound(const Camera& camera) {
  const CameraBasis stored = *basis_of(camera);
  const CameraBasis look_at = *camera_basis(camera.eye, camera.point_of_interest, camera.up);
  check_close(stored.u, look_at.u, 1e-11);
  check_close(stored.v, look_at.v, 1e-11);
  check_close(stored.w, look_at.w, 1e-11);
  CHECK(glm::length(stored.u) == Approx(1).epsilon(1e-14));
  CHECK(glm::length(glm::cross(stored.u, stored.v) - stored.w) < 1e-14);
}

std::string refused(const Result<Camera>& camera) { return camera ? "(accepted)" : camera.error().message; }

}  // namespace

TEST_CASE("camera: the look-at system of the notes", "[C12][C22]") {
  const Camera camera = notes_camera();
  const CameraBasis basis = *basis_of(camera);
  check_close(basis.w, {0.42426, 0.56569, 0.70711}, 1e-5);
  check_close(basis.u, {0.85749, 0, -0.51450}, 1e-5);
  check_close(basis.v, {-0.29104, 0.82462, -0.48507}, 1e-5);
  const glm::mat4 view = camera_matrices(camera)->view_from_world;
  CHECK(glm::length(view * glm::vec4(3, 4, 5, 1) - glm::vec4(0, 0, 0, 1)) < 1e-6f);
  CHECK(glm::length(view * glm::vec4(0, 0, 0, 1) - glm::vec4(0, 0, -7.07107f, 1)) < 1e-5f);
  const glm::mat3 rotation(view);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) CHECK(glm::dot(rotation[i], rotation[j]) == Approx(i == j ? 1 : 0).margin(1e-6));
}

TEST_CASE("camera: up parallel to the view is reported by every motion", "[C12]") {
  Camera camera{.eye = {0, 5, 0}, .point_of_interest = {0, 0, 0}, .up = {0, 1, 0}};
  for (const auto& moved : {pan(camera, 1, 1), dolly(camera, 1), orbit(camera, {.right = 1}), pitch(camera, 1), yaw(camera, 1), roll(camera, 1)})
    CHECK(refused(moved) == "up (0, 1, 0) is parallel to the line of sight");
  CHECK(!frustum_planes(camera).ok());
  camera.basis = CameraBasis{.u = {1, 0, 0}, .v = {0, 0, -1}, .w = {0, 1, 0}};  // with axes of its own it may look straight down
  CHECK(frustum_planes(camera).ok());
  CHECK(camera_matrices(*pan(camera, 1, 1)).ok());
  camera.basis->u = {0.9, 0, 0};
  CHECK(camera_matrices(camera).error().message == "basis is not orthonormal and right-handed");
}

TEST_CASE("camera: the openings of the notes", "[C10][C11]") {
  const ViewVolume view = *perspective_volume(kTurn / 6, 4.0 / 3, 1, 10);
  CHECK(view.top == Approx(0.57735).margin(1e-5));
  CHECK(view.right == Approx(0.76980).margin(1e-5));
  CHECK(view.bottom == -view.top);
  CHECK(view.left == -view.right);
  const double field_width = 2 * std::atan(view.right / view.near_distance), field_height = 2 * std::atan(view.top / view.near_distance);
  CHECK(std::tan(field_width / 2) / std::tan(field_height / 2) == Approx(4.0 / 3));
  const glm::mat4 clip_from_view = *frustum(view, ClipVolume::minus_w_to_w);
  for (const auto& [distance, depth] : {std::pair{1.0f, -1.0}, {2.0f, 0.11111}, {5.0f, 0.77778}, {10.0f, 1.0}}) {
    const glm::vec4 clip = clip_from_view * glm::vec4(0, 0, -distance, 1);
    CHECK(clip.z / clip.w == Approx(depth).margin(1e-5));
  }

  CHECK(*orthographic_volume(4, 2, -1, 9) == ViewVolume{-2, 2, -1, 1, -1, 9});
  CHECK(orthographic_volume(0, 2, 1, 9).error().message == "width is 0, but must be finite and greater than 0");
  const auto lost = orthographic_volume(4, std::numeric_limits<double>::quiet_NaN(), 1, 9);
  CHECK(lost.error().message == "height is nan, but must be finite and greater than 0");
  CHECK(orthographic_volume(4, 2, 9, 9).error().message == "far_distance is 9, but must be finite and greater than near_distance");
}

TEST_CASE("camera: panning keeps the axes to the last bit, wherever the eye goes", "[C13]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> step(-1000, 1000);
  Camera camera = notes_camera();
  camera.eye = {0.1, 0.2, 0.7};  // numbers whose last bits are lost far from the origin
  const CameraBasis basis = *basis_of(camera);
  const glm::dvec3 line_of_sight = camera.point_of_interest - camera.eye;
  for (int i = 0; i < 1000; ++i) {
    const double right = step(random), up = step(random);
    const glm::dvec3 before = camera.eye;
    camera = *pan(camera, right, up);
    REQUIRE(*basis_of(camera) == basis);
    check_close(camera.eye - before, right * basis.u + up * basis.v, 1e-9);
    check_close(camera.point_of_interest - camera.eye, line_of_sight, 1e-9);
  }
  CHECK(camera.up == glm::dvec3(0, 1, 0));
  CHECK(camera.view == notes_camera().view);
  CHECK(refused(pan(camera, 0, std::numeric_limits<double>::infinity())) == "up is inf, but must be finite");
}

TEST_CASE("camera: zoom by distance moves the eye along w only", "[C14]") {
  const Camera camera = notes_camera(), near = *dolly(camera, 5), far = *dolly(near, -20);
  CHECK(*basis_of(near) == *basis_of(camera));
  CHECK(*basis_of(far) == *basis_of(camera));
  CHECK(far.view == camera.view);
  CHECK(far.point_of_interest == camera.point_of_interest);
  CHECK(vertical_field(near) == vertical_field(camera));
  CHECK(glm::length(near.eye) == Approx(std::sqrt(50.0) - 5));
  check_close(far.eye, camera.eye + 15.0 * basis_of(camera)->w, 1e-12);
  check_sound(far);
  CHECK_THAT(refused(dolly(camera, 7.08)), Catch::Contains("forwards is 7.08, but must be less than the distance to the point of interest"));
}

TEST_CASE("camera: zoom by field changes the opening only", "[C15]") {
  const Camera camera = notes_camera(), zoomed = *zoom_field(camera, 0.3);
  CHECK(vertical_field(camera) == Approx(1));
  CHECK(vertical_field(zoomed) == Approx(0.3));
  Camera kept = zoomed;
  kept.view = camera.view;
  CHECK(kept == camera);  // nothing else
  CHECK(zoomed.view.near_distance == camera.view.near_distance);

  // A point's image moves away from the centre by the ratio of the tangents.
  const glm::vec4 point(0.3f, 0.2f, -0.5f, 1);
  const glm::vec4 before = camera_matrices(camera)->clip_from_world * point, after = camera_matrices(zoomed)->clip_from_world * point;
  const double ratio = std::tan(0.5) / std::tan(0.15);
  CHECK(after.x / after.w == Approx(ratio * before.x / before.w).epsilon(1e-5));
  CHECK(after.y / after.w == Approx(ratio * before.y / before.w).epsilon(1e-5));

  CHECK_THAT(refused(zoom_field(camera, 0)), Catch::Contains("fovy_radians is 0"));
  Camera parallel = camera;
  parallel.projection = Projection::orthographic;
  CHECK(refused(zoom_field(parallel, 0.5)) == "an orthographic camera has no field of view to zoom by");
}

TEST_CASE("camera: the eye orbits on a sphere and comes back after a turn", "[C16]") {
  for (const OrbitMotion& step : {OrbitMotion{.right = kTurn / 360}, OrbitMotion{.up = kTurn / 360},
                                  OrbitMotion{.right = kTurn / 360, .vertical = glm::dvec3(0, 3, 0)}}) {
    const Camera start = notes_camera();
    Camera camera = start;
    for (int i = 0; i < 360; ++i) {
      camera = *orbit(camera, step);
      REQUIRE(glm::length(camera.eye) == Approx(std::sqrt(50.0)).epsilon(1e-13));
      REQUIRE(camera.point_of_interest == start.point_of_interest);
      check_sound(camera);  // over the poles, too
    }
    check_close(camera.eye, start.eye, 1e-12);
    check_close(basis_of(camera)->u, basis_of(start)->u, 1e-12);
    check_close(basis_of(camera)->v, basis_of(start)->v, 1e-12);
    CHECK(camera.view == start.view);
  }
}

TEST_CASE("camera: senses of the orbit, and the inverted ones of inspection", "[C16]") {
  const Camera camera{.eye = {0, 0, 3}, .point_of_interest = {0, 0, 0}, .up = {0, 1, 0}};
  check_close(orbit(camera, {.right = kTurn / 4})->eye, {3, 0, 0}, 1e-14);
  check_close(orbit(camera, {.up = kTurn / 4})->eye, {0, 3, 0}, 1e-14);
  check_close(basis_of(*orbit(camera, {.up = kTurn / 4}))->v, {0, 0, -1}, 1e-14);
  check_close(orbit(camera, {.right = kTurn / 4, .inspection = true})->eye, {-3, 0, 0}, 1e-14);
  check_close(orbit(camera, {.up = kTurn / 4, .inspection = true})->eye, {0, -3, 0}, 1e-14);

  // About the world's vertical the eye's height stays, about a leaning camera's own v it does not.
  const Camera above = *orbit(camera, {.up = 0.5});
  const Camera turntable = *orbit(above, {.right = 1, .vertical = glm::dvec3(0, 1, 0)});
  CHECK(turntable.eye.y == Approx(above.eye.y).epsilon(1e-14));
  CHECK(std::abs(basis_of(turntable)->u.y) < 1e-15);  // and the horizon stays level
  CHECK(orbit(above, {.right = 1})->eye.y < above.eye.y - 0.1);
  CHECK(refused(orbit(camera, {.right = 1, .vertical = glm::dvec3(0)})) == "vertical has no direction");
  CHECK(refused(orbit(camera, {.right = std::numeric_limits<double>::quiet_NaN()})) == "right is nan, but must be finite");
}

TEST_CASE("camera: turns of the head keep the eye and their axis to the last bit", "[C17]") {
  const Camera camera = notes_camera();
  const CameraBasis before = *basis_of(camera);
  const Camera raised = *pitch(camera, 0.3), left = *yaw(camera, 0.3), leaning = *roll(camera, 0.3);
  for (const Camera& turned : {raised, left, leaning}) {
    CHECK(turned.eye == camera.eye);
    CHECK(turned.view == camera.view);
    CHECK(glm::distance(turned.eye, turned.point_of_interest) == Approx(std::sqrt(50.0)).epsilon(1e-14));
    check_sound(turned);
  }
  CHECK(basis_of(raised)->u == before.u);
  CHECK(basis_of(left)->v == before.v);
  CHECK(basis_of(leaning)->w == before.w);
  CHECK(leaning.point_of_interest == camera.point_of_interest);
  check_close(-basis_of(raised)->w, -std::cos(0.3) * before.w + std::sin(0.3) * before.v, 1e-14);
  check_close(-basis_of(left)->w, -std::cos(0.3) * before.w - std::sin(0.3) * before.u, 1e-14);
  check_close(basis_of(leaning)->v, std::cos(0.3) * before.v - std::sin(0.3) * before.u, 1e-14);

  // The image of a point turns clockwise by the angle when the head leans to the left (the window is square here).
  Camera square = camera, square_leaning = leaning;
  square.view = square_leaning.view = *perspective_volume(1.0, 1.0, 1, 20);
  const glm::vec4 point(1, 0.5f, 0, 1);
  const glm::vec4 a = camera_matrices(square)->clip_from_world * point, b = camera_matrices(square_leaning)->clip_from_world * point;
  CHECK(std::atan2(a.y, a.x) - std::atan2(b.y, b.x) == Approx(0.3).epsilon(1e-5));
  CHECK(std::hypot(a.x, a.y) == Approx(std::hypot(b.x, b.y)));

  Camera many = camera;
  for (int i = 0; i < 1000; ++i) many = *roll(*yaw(*pitch(many, 0.1), -0.2), 0.3);
  check_sound(many);
  CHECK(many.eye == camera.eye);
  CHECK(refused(yaw(camera, std::numeric_limits<double>::infinity())) == "angle_radians is inf, but must be finite");
}

TEST_CASE("camera: six planes hold what the clip volume holds", "[C09]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> near_eye(-20, 20);
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const ClipVolume volume : {ClipVolume::minus_w_to_w, ClipVolume::zero_to_w}) {
      Camera camera = notes_camera();
      camera.projection = projection;
      camera.clip_volume = volume;
      camera.view = projection == Projection::perspective ? ViewVolume{-0.5, 0.8, -0.3, 0.6, 1, 15} : ViewVolume{-5, 8, -3, 6, 1, 15};
      const auto planes = *frustum_planes(camera);
      const glm::dmat4 clip_from_world(camera_matrices(camera)->clip_from_world);
      int inside_count = 0;
      for (int i = 0; i < 20000; ++i) {
        const glm::dvec4 point(near_eye(random), near_eye(random), near_eye(random), 1);
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec4& plane : planes) least = std::min(least, glm::dot(plane, point));
        if (std::abs(least) < 1e-4) continue;  // the matrix was rounded to floats
        const glm::dvec4 clip = clip_from_world * point;
        const double back = volume == ClipVolume::zero_to_w ? 0 : -clip.w;
        const bool inside = std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && clip.z >= back && clip.z <= clip.w;
        REQUIRE(inside == (least > 0));
        inside_count += inside;
      }
      CHECK(inside_count > 100);
      // Distances: the eye lies on the sides of a perspective volume and near_distance before the near plane.
      CHECK(glm::dot(planes[4], glm::dvec4(camera.eye, 1)) == Approx(-1));
      CHECK(glm::dot(planes[5], glm::dvec4(camera.eye, 1)) == Approx(15));
      CHECK(glm::dot(planes[0], glm::dvec4(camera.eye, 1)) == Approx(projection == Projection::perspective ? 0 : 5).margin(1e-14));
    }
  Camera endless = notes_camera();
  endless.view.far_distance = std::numeric_limits<double>::infinity();
  CHECK((*frustum_planes(endless))[5] == glm::dvec4(0, 0, 0, 1));
}

}  // namespace tuberia
