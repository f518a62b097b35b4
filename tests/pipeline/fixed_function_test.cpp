#include "pipeline/programs/fixed_function.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "raster/sample_texture.hpp"
#include "raster/texture_target.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

using Four = std::array<double, 4>;

/// A square over the whole target, with coordinates for every unit.
struct UnitSquare {
  test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
  std::array<std::vector<glm::vec4>, kTextureUnits> strq;

  MeshView view() const {
    MeshView result = mesh.view();
    for (std::size_t i = 0; i < strq.size(); ++i) result.unit_texcoords[i] = strq[i];
    return result;
  }
};

test::Picture drawn(const UnitSquare& square, const FixedFunctionUniforms& uniforms, const PipelineState& state = {}, const test::Canvas& canvas = {.width = 8, .height = 8, .colour = ColourFormat::rgba32f}) {
  test::Studio studio(canvas);
  studio.draw(square.view(), fixed_function(uniforms), state);
  return studio.picture();
}

std::shared_ptr<const Texture> one_texel(const Rgba32F& colour) {
  return std::make_shared<const Texture>(*Texture::create(Image<Rgba32F>(1, 1, colour)));
}

double clamped(double x) { return std::min(std::max(x, 0.0), 1.0); }

/// Units by the table, in doubles.
double combined_value(CombineFunction function, double a0, double a1, double a2) {
  switch (function) {
    case CombineFunction::replace: return a0;
    case CombineFunction::modulate: return a0 * a1;
    case CombineFunction::add: return a0 + a1;
    case CombineFunction::add_signed: return a0 + a1 - 0.5;
    case CombineFunction::interpolate: return a0 * a2 + a1 * (1 - a2);
    default: return a0 - a1;
  }
}

Four combined_by_table(const TextureUnit& unit, const Four& texel, const Four& primary, const Four& previous) {
  const Rgba32F& k = unit.constant;
  const Four sources[4] = {texel, {static_cast<double>(k.r), static_cast<double>(k.g), static_cast<double>(k.b), static_cast<double>(k.a)}, primary, previous};
  const auto argument = [&](const CombineArgument& a, std::size_t channel) {
    const Four& s = sources[static_cast<std::size_t>(a.source)];
    const bool of_alpha = a.operand == CombineOperand::alpha || a.operand == CombineOperand::one_minus_alpha;
    const double value = s[of_alpha ? 3 : channel];
    return a.operand == CombineOperand::one_minus_colour || a.operand == CombineOperand::one_minus_alpha ? 1 - value : value;
  };
  const auto half = [&](const Combine& c, std::size_t channel) {
    return clamped(c.scale * combined_value(c.function, argument(c.argument[0], channel), argument(c.argument[1], channel), argument(c.argument[2], channel)));
  };
  Four result{half(unit.colour, 0), half(unit.colour, 1), half(unit.colour, 2), half(unit.alpha, 3)};
  if (unit.colour.function < CombineFunction::dot3_rgb) return result;
  double dot = 0;
  for (std::size_t i = 0; i < 3; ++i) dot += (argument(unit.colour.argument[0], i) - 0.5) * (argument(unit.colour.argument[1], i) - 0.5);
  result[0] = result[1] = result[2] = clamped(unit.colour.scale * 4 * dot);
  if (unit.colour.function == CombineFunction::dot3_rgba) result[3] = result[0];
  return result;
}

Combine random_combine(test::Random& random, int functions) {
  Combine combine;
  combine.function = static_cast<CombineFunction>(random.below(functions));
  combine.scale = 1 << random.below(3);
  for (CombineArgument& a : combine.argument) a = {static_cast<CombineSource>(random.below(4)), static_cast<CombineOperand>(random.below(4))};
  return combine;
}

std::array<float, 4> channels_of(const Rgba32F& c) { return {c.r, c.g, c.b, c.a}; }

FixedFunctionUniforms only_unit_0(std::shared_ptr<const Texture> texture, const CombinePair& pair = replace_environment(), const Sampler& sampler = {}) {
  FixedFunctionUniforms uniforms;
  uniforms.units[0] = {.texture = std::move(texture), .sampler = sampler, .colour = pair.colour, .alpha = pair.alpha};
  return uniforms;
}

std::shared_ptr<const Texture> noise_texture(std::uint64_t seed, int size) {
  test::Random random(seed);
  Image<Rgba8> image(size, size);
  const auto code = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  for (Rgba8& p : image.pixels()) p = {code(), code(), code(), code()};
  return test::texture_of(image);
}

}  // namespace

