// Environment maps as images: where directions stand in them, conversions, files.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "image/write_image.hpp"
#include "scene/environment/directions.hpp"
#include "scene/environment/read_environment.hpp"
#include "scene/environment/sky.hpp"
#include "tests/image/temporary_folder.hpp"
#include "tests/support/random.hpp"

namespace tuberia {
namespace {

glm::dvec3 random_direction(test::Random& random) {
  while (true) {
    const glm::dvec3 d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (const double length = glm::length(d); length > 0.1 && length < 1) return d / length;
  }
}

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Smooth, different in every direction, in [0, 1].
Surroundings smooth_surroundings() {
  return {[](const glm::dvec3& d) { return 0.5 + 0.5 * glm::dvec3(d.x * d.y + 0.3 * d.z, d.y * 0.7 - 0.3 * d.x * d.z, 0.5 * d.z + 0.5 * d.x); }, 0.2};
}

/// How far two surroundings are apart over random directions that `counts` accepts.
struct SurroundingsDifference {
  double mean = 0, most = 0;
  int count = 0;
};
template <class Counts>
SurroundingsDifference difference_of(const Surroundings& a, const Surroundings& b, int directions, const Counts& counts) {
  test::Random random(601);
  SurroundingsDifference difference;
  while (difference.count < directions) {
    const glm::dvec3 d = random_direction(random);
    if (!counts(d)) continue;
    const double apart = largest(a.radiance(d) - b.radiance(d));
    difference.mean += apart / directions;
    difference.most = std::max(difference.most, apart);
    ++difference.count;
  }
  return difference;
}
bool every_direction(const glm::dvec3&) { return true; }

constexpr double kTwoCodes = 2.0 / 255;

}  // namespace

// notes 15.20
TEST_CASE("environment: where known directions stand in each map", "[scene][A29][A32][A33][B37]") {
  const CubeFacePoint known = cube_face_point({0.2, -0.3, 0.9});
  CHECK(known.face == 4);
  CHECK(known.at.x == Approx(0.61111).margin(1e-5));
  CHECK(known.at.y == Approx(0.66667).margin(1e-5));
  CHECK(cube_face_point({-1, 0, 0}).face == 1);
  CHECK(cube_face_point({-1, 0, 0}).at == glm::dvec2(0.5, 0.5));
  CHECK(sphere_map_point({0, 0, 1}) == glm::dvec2(0.5, 0.5));

  // A quarter of the turn from the middle, -z, to the right is +x; the zenith is at the top.
  CHECK(panorama_point({0, 0, -1}) == glm::dvec2(0.5, 0.5));
  CHECK(panorama_point({1, 0, 0}) == glm::dvec2(0.75, 0.5));
  CHECK(panorama_point({-2, 0, 0}) == glm::dvec2(0.25, 0.5));
  CHECK(panorama_point({0, 3, 0}) == glm::dvec2(0.5, 0));
  CHECK(panorama_point({0, -1, 0}) == glm::dvec2(0.5, 1));
  // The mirror ball's upper edge, as seen by the eye, shows what is behind it; half-way up the slope is 45
  // degrees, and shows the zenith.
  CHECK(sphere_map_point({0, 1, 0}).y == Approx(0.5 - std::sqrt(0.5) / 2));
  CHECK(sphere_map_point({1, 0, 0}).x == Approx(0.5 + std::sqrt(0.5) / 2));
  CHECK(sphere_map_point({0, 0, -1}) == glm::dvec2(1, 0.5));
}

TEST_CASE("environment: a point's direction leads back to it", "[scene]") {
  test::Random random(602);
  for (int i = 0; i < 1000; ++i) {
    INFO("seed 602, direction " << i);
    const glm::dvec3 d = random_direction(random);
    CHECK(largest(panorama_direction(panorama_point(d * 3.0)) - d) < 1e-12);
    CHECK(largest(sphere_map_direction(sphere_map_point(d * 0.1)) - d) < 1e-7);  // the rim loses digits
    CHECK(largest(glm::normalize(cube_face_direction(cube_face_point(d * 7.0))) - d) < 1e-12);
  }
  for (const auto at : {glm::dvec2(0, 0), glm::dvec2(1, 0.5), glm::dvec2(0.99, 0.9)}) CHECK(sphere_map_direction(at) == glm::dvec3(0, 0, -1));
}

TEST_CASE("environment: the zero vector counts as +z", "[scene]") {
  CHECK(panorama_point({0, 0, 0}) == panorama_point({0, 0, 1}));
  CHECK(sphere_map_point({0, 0, 0}) == sphere_map_point({0, 0, 1}));
  CHECK(cube_face_point({0, 0, 0}).face == 4);
  CHECK(cube_face_point({0, 0, 0}).at == glm::dvec2(0.5, 0.5));
  CHECK(std::isfinite(sky_radiance({}, {0, 0, 0}).r));
}

// The notes' recipe: n = (nx, ny, sqrt(1 - nx^2 - ny^2)), r = 2 nz n - z, look r up in the panorama.
TEST_CASE("environment: a converted map shows what the panorama shows", "[scene][A34][A29][A33]") {
  const Surroundings panorama = panorama_surroundings(panorama_of(smooth_surroundings(), 512, 256));
  CHECK(difference_of(panorama, smooth_surroundings(), 1000, every_direction).most < 0.001);

  const Surroundings cube = cube_surroundings(cube_of(panorama, 128));
  CHECK(difference_of(panorama, cube, 1000, every_direction).most < kTwoCodes);
  const Surroundings ball = sphere_map_surroundings(sphere_map_of(panorama, 512));
  const SurroundingsDifference by_ball = difference_of(panorama, ball, 1000, every_direction);
  CHECK(by_ball.mean < 0.2 * kTwoCodes);
  // Next to -z, which takes the whole rim, a texel spans a large angle along it.
  CHECK(difference_of(panorama, ball, 1000, [](const glm::dvec3& d) { return d.z > -0.99; }).most < kTwoCodes);

  // And back from each.
  CHECK(difference_of(panorama, panorama_surroundings(panorama_of(cube, 512, 256)), 1000, every_direction).most < kTwoCodes);
  CHECK(difference_of(panorama, panorama_surroundings(panorama_of(ball, 512, 256)), 1000, every_direction).mean < 0.2 * kTwoCodes);
}

TEST_CASE("environment: no map has a seam where its image ends", "[scene][A29][A33]") {
  const Surroundings panorama = panorama_surroundings(panorama_of(smooth_surroundings(), 128, 64));
  const Surroundings cube = cube_surroundings(cube_of(smooth_surroundings(), 32));
  test::Random random(603);
  for (int i = 0; i < 500; ++i) {
    const double height = random.between(-0.9f, 0.9f), step = 1e-6;
    CHECK(largest(panorama.radiance({-step, height, 1}) - panorama.radiance({step, height, 1})) < 1e-4);
    // Across each of the cube's twelve edges: two coordinates are equally large.
    const int axis = i % 3;
    glm::dvec3 d(i & 4 ? 1 : -1, i & 8 ? 1 : -1, i & 16 ? 1 : -1), nudged = d;
    d[axis] = nudged[axis] = height;
    nudged[(axis + 1) % 3] *= 1 - step;
    d[(axis + 2) % 3] *= 1 - step;
    INFO("seed 603, edge " << d.x << " " << d.y << " " << d.z);
    CHECK(largest(cube.radiance(d) - cube.radiance(nudged)) < 1e-4);
  }
}

TEST_CASE("environment: maps that are smaller than their source keep its mean", "[scene][A34]") {
  // A sun of radius r makes the share (1 - cos r) / 2 of the sphere; texels far larger than it must not miss it.
  const double radius = 0.05;
  const glm::dvec3 sun = glm::normalize(glm::dvec3(0.3, 0.5, 0.8));
  const Surroundings sky{[=](const glm::dvec3& d) { return glm::dvec3(glm::dot(d, sun) > std::cos(radius) ? 1000.0 : 0.0); }, radius / 4};
  const double expected = 1000 * (1 - std::cos(radius)) / 2;

  const int height = 32;
  const Image<Rgba32F> panorama = panorama_of(sky, 2 * height, height);
  double sum = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 2 * height; ++x) {
      const double low = std::cos(std::numbers::pi * y / height), high = std::cos(std::numbers::pi * (y + 1) / height);
      sum += static_cast<double>(panorama.at(x, y).r) * (low - high) / 2 / (2 * height);
    }
  CHECK(sum == Approx(expected).epsilon(0.1));

