#include "pipeline/programs/surface.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/lit_triangle.hpp"
#include "tests/support/shapes.hpp"

namespace tuberia {

namespace {

using test::LitTriangle;

const LitTriangle kBent{{glm::vec3{-0.5f, -0.3f, 0.9f}, {1.2f, 0.1f, 0.7f}, {-0.2f, 1.5f, 0.5f}}};

SurfaceUniforms with_model(Reflection model) {
  SurfaceUniforms uniforms{.reflection = {.model = model, .ambient = {0.3f, 0.2f, 0.1f}, .diffuse = {0.7f, 0.4f, 0.2f}, .specular = {0.5f, 0.6f, 0.3f}, .exponent = 40},
                           .ambient_light = {0.1f, 0.2f, 0.3f}, .eye = {0.4f, -0.2f, 2}};
  uniforms.reflection.refractive_index = {1.5f, 2.2f, 0.7f};
  uniforms.lights.push_back({.light = {.towards = {0.48f, 0.6f, 0.64f}, .intensity = {0.9f, 0.8f, 0.7f}}});
  uniforms.lights.push_back({.light = {.kind = Light::Kind::point, .towards = {-0.7f, 0.3f, 0.9f}, .intensity = {0.2f, 0.5f, 0.9f}}});
  return uniforms;
}

/// The sum over the lights by math/reflection.hpp; normals are kBent's.
glm::dvec3 by_definition(const SurfaceUniforms& uniforms, int x, int y) {
  glm::dvec3 sum = glm::dvec3(uniforms.reflection.ambient) * glm::dvec3(uniforms.ambient_light);
  for (const SurfaceLight& source : uniforms.lights)
    sum += glm::dvec3(source.light.intensity) * reflected_share(uniforms.reflection, kBent.point(x, y, source.light, uniforms.eye));
  return sum;
}

/// The largest |found - right| / (1 + right) over picture and channels.
double largest_error(const Image<Rgba32F>& found, const SurfaceUniforms& uniforms) {
  double largest = 0;
  for (int y = 0; y < found.height(); ++y)
    for (int x = 0; x < found.width(); ++x) {
      const glm::dvec3 right = by_definition(uniforms, x, y);
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(test::channel(found.at(x, y), i) - right[i]) / (1 + right[i]));
    }
  return largest;
}

std::string refusal_of_surface(const SurfaceUniforms& uniforms) {
  Pipeline pipeline({.threads = 1});
  RenderTarget target = *RenderTarget::create(8, 8);
  const test::Mesh mesh = kBent.mesh();
  const auto drawn = pipeline.draw(target, {.mesh = mesh.view(), .program = surface(uniforms), .state = {}});
  return drawn ? "accepted" : drawn.error().message;
}

constexpr Reflection kModels[] = {Reflection::lambert, Reflection::phong, Reflection::blinn_phong, Reflection::weighted_phong, Reflection::cook_torrance};

}  // namespace

// Largest error 1e-5 (1 + I) for exponents up to 200 and roughness from 0.1: a cosine's last bit times 200.
TEST_CASE("surface: every reflection model is what its definition says", "[pipeline][B04][B12][B15][B42]") {
  for (const Reflection model : kModels)
    for (const float sharpness : {0.0f, 0.4f, 1.0f}) {
      SurfaceUniforms uniforms = with_model(model);
      uniforms.reflection.exponent = 200 * sharpness;
      uniforms.reflection.roughness = 0.9f - 0.8f * sharpness;
      uniforms.reflection.divided_by_pi = sharpness < 0.5f;
      if (sharpness == 0.4f) uniforms.reflection.facets = FacetDistribution::gaussian;
      if (sharpness == 1) uniforms.reflection.refractive_index = glm::vec3(1.5f);
      INFO("model " << static_cast<int>(model) << ", exponent " << uniforms.reflection.exponent << ", roughness " << uniforms.reflection.roughness);
      Image<Rgba32F> first;
      test::for_every_machine([&](InstructionSet set, Precision precision) {
        const Image<Rgba32F> picture = kBent.picture(surface(uniforms), set, precision);
        CHECK(largest_error(picture, uniforms) < (precision == Precision::exact ? 1e-5 : 2e-5));
        if (precision != Precision::exact) return;
        if (first.empty()) first = picture;
        CHECK(std::equal(picture.pixels().begin(), picture.pixels().end(), first.pixels().begin()));
      });
    }
}