TEST_CASE("fixed function: every combination by its table", "[pipeline]") {
  test::Random random(211);
  const auto value = [&] { return random.between(0, 1); };
  const auto colour = [&] { return Rgba32F{value(), value(), value(), value()}; };
  for (int round = 0; round < 400; ++round) {
    UnitSquare square;
    const Rgba32F p = colour();
    square.mesh.colours.assign(square.mesh.positions.size(), {p.r, p.g, p.b, p.a});
    const Four primary{static_cast<double>(p.r), static_cast<double>(p.g), static_cast<double>(p.b), static_cast<double>(p.a)};
    Four right = primary;
    FixedFunctionUniforms uniforms;
    for (TextureUnit& unit : uniforms.units) {
      if (random.below(4) == 0) continue;
      const Rgba32F texel = colour();
      unit = {.texture = one_texel(texel), .sampler = {}, .colour = random_combine(random, 8), .alpha = random_combine(random, 6), .constant = colour()};
      right = combined_by_table(unit, {static_cast<double>(texel.r), static_cast<double>(texel.g), static_cast<double>(texel.b), static_cast<double>(texel.a)}, primary, right);
    }
    const std::array<float, 4> found = channels_of(drawn(square, uniforms).linear.at(3, 4));
    INFO("seed 211, round " << round);
    for (std::size_t i = 0; i < 4; ++i) CHECK(found[i] == Approx(right[i]).margin(2e-4));
  }
}

TEST_CASE("fixed function: the classic environments", "[pipeline]") {
  const Four p{0.75, 0.5, 0.25, 0.5}, t{0.5, 1, 0.25, 0.25}, k{1, 0.5, 0, 0.125};
  UnitSquare square;
  square.mesh.colours.assign(square.mesh.positions.size(), {p[0], p[1], p[2], p[3]});
  struct Known {
    CombinePair pair;
    double (*colour)(double p, double t, double k, double alpha);
    double alpha;
  };
  for (const Known& known : {Known{replace_environment(), [](double, double texel, double, double) { return texel; }, t[3]},
                             {modulate_environment(), [](double before, double texel, double, double) { return before * texel; }, p[3] * t[3]},
                             {decal_environment(), [](double before, double texel, double, double alpha) { return before * (1 - alpha) + texel * alpha; }, p[3]},
                             {blend_environment(), [](double before, double texel, double constant, double) { return before * (1 - texel) + constant * texel; }, p[3] * t[3]},
                             {add_environment(), [](double before, double texel, double, double) { return std::min(1.0, before + texel); }, p[3] * t[3]}}) {
    FixedFunctionUniforms uniforms = only_unit_0(one_texel({0.5f, 1, 0.25f, 0.25f}), known.pair);
    uniforms.units[0].constant = {1, 0.5f, 0, 0.125f};
    const auto found = channels_of(drawn(square, uniforms).linear.at(2, 2));
    for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(known.colour(p[i], t[i], k[i], t[3])).margin(1e-6));
    CHECK(found[3] == Approx(known.alpha).margin(1e-6));
  }
}

TEST_CASE("fixed function: units that are off pass on the clamped vertex colour", "[pipeline]") {
  UnitSquare square;
  square.mesh.texcoords.clear();  // nobody needs them
  square.mesh.colours.assign(square.mesh.positions.size(), {3, -1, 0.5f, 7});
  CHECK(drawn(square, {}).linear.at(0, 0) == Rgba32F{1, 0, 0.5f, 1});
}