  double cube_sum = 0;
  const CubeImages cube = cube_of(sky, 16);
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const glm::dvec3 d = cube_face_direction({face, {(x + 0.5) / 16, (y + 0.5) / 16}});
        const double solid_angle = 4.0 / 256 / std::pow(glm::dot(d, d), 1.5);
        cube_sum += static_cast<double>(cube[static_cast<std::size_t>(face)].at(x, y).r) * solid_angle / (4 * std::numbers::pi);
      }
  CHECK(cube_sum == Approx(expected).epsilon(0.1));

  // The ball mirrors equal solid angles from equal areas of its disc.
  double ball_sum = 0;
  const Image<Rgba32F> ball = sphere_map_of(sky, 48);
  for (const Rgba32F& texel : ball.pixels()) ball_sum += static_cast<double>(texel.r) / (48 * 48 * std::numbers::pi / 4);
  CHECK(ball_sum == Approx(expected).epsilon(0.1));
}

TEST_CASE("environment: the sky is bright at its sun, dark below, and finite", "[scene]") {
  const Sky sky;
  CHECK(sky_radiance({.cloudiness = 0}, sky.towards_sun).r > 100);
  CHECK(sky_radiance(sky, {0, -1, 0}).r < 0.2);
  CHECK(sky_radiance({.cloudiness = 0}, {0, 1, 0}).b > sky_radiance({.cloudiness = 0}, {0, 1, 0}).r);
  test::Random random(604);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 radiance = sky_radiance(sky, random_direction(random));
    CHECK((std::isfinite(radiance.r + radiance.g + radiance.b) && std::min({radiance.r, radiance.g, radiance.b}) >= 0));
  }
  CHECK(panorama_of(sky_surroundings(sky), 64, 32) == panorama_of(sky_surroundings(sky), 64, 32));
}

