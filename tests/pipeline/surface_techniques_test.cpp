// Patterns, relief and texture access, hooked into the surface program.

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "math/bump.hpp"
#include "math/patterns.hpp"
#include "pipeline/programs/surface.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

constexpr int kSurfaceSide = 32;
const SurfaceFrame kSquareFrame{.tangent = {2, 0, 0}, .bitangent = {0, -2, 0}};

/// A square that fills the picture, u right and v down over two world units each; lit from one side, dull.
struct LitSquare {
  SurfaceUniforms uniforms{.reflection = {.model = Reflection::lambert, .ambient = glm::vec3(0.5f), .diffuse = {0.9f, 0.8f, 0.7f}}, .ambient_light = glm::vec3(0.2f)};

  LitSquare() { uniforms.lights.push_back({.light = {.towards = {0.48f, 0.6f, 0.64f}}}); }

  Image<Rgba32F> picture(InstructionSet set = supported_instruction_sets().front(), Precision precision = Precision::exact) const {
    const test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
    const std::vector<glm::vec3> tangents(4, glm::vec3(kSquareFrame.tangent)), bitangents(4, glm::vec3(kSquareFrame.bitangent));
    MeshView view = mesh.view();
    view.tangents = tangents;
    view.bitangents = bitangents;
    test::Studio studio({.width = kSurfaceSide, .height = kSurfaceSide, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set, .precision = precision}});
    studio.draw(view, surface(uniforms));
    return studio.picture().linear;
  }

  /// own * (ka Ia + kd (N.L)), with the colour and normal of (u, v) = the pixel's centre.
  glm::dvec3 defined(const glm::dvec3& own, const glm::dvec3& normal) const {
    const double cosine = std::max(0.0, glm::dot(normal, glm::dvec3(uniforms.lights[0].light.towards)));
    return own * (glm::dvec3(uniforms.reflection.ambient * uniforms.ambient_light) + glm::dvec3(uniforms.reflection.diffuse) * cosine);
  }
};

glm::dvec2 centre(int x, int y) { return {(x + 0.5) / kSurfaceSide, (y + 0.5) / kSurfaceSide}; }

double off(const Rgba32F& a, const glm::dvec3& b) {
  return std::max({std::abs(static_cast<double>(a.r) - b.x), std::abs(static_cast<double>(a.g) - b.y), std::abs(static_cast<double>(a.b) - b.z)});
}

std::string refused(const SurfaceUniforms& uniforms) {
  const test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
  const std::vector<glm::vec3> tangents(4, {1, 0, 0}), bitangents(4, {0, 1, 0});
  MeshView view = mesh.view();
  view.tangents = tangents;
  view.bitangents = bitangents;
  Pipeline pipeline({.threads = 1});
  RenderTarget target = *RenderTarget::create(8, 8);
  const auto drawn = pipeline.draw(target, {.mesh = view, .program = surface(uniforms), .state = {}});
  return drawn ? "accepted" : drawn.error().message;
}

}  // namespace

TEST_CASE("surface: a pattern takes kd's and ka's part", "[pipeline][B01][B36]") {
  test::for_every_machine([](InstructionSet set, Precision precision) {
    for (const Pattern::Kind kind : {Pattern::Kind::checker, Pattern::Kind::random_squares, Pattern::Kind::wood, Pattern::Kind::marble}) {
      LitSquare square;
      square.uniforms.colour.pattern = {.kind = kind, .first = {1, 0.8f, 0.6f}, .second = {0.1f, 0.2f, 0.3f}, .scale = 3};
      const Image<Rgba32F> picture = square.picture(set, precision);
      double most = 0;
      for (int y = 0; y < kSurfaceSide; ++y)
        for (int x = 0; x < kSurfaceSide; ++x) {
          const glm::dvec2 uv = centre(x, y);
          const glm::dvec3 own = pattern_colour(square.uniforms.colour.pattern, {.texcoord = uv, .world = {2 * uv.x - 1, 1 - 2 * uv.y, 0}, .texcoord_width = glm::dvec2(1.0 / kSurfaceSide)});
          most = std::max(most, off(picture.at(x, y), square.defined(own, {0, 0, 1})));
        }
      INFO("kind " << static_cast<int>(kind));
      CHECK(most < 1e-4);
    }
  });
}

TEST_CASE("surface: relief shades by its perturbed normals", "[pipeline][A08][A11][B39][B40]") {
  using Relief = HeightAndSlope (*)(const glm::dvec2&);
  const std::pair<BumpMap::Kind, Relief> reliefs[] = {{BumpMap::Kind::waves, [](const glm::dvec2& uv) { return waves(uv, 4); }},
                                                      {BumpMap::Kind::orange, [](const glm::dvec2& uv) { return orange(uv, 4, 3); }},
                                                      {BumpMap::Kind::rough, [](const glm::dvec2& uv) { return rough(uv, 4, 3); }}};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const auto& [kind, relief] : reliefs) {
      LitSquare square;
      square.uniforms.bump = {.kind = kind, .texture = {}, .sampler = {}, .gain = 0.1f, .scale = 4, .seed = 3};
      const Image<Rgba32F> picture = square.picture(set, precision);
      double most = 0;
      for (int y = 0; y < kSurfaceSide; ++y)
        for (int x = 0; x < kSurfaceSide; ++x) {
          const glm::dvec3 normal = perturbed_normal(kSquareFrame, relief(centre(x, y)).slope * static_cast<double>(0.1f));
          most = std::max(most, off(picture.at(x, y), square.defined(glm::dvec3(1), normal)));
        }
      CHECK(most < 1e-4);
    }
  });
}

