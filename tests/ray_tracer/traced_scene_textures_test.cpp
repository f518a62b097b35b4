// Textures, patterns and relief of traced scenes: the same texels as the documents, and so the pipeline, say.

#include <cmath>
#include <numbers>

#include "math/bump.hpp"
#include "math/colour.hpp"
#include "math/patterns.hpp"
#include "reference/oracle/texture.hpp"
#include "scene/sphere_mapping.hpp"
#include "tests/ray_tracer/traced_scene_support.hpp"

namespace tuberia::tracer::traced_test {
namespace {

constexpr double kTexturePi = std::numbers::pi;
using Wrap = description::Texture::Wrap;

TexturePicture random_picture(test::Random& random) {
  const int width = 1 + static_cast<int>(random.below(13)), height = 1 + static_cast<int>(random.below(13));
  TexturePicture picture{.codes = {}, .is_srgb = random.below(2) == 0, .light = {}};
  const auto code = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  if (random.below(3) == 0) {
    picture.light = Image<Rgba32F>(width, height);
    for (Rgba32F& texel : picture.light.pixels()) texel = {random.between(0, 4), random.between(0, 1), random.between(0, 1), random.between(0, 1)};
  } else {
    picture.codes = Image<Rgba8>(width, height);
    for (Rgba8& texel : picture.codes.pixels()) texel = {code(), code(), code(), code()};
  }
  return picture;
}

oracle::Texture oracle_texture(const TexturePicture& picture, bool has_mipmaps) {
  oracle::Texture texture;
  texture.width = picture.codes.empty() ? picture.light.width() : picture.codes.width();
  texture.height = picture.codes.empty() ? picture.light.height() : picture.codes.height();
  texture.is_srgb = picture.is_srgb;
  texture.has_mipmaps = has_mipmaps;
  for (const Rgba8& texel : picture.codes.pixels()) texture.texels.push_back({texel.r, texel.g, texel.b, texel.a});
  for (const Rgba32F& texel : picture.light.pixels()) texture.floats.emplace_back(texel.r, texel.g, texel.b, texel.a);
  oracle::complete(texture);
  return texture;
}

oracle::Sampler oracle_sampler(const TextureRules& rules) {
  oracle::Sampler sampler;
  sampler.texels = rules.is_nearest ? oracle::TexelFilter::nearest : oracle::TexelFilter::bilinear;
  sampler.mipmaps = static_cast<oracle::MipmapFilter>(rules.mipmaps);
  sampler.wrap_u = sampler.wrap_v = static_cast<oracle::Wrap>(rules.wrap == Wrap::clamp ? 1 : rules.wrap == Wrap::mirror ? 2 : 0);
  sampler.max_anisotropy = static_cast<float>(rules.anisotropy);
  return sampler;
}

oracle::TexturePoint oracle_point(const glm::dvec2& uv, const TextureFootprint& footprint, const glm::dvec2& size) {
  oracle::TexturePoint point;
  point.s = uv.x;
  point.t = uv.y;
  point.r = point.reference = 0.0;
  const auto triple = [](const glm::dvec2& v) { return oracle::Triple{v.x, v.y, 0.0}; };
  point.steps = {triple(footprint.right), triple(footprint.down)};
  point.texel_steps = {triple(footprint.right * size), triple(footprint.down * size)};
  return point;
}

/// Squares of 3 x 2 texels in colours of their own, read at single texels.
const std::string kSquares = R"("textures": {"squares": {"source": "random-squares", "size": 12, "squares": 4, "seed": 3, "filter": "nearest"}})";

glm::dvec3 texel_of_squares(const glm::dvec2& uv) {
  static const Image<Rgba32F> picture = light_of(*texture_picture({}, described(std::string("{").append(kSquares).append("}")).textures[0]));
  const auto place = [](double u) { return static_cast<int>(std::floor((u - std::floor(u)) * 12)); };
  const Rgba32F& texel = picture.at(place(uv.x), place(uv.y));
  return {texel.r, texel.g, texel.b};
}

/// A single object of a material with kd = 1, ka = 1/4 and more.
std::string scene_of_one(const std::string& shape, const std::string& material, const std::string& more = "") {
  return std::string("{").append(kSquares).append(R"(, "materials": {"m": {"diffuse": 1, "ambient": 0.25, )").append(material)
      .append(R"(}}, "objects": [{"material": "m", "shape": {)").append(shape).append("}").append(more).append("}]}");
}

}  // namespace

TEST_CASE("traced scene: textures are read as the oracle reads them", "[A44][ray_tracer][traced_scene][texture]") {
  const std::uint64_t seed = 44;
  CAPTURE(seed);
  test::Random random(seed);
  for (int trial = 0; trial < 400; ++trial) {
    const TexturePicture picture = random_picture(random);
    TextureRules rules{.is_nearest = random.below(3) == 0, .mipmaps = static_cast<TextureRules::Mipmaps>(random.below(3)), .wrap = static_cast<Wrap>(random.below(3))};
    if (random.below(3) == 0) rules.anisotropy = 1 + static_cast<double>(random.below(8));
    const TextureLookup lookup(picture, rules);
    const oracle::Texture texture = oracle_texture(picture, rules.mipmaps != TextureRules::Mipmaps::none);
    REQUIRE(lookup.level_count() == static_cast<int>(texture.levels.size()));
    const oracle::Sampler sampler = oracle_sampler(rules);
    for (int i = 0; i < 30; ++i) {
      const auto pair = [&](double size) { return glm::dvec2(number_between(random, -size, size), number_between(random, -size, size)); };
      const glm::dvec2 uv = pair(2.5);
      const TextureFootprint footprint = random.below(5) == 0 ? TextureFootprint{} : TextureFootprint{.right = pair(0.5), .down = pair(0.5)};
      const glm::dvec4 colour = lookup.at(uv, footprint);
      const oracle::Colour bounds = oracle::sample(texture, sampler, oracle_point(uv, footprint, lookup.size()));
      CAPTURE(trial, i, uv.x, uv.y, rules.is_nearest, static_cast<int>(rules.mipmaps), static_cast<int>(rules.wrap), rules.anisotropy);
      for (int c = 0; c < 4; ++c) {
        const oracle::Interval& bound = bounds[static_cast<std::size_t>(c)];
        CAPTURE(c, colour[c], bound.low, bound.high);
        CHECK((colour[c] >= bound.low - 1e-6 && colour[c] <= bound.high + 1e-6));
      }
    }
  }
}

TEST_CASE("traced scene: coordinates that are none read some texel", "[ray_tracer][traced_scene][texture][bad]") {
  TexturePicture picture{.codes = Image<Rgba8>(3, 5, {255, 255, 255, 255}), .light = {}};
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
    const TextureLookup lookup(picture, {.wrap = wrap, .anisotropy = 4});
    for (const double bad : {kInfinity, -kInfinity, std::nan(""), 1e300, -1e300})
      for (const glm::dvec2& uv : {glm::dvec2(bad, 0.5), glm::dvec2(0.5, bad)}) {
        CHECK(lookup.at(uv, {}) == glm::dvec4(1));
        CHECK(lookup.at({0.5, 0.5}, {.right = uv, .down = {bad, bad}}) == glm::dvec4(1));
        CHECK(lookup.at_level({0.5, 0.5}, bad) == glm::dvec4(1));
      }
  }
}