TEST_CASE("environment: panoramas and cubes from files", "[scene][A31][B37]") {
  const TemporaryFolder folder("environment");
  const Image<Rgba32F> sky = panorama_of(sky_surroundings({}), 64, 32);
  REQUIRE(write_image(folder / "sky.pfm", sky));
  REQUIRE(write_image(folder / "sky.hdr", sky));
  const auto kept = read_environment_image(folder / "sky.pfm");
  REQUIRE(kept);
  CHECK(*kept == sky);
  const auto rounded = read_environment_image(folder / "sky.hdr");
  REQUIRE(rounded);
  CHECK(static_cast<double>(rounded->at(20, 10).g) == Approx(static_cast<double>(sky.at(20, 10).g)).epsilon(0.02));

  const char* names[] = {"px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"};
  for (int face = 0; face < 6; ++face)
    REQUIRE(write_image(folder / names[face], Image<Rgba8>(4, 4, {static_cast<std::uint8_t>(40 * face), 255, 0, 255})));
  const auto paths = find_cube_files(folder / "");
  REQUIRE(paths);
  const auto cube = read_cube_images(*paths);
  REQUIRE(cube);
  for (int face = 0; face < 6; ++face) {
    const double signal = 40 * face / 255.0, linear = signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
    CHECK(static_cast<double>((*cube)[static_cast<std::size_t>(face)].at(1, 2).r) == Approx(linear).margin(1e-6));
  }
}

