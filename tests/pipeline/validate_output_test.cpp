#include "pipeline/validate_output.hpp"

#include <catch2/catch.hpp>

#include <limits>

namespace tuberia {

using Catch::Matchers::Contains;

namespace {

std::string output_refusal_of(const PipelineState& state, const RenderTargetDescription& description = {.width = 8, .height = 8}) {
  const RenderTarget target = *RenderTarget::create(description);
  const std::optional<Error> refusal = output_refusal(state, target);
  return refusal ? refusal->message : "accepted";
}

}  // namespace

TEST_CASE("validate: what a target cannot hold is refused by name", "[pipeline]") {
  PipelineState stencil, logic;
  stencil.stencil.enabled = true;
  CHECK_THAT(output_refusal_of(stencil), Contains("stencil.enabled"));
  CHECK(output_refusal_of(stencil, {.width = 8, .height = 8, .stencil = true}) == "accepted");
  logic.blend.logic = LogicOperation::xor_;
  CHECK(output_refusal_of(logic) == "accepted");
  for (const ColourFormat format : {ColourFormat::srgb8, ColourFormat::rgba16f, ColourFormat::rgba32f})
    CHECK_THAT(output_refusal_of(logic, {.width = 8, .height = 8, .colour = format}), Contains("blend.logic"));
}

TEST_CASE("validate: only exact edges go with several samples", "[pipeline]") {
  PipelineState state;
  state.rasterization.edge_arithmetic = EdgeArithmetic::float_anchored;
  CHECK(output_refusal_of(state) == "accepted");
  CHECK_THAT(output_refusal_of(state, {.width = 8, .height = 8, .samples = 4}), Contains("rasterization.edge_arithmetic is 2") && Contains("4 samples"));
}

TEST_CASE("validate: fragment state out of range is refused with its value", "[pipeline]") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const float reference : {-0.5f, 1.5f, nan}) {
    PipelineState state;
    state.alpha_test = {Compare::greater, reference};
    CHECK_THAT(output_refusal_of(state), Contains("alpha_test.reference is"));
    state.alpha_test.test = Compare::always;  // then it is not read
    CHECK(output_refusal_of(state) == "accepted");
  }
  PipelineState blend;
  blend.blend.constant.g = inf;
  CHECK(output_refusal_of(blend) == "accepted");
  blend.blend.mode = BlendMode::function;
  CHECK_THAT(output_refusal_of(blend), Contains("blend.constant.g is inf"));

  PipelineState fog;
  fog.fog.colour.b = nan;
  CHECK(output_refusal_of(fog) == "accepted");
  fog.fog.mode = FogMode::exp;
  CHECK_THAT(output_refusal_of(fog), Contains("fog.colour.b is nan"));
  fog.fog.colour.b = 0, fog.fog.density = -2;
  CHECK_THAT(output_refusal_of(fog), Contains("fog.density is -2"));
  fog.fog.mode = FogMode::linear;
  CHECK(output_refusal_of(fog) == "accepted");
  fog.fog.start = fog.fog.end = 1, fog.fog.colour.a = nan;
  CHECK(output_refusal_of(fog) == "accepted");
  fog.fog.end = inf;
  CHECK_THAT(output_refusal_of(fog), Contains("fog.end is inf"));
}

}  // namespace tuberia