TEST_CASE("traced scene: levels in colours show which level a footprint reads", "[A44][ray_tracer][traced_scene][texture]") {
  TextureLookup lookup({.codes = Image<Rgba8>(64, 64), .light = {}}, {});
  lookup.colour_levels();
  const auto at = [&](double texels) { return glm::dvec3(lookup.at({0.3, 0.6}, {.right = {texels / 64, 0}, .down = {0, 0.5 * texels / 64}})); };
  CHECK(at(0.3) == glm::dvec3(1, 0, 0));
  CHECK(at(2) == glm::dvec3(1, 1, 0));
  CHECK(at(4) == glm::dvec3(0, 1, 0));
  CHECK(largest_difference(at(4 * std::sqrt(2.0)), {0, 1, 0.5}) < 1e-12);  // halfway to cyan
  CHECK(largest_difference(at(1e6), {127.0 / 255, 0, 0}) < 1e-7);         // the seventh, of one texel: darker red
}

TEST_CASE("traced scene: a plane has u along x and v along z", "[A44][ray_tracer][traced_scene]") {
  test::Random random(1);
  for (const SurfaceKind surfaces : {SurfaceKind::exact, SurfaceKind::tessellated}) {
    const TracedScene scene = traced(scene_of_one(R"("type": "plane", "width": 4, "depth": 2, "segments": 3)", R"("texture": "squares", "mapping": {"repeat": [2, 3]})",
                                                  R"(, "transforms": [{"translate": [5, 0, 0]}])"), surfaces);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 at(number_between(random, -2, 2), 0, number_between(random, -1, 1));
      const PointMaterial material = material_met(scene, at + glm::dvec3(5.5, 3, 0.2), at + glm::dvec3(5, 0, 0));
      const glm::dvec3 texel = texel_of_squares({2 * (at.x / 4 + 0.5), 3 * (at.z / 2 + 0.5)});
      CAPTURE(i, at.x, at.z);
      CHECK(largest_difference(material.reflection.diffuse, texel) < 1e-7);
      CHECK(largest_difference(material.reflection.ambient, 0.25 * texel) < 1e-7);
    }
  }
}

