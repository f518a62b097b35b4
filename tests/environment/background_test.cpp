// The environment behind a scene, and scenes as environments.

#include <catch2/catch.hpp>

#include "scene/environment/background.hpp"
#include "scene/environment/read_environment.hpp"
#include "scene/environment/render_cube.hpp"
#include "raster/cube_map.hpp"
#include "tests/support/environments.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {
namespace {

using test::largest_component;
using test::radiance_of;

/// The unit direction that a camera sees at a pixel's centre; from its own axes, in double.
glm::dvec3 seen_direction(const Camera& camera, int width, int height, int x, int y) {
  const CameraBasis basis = *camera_basis(camera.eye, camera.point_of_interest, camera.up);
  if (camera.projection == Projection::orthographic) return -basis.w;
  const double across = camera.view.left + (camera.view.right - camera.view.left) * (x + 0.5) / width;
  const double up = camera.view.top + (camera.view.bottom - camera.view.top) * (y + 0.5) / height;
  return glm::normalize(across * basis.u + up * basis.v - camera.view.near_distance * basis.w);
}

/// A room from (-2, -1, -3) to (2, 3, 3), seen from within. Each point of a wall has its own colour: its place in the room.
struct Room {
  static constexpr glm::dvec3 kLow{-2, -1, -3}, kHigh{2, 3, 3};
  test::Mesh mesh;

  Room() {
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 at(corner & 1 ? kHigh.x : kLow.x, corner & 2 ? kHigh.y : kLow.y, corner & 4 ? kHigh.z : kLow.z);
      mesh.positions.push_back(at);
      mesh.colours.push_back(glm::vec4(glm::vec3((glm::dvec3(at) - kLow) / (kHigh - kLow)), 1));
    }
    // Each wall's corners counter-clockwise as seen from within.
    const std::uint32_t walls[6][4] = {{1, 5, 7, 3}, {0, 2, 6, 4}, {2, 3, 7, 6}, {0, 4, 5, 1}, {4, 6, 7, 5}, {0, 1, 3, 2}};
    for (const auto& wall : walls)
      for (const int k : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(wall[k]);
  }

  static Result<Nothing> draw(const Room& room, Pipeline& pipeline, RenderTarget& target, const Camera& camera) {
    DrawCall call{.mesh = room.mesh.view(), .program = gouraud(), .state = {}};
    call.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
    call.state.clipping.volume = camera.clip_volume;
    call.state.culling.cull = CullFace::back;
    if (camera.reversed_depth) call.state.depth.test = Compare::greater;
    const auto drawn = pipeline.draw(target, call);
    if (!drawn) return drawn.error();
    return Nothing{};
  }
  DrawScene scene() const {
    return [this](Pipeline& pipeline, RenderTarget& target, const Camera& camera) { return draw(*this, pipeline, target, camera); };
  }

  /// The colour of the wall in a direction from a point within.
  static glm::dvec3 colour_towards(const glm::dvec3& eye, const glm::dvec3& direction) {
    double distance = 1e30;
    for (int axis = 0; axis < 3; ++axis)
      if (direction[axis] != 0) distance = std::min(distance, ((direction[axis] > 0 ? kHigh : kLow)[axis] - eye[axis]) / direction[axis]);
    return (eye + distance * direction - kLow) / (kHigh - kLow);
  }
};

}  // namespace

TEST_CASE("background: each pixel shows the environment in its own direction", "[environment][A36]") {
  const Image<Rgba32F> panorama = panorama_of(test::sunless_sky(), 256, 128);
  EnvironmentMap map = *panorama_map(panorama);
  map.sampler.mipmaps = MipmapFilter::none;
  const Surroundings expected = panorama_surroundings(panorama);

  Camera straight{.eye = {1, 2, 3}, .point_of_interest = {4, 3, -1}};
  straight.view = *perspective_volume(1.1, 48.0 / 32, 0.1, 50);
  Camera reversed = straight, off_axis = straight, parallel = straight, endless = straight;
  reversed.reversed_depth = true;
  reversed.clip_volume = ClipVolume::zero_to_w;
  off_axis.view.left = 0.2 * off_axis.view.right;
  off_axis.up = {0.3, 1, 0.1};
  off_axis.reversed_depth = true;
  parallel.projection = Projection::orthographic;
  endless.view.far_distance = std::numeric_limits<double>::infinity();
  for (const Camera& camera : {straight, reversed, off_axis, parallel, endless}) {
    test::Canvas canvas = test::float_canvas(0);
    canvas.width = 48;
    canvas.height = 32;
    canvas.far_depth = camera.reversed_depth ? 0.0f : 1.0f;
    test::Studio studio(canvas);
    const auto background = Background::create(camera);
    REQUIRE(background);
    REQUIRE(studio.pipeline().draw(studio.target(), background->draw(map)));
    const Image<Rgba32F> seen = studio.target().linear_image();
    double most = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 48; ++x)
        most = std::max(most, largest_component(radiance_of(seen.at(x, y)) - expected.radiance(seen_direction(camera, 48, 32, x, y))));
    CHECK(most < 1e-3);
    CHECK(studio.target().depth_image().at(20, 20) == canvas.far_depth);
  }
}