TEST_CASE("surface: lights add up, before anything is clamped", "[pipeline][B15]") {
  test::for_every_machine([](InstructionSet set, Precision precision) {
    SurfaceUniforms both = with_model(Reflection::phong), first = both, second = both;
    for (SurfaceLight& light : both.lights) light.light.intensity *= 3;
    first.lights = {both.lights[0]}, second.lights = {both.lights[1]};
    const auto sum = kBent.picture(surface(both), set, precision), a = kBent.picture(surface(first), set, precision), b = kBent.picture(surface(second), set, precision);
    bool exceeds_one = false;
    for (std::size_t i = 0; i < sum.pixels().size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double ambient = static_cast<double>(both.reflection.ambient[c] * both.ambient_light[c]);
        CHECK(test::channel(sum.pixels()[i], c) == Approx(test::channel(a.pixels()[i], c) + test::channel(b.pixels()[i], c) - ambient).epsilon(1e-5));
        exceeds_one |= test::channel(sum.pixels()[i], c) > 1;
      }
    CHECK(exceeds_one);
  });
}

TEST_CASE("surface: red light on a green surface is black", "[pipeline][B03]") {
  test::for_every_machine([](InstructionSet set, Precision precision) {
    SurfaceUniforms uniforms = with_model(Reflection::lambert);
    uniforms.reflection.diffuse = {0, 1, 0};
    uniforms.ambient_light = glm::vec3(0);
    for (SurfaceLight& light : uniforms.lights) light.light.intensity = {1, 0, 0};
    const auto picture = kBent.picture(surface(uniforms), set, precision);
    for (const Rgba32F& pixel : picture.pixels()) CHECK((pixel.r == 0 && pixel.g == 0 && pixel.b == 0 && pixel.a == 1));
  });
}

TEST_CASE("surface: the highlight keeps the light's colour", "[pipeline][B17]") {
  // A blue surface; the light shines from where the mirror direction is the eye's.
  const LitTriangle flat;
  SurfaceUniforms uniforms{.reflection = {.diffuse = {0, 0, 0.4f}, .specular = glm::vec3(1), .exponent = 1}, .ambient_light = glm::vec3(0), .eye = {-6e5f, 0, 8e5f}};
  uniforms.lights.push_back({.light = {.towards = {0.6f, 0, 0.8f}, .intensity = {1, 0.5f, 0.25f}}});
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const Rgba32F pixel = flat.picture(surface(uniforms), set, precision).at(8, 8);
    CHECK(pixel.r == Approx(1).epsilon(1e-5));
    CHECK(pixel.g == Approx(0.5).epsilon(1e-5));
    CHECK(pixel.b == Approx(0.25 * (0.4 * 0.8 + 1)).epsilon(1e-5));
  });
}

TEST_CASE("surface: a texture is the colour that kd and ka are multiplied with", "[pipeline]") {
  Image<Rgba8> texels(1, 1, {255, 51, 102, 128});
  SurfaceUniforms plain = with_model(Reflection::phong), textured = plain;
  textured.colour.texture = test::texture_of(texels);
  const glm::vec3 colour{1, 0.2f, 0.4f};
  plain.reflection.diffuse *= colour, plain.reflection.ambient *= colour;
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto found = kBent.picture(surface(textured), set, precision), right = kBent.picture(surface(plain), set, precision);
    for (std::size_t i = 0; i < found.pixels().size(); ++i) {
      for (int c = 0; c < 3; ++c) CHECK(test::channel(found.pixels()[i], c) == Approx(test::channel(right.pixels()[i], c)).epsilon(1e-5));
      CHECK(found.pixels()[i].a == Approx(128 / 255.0).epsilon(1e-6));
    }
  });
}