TEST_CASE("surface: relief without height leaves the picture's bits", "[pipeline][A09]") {
  LitSquare square;
  const Image<Rgba32F> plain = square.picture();
  square.uniforms.bump = {.kind = BumpMap::Kind::rough, .texture = {}, .sampler = {}, .gain = 0};
  CHECK(square.picture() == plain);
}

// Macroscopic roughness is geometry and changes depths; microscopic roughness is the reflection model's and changes the
// highlight's width, but no normal; relief changes normals and no depth.
TEST_CASE("surface: the scales of roughness change different things", "[pipeline][B38]") {
  const auto drawn = [](float roughness, BumpMap::Kind kind, float amplitude) {
    test::Mesh ball = test::sphere(24);
    for (std::size_t i = 0; i < ball.positions.size(); ++i)
      ball.positions[i] *= 1 + amplitude * static_cast<float>(rough(glm::dvec2(ball.texcoords[i]), 8, 1).height);
    std::vector<glm::vec3> tangents, bitangents;
    for (const glm::vec3& n : ball.normals) tangents.push_back({-n.z, 0, n.x}), bitangents.push_back(glm::cross(n, glm::vec3(n.z, 0, -n.x)));
    MeshView view = ball.view();
    view.tangents = tangents;
    view.bitangents = bitangents;
    SurfaceUniforms uniforms{.reflection = {.model = Reflection::cook_torrance, .diffuse = glm::vec3(0), .specular = glm::vec3(1), .roughness = roughness}, .eye = {0, 0, 3}};
    uniforms.lights.push_back({.light = {.towards = {0, 0, 1}}});
    uniforms.bump = {.kind = kind, .texture = {}, .sampler = {}, .gain = 0.1f};
    test::Studio studio({.width = 64, .height = 64, .colour = ColourFormat::rgba32f});
    PipelineState state;
    state.transform.clip_from_world = test::clip_from_world({0, 0, 3}, 1);
    studio.draw(view, surface(uniforms), state);
    return studio.picture();
  };
  const auto lit_pixels = [](const Image<Rgba32F>& image) {
    float most = 0;
    for (const Rgba32F& pixel : image.pixels()) most = std::max(most, pixel.r);
    int count = 0;
    for (const Rgba32F& pixel : image.pixels()) count += pixel.r > most / 2 ? 1 : 0;
    return count;
  };
  const test::Picture smooth = drawn(0.1f, BumpMap::Kind::none, 0), dull = drawn(0.3f, BumpMap::Kind::none, 0);
  CHECK(smooth.depth == dull.depth);
  CHECK(lit_pixels(dull.linear) > 3 * lit_pixels(smooth.linear));
  const test::Picture relief = drawn(0.1f, BumpMap::Kind::orange, 0), geometry = drawn(0.1f, BumpMap::Kind::none, 0.1f);
  CHECK(relief.depth == smooth.depth);
  CHECK_FALSE(relief.linear == smooth.linear);
  CHECK_FALSE(geometry.depth == smooth.depth);
}

TEST_CASE("surface: what patterns, relief and texture access cannot be drawn with is refused by name", "[pipeline]") {
  const float no_number = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
  const auto says = [](const std::string& message, const char* words) {
    INFO(message);
    CHECK(message.find(words) != std::string::npos);
  };
  const auto with_pattern = [](const Pattern& pattern) { return refused({.colour = {.pattern = pattern}}); };
  CHECK(with_pattern({.kind = Pattern::Kind::wood}) == "accepted");
  says(with_pattern({.kind = static_cast<Pattern::Kind>(9)}), "pattern.kind is 9");
  says(with_pattern({.first = {1, no_number, 0}}), "pattern.first");
  says(with_pattern({.scale = endless}), "pattern.scale");
  says(with_pattern({.turbulence = no_number}), "pattern.turbulence");
  says(with_pattern({.pattern_from_world = glm::mat4(endless)}), "pattern.pattern_from_world[0][0]");

  const auto with_access = [](const TextureAccess& access) { return refused({.colour = {.access = access}}); };
  says(with_access({.coordinates = static_cast<TextureAccess::Coordinates>(7)}), "access.coordinates is 7");
  says(with_access({.level_rule = static_cast<TextureAccess::LevelRule>(7)}), "access.level_rule is 7");
  says(with_access({.texel_distance = 0}), "access.texel_distance");
  says(with_access({.globe_from_world = glm::mat4(no_number)}), "access.globe_from_world");

  const auto with_bump = [](BumpMap::Kind kind, std::shared_ptr<const Texture> texture, const Sampler& sampler = {}, float gain = 1) {
    return refused({.bump = {.kind = kind, .texture = std::move(texture), .sampler = sampler, .gain = gain}});
  };
  using enum BumpMap::Kind;
  const Image<Rgba8> texel(1, 1);
  const auto linear = test::texture_of(texel), srgb = test::texture_of(texel, TextureEncoding::srgb);
  CHECK(with_bump(height_texture, linear) == "accepted");
  CHECK(with_bump(waves, {}) == "accepted");
  says(with_bump(static_cast<BumpMap::Kind>(9), {}), "bump.kind is 9");
  says(with_bump(normal_map, {}), "bump has no texture");
  says(with_bump(normal_map, srgb), "sRGB");
  says(with_bump(height_texture, std::make_shared<const Texture>(*Texture::create_depth(Image<float>(1, 1)))), "depths");
  says(with_bump(height_texture, std::make_shared<const Texture>(*Texture::create_1d(texel.row(0), TextureEncoding::linear))), "two-dimensional");
  says(with_bump(height_texture, linear, {.max_anisotropy = 99}), "bump: ");
  says(with_bump(waves, {}, {}, no_number), "bump.gain");
}

}  // namespace tuberia
