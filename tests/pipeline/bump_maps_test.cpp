#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>

#include "math/bump.hpp"
#include "tests/pipeline/technique_program_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

using test::Shown;

constexpr int kPixels = 64;
constexpr double kDegree = 3.14159265358979 / 180;

/// What a picture of normals is drawn from: a square that fills it, u to the right and v down.
struct ReliefScene {
  BumpMap bump;
  SurfaceFrame frame{};
  bool mirrored_u = false;  // u to the left
};

Image<Rgba32F> normals_of(const ReliefScene& scene, InstructionSet set = supported_instruction_sets().front(), Precision precision = Precision::exact) {
  test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, glm::vec3(scene.frame.normal));
  if (scene.mirrored_u)
    for (glm::vec2& uv : mesh.texcoords) uv.x = 1 - uv.x;
  const std::vector<glm::vec4> tangents(4, glm::vec4(glm::vec3(scene.frame.tangent), 0)), bitangents(4, glm::vec4(glm::vec3(scene.frame.bitangent), 0));
  MeshView view = mesh.view();
  view.unit_texcoords[0] = tangents;
  view.unit_texcoords[1] = bitangents;
  test::Studio studio({.width = kPixels, .height = kPixels, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set, .precision = precision}});
  studio.draw(view, test::technique({.shown = Shown::bumped_normal, .bump = scene.bump}));
  return studio.picture().linear;
}

glm::dvec3 vector_of(const Rgba32F& pixel) { return {static_cast<double>(pixel.r), static_cast<double>(pixel.g), static_cast<double>(pixel.b)}; }

double angle_between(const glm::dvec3& a, const glm::dvec3& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

/// The largest angle between the pixels' normals and those of a function of (u, v), `rim` pixels from the border left out.
double largest_angle(const Image<Rgba32F>& found, const std::function<glm::dvec3(glm::dvec2)>& right, int rim = 0) {
  double most = 0;
  for (int y = rim; y < kPixels - rim; ++y)
    for (int x = rim; x < kPixels - rim; ++x) {
      const double angle = angle_between(vector_of(found.at(x, y)), right({(x + 0.5) / kPixels, (y + 0.5) / kPixels}));
      most = std::isnan(angle) ? 1e9 : std::max(most, angle);
    }
  return most;
}

/// A height function as a picture of floats in [0, 1].
std::shared_ptr<const Texture> height_picture(int width, int height, const std::function<double(glm::dvec2)>& function) {
  Image<Rgba32F> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float value = static_cast<float>(function({(x + 0.5) / width, (y + 0.5) / height}));
      image.at(x, y) = {value, value, value, 1};
    }
  return std::make_shared<const Texture>(*Texture::create(image));
}

BumpMap height_map(std::shared_ptr<const Texture> texture, float gain = 1) {
  return {.kind = BumpMap::Kind::height_texture, .texture = std::move(texture), .sampler = {}, .gain = gain};
}

/// n, t_u and t_v of no particular lengths, tangents not at right angles.
SurfaceFrame skew_frame() { return {.tangent = {1.5, 0.2, 0.1}, .bitangent = {0.3, -0.8, 0.2}, .normal = glm::normalize(glm::dvec3(0.1, 0.2, 1))}; }

}  // namespace

TEST_CASE("bump maps: a ramp tilts the normal as the notes' vectors say", "[pipeline][bump][A09][A11]") {
  const auto ramp_u = height_picture(64, 4, [](glm::dvec2 uv) { return 0.5 * uv.x; }), ramp_v = height_picture(4, 64, [](glm::dvec2 uv) { return 0.5 * uv.y; });
  const auto flat = height_picture(4, 4, [](glm::dvec2) { return 0.25; });
  const SurfaceFrame upright, mirrored{.tangent = {-1, 0, 0}};
  const auto is = [](const ReliefScene& scene, const glm::dvec3& normal) {
    test::for_every_machine([&](InstructionSet set, Precision precision) {
      CHECK(largest_angle(normals_of(scene, set, precision), [&](glm::dvec2) { return normal; }, 2) < 1e-4);
    });
  };
  is({.bump = height_map(ramp_u), .frame = upright}, {-0.44721, 0, 0.89443});
  is({.bump = height_map(ramp_v), .frame = upright}, {0, -0.44721, 0.89443});
  is({.bump = height_map(flat), .frame = upright}, {0, 0, 1});
  is({.bump = height_map(flat), .frame = mirrored}, {0, 0, 1});
  is({.bump = height_map(ramp_u), .frame = mirrored}, {0.44721, 0, 0.89443});
}