// TUBERIA_ENVIRONMENTS: a folder of panoramas *.hdr and, if there are any, of the same places as NAME_ldr.png
// and as the six files of a folder cube_NAME. Without it there is nothing to try.
TEST_CASE("environment: photographs of real places are read and converted", "[scene][A31][A33]") {
  const char* folder = std::getenv("TUBERIA_ENVIRONMENTS");
  if (folder == nullptr) return;
  int places = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".hdr") continue;
    INFO(entry.path().string());
    ++places;
    const auto panorama = read_environment_image(entry.path());
    REQUIRE(panorama);
    CHECK(panorama->width() == 2 * panorama->height());

    const std::string name = entry.path().stem().string();
    const auto paths = find_cube_files(std::filesystem::path(folder) / ("cube_" + name));
    const auto codes = read_environment_image(std::filesystem::path(folder) / (name + "_ldr.png"));
    if (!paths || !codes) continue;
    const auto cube = read_cube_images(*paths);
    REQUIRE(cube);
    CHECK(difference_of(panorama_surroundings(*codes), cube_surroundings(*cube), 5000, every_direction).mean < kTwoCodes);
  }
  CHECK(places > 0);
}

TEST_CASE("environment: what is wrong with a file is told by name", "[scene][A29]") {
  const TemporaryFolder folder("environment");
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  Image<Rgba32F> spoilt(8, 4, {1, 1, 1, 1});
  spoilt.at(5, 2).g = nan;
  REQUIRE(write_image(folder / "spoilt.pfm", spoilt));
  const auto refused = read_environment_image(folder / "spoilt.pfm");
  REQUIRE_FALSE(refused);
  CHECK(one_line_naming(refused.error().message, "spoilt.pfm"));
  CHECK(one_line_naming(refused.error().message, "texel (5, 2) has g = nan"));
  CHECK_FALSE(read_environment_image(folder / "none.hdr"));
  CHECK_FALSE(read_environment_image(folder / "none.png"));

  CubeImages faces;
  faces.fill(Image<Rgba32F>(4, 4));
  CHECK(check_cube(faces));
  const auto spoilt_by = [&](int face, const Image<Rgba32F>& image, const char* culprit) {
    CubeImages other = faces;
    other[static_cast<std::size_t>(face)] = image;
    const auto checked = check_cube(other);
    REQUIRE_FALSE(checked);
    CHECK(one_line_naming(checked.error().message, culprit));
  };
  spoilt_by(2, {}, "face +y: it is missing");
  spoilt_by(5, {8, 8}, "face -z: it has 8 x 8 texels, but face +x has 4 x 4");
  spoilt_by(0, {4, 5}, "face +x: it has 4 x 5 texels, but faces of a cube are square");
  spoilt_by(1, {4, 4, {0, 0, -infinity, 1}}, "face -x: texel (0, 0) has b = -inf");

  const char* names[] = {"posx.png", "negx.png", "posy.png", "negy.png", "posz.png", "negz.png"};
  for (const char* name : names) REQUIRE(write_image(folder / name, Image<Rgba8>(2, 2)));
  REQUIRE(find_cube_files(folder / ""));
  std::filesystem::remove(folder / "negy.png");
  const auto missing = find_cube_files(folder / "");
  REQUIRE_FALSE(missing);
  CHECK(one_line_naming(missing.error().message, "face -y: no file 'negy'"));
  REQUIRE(write_image(folder / "posx.bmp", Image<Rgba8>(2, 2)));
  const auto twice = find_cube_files(folder / "");
  REQUIRE_FALSE(twice);
  CHECK(one_line_naming(twice.error().message, "face +x: both"));
  CHECK_FALSE(find_cube_files(folder / "nowhere"));
}

}  // namespace tuberia