TEST_CASE("surface: what exceeds 1 is clamped, or keeps its hue", "[pipeline][B16][B18]") {
  // Ambient light alone gives the notes' colour (1.6, .8, .4) everywhere.
  SurfaceUniforms uniforms{.reflection = {.ambient = glm::vec3(1)}, .ambient_light = {1.6f, 0.8f, 0.4f}};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto pixel_of = [&](Overflow overflow) {
      uniforms.overflow = overflow;
      return kBent.picture(surface(uniforms), set, precision).at(3, 3);
    };
    CHECK(pixel_of(Overflow::kept) == Rgba32F{1.6f, 0.8f, 0.4f, 1});
    const Rgba32F hue = pixel_of(Overflow::hue_preserving);
    CHECK(hue.r == 1);
    CHECK(hue.g == Approx(0.5).epsilon(1e-6));
    CHECK(hue.b == Approx(0.25).epsilon(1e-6));
    uniforms.ambient_light = {0.5f, 0.75f, 0.25f};  // what does not exceed 1 stays
    CHECK(pixel_of(Overflow::hue_preserving) == Rgba32F{0.5f, 0.75f, 0.25f, 1});
    uniforms.ambient_light = {1.6f, 0.8f, 0.4f};
    uniforms.overflow = Overflow::kept;
    const test::Canvas codes{.width = 8, .height = 8, .options = {.threads = 1, .instruction_set = set, .precision = precision}};
    CHECK(test::render(kBent.mesh(), surface(uniforms), {}, codes).colour.at(3, 3) == Rgba8{255, 204, 102, 255});  // the target clamps
  });
}

TEST_CASE("surface: the far side is lit where it is two-sided, and ambient light alone where there is no normal", "[pipeline]") {
  SurfaceUniforms uniforms = with_model(Reflection::cook_torrance);
  LitTriangle turned = kBent, none;
  for (glm::vec3& n : turned.normals) n = -n;
  none.normals.fill(glm::vec3(0));
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    uniforms.two_sided = true;
    const auto front = kBent.picture(surface(uniforms), set, precision), back = turned.picture(surface(uniforms), set, precision);
    CHECK(std::equal(front.pixels().begin(), front.pixels().end(), back.pixels().begin()));
    for (const Reflection model : kModels) {
      uniforms.reflection.model = model;
      const auto unlit = none.picture(surface(uniforms), set, precision);
      for (const Rgba32F& pixel : unlit.pixels()) {
        CHECK(pixel.r == Approx(0.03).epsilon(1e-6));
        CHECK(pixel.b == Approx(0.03).epsilon(1e-6));
      }
    }
  });
}

// As in tests/math, but drawn: light from 40 x 80 directions, weighted by their solid angles over pi.
TEST_CASE("surface: a white furnace, drawn", "[pipeline][furnace]") {
  const LitTriangle flat{.size = 4};
  SurfaceUniforms uniforms{.reflection = {.diffuse = glm::vec3(0.7f), .exponent = 10, .roughness = 0.5f}, .ambient_light = glm::vec3(0), .eye = {0.6e6f, 0, 0.8e6f}};
  constexpr int kRings = 40, kSectors = 80;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSectors; ++j) {
      const double theta = (i + 0.5) * std::numbers::pi / 2 / kRings, phi = (j + 0.5) * 2 * std::numbers::pi / kSectors;
      const double share = std::sin(theta) * (std::numbers::pi / 2 / kRings) * (2 * std::numbers::pi / kSectors) / std::numbers::pi;
      uniforms.lights.push_back({.light = {.towards = glm::dvec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)},
                                           .intensity = glm::vec3(static_cast<float>(share))}});
    }
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto drawn = [&](Reflection model, float diffuse, float specular) {
      uniforms.reflection.model = model;
      uniforms.reflection.diffuse = glm::vec3(diffuse), uniforms.reflection.specular = glm::vec3(specular);
      uniforms.reflection.divided_by_pi = false;
      return static_cast<double>(flat.picture(surface(uniforms), set, precision).at(1, 1).r);
    };
    CHECK(drawn(Reflection::lambert, 0.7f, 1) == Approx(0.7).epsilon(1e-3));
    for (const Reflection model : {Reflection::phong, Reflection::blinn_phong, Reflection::weighted_phong, Reflection::cook_torrance}) {
      INFO("model " << static_cast<int>(model));
      // 2/(n+1), 8/(n+1) of what is shared: see tests/math/reflection_test.cpp. Facets send on no more than arrives.
      const double most = model == Reflection::blinn_phong ? 8.0 / 11 : model == Reflection::cook_torrance ? 1 : 2.0 / 11;
      const double found = drawn(model, 0, 1);
      CHECK(found > 0.01);
      CHECK(found <= most);
      double right = 0;
      for (const SurfaceLight& light : uniforms.lights)
        right += static_cast<double>(light.light.intensity.r) * reflected_share(uniforms.reflection, flat.point(1, 1, light.light, uniforms.eye)).r;
      CHECK(found == Approx(right).epsilon(1e-4));
      CHECK(drawn(model, 0.25f, 0.7f) <= 1);
    }
  });
}

