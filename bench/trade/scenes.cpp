#include "bench/trade/scenes.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "bench/peers/meshes.hpp"
#include "bench/trade/lit_program.hpp"
#include "math/transforms.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr Rgba32F kSky{0.45f, 0.6f, 0.8f, 1};
constexpr int kIdealSupersampling = 8;

using Add = std::function<void(Frame&)>;

/// A scene of what `add` adds, held against 64 samples a pixel of its reference setting.
Scene scene_of(std::string name, std::string what, const Rgba32F& background, Add add) {
  Scene scene{.name = std::move(name),
              .what = std::move(what),
              .recipe = {},
              .build = [background, add = std::move(add)](const Recipe& recipe) -> Result<Frame> {
                auto frame = Frame::create(recipe, background);
                if (frame) add(*frame);
                return frame;
              }};
  scene.ideal_supersampling = kIdealSupersampling;
  return scene;
}

Lighting material(const glm::vec3& diffuse, float specular, float shininess, const Eye& eye) {
  Lighting light;
  light.ambient = 0.15f * diffuse;
  light.diffuse = diffuse;
  light.specular = glm::vec3(specular);
  light.shininess = shininess;
  light.eye = glm::vec3(eye.at);
  light.light_count = 2;
  light.lights[0].towards = glm::normalize(glm::vec3(0.5f, 0.8f, 0.6f));
  light.lights[1] = {.kind = Light::Kind::point, .towards = {-3, 2, 3}, .intensity = glm::vec3(0.35f)};
  return light;
}

void add_lit(Frame& frame, std::shared_ptr<const Shape> shape, PipelineState state, const Lighting& light,
             const std::shared_ptr<const Texture>& texture = nullptr) {
  FragmentProgram program = lit_program(frame.recipe(), light, texture, state);
  frame.add(std::move(shape), std::move(program), state);
}

std::shared_ptr<const Texture> texture_of(const Image<Rgba8>& image) {
  return std::make_shared<const Texture>(Texture::create(image, TextureEncoding::linear).value());
}

Image<Rgba8> checkers(int size, int cell) {
  Image<Rgba8> image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const std::uint8_t code = (x / cell + y / cell) % 2 == 0 ? 255 : 0;
      image.at(x, y) = {code, code, code, 255};
    }
  return image;
}

std::shared_ptr<Shape> rectangle(glm::vec3 a, glm::vec3 u, glm::vec3 v, float repeats = 1) {
  auto shape = std::make_shared<Shape>();
  add_rectangle(*shape, a, u, v, glm::normalize(glm::cross(u, v)), repeats);
  return shape;
}

glm::vec3 hue(double turn) {
  const auto wave = [&](double shift) {
    return static_cast<float>(0.5 + 0.5 * std::cos(2 * glm::pi<double>() * (turn + shift)));
  };
  return {wave(0), wave(1.0 / 3), wave(2.0 / 3)};
}

constexpr int kTransparentShapes = 40;

