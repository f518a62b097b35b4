// Where corners of triangles are in the picture, exactly and as the pipeline's floats have it.

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/geometric.hpp>

#include "examples/tuberia/witness/explaining.hpp"
#include "scene/content/object_content.hpp"
#include "scene/content/placement.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/description/read_scene.hpp"

namespace tuberia::witness {
namespace {

constexpr glm::ivec2 kLargePicture{1000, 667};

/// How far, in pixels, float matrices move what is seen of a mesh.
double largest_error(const Mesh& mesh, const glm::mat4& world_from_object, const Camera& camera) {
  const PictureGrid grid(camera, *basis_of(camera), kLargePicture);
  const glm::mat4 clip_from_object = compose(camera_matrices(camera)->clip_from_world, world_from_object);
  double largest = 0;
  for (const glm::vec3& position : mesh.positions) {
    const glm::dvec3 exact = grid.screen_from_world(glm::dvec3(glm::dmat4(world_from_object) * glm::dvec4(glm::dvec3(position), 1)));
    const bool is_seen = exact.z >= camera.view.near_distance && glm::all(glm::greaterThan(glm::dvec2(exact), glm::dvec2(0))) && exact.x < kLargePicture.x && exact.y < kLargePicture.y;
    if (camera.projection == Projection::perspective && !is_seen) continue;
    const glm::dvec4 clip(clip_from_object * glm::vec4(position, 1));
    const glm::dvec2 drawn = (glm::dvec2(clip.x, -clip.y) / clip.w + 1.0) / 2.0 * glm::dvec2(kLargePicture);
    largest = std::max(largest, glm::length(drawn - glm::dvec2(exact)));
  }
  return largest;
}

}  // namespace

TEST_CASE("tracer witness: floats move corners by less than a quarter of 1/256 pixel", "[Y5][tracer_witness]") {
  double largest = 0;
  for (const char* name : {"04_phong", "10_shading", "21_parametric_mapping", "22b_tunnel_trilinear", "32_water", "44_film", "50_shadows"}) {
    const auto scene = read_scene("examples/scenes/" + std::string(name) + ".json");
    REQUIRE(scene);
    const auto camera = camera_of(scene->camera, static_cast<double>(kLargePicture.x) / kLargePicture.y);
    REQUIRE(camera);
    std::vector<std::string> warnings;
    for (const description::Object& object : scene->objects) {
      const auto parts = content_of(*scene, object, warnings);
      REQUIRE(parts);
      for (const ContentPart& part : *parts) largest = std::max(largest, largest_error(part.mesh, float_matrix_of(object.transforms), *camera));
    }
  }
  CAPTURE(largest * 256);
  CHECK(largest < 0.25 / 256);
  CHECK(largest > 0.001 / 256);  // or nothing was compared
}

TEST_CASE("tracer witness: weights on the grid are those of the snapped triangle", "[Y5][tracer_witness]") {
  Camera camera{.eye = {0, 0, 5}, .point_of_interest = {0, 0, 0}};
  camera.view = {.left = -1, .right = 1, .bottom = -1, .top = 1, .near_distance = 1, .far_distance = 20};
  const PictureGrid grid(camera, *basis_of(camera), {100, 100});
  const std::array<glm::dvec3, 3> corners{glm::dvec3(-1, -1, 0), glm::dvec3(1, -1, -3), glm::dvec3(0, 1, 1)};
  // At a corner's own place on the grid the weights are that corner's.
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 place = glm::round(glm::dvec2(grid.screen_from_world(corners[k])) * 256.0) / 256.0;
    const auto weights = grid.weights_at(corners, place);
    REQUIRE(weights);
    CHECK(glm::length(*weights - glm::dvec2(k == 1, k == 2)) < 1e-12);
  }
  // Half way on the screen between distances 5 and 8 is nearer to the first corner: 1/8 to 1/5.
  const glm::dvec2 a = glm::round(glm::dvec2(grid.screen_from_world(corners[0])) * 256.0) / 256.0, b = glm::round(glm::dvec2(grid.screen_from_world(corners[1])) * 256.0) / 256.0;
  CHECK(grid.weights_at(corners, (a + b) / 2.0)->x == Approx(5.0 / 13));
  // What reaches behind the near plane is cut before it gets here.
  CHECK_FALSE(grid.weights_at({glm::dvec3(0, 0, 4.5), corners[1], corners[2]}, a));
}

}  // namespace tuberia::witness