TEST_CASE("bump maps: a gain of 0 leaves the normal's bits, a negative one inverts the relief", "[pipeline][bump][A09]") {
  const auto picture = height_picture(32, 32, [](glm::dvec2 uv) { return 0.5 + 0.05 * rough(uv, 4, 3).height; });
  const glm::dvec3 n = skew_frame().normal;
  using enum BumpMap::Kind;
  for (const BumpMap::Kind kind : {height_texture, normal_map, waves, orange, rough}) {
    const auto with_gain = [&](float gain) {
      return normals_of({.bump = {.kind = kind, .texture = picture, .sampler = {}, .gain = gain}, .frame = skew_frame()});
    };
    const Image<Rgba32F> flat = with_gain(0), plain = normals_of({.bump = {}, .frame = skew_frame()});
    if (kind != normal_map) CHECK(flat == plain);
    CHECK(largest_angle(flat, [&](glm::dvec2) { return n; }) < 1e-6);
    if (kind == normal_map) continue;
    const Image<Rgba32F> raised = with_gain(0.02f), sunk = with_gain(-0.02f);
    double steepest = 0;
    for (int y = 0; y < kPixels; ++y)
      for (int x = 0; x < kPixels; ++x) {
        const glm::dvec3 up = vector_of(raised.at(x, y)), down = vector_of(sunk.at(x, y));
        // Mirror images in the unperturbed normal: their sum lies along it.
        CHECK(angle_between(up + down, n) < 1e-5);
        steepest = std::max(steepest, angle_between(up, n));
      }
    CHECK(steepest > 0.5 * kDegree);
  }
}

TEST_CASE("bump maps: programs draw what the definition in double says", "[pipeline][bump][A08][A11]") {
  using enum BumpMap::Kind;
  const SurfaceFrame frame = skew_frame();
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto worst_of = [&](BumpMap::Kind kind, HeightAndSlope (*relief)(const glm::dvec2&)) {
      const ReliefScene scene{.bump = {.kind = kind, .texture = {}, .sampler = {}, .gain = 0.1f, .scale = 6, .seed = 9}, .frame = frame};
      return largest_angle(normals_of(scene, set, precision), [&](glm::dvec2 uv) { return perturbed_normal(frame, relief(uv).slope * 0.1); });
    };
    CHECK(worst_of(BumpMap::Kind::waves, [](const glm::dvec2& uv) { return tuberia::waves(uv, 6); }) < 1e-5);
    CHECK(worst_of(BumpMap::Kind::orange, [](const glm::dvec2& uv) { return tuberia::orange(uv, 6, 9); }) < 1e-5);
    CHECK(worst_of(BumpMap::Kind::rough, [](const glm::dvec2& uv) { return tuberia::rough(uv, 6, 9); }) < 1e-5);
  });
}

TEST_CASE("bump maps: a function, its grey picture and its picture of normals agree to a degree", "[pipeline][bump][A07]") {
  const SurfaceFrame frame;
  const float gain = 0.02f;
  const auto height = [](glm::dvec2 uv) { return 0.5 + 0.5 * waves(uv, 3).height; };
  const auto right = [&](glm::dvec2 uv) { return perturbed_normal(frame, waves(uv, 3).slope * static_cast<double>(gain)); };
  const Image<Rgba32F> analytic = normals_of({.bump = {.kind = BumpMap::Kind::waves, .texture = {}, .sampler = {}, .gain = gain, .scale = 3}});
  // The picture holds heights from 0 to 1, half as high as the function's -1 to 1.
  const Image<Rgba32F> from_picture = normals_of({.bump = height_map(height_picture(256, 256, height), 2 * gain)});

  Image<Rgba8> codes(256, 256);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const glm::dvec3 n = right({(x + 0.5) / 256, (y + 0.5) / 256});
      const auto code = [](double c) { return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * c)); };
      codes.at(x, y) = {code(n.x), code(-n.y), code(n.z), 255};
    }
  const BumpMap map{.kind = BumpMap::Kind::normal_map, .texture = test::texture_of(codes), .sampler = {}};
  const Image<Rgba32F> from_normals = normals_of({.bump = map});

  for (const Image<Rgba32F>* picture : {&analytic, &from_picture, &from_normals}) CHECK(largest_angle(*picture, right) < 1 * kDegree);
  CHECK(largest_angle(analytic, [](glm::dvec2) { return glm::dvec3(0, 0, 1); }) > 5 * kDegree);
}