/// Back to front.
std::vector<std::shared_ptr<const Shape>> transparent_shapes() {
  std::vector<std::shared_ptr<const Shape>> shapes;
  Random random(6);
  for (int i = 0; i < kTransparentShapes; ++i) {
    auto shape = std::make_shared<Shape>();
    const double turn = random.between(0, 2 * glm::pi<double>());
    const auto x = static_cast<float>(random.between(-1.6, 1.6)), y = static_cast<float>(random.between(-0.9, 0.9));
    const auto z = static_cast<float>(-2 + 0.05 * i), size = static_cast<float>(random.between(0.3, 1.4));
    const glm::vec3 u(size * std::cos(turn), size * std::sin(turn), 0), v(-u.y, u.x, 0);
    add_rectangle(*shape, glm::vec3(x, y, z) - 0.5f * (u + v), u, v, {0, 0, 1});
    const auto alpha = static_cast<float>(random.between(0.02, 0.4));
    const double colour = random.between(0, 1);
    for (int corner = 0; corner < 4; ++corner) shape->colours.emplace_back(hue(colour + 0.1 * corner), alpha);
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

/// Plates of growing distance along -z, 0.4 to 2 thousandths above the ground.
std::shared_ptr<const Shape> plates() {
  auto shape = std::make_shared<Shape>();
  Random random(7);
  for (double distance = 2; distance < 3000; distance *= 1.12)
    for (int i = -4; i <= 4; ++i) {
      const double width = distance * 0.12, left = i * distance * 0.25;
      const double height = 2e-3 * random.between(0.2, 1);
      add_rectangle(*shape, {left, height, -distance}, {width, 0, 0}, {0, 0, -0.08 * distance}, {0, 1, 0});
      for (int corner = 0; corner < 4; ++corner) shape->colours.emplace_back(hue(0.37 * i + 0.11 * distance), 1);
    }
  return shape;
}

std::shared_ptr<const Shape> street_boxes() {
  auto shape = std::make_shared<Shape>();
  Random random(8);
  for (int i = 0; i < 16; ++i)
    for (const float side : {-1.0f, 1.0f}) {
      const auto height = static_cast<float>(random.between(1, 5)), depth = static_cast<float>(random.between(2, 4));
      add_box(*shape, {4 * side, 0, -5.0f * static_cast<float>(i)}, {3, height, depth});
    }
  return shape;
}

}  // namespace

Scene spheres() {
  auto ball = std::make_shared<Shape>();
  add_sphere(*ball, glm::vec3(0), 0.45f, 12);
  return scene_of("spheres", "24 shining spheres of 576 triangles each, two lights", kSky, [ball](Frame& frame) {
    const Eye eye{.at = {0, 0, 5.2}};
    for (int i = 0; i < 24; ++i) {
      PipelineState state = frame.state_for(eye);
      state.transform.world_from_object = translation({i % 6 - 2.5, i / 6 - 1.5, 0});
      add_lit(frame, ball, state, material(0.8f * hue(i / 24.0), 0.8f, static_cast<float>(8 + 4 * i), eye));
    }
  });
}

Scene floor_scene() {
  return scene_of("floor", "a noisy checkered floor of 1024 x 1024 texels, forty times over, to the horizon", kSky,
                  [shape = rectangle({-200, 0, 20}, {400, 0, 0}, {0, 0, -400}, 40),
                   texture = texture_of(noisy_checkerboard(1024, 0))](Frame& frame) {
                    const PipelineState state = frame.state_for(
                        {.at = {0, 2, 0}, .point_of_interest = {2, 0.6, -6}, .fovy_degrees = 60, .far_distance = 1000});
                    frame.add(shape, textured({.texture = texture, .sampler = frame.recipe().sampler}), state);
                  });
}

Scene checker_floor() {
  Scene scene = scene_of(
      "checkered floor", "128 x 128 pixels of a black and white floor, against 144 samples a pixel", {0, 0, 0, 1},
      [shape = rectangle({-64, 0, 64}, {128, 0, 0}, {0, 0, -128}, 512),
       texture = texture_of(checkers(32, 16))](Frame& frame) {
        const PipelineState state = frame.state_for(
            {.at = {0, 1, 0}, .point_of_interest = {0, 1, -1}, .fovy_degrees = 90, .far_distance = 100});
        frame.add(shape, textured({.texture = texture, .sampler = frame.recipe().sampler}), state);
      });
  scene.recipe.target.width = scene.recipe.target.height = 128;
  scene.ideal = [build = scene.build, recipe = scene.recipe]() mutable {
    recipe.supersampling = 12;
    recipe.sampler = {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none};
    Frame frame = build(recipe).value();
    frame.draw().value();
    return frame.picture();
  };
  return scene;
}

Scene magnified_texture() {
  Image<Rgba8> noise(8, 8);
  Random random(9);
  for (Rgba8& texel : noise.pixels()) {
    const std::uint64_t bits = random.bits();
    texel = {static_cast<std::uint8_t>(bits & 255), static_cast<std::uint8_t>(bits >> 8 & 255),
             static_cast<std::uint8_t>(bits >> 16 & 255), 255};
  }
  return scene_of("magnified texture", "8 x 8 texels of noise over the whole picture", kSky,
                  [shape = rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), texture = texture_of(noise)](Frame& frame) {
                    frame.add(shape, textured({.texture = texture, .sampler = frame.recipe().sampler}),
                              frame.recipe().state);
                  });
}