TEST_CASE("traced scene: spheres are mapped by the directions of their points", "[A44][ray_tracer][traced_scene]") {
  test::Random random(2);
  for (const std::string of_positions : {"true", "false"}) {
    const TracedScene scene = traced(scene_of_one(R"("type": "sphere", "radius": 2)",
                                                  R"("texture": "squares", "mapping": {"type": "sphere", "pole": [0, 0, 2], "equator": [0, 1, 0], "repeat": [3, 1], "of_positions": )" + of_positions + R"(})",
                                                  R"(, "transforms": [{"rotate": 90, "about": [0, 1, 0]}, {"translate": [1, 2, 3]}])"));
    for (int i = 0; i < 200; ++i) {
      // In the world the pole is +x, since z turns to x, and the equator still +y.
      const glm::dvec3 n = glm::normalize(glm::dvec3(number_between(random, -1, 1), number_between(random, -1, 1), number_between(random, -1, 1)));
      const glm::dvec2 up = sphere_coordinates(n, {.pole = {1, 0, 0}, .equator = {0, 1, 0}});
      const PointMaterial material = material_met(scene, glm::dvec3(1, 2, 3) + 5.0 * n, {1, 2, 3});
      CHECK(largest_difference(material.reflection.diffuse, texel_of_squares({3 * up.x, 1 - up.y})) < 1e-7);
    }
  }
}

TEST_CASE("traced scene: triangles carry their own coordinates and colours", "[A44][ray_tracer][traced_scene]") {
  const TracedScene scene = traced(scene_of_one(R"("type": "mesh", "positions": [[0,0,0],[3,0,0],[0,3,0]], "texcoords": [[0.1,0.9],[1.1,0.6],[0.3,-0.4]],
    "colours": [[1,0.5,0.25],[1,0.5,0.25],[1,0.5,0.25]], "triangles": [[0,1,2]])", R"("texture": "squares")"));
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double a = number_between(random, 0, 0.5), b = number_between(random, 0, 0.5);
    const glm::dvec2 uv = (1 - a - b) * glm::dvec2(0.1, 0.9) + a * glm::dvec2(1.1, 0.6) + b * glm::dvec2(0.3, -0.4);
    const PointMaterial material = material_met(scene, {3 * a, 3 * b, 2}, {3 * a, 3 * b, 0});
    CHECK(largest_difference(material.reflection.diffuse, texel_of_squares(uv) * glm::dvec3(1, 0.5, 0.25)) < 1e-7);
  }
}

