// What is needed, and what is known to be not.

#include <catch2/catch.hpp>

#include "pipeline/cutting.hpp"
#include "scene/clip_bounds.hpp"
#include "scene/closed_mesh.hpp"
#include "scene/neutral_features.hpp"
#include "scene/requirements.hpp"
#include "tests/support/draws.hpp"

namespace tuberia {
namespace {

constexpr RenderTargetDescription kTarget{.width = 96, .height = 64, .stencil = true};

const test::Mesh& ball() {
  static const test::Mesh kBall = test::sphere(8);
  return kBall;
}

DrawCall ball_seen_from(glm::dvec3 eye) { return {.mesh = ball().view(), .program = gouraud(), .state = test::seen_from(eye)}; }

TEST_CASE("requirements: an opaque ball in front of the eye needs next to nothing", "[requirements]") {
  const Requirements found = requirements_of(ball_seen_from({0, 0, 4}), kTarget);
  for (const Requirement& r : found.features) {
    INFO(name_of(r.feature) << ": " << r.reason);
    const bool expected = r.feature == Feature::drawing || r.feature == Feature::vertex_attributes || r.feature == Feature::shading ||
                          r.feature == Feature::interpolation || r.feature == Feature::perspective || r.feature == Feature::depth_test ||
                          r.feature == Feature::depth_write;
    CHECK(r.is_needed == expected);
    CHECK(!r.reason.empty());
    CHECK((r.reason.back() == '.'));
  }
  CHECK(found.attributes == Attributes::colour);
  CHECK(found.smallest.mesh.normals.empty());
  CHECK(found.smallest.mesh.texcoords.empty());
}

TEST_CASE("requirements: what is behind the eye or beside the view is not drawn", "[requirements]") {
  CHECK(requirements_of(ball_seen_from({0, 0, 4}), kTarget).needs(Feature::drawing));
  DrawCall beside = ball_seen_from({0, 0, 4}), behind = beside;
  beside.state.transform.world_from_object = translation({40, 0, 0});
  behind.state.transform.world_from_object = translation({0, 0, 8});
  CHECK_FALSE(requirements_of(beside, kTarget).needs(Feature::drawing));
  CHECK_FALSE(requirements_of(behind, kTarget).needs(Feature::drawing));
  CHECK(smallest_pipelines(std::vector{beside, ball_seen_from({0, 0, 4})}, kTarget).size() == 1);
}

TEST_CASE("requirements: a ball around the eye must be clipped, one beyond the border need not", "[requirements]") {
  CHECK(requirements_of(ball_seen_from({0, 0, 0.5}), kTarget).needs(Feature::clipping));
  DrawCall cut_by_border = ball_seen_from({0, 0, 4});
  cut_by_border.state.transform.world_from_object = translation({2.5, 0, 0});
  CHECK_FALSE(requirements_of(cut_by_border, kTarget).needs(Feature::clipping));
  CHECK(requirements_of(cut_by_border, kTarget).needs(Feature::drawing));
}

TEST_CASE("requirements: a depth-only pass reads positions only", "[requirements]") {
  DrawCall draw = ball_seen_from({0, 0, 4});
  draw.program = phong({});
  draw.state.blend.write = false;
  draw.state.fog = {.mode = FogMode::exp};
  const Requirements found = requirements_of(draw, kTarget);
  CHECK(found.attributes == Attributes::none);
  CHECK(found.smallest.mesh.normals.empty());
  for (const Feature feature : {Feature::shading, Feature::interpolation, Feature::fog, Feature::late_depth_test, Feature::vertex_attributes})
    CHECK_FALSE(found.needs(feature));
  // But where alpha decides what leaves a depth, it must be known.
  draw.program = textured({.texture = test::texture_of(test::checkerboard(8, 2, {255, 255, 255, 255}, {0, 0, 0, 0})), .sampler = {}, .alpha_cutoff = 0.5f}, true);
  const Requirements holes = requirements_of(draw, kTarget);
  CHECK(holes.needs(Feature::shading));
  CHECK(holes.attributes == Attributes::texcoord);
}

TEST_CASE("requirements: what is opaque need not be blended, nor tested for its alpha", "[requirements]") {
  DrawCall draw = ball_seen_from({0, 0, 4});
  draw.state.blend.mode = BlendMode::source_over;
  draw.state.alpha_test = {Compare::greater, 0.5f};
  const Requirements opaque = requirements_of(draw, kTarget);
  CHECK_FALSE(opaque.needs(Feature::blending));
  CHECK_FALSE(opaque.needs(Feature::alpha_test));
  CHECK_FALSE(opaque.needs(Feature::late_depth_test));
  std::vector<glm::vec4> colours(ball().positions.size(), glm::vec4(1));
  colours.back().a = 0.99f;
  draw.mesh.colours = colours;
  const Requirements translucent = requirements_of(draw, kTarget);
  CHECK(translucent.needs(Feature::blending));
  CHECK(translucent.needs(Feature::alpha_test));
  CHECK(translucent.needs(Feature::late_depth_test));
}

TEST_CASE("requirements: user planes that cut nothing go, others stay in their order", "[requirements]") {
  DrawCall draw = ball_seen_from({0, 0, 4});
  const glm::mat4& clip = draw.state.transform.clip_from_world;
  ClippingState& clipping = draw.state.clipping;
  clipping.user_planes[0] = clip_plane_from_world({0, 1, 0, 5}, clip);
  clipping.user_planes[1] = clip_plane_from_world({0, 1, 0, 0.5}, clip);
  clipping.user_planes[2] = clip_plane_from_world({1, 0, 0, 0.25}, clip);
  clipping.user_plane_count = 3;
  const ClippingState& left = requirements_of(draw, kTarget).smallest.state.clipping;
  REQUIRE(left.user_plane_count == 2);
  CHECK(left.user_planes[0] == clipping.user_planes[1]);
  CHECK(left.user_planes[1] == clipping.user_planes[2]);
  clipping.user_planes[2] = clip_plane_from_world({0, 1, 0, -5}, clip);
  CHECK_FALSE(requirements_of(draw, kTarget).needs(Feature::drawing));
}

TEST_CASE("requirements: everything that is added is found to be superfluous", "[requirements]") {
  for (const FragmentProgram& program : {gouraud(), flat(), phong({})}) {
    DrawCall draw = ball_seen_from({0, 0, 4});
    draw.program = program;
    const DrawCall full = with_everything(draw, kTarget);
    CHECK_FALSE(full.state == draw.state);
    const Requirements found = requirements_of(full, kTarget), plain = requirements_of(draw, kTarget);
    CHECK(found.smallest.state == plain.smallest.state);
    CHECK(&found.smallest.program.interface() == &plain.smallest.program.interface());
    for (const Requirement& r : found.features) {
      INFO(name_of(r.feature) << ": " << r.reason);
      CHECK(r.is_needed == plain.needs(r.feature));
    }
  }
}

glm::mat4 random_matrix(test::Random& random) {
  glm::mat4 matrix;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) matrix[c][r] = (static_cast<float>(random.below(2001)) - 1000) / 500;
  return matrix;
}

TEST_CASE("requirements: the box around the vertices tells nothing that is wrong of one of them", "[requirements]") {
  test::Random random(23);
  int inside = 0, outside = 0;
  for (int n = 0; n < 20000; ++n) {
    std::vector<glm::vec3> positions(3);
    const float size = n % 2 == 0 ? 0.25f : 4.0f;
    for (glm::vec3& p : positions)
      for (int k = 0; k < 3; ++k) p[k] = (static_cast<float>(random.below(2001)) - 1000) / 1000 * size;
    DrawCall draw;
    draw.mesh.positions = positions;
    draw.state.transform.clip_from_world = random_matrix(random);
    const Viewport viewport{0, 0, 96, 64};
    const ClipBounds bounds(draw, viewport);
    const ClipLimits limits = clip_limits(viewport, draw.state.clipping);
    std::uint32_t any = 0, all = ~0u;
    for (const glm::vec3& p : positions) {
      const std::uint32_t code = outcode_of(draw.state.transform.clip_from_world * glm::vec4(p, 1), limits);
      any |= code;
      all &= code;
    }
    inside += bounds.are_inside() ? 1 : 0;
    outside += bounds.are_outside(true) ? 1 : 0;
    if (bounds.are_inside()) REQUIRE(any == 0);
    if (bounds.are_outside(true)) REQUIRE(all != 0);
  }
  CHECK(inside > 1000);
  CHECK(outside > 1000);
}

TEST_CASE("requirements: a mesh is closed until a triangle is missing or turned round", "[requirements]") {
  // A tetrahedron whose faces have corners of their own.
  const glm::vec3 corner[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<glm::vec3> positions;
  for (const int i : {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}) positions.push_back(corner[i]);
  DrawCall draw;
  draw.mesh.positions = positions;
  CHECK(is_closed(draw));
  draw.mesh.positions = std::span(positions).first(9);
  CHECK_FALSE(is_closed(draw));
  draw.mesh.positions = positions;
  std::swap(positions[9], positions[10]);
  CHECK_FALSE(is_closed(draw));
  CHECK(is_closed({.mesh = ball().view(), .program = {}, .state = {}}));
}

TEST_CASE("requirements: of positions that are not finite nothing is known", "[requirements]") {
  std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}};
  DrawCall draw;
  draw.mesh.positions = positions;
  const ClipBounds bounds(draw, {0, 0, 96, 64});
  CHECK_FALSE(bounds.are_known());
  CHECK_FALSE(bounds.are_inside());
  CHECK_FALSE(bounds.are_outside(true));
}

}  // namespace
}  // namespace tuberia