TEST_CASE("bump maps: a table of few heights is interpolated", "[pipeline][bump][B41]") {
  // Four values a side; between two texels a bilinear height changes as a straight line.
  const double table[4] = {0, 0.3, 0.1, 0.2};
  const auto picture = height_picture(4, 4, [&](glm::dvec2 uv) { return table[static_cast<int>(uv.x * 4)]; });
  const Image<Rgba32F> found = normals_of({.bump = height_map(picture)});
  const SurfaceFrame frame;
  const auto height = [&](double u, double) {
    const double texel = u * 4 - 0.5, first = std::floor(texel);
    const auto at = [&](double i) { return table[(static_cast<int>(i) + 8) % 4]; };
    return at(first) + (at(first + 1) - at(first)) * (texel - first);
  };
  CHECK(largest_angle(found, [&](glm::dvec2 uv) { return perturbed_normal(frame, central_differences(height, uv, glm::dvec2(0.25), 1)); }) < 1e-4);
}

TEST_CASE("bump maps: mirrored texture coordinates show the same relief mirrored", "[pipeline][bump][A11]") {
  const auto heights = height_picture(64, 64, [](glm::dvec2 uv) { return 0.5 + 0.02 * rough(uv, 4, 2).height; });
  const Image<Rgba32F> plain = normals_of({.bump = height_map(heights)});
  const Image<Rgba32F> mirrored = normals_of({.bump = height_map(heights), .frame = {.tangent = {-1, 0, 0}}, .mirrored_u = true});
  for (int y = 0; y < kPixels; ++y)
    for (int x = 0; x < kPixels; ++x) {
      const glm::dvec3 a = vector_of(plain.at(x, y)), b = vector_of(mirrored.at(kPixels - 1 - x, y));
      CHECK(angle_between({-a.x, a.y, a.z}, b) < 1e-4);
    }
}

TEST_CASE("bump maps: degenerate tangents leave the normal's bits", "[pipeline][bump][A11]") {
  const glm::dvec3 n = skew_frame().normal;
  const SurfaceFrame frames[] = {{{0, 0, 0}, {0, 1, 0}, n}, {{0, 1, 0}, {0, 2, 0}, n}, {{0, 0, 0}, {0, 0, 0}, n}, {{1e30, 0, 0}, {0, 1e30, 0}, n}, {n, {0, 1, 0}, n}};
  for (const SurfaceFrame& frame : frames)
    for (const BumpMap::Kind kind : {BumpMap::Kind::waves, BumpMap::Kind::orange, BumpMap::Kind::rough}) {
      const BumpMap bump{.kind = kind, .texture = {}, .sampler = {}, .gain = 0.5f};
      const Image<Rgba32F> plain = normals_of({.bump = {}, .frame = frame}), bumped = normals_of({.bump = bump, .frame = frame});
      // The normal as a tangent is parallel to it up to its own rounding.
      if (frame.tangent != n) CHECK(bumped == plain);
      CHECK(largest_angle(bumped, [&](glm::dvec2) { return n; }) < 1e-6);
    }
}

TEST_CASE("bump maps: exact relief has the same bits on every instruction set", "[pipeline][bump][exact]") {
  using enum BumpMap::Kind;
  const auto picture = height_picture(32, 32, [](glm::dvec2 uv) { return 0.5 + 0.05 * tuberia::rough(uv, 4, 3).height; });
  for (const BumpMap::Kind kind : {height_texture, normal_map, waves, orange, rough}) {
    const ReliefScene scene{.bump = {.kind = kind, .texture = picture, .sampler = {}, .gain = 0.1f}, .frame = skew_frame()};
    const Image<Rgba32F> first = normals_of(scene);
    test::for_every_instruction_set([&](InstructionSet set) { CHECK(normals_of(scene, set) == first); });
  }
}