TEST_CASE("traced scene: tessellated surfaces have the texels of the triangles", "[A44][ray_tracer][traced_scene]") {
  // A sphere of few triangles: inside each, coordinates are linear. The mean of the corners is the triangle's middle.
  const TracedScene scene = traced(scene_of_one(R"("type": "sphere", "segments": [8, 4])", R"("texture": "squares")"), SurfaceKind::tessellated);
  int count = 0;
  for (std::int64_t item = 0; item < scene.geometry().count(); ++item) {
    const auto corners = scene.geometry().triangle(item);
    if (!corners) continue;
    const glm::dvec3 middle = ((*corners)[0] + (*corners)[1] + (*corners)[2]) / 3.0;
    const TracedMeeting meeting = met(scene, 2.0 * middle, middle);
    REQUIRE(meeting.hit.item == item);
    // The corners' coordinates: longitude from +x towards -z, and latitude, of stacks and slices; those of a pole lie
    // between the others'.
    double u = 0, v = 0;
    std::vector<double> longitudes;
    for (const glm::dvec3& corner : *corners) {
      v += std::acos(std::clamp(corner.y, -1.0, 1.0)) / kTexturePi / 3;
      if (std::abs(corner.y) < 0.999) longitudes.push_back(std::atan2(-corner.z, corner.x) / (2 * kTexturePi));
    }
    for (double& longitude : longitudes) longitude += longitude < longitudes[0] - 0.5 ? 1 : longitude > longitudes[0] + 0.5 ? -1 : 0;
    for (const double longitude : longitudes) u += longitude / static_cast<double>(longitudes.size());
    if (longitudes.size() == 3) {
      CHECK(meeting.at.texcoord.y == Approx(v).margin(1e-6));
      CHECK(std::abs(meeting.at.texcoord.x - u - std::round(meeting.at.texcoord.x - u)) < 1e-6);
    }
    CHECK(largest_difference(scene.material(item, meeting.at).reflection.diffuse, texel_of_squares(meeting.at.texcoord)) < 1e-7);
    ++count;
  }
  CHECK(count == 8 * 2 + 2 * 8 * 2);  // caps of single triangles, and two rows of pairs
}

TEST_CASE("traced scene: a level may be that of the distance", "[A44][ray_tracer][traced_scene]") {
  const auto level_at = [](double height) {
    const TracedScene scene = traced(R"({"camera": {"eye": [0, )" + std::to_string(height) + R"(, 0], "look_at": [0, 0, 0], "up": [0, 0, -1]},
      "textures": {"levels": {"source": "gradient", "size": 64, "level_colours": true, "level_rule": "distance", "texel_distance": 2}},
      "materials": {"m": {"texture": "levels"}}, "objects": [{"shape": {"type": "plane"}, "material": "m"}]})");
    return material_met(scene, {0, height, 0}, {0, 0, 0}).reflection.diffuse / 0.8f;
  };
  CHECK(largest_difference(level_at(1), {1, 0, 0}) < 1e-6);
  CHECK(largest_difference(level_at(4), {1, 1, 0}) < 1e-6);
  CHECK(largest_difference(level_at(8), {0, 1, 0}) < 1e-6);
}

TEST_CASE("traced scene: patterns are those of math", "[A44][ray_tracer][traced_scene]") {
  const TextureFootprint footprint{.right = {0.02, 0}, .down = {0, 0.03}};
  const TracedScene squares = traced(scene_of_one(R"("type": "plane")", R"("pattern": {"type": "checker", "scale": 4, "first": 0.75, "second": [0, 0, 1]}, "mapping": {"repeat": [2, 1]})"));
  const Pattern checker{.kind = Pattern::Kind::checker, .first = glm::vec3(0.75f), .second = {0, 0, 1}, .scale = 4};
  const TracedScene block = traced(scene_of_one(R"("type": "cube")", R"("pattern": {"type": "wood", "scale": 3, "seed": 2, "placement": [{"translate": [0.5, 0, 0]}]})"));
  Pattern wood{.kind = Pattern::Kind::wood, .scale = 3, .seed = 2};
  wood.pattern_from_world[3] = {-0.5f, 0, 0, 1};
  test::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const double x = number_between(random, -1, 1), z = number_between(random, -1, 1);
    const PointMaterial material = material_met(squares, {x, 2, z}, {x, 0, z}, footprint);
    const glm::dvec3 wanted = pattern_colour(checker, {.texcoord = {x + 1, z / 2 + 0.5}, .texcoord_width = {0.04, 0.03}});
    CHECK(largest_difference(material.reflection.diffuse, wanted) < 1e-6);
    // On the box's upper face u and v span two units each: steps of 0.04 along x and 0.06 along z.
    const auto rings = [](double px, double pz) { return 3 * std::hypot(px - 0.5, pz); };
    const double band = std::max(std::abs(rings(x + 0.04, z) - rings(x, z)), std::abs(rings(x, z + 0.06) - rings(x, z)));
    const glm::dvec3 ring = pattern_colour(wood, {.world = {x, 1, z}, .band_width = band});
    CHECK(largest_difference(material_met(block, {x, 2, z}, {x, 1, z}, footprint).reflection.diffuse, ring) < 1e-6);
  }
}

}  // namespace tuberia::tracer::traced_test