TEST_CASE("surface: what cannot be computed is refused, field and value", "[pipeline]") {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  const auto refused = [](const char* words, auto change) {
    SurfaceUniforms uniforms = with_model(Reflection::cook_torrance);
    change(uniforms);
    CHECK_THAT(refusal_of_surface(uniforms), Catch::Matchers::Contains(words));
  };
  CHECK(refusal_of_surface(with_model(Reflection::phong)) == "accepted");
  refused("reflection.exponent is -1; it must be finite and not negative", [](SurfaceUniforms& u) { u.reflection.exponent = -1; });
  refused("reflection.exponent is nan", [](SurfaceUniforms& u) { u.reflection.exponent = kNaN; });
  for (const float m : {0.0f, -0.1f, kNaN}) refused("reflection.roughness is", [m](SurfaceUniforms& u) { u.reflection.roughness = m; });
  refused("reflection.refractive_index.y is 0, outside 0.001 to 1000", [](SurfaceUniforms& u) { u.reflection.refractive_index.y = 0; });
  refused("reflection.diffuse.z is inf", [](SurfaceUniforms& u) { u.reflection.diffuse.z = kInfinity; });
  refused("reflection.model is 7", [](SurfaceUniforms& u) { u.reflection.model = static_cast<Reflection>(7); });
  refused("mirror.x is nan", [](SurfaceUniforms& u) { u.mirror.x = kNaN; });
  refused("ambient_light.y is inf", [](SurfaceUniforms& u) { u.ambient_light.y = kInfinity; });
  refused("eye.z is nan", [](SurfaceUniforms& u) { u.eye.z = kNaN; });
  refused("alpha is nan", [](SurfaceUniforms& u) { u.alpha = kNaN; });
  refused("lights[1].intensity.x is nan", [](SurfaceUniforms& u) { u.lights[1].light.intensity.x = kNaN; });
  refused("lights[0].falloff_distance is -2; it must be finite and not negative", [](SurfaceUniforms& u) { u.lights[0].light.falloff_distance = -2; });
  refused("lights[1].cos_inner is 0.5, outside 0.75 to 1", [](SurfaceUniforms& u) {
    u.lights[1].light.kind = Light::Kind::spot;
    u.lights[1].light.cos_inner = 0.5f, u.lights[1].light.cos_outer = 0.75f;
  });
  refused("colour.texture is not a two-dimensional texture", [](SurfaceUniforms& u) {
    const Rgba8 texels[2] = {};
    u.colour.texture = std::make_shared<const Texture>(*Texture::create_1d(texels, TextureEncoding::linear));
  });
  refused("lod_bias is nan", [](SurfaceUniforms& u) {
    u.colour.texture = test::texture_of(Image<Rgba8>(1, 1));
    u.colour.sampler.lod_bias = kNaN;
  });
}

}  // namespace tuberia