TEST_CASE("fixed function: coordinates are divided by q", "[pipeline]") {
  const auto texture = noise_texture(212, 16);
  UnitSquare plain, projected;
  for (std::size_t i = 0; i < plain.mesh.positions.size(); ++i) {
    const glm::vec2 uv = plain.mesh.texcoords[i];
    projected.strq[0].push_back({uv.x * 4, uv.y * 4, 9, 4});
  }
  const auto uniforms = only_unit_0(texture);
  CHECK(drawn(plain, uniforms).linear == drawn(projected, uniforms).linear);

  // A slide projected with another q at each corner: s/q and t/q of the interpolated coordinates.
  test::Random random(213);
  UnitSquare uneven;
  for (int i = 0; i < 4; ++i) uneven.strq[0].push_back({random.between(0, 2), random.between(0, 2), 0, random.between(1, 3)});
  const Sampler nearest{.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none};
  const test::Picture picture = drawn(uneven, only_unit_0(texture, replace_environment(), nearest), {}, {.width = 32, .height = 32, .colour = ColourFormat::rgba32f});
  int compared = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      // Inside one of the two triangles, by the mesh's own indices.
      const glm::vec2 pixel{(static_cast<float>(x) + 0.5f) / 16 - 1, 1 - (static_cast<float>(y) + 0.5f) / 16};
      for (std::size_t first = 0; first < uneven.mesh.indices.size(); first += 3) {
        const auto corner = [&](std::size_t k) { return glm::vec2(uneven.mesh.positions[uneven.mesh.indices[first + k]]); };
        const auto cross = [](const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; };
        const float area = cross(corner(1) - corner(0), corner(2) - corner(0));
        const float w1 = cross(pixel - corner(0), corner(2) - corner(0)) / area, w2 = cross(corner(1) - corner(0), pixel - corner(0)) / area;
        if (w1 < 0.01f || w2 < 0.01f || w1 + w2 > 0.99f) continue;
        const auto strq = [&](std::size_t k) { return uneven.strq[0][uneven.mesh.indices[first + k]]; };
        const glm::vec4 here = strq(0) * (1 - w1 - w2) + strq(1) * w1 + strq(2) * w2;
        const glm::vec2 place = glm::vec2(here.x / here.w, here.y / here.w) * 16.0f;
        const auto close_to_border = [](float v) { return std::abs(v - std::round(v)) < 1e-3f; };
        if (close_to_border(place.x) || close_to_border(place.y)) continue;
        ++compared;
        CHECK(picture.linear.at(x, y) == sample_texture(*texture, nearest, {.at = {here.x / here.w, here.y / here.w, 0}}));
      }
    }
  CHECK(compared > 500);
}

TEST_CASE("fixed function: q of 0 and coordinates that are no numbers do no harm", "[pipeline]") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const glm::vec4& odd : {glm::vec4(1, 1, 1, 0), glm::vec4(0), glm::vec4(nan), glm::vec4(inf, -inf, 1, 1), glm::vec4(1, 1, 1, 1e-45f)}) {
    UnitSquare square;
    square.strq[0].assign(4, odd);
    square.strq[0][1] = {0, 0, 0, 1};
    for (const float anisotropy : {1.0f, 16.0f}) {
      const test::Picture picture = drawn(square, only_unit_0(noise_texture(214, 16), modulate_environment(), {.max_anisotropy = anisotropy}));
      for (const Rgba32F& p : picture.linear.pixels()) CHECK((p.r >= 0 && p.r <= 1 && p.a >= 0 && p.a <= 1));
    }
  }
}

TEST_CASE("fixed function: rows, boxes and cube maps", "[pipeline]") {
  const std::vector<Rgba8> row{{10, 0, 0, 255}, {20, 0, 0, 255}, {30, 0, 0, 255}, {40, 0, 0, 255}};
  const Sampler nearest{.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none};
  const auto red_at = [&](const Texture& texture, const glm::vec4& strq) {
    UnitSquare square;
    square.strq[0].assign(4, strq);
    return std::lround(255 * drawn(square, only_unit_0(std::make_shared<const Texture>(texture), replace_environment(), nearest)).linear.at(4, 4).r);
  };
  const Texture line = *Texture::create_1d(row, TextureEncoding::linear);
  CHECK(red_at(line, {0.6f * 2, 9, 9, 2}) == 30);
  const std::vector<Image<Rgba8>> slices{Image<Rgba8>(1, 1, {10, 0, 0, 255}), Image<Rgba8>(1, 1, {20, 0, 0, 255})};
  const Texture box = *Texture::create_3d(slices, TextureEncoding::linear);
  CHECK(red_at(box, {0, 0, 0.75f * 2, 2}) == 20);
  std::array<Image<Rgba8>, 6> faces;
  for (std::size_t i = 0; i < 6; ++i) faces[i] = Image<Rgba8>(1, 1, {static_cast<std::uint8_t>(i * 10), 0, 0, 255});
  const Texture cube = *Texture::create_cube(faces, TextureEncoding::linear);
  CHECK(red_at(cube, {1, -9, 2, -5}) == 30);  // q does not divide
}