// The same hills as geometry: a grid displaced along its normal, each vertex with the mean of its
// triangles' normals.
TEST_CASE("bump maps: in its middle a bumped square shades as a mesh with these bumps does", "[pipeline][bump][A06]") {
  constexpr int kCells = 256;
  constexpr float kGain = 0.015f;
  const auto height = [](double u, double v) { return static_cast<double>(kGain) * waves({u, v}, 4).height; };
  test::Mesh hills;
  for (int j = 0; j <= kCells; ++j)
    for (int i = 0; i <= kCells; ++i) {
      const double u = static_cast<double>(i) / kCells, v = static_cast<double>(j) / kCells;
      hills.positions.push_back({static_cast<float>(2 * u - 1), static_cast<float>(1 - 2 * v), static_cast<float>(height(u, v))});
      hills.normals.push_back({0, 0, 0});
      hills.texcoords.push_back({0, 0});
    }
  for (std::uint32_t j = 0; j < kCells; ++j)
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t a = j * (kCells + 1) + i, b = a + 1, c = a + kCells + 1, d = c + 1;
      for (const std::array<std::uint32_t, 3>& triangle : {std::array{a, c, b}, std::array{b, c, d}}) {
        const glm::vec3 p = hills.positions[triangle[0]], normal = glm::cross(hills.positions[triangle[1]] - p, hills.positions[triangle[2]] - p);
        for (const std::uint32_t corner : triangle) hills.indices.push_back(corner), hills.normals[corner] += normal;
      }
    }
  const Image<Rgba32F> geometry = test::render(hills, test::technique({.shown = Shown::bumped_normal}), {}, {.width = kPixels, .height = kPixels, .colour = ColourFormat::rgba32f}).linear;
  // u and v run along two world units each.
  const SurfaceFrame frame{.tangent = {2, 0, 0}, .bitangent = {0, -2, 0}};
  const Image<Rgba32F> bumped = normals_of({.bump = {.kind = BumpMap::Kind::waves, .texture = {}, .sampler = {}, .gain = kGain, .scale = 4}, .frame = frame});

  const glm::dvec3 light = glm::normalize(glm::dvec3(0.6, 0.5, 0.7));
  double most = 0, contrast = 0;
  for (int y = kPixels / 4; y < kPixels * 3 / 4; ++y)
    for (int x = kPixels / 4; x < kPixels * 3 / 4; ++x) {
      const double of_mesh = glm::dot(glm::normalize(vector_of(geometry.at(x, y))), light), of_bump = glm::dot(vector_of(bumped.at(x, y)), light);
      most = std::max(most, std::abs(of_mesh - of_bump));
      contrast = std::max(contrast, std::abs(of_bump - light.z));
    }
  CHECK(most < 2.0 / 255);
  CHECK(contrast > 10.0 / 255);
}

TEST_CASE("bump maps: the silhouette knows nothing of the relief", "[pipeline][bump][B41]") {
  test::Mesh ball = test::sphere(24);
  std::vector<glm::vec4> tangents, bitangents;
  for (const glm::vec3& n : ball.normals) tangents.push_back({-n.z, 0, n.x, 0}), bitangents.push_back({glm::cross(n, glm::vec3(n.z, 0, -n.x)), 0});
  const auto drawn = [&](const BumpMap& bump) {
    MeshView view = ball.view();
    view.unit_texcoords[0] = tangents;
    view.unit_texcoords[1] = bitangents;
    test::Studio studio({.width = 96, .height = 96, .colour = ColourFormat::rgba32f});
    PipelineState state;
    state.transform.clip_from_world = test::clip_from_world({1, 2, 2}, 1);
    studio.draw(view, test::technique({.shown = Shown::bumped_normal, .bump = bump}), state);
    return studio.picture();
  };
  const test::Picture smooth = drawn({}), bumped = drawn({.kind = BumpMap::Kind::orange, .texture = {}, .sampler = {}, .gain = 0.5f});
  CHECK(smooth.depth == bumped.depth);
  int differing = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      CHECK((smooth.linear.at(x, y).a == bumped.linear.at(x, y).a));
      differing += smooth.linear.at(x, y) == bumped.linear.at(x, y) ? 0 : 1;
    }
  CHECK(differing > 500);
}

}  // namespace tuberia