Scene relief_scene() {
  auto wall = std::make_shared<Shape>(relief(128, 7, 0.05f));
  for (glm::vec2& at : wall->texcoords) at *= 3.0f;
  return scene_of("relief", "a bumpy wall of 33,000 triangles with a noisy texture, shining", kSky,
                  [wall, texture = texture_of(noisy_checkerboard(256, 5))](Frame& frame) {
                    const Eye eye{.at = {1.2, -1.1, 1.3}, .point_of_interest = {0.1, -0.1, 0}};
                    add_lit(frame, wall, frame.state_for(eye), material(glm::vec3(0.9f), 0.7f, 40, eye), texture);
                  });
}

Scene model() {
  return scene_of("model", "a knotted tube of 38,400 triangles and a plain floor, shining", kSky,
                  [tube = std::make_shared<Shape>(knot(600, 32, 0.16f)),
                   ground = rectangle({-3, -0.75f, 3}, {6, 0, 0}, {0, 0, -6})](Frame& frame) {
                    const Eye eye{.at = {1.5, 1.2, 2.0}};
                    add_lit(frame, tube, frame.state_for(eye), material({0.8f, 0.45f, 0.2f}, 0.7f, 50, eye));
                    add_lit(frame, ground, frame.state_for(eye), material({0.3f, 0.4f, 0.35f}, 0, 1, eye));
                  });
}

Scene layers() {
  return scene_of("layers", "40 transparent rectangles over one another, colours interpolated", {0.1f, 0.1f, 0.15f, 1},
                  [shapes = transparent_shapes()](Frame& frame) {
                    PipelineState state = frame.state_for({.at = {0, 0, 2}});
                    state.blend.mode = BlendMode::source_over;
                    state.depth.write = false;
                    for (const auto& shape : shapes) frame.add(shape, gouraud(), state);
                  });
}

Scene close_planes() {
  auto ground = rectangle({-4000, 0, 10}, {8000, 0, 0}, {0, 0, -8000});
  ground->colours.assign(4, glm::vec4(0.3f, 0.3f, 0.3f, 1));
  return scene_of("close planes", "plates 0.4 to 2 thousandths above the ground, seen from 6 above it, 2 to 3000 away",
                  kSky, [ground, decals = plates()](Frame& frame) {
                    const PipelineState state = frame.state_for({.at = {0, 6, 4},
                                                                 .point_of_interest = {0, 4, -8},
                                                                 .fovy_degrees = 50,
                                                                 .near_distance = 0.1,
                                                                 .far_distance = 1e4});
                    frame.add(ground, gouraud(), state);
                    frame.add(decals, gouraud(), state);
                  });
}

Scene foggy_street() {
  constexpr Rgba32F kFog{0.7f, 0.72f, 0.75f, 1};
  return scene_of(
      "foggy street", "32 boxes along a street of two triangles that ends in fog", kFog,
      [kFog, boxes = street_boxes(), ground = rectangle({-60, 0, 10}, {120, 0, 0}, {0, 0, -120})](Frame& frame) {
        const Eye eye{.at = {0.5, 1.8, 6}, .point_of_interest = {0, 1.5, -5}, .fovy_degrees = 60};
        PipelineState state = frame.state_for(eye);
        state.fog.mode = FogMode::exp2;
        state.fog.colour = kFog;
        state.fog.density = 0.03f;
        add_lit(frame, ground, state, material({0.35f, 0.35f, 0.3f}, 0, 1, eye));
        add_lit(frame, boxes, state, material({0.7f, 0.5f, 0.35f}, 0.3f, 20, eye));
      });
}

Scene against_reference(Scene scene) {
  scene.ideal = {};
  scene.ideal_supersampling = 1;
  return scene;
}

}  // namespace tuberia::bench::trade