TEST_CASE("fixed function: a shadow map's shadow", "[pipeline]") {
  // Seen from the light: a plane, and an occluder in front of its left half.
  const test::Mesh plane = test::rectangle({-1, 1, 0.5f}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
  const test::Mesh occluder = test::rectangle({-1, 1, -0.5f}, {1, 0, 0}, {0, -2, 0}, {0, 0, 1});
  test::Studio light({.width = 32, .height = 32});
  light.draw(plane.view(), fixed_function({}));
  light.draw(occluder.view(), fixed_function({}));
  auto shadow_map = std::make_shared<Texture>(*Texture::create_depth(Image<float>(32, 32)));
  REQUIRE(copy_depth_to_texture(light.target(), *shadow_map).ok());

  PipelineState state;
  state.transform.texture_units[0] = {
      .source = {TexCoordSource::object_linear, TexCoordSource::object_linear, TexCoordSource::object_linear, TexCoordSource::vertex},
      .plane = {glm::vec4{0.5f, 0, 0, 0.5f}, {0, -0.5f, 0, 0.5f}, {0, 0, 0.5f, 0.5f - 1e-3f}, {}}};
  UnitSquare receiver;
  receiver.mesh = plane;
  const test::Picture picture = drawn(receiver, only_unit_0(shadow_map, replace_environment(), {.compare = Compare::less_equal}), state,
                                {.width = 16, .height = 16, .colour = ColourFormat::rgba32f});
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) CHECK(picture.linear.at(x, y) == Rgba32F{x < 8 ? 0.0f : 1.0f, x < 8 ? 0.0f : 1.0f, x < 8 ? 0.0f : 1.0f, 1});
}

TEST_CASE("fixed function: the same bits on every machine and with any threads", "[pipeline][exact]") {
  UnitSquare square;
  for (auto& strq : square.strq)
    for (int i = 0; i < 4; ++i) strq.push_back({static_cast<float>(i % 2) * 3, static_cast<float>(i / 2) * 2, static_cast<float>(i), 1 + static_cast<float>(i) / 2});
  square.mesh.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}, {1, 1, 1, 1}};
  FixedFunctionUniforms uniforms;
  test::Random random(215);
  for (std::size_t i = 0; i < 4; ++i) {
    uniforms.units[i] = {.texture = noise_texture(216 + i, 32), .sampler = {.max_anisotropy = i % 2 == 0 ? 1.0f : 8.0f}, .colour = random_combine(random, 8), .alpha = random_combine(random, 6)};
    uniforms.units[i].colour.argument[0].source = CombineSource::texture;
  }
  const auto digest = [&](InstructionSet set, int threads) {
    test::Studio studio({.width = 150, .height = 130, .options = {.threads = threads, .instruction_set = set}});
    studio.draw(square.view(), fixed_function(uniforms));
    return studio.digest();
  };
  const std::string right = digest(InstructionSet::baseline, 1);
  test::for_every_instruction_set([&](InstructionSet set) {
    for (const int threads : {1, 3}) CHECK(digest(set, threads) == right);
  });
}

TEST_CASE("fixed function: what cannot be combined is refused by name", "[pipeline]") {
  const auto refusal = [](const auto& change) {
    FixedFunctionUniforms uniforms;
    uniforms.units[2].texture = one_texel({1, 1, 1, 1});
    change(uniforms.units[2]);
    test::Studio studio({.width = 4, .height = 4});
    UnitSquare square;
    const auto result = studio.pipeline().draw(studio.target(), {.mesh = square.view(), .program = fixed_function(uniforms), .state = {}});
    return result.ok() ? std::string() : result.error().message;
  };
  const auto names = [](const char* words) { return Catch::Matchers::Contains(words); };
  CHECK(refusal([](TextureUnit&) {}).empty());
  CHECK_THAT(refusal([](TextureUnit& u) { u.colour.scale = 3; }), names("unit 2: the colour's scale is 3"));
  CHECK_THAT(refusal([](TextureUnit& u) { u.alpha.function = static_cast<CombineFunction>(8); }), names("none of its enumeration"));
  CHECK_THAT(refusal([](TextureUnit& u) { u.colour.argument[2].source = static_cast<CombineSource>(4); }), names("none of its enumeration"));
  CHECK_THAT(refusal([](TextureUnit& u) { u.alpha.scale = 0; }), names("unit 2: the alpha's scale is 0"));
  CHECK_THAT(refusal([](TextureUnit& u) { u.alpha.function = CombineFunction::dot3_rgb; }), names("dot3"));
  CHECK_THAT(refusal([](TextureUnit& u) { u.constant.g = std::numeric_limits<float>::quiet_NaN(); }), names("constant"));
  CHECK_THAT(refusal([](TextureUnit& u) { u.constant.a = 1.5f; }), names("1.5"));
  CHECK_THAT(refusal([](TextureUnit& u) { u.sampler.max_anisotropy = 32; }), names("max_anisotropy"));
  CHECK(refusal([](TextureUnit& u) { u.colour.scale = 3, u.texture = nullptr; }).empty());
}

}  // namespace tuberia
