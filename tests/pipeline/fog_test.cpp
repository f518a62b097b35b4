// Fog per fragment and per vertex, through the whole pipeline.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

/// A triangle in clip space with colours and fog coordinates.
struct FoggyTriangle {
  std::vector<glm::vec4> clip;
  std::vector<float> fog;
  std::vector<glm::vec4> colours = std::vector<glm::vec4>(3, glm::vec4(1));

  Image<Rgba32F> drawn(const FogState& state, const PipelineOptions& options) const {
    test::Studio studio({.width = 64, .height = 64, .colour = ColourFormat::rgba32f, .options = options});
    PipelineState pipeline_state;
    pipeline_state.fog = state;
    studio.draw({.clip_positions = clip, .colours = colours, .fog_coordinates = fog}, gouraud(), pipeline_state);
    return studio.picture().linear;
  }
};

/// Of white in black fog.
float share(const FogState& fog, float coordinate) {
  const double c = std::abs(static_cast<double>(coordinate)), thickness = c * static_cast<double>(fog.density);
  if (fog.mode == FogMode::linear) {
    const double left = (static_cast<double>(fog.end) - c) / (static_cast<double>(fog.end) - static_cast<double>(fog.start));
    return static_cast<float>(std::clamp(left, 0.0, 1.0));
  }
  return static_cast<float>(std::exp(-(fog.mode == FogMode::exp ? thickness : thickness * thickness)));
}

double largest_difference(const Image<Rgba32F>& a, const Image<Rgba32F>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) largest = std::max(largest, static_cast<double>(std::abs(a.pixels()[i].r - b.pixels()[i].r)));
  return largest;
}

}  // namespace

// The triangle's first corner lies behind the eye: clipping makes vertices, whose share is interpolated.
TEST_CASE("fog: per vertex it is interpolated like a colour, also where clipping cuts", "[pipeline]") {
  const FoggyTriangle foggy{.clip = {{0.2f, -3, 0, -0.5f}, {-2, 1, 0.5f, 2}, {3, 2, 1, 4}}, .fog = {-0.5f, 2, 4}};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const PipelineOptions options{.threads = 1, .instruction_set = set, .precision = precision};
    for (const FogMode mode : {FogMode::linear, FogMode::exp, FogMode::exp2}) {
      const FogState fog{.mode = mode, .density = 0.4f, .start = 1, .end = 3, .per_vertex = true};
      FoggyTriangle coloured = foggy;
      for (std::size_t i = 0; i < 3; ++i) coloured.colours[i] = glm::vec4(glm::vec3(share(fog, foggy.fog[i])), 1);
      const auto shares = coloured.drawn({}, options);
      CHECK(largest_difference(foggy.drawn(fog, options), shares) < 2e-6);
      FoggyTriangle by_w = foggy;  // without coordinates of its own the fog follows w, which here is the same
      by_w.fog.clear();
      CHECK(largest_difference(by_w.drawn(fog, options), shares) < 2e-6);
    }
  });
}

TEST_CASE("fog: per vertex it bends no more between them", "[pipeline][trade]") {
  // Coordinates 0 and 4 at the ends; (20, 32) and its neighbours lie near the middle of the screen triangle's left part.
  const FoggyTriangle foggy{.clip = {{-1, 1, 0, 1}, {-1, -3, 0, 1}, {3, 1, 0, 1}}, .fog = {0, 0, 8}};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const PipelineOptions options{.threads = 1, .instruction_set = set, .precision = precision};
    const FogState per_fragment{.mode = FogMode::exp, .density = 0.5f};
    FogState per_vertex = per_fragment;
    per_vertex.per_vertex = true;
    const auto bent = foggy.drawn(per_fragment, options), straight = foggy.drawn(per_vertex, options);
    for (int x = 0; x < 64; ++x) {
      const double along = (x + 0.5) / 128;  // the coordinate is 8 times that
      CHECK(bent.at(x, 0).r == Approx(std::exp(-4 * along)).epsilon(2e-6));
      CHECK(straight.at(x, 0).r == Approx(1 + along * (std::exp(-4.0) - 1)).epsilon(2e-6));
    }
    FogState linear{.mode = FogMode::linear, .start = -1, .end = 9};  // never clamped: both are the same straight line
    const auto first = foggy.drawn(linear, options);
    linear.per_vertex = true;
    CHECK(largest_difference(first, foggy.drawn(linear, options)) < 1e-6);
  });
}

}  // namespace tuberia
