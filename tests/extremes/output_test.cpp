// Colours that become codes and mix with what is there, through the whole pipeline: rules B1 and B2, cases 44 to 47.

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Mesh;
using test::Studio;

namespace {

/// Layers that hide the screen, the first one first.
Mesh full_screen_layers(const std::vector<glm::vec4>& colours) {
  Mesh mesh;
  for (const glm::vec4& colour : colours)
    for (const glm::vec3& corner : {glm::vec3(-1, -1, 0), glm::vec3(3, -1, 0), glm::vec3(-1, 3, 0)}) {
      mesh.positions.push_back(corner);
      mesh.colours.push_back(colour);
    }
  return mesh;
}

/// What is left of white under the layers. One draw for all, or one for each: the same.
template <class Read>
auto over_white_screen(const std::vector<glm::vec4>& layers, ColourFormat format, InstructionSet set, Read&& read) {
  PipelineState state;
  state.depth = kDepthOff;
  state.blend.mode = BlendMode::source_over;
  Studio once({.width = 9, .height = 9, .colour = format, .background = {1, 1, 1, 1}, .options = {.threads = 3, .instruction_set = set}});
  Studio one_by_one({.width = 9, .height = 9, .colour = format, .background = {1, 1, 1, 1}, .options = {.threads = 1, .instruction_set = set}});
  once.draw(full_screen_layers(layers).view(), gouraud(), state);
  for (const glm::vec4& layer : layers) one_by_one.draw(full_screen_layers({layer}).view(), flat(), state);
  CHECK(once.digest() == one_by_one.digest());
  return read(once.target());
}

Rgba8 codes_over_white(const std::vector<glm::vec4>& layers, InstructionSet set) {
  return over_white_screen(layers, ColourFormat::rgba8, set, [](const RenderTarget& target) { return target.colour_image().at(4, 4); });
}
Rgba32F floats_over_white(const std::vector<glm::vec4>& layers, InstructionSet set) {
  return over_white_screen(layers, ColourFormat::rgba32f, set, [](const RenderTarget& target) { return target.linear_image().at(4, 4); });
}

/// One point a pixel, each with a colour of its own, blended or not. Flat: the difference between two
/// infinite colours, which interpolation would need, is no number.
template <class Read>
auto stored_points(const std::vector<float>& values, ColourFormat format, BlendMode mode, InstructionSet set, Read&& read) {
  Mesh points;
  const auto width = static_cast<float>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    points.positions.push_back({(2 * static_cast<float>(i) + 1) / width - 1, 0, 0});
    points.colours.push_back(glm::vec4(values[i]));
  }
  PipelineState state;
  state.assembly.topology = Topology::points;
  state.depth = kDepthOff;
  state.blend.mode = mode;
  Studio studio({.width = static_cast<int>(values.size()), .height = 1, .colour = format, .options = {.threads = 1, .instruction_set = set}});
  studio.draw(points.view(), flat(), state);
  return read(studio.target());
}

constexpr float kOutputNan = std::numeric_limits<float>::quiet_NaN(), kOutputInf = std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("output: three transparent layers, in order and in reverse", "[extremes][B2][case-44]") {
  const float half = 128.0f / 255;
  const glm::vec4 red{1, 0, 0, half}, green{0, 1, 0, half}, blue{0, 0, 1, half};
  for_every_instruction_set([&](InstructionSet set) {
    CHECK(codes_over_white({red}, set) == Rgba8{255, 127, 127, 255});
    CHECK(codes_over_white({blue, green, red}, set) == Rgba8{159, 95, 63, 255});
    CHECK(codes_over_white({red, green, blue}, set) == Rgba8{63, 95, 159, 255});
    const Rgba32F exact = floats_over_white({blue, green, red}, set);
    CHECK(exact.r * 255 == Approx(159.50146866589773).epsilon(1e-6));
    CHECK(exact.g * 255 == Approx(95.25048827374087).epsilon(1e-6));
    CHECK(exact.b * 255 == Approx(63.25098039215686).epsilon(1e-6));
  });
}