TEST_CASE("background: what was drawn before stays in front", "[environment][A36]") {
  const EnvironmentMap map = *panorama_map(Image<Rgba32F>(4, 2, {0, 1, 0, 1}));
  Camera camera{.eye = {0, 0, 4}};
  camera.view = *perspective_volume(0.9, 1, 0.5, 20);
  test::Studio studio(test::float_canvas(32));
  PipelineState state;
  state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
  studio.draw(test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1, {1, 0, 0, 1}).view(), flat(), state);
  REQUIRE(studio.pipeline().draw(studio.target(), Background::create(camera)->draw(map)));
  CHECK(studio.target().linear_image().at(16, 16) == Rgba32F{1, 0, 0, 1});
  CHECK(studio.target().linear_image().at(1, 1) == Rgba32F{0, 1, 0, 1});
  camera.up = {0, 0, 1};
  CHECK_FALSE(Background::create(camera));
}

TEST_CASE("render to cube: every texel shows the wall in its direction", "[environment][A30][C38][B37]") {
  const Room room;
  for (const bool reversed : {false, true}) {
    const CubeView view{.eye = {0.5, 0.25, -1}, .size_pixels = 24, .near_distance = 0.1, .far_distance = 20,
                        .clip_volume = reversed ? ClipVolume::zero_to_w : ClipVolume::minus_w_to_w, .reversed_depth = reversed};
    Pipeline pipeline({.threads = 1});
    const auto faces = render_cube(pipeline, view, room.scene());
    REQUIRE(faces);
    for (int face = 0; face < 6; ++face) {
      double most = 0;
      for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
          const glm::dvec3 expected = Room::colour_towards(view.eye, test::pixel_direction(face, 24, x, y));
          most = std::max(most, largest_component(radiance_of((*faces)[static_cast<std::size_t>(face)].at(x, y)) - expected));
        }
      INFO("face " << cube_face_name(face));
      CHECK(most < 1e-3);
    }
  }
}

TEST_CASE("render to cube: programs read the room from the texture, without seams", "[environment][A30][C38][A29]") {
  const Room room;
  const CubeView view{.eye = {0.5, 0.25, -1}, .size_pixels = 64};
  Pipeline pipeline({.threads = 1});
  const auto faces = render_cube(pipeline, view, room.scene());
  REQUIRE(faces);
  const auto map = cube_map(*faces);
  REQUIRE(map);
  for (int face = 0; face < 6; ++face) {
    // Pixels between the texels' centres, up to the very edges of the face.
    const Image<Rgba32F> seen = test::looked_up(*map, face, 50);
    double sum = 0, most = 0;
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 50; ++x) {
        const double apart = largest_component(radiance_of(seen.at(x, y)) - Room::colour_towards(view.eye, test::pixel_direction(face, 50, x, y)));
        sum += apart / 2500;
        most = std::max(most, apart);
      }
    INFO("face " << cube_face_name(face));
    CHECK(255 * sum < 0.5);
    CHECK(255 * most < 8);  // where walls meet, a texel is their mean: it spans 1/32 of the distance, which is less than the room's size
  }
  // Neighbours' border texels, a texel's width apart, differ no more than that width explains.
  const Surroundings cube = cube_surroundings(*faces);
  for (int i = 0; i < 64; ++i) {
    const double along = (i + 0.5) / 32 - 1;
    for (int edge = 0; edge < 12; ++edge) {
      glm::dvec3 d(edge & 1 ? 1 : -1, edge & 2 ? 1 : -1, edge & 1 ? 1 : -1);
      d[edge / 4] = along;
      const glm::dvec3 expected = Room::colour_towards(view.eye, d);
      CHECK(255 * largest_component(cube.radiance(glm::normalize(d)) - expected) < 8);
    }
  }
}

TEST_CASE("render to cube: refused wishes name the face and the reason", "[environment][A30]") {
  Pipeline pipeline({.threads = 1});
  const DrawScene nothing = [](Pipeline&, RenderTarget&, const Camera&) -> Result<Nothing> { return Nothing{}; };
  CHECK(render_cube(pipeline, {.size_pixels = 2, .background = {0.5f, 2, 0, 1}}, nothing)->back().at(1, 0) == Rgba32F{0.5f, 2, 0, 1});
  CHECK(render_cube(pipeline, {.size_pixels = 0}, nothing).error().message.find("face +x") != std::string::npos);
  CHECK_FALSE(render_cube(pipeline, {.size_pixels = 4, .near_distance = 0}, nothing));
  CHECK_FALSE(render_cube(pipeline, {.size_pixels = 4, .samples = 3}, nothing));
  int draws = 0;
  const DrawScene fails_at_third = [&](Pipeline&, RenderTarget&, const Camera&) -> Result<Nothing> {
    if (++draws == 3) return Error{"no paint left"};
    return Nothing{};
  };
  CHECK(render_cube(pipeline, {.size_pixels = 4}, fails_at_third).error().message == "face +y: no paint left");
}

TEST_CASE("environment: faces in double are those of the kernels", "[environment][A29]") {
  test::Random random(651);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const CubePoint in_float = cube_point(d);
    const CubeFacePoint in_double = cube_face_point(d);
    INFO("seed 651, direction " << i);
    REQUIRE(in_double.face == in_float.face);
    CHECK(glm::length(in_double.at - glm::dvec2(in_float.s, in_float.t)) < 1e-6);
    CHECK(largest_component(cube_face_direction(in_double) - glm::dvec3(cube_direction(in_float))) < 1e-6);
  }
}

}  // namespace tuberia