TEST_CASE("output: a thousand layers of a 255th of black stall on codes, not on floats", "[extremes][B2][case-45]") {
  struct Known {
    std::size_t layers;
    int code;
    double exact;
  };
  for_every_instruction_set([](InstructionSet set) {
    for (const Known& k : {Known{1, 254, 254}, {10, 245, 245.1746}, {100, 155, 172.1448}, {255, 127, 93.6250}, {1000, 127, 5.0128}}) {
      INFO(k.layers << " layers");
      const std::vector<glm::vec4> layers(k.layers, {0, 0, 0, 1.0f / 255});
      CHECK(codes_over_white(layers, set).g == k.code);
      CHECK(floats_over_white(layers, set).g * 255 == Approx(k.exact).margin(1e-4 * 255));
    }
  });
}

TEST_CASE("output: codes of eight bits at their ties, and of what is no number", "[extremes][B1][case-46]") {
  const std::vector<float> values{0.5f, static_cast<float>(1.0 / 510 - 1e-9), static_cast<float>(1.0 / 510 + 1e-9), -0.0f, kOutputNan, kOutputInf, -kOutputInf, 2};
  const std::vector<int> codes{128, 0, 1, 0, 0, 255, 0, 255};
  for_every_instruction_set([&](InstructionSet set) {
    const auto image = stored_points(values, ColourFormat::rgba8, BlendMode::replace, set, [](const RenderTarget& t) { return t.colour_image(); });
    for (std::size_t i = 0; i < values.size(); ++i) {
      INFO("value " << values[i]);
      CHECK(static_cast<int>(image.at(static_cast<int>(i), 0).r) == codes[i]);
      CHECK(static_cast<int>(image.at(static_cast<int>(i), 0).a) == codes[i]);
    }
    // Blending clamps its inputs to what the target can hold: 2 is 1 before it is added, or laid over.
    const auto added = stored_points({2, kOutputInf, 0.25f}, ColourFormat::rgba8, BlendMode::additive, set, [](const RenderTarget& t) { return t.colour_image(); });
    CHECK((added.at(0, 0).r == 255 && added.at(1, 0).r == 255 && added.at(2, 0).r == 64));
    const auto over = stored_points({2, kOutputInf}, ColourFormat::rgba8, BlendMode::source_over, set, [](const RenderTarget& t) { return t.colour_image(); });
    CHECK((over.at(0, 0) == Rgba8{255, 255, 255, 255} && over.at(1, 0) == Rgba8{255, 255, 255, 255}));
  });
}

TEST_CASE("output: halves are rounded to nearest, from 65520 on to infinity", "[extremes][B1][case-46]") {
  const std::vector<float> values{65519.99f, 65520, 65504, -65520, 0x1p-25f, 0x1.8p-25f, 1 + 0x1p-11f, 1 + 0x1.8p-10f};
  const std::vector<float> stored{65504, kOutputInf, 65504, -kOutputInf, 0, 0x1p-24f, 1, 1 + 0x1p-9f};
  for_every_instruction_set([&](InstructionSet set) {
    const auto image = stored_points(values, ColourFormat::rgba16f, BlendMode::replace, set, [](const RenderTarget& t) { return t.linear_image(); });
    for (std::size_t i = 0; i < values.size(); ++i) CHECK(image.at(static_cast<int>(i), 0).g == stored[i]);
  });
}

TEST_CASE("output: a thousand transparent triangles come out the same from any number of threads", "[extremes][B2][case-47]") {
  test::Random random(52);
  Mesh layers;
  for (int i = 0; i < 3000; ++i) {
    layers.positions.push_back({random.between(-1.5, 1.5), random.between(-1.5, 1.5), 0});
    layers.colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 0.5)});
  }
  PipelineState state;
  state.depth = kDepthOff;
  state.blend.mode = BlendMode::source_over;
  // One draw for each triangle: then there is no order to lose.
  Studio one_by_one({.width = 150, .height = 100, .options = {.threads = 1, .instruction_set = InstructionSet::baseline}});
  for (std::uint32_t i = 0; i < 3000; i += 3) {
    Mesh one = layers;
    one.indices = {i, i + 1, i + 2};
    one_by_one.draw(one.view(), gouraud(), state);
  }
  for (const InstructionSet set : supported_instruction_sets())
    for (const int threads : {1, 2, 3, 7, 16}) {
      INFO(name_of(set) << ", " << threads << " threads");
      Studio studio({.width = 150, .height = 100, .options = {.threads = threads, .instruction_set = set}});
      studio.draw(layers.view(), gouraud(), state);
      CHECK(studio.digest() == one_by_one.digest());
    }
}

}  // namespace tuberia
