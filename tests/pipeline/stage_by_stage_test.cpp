#include <catch2/catch.hpp>

#include "pipeline/blending.hpp"
#include "pipeline/clipping.hpp"
#include "pipeline/culling.hpp"
#include "pipeline/depth_test.hpp"
#include "pipeline/fragment_shading.hpp"
#include "pipeline/perspective_divide.hpp"
#include "pipeline/primitive_assembly.hpp"
#include "pipeline/rasterization.hpp"
#include "pipeline/validate.hpp"
#include "pipeline/vertex_transform.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

namespace {

/// A draw as a lecturer would give it: one stage after the other, each finished before the next.
void draw_slowly(RenderTarget& target, const DrawCall& draw, InstructionSet set, Precision precision) {
  Workers workers(1);
  const PipelineState& state = draw.state;
  const AcceptedDraw accepted = *validate(draw, target, workers);
  const ClipLimits limits = clip_limits(accepted.viewport, state.clipping.volume);
  const auto primitives = static_cast<int>(primitive_count(state.assembly.topology, static_cast<std::int64_t>(draw.mesh.element_count())));

  VertexFetch fetch;
  VertexBatch vertices;
  TriangleBatch triangles;
  std::vector<std::uint32_t> slots;
  fetch(draw.mesh, state.assembly.topology, {0, primitives}, vertices, slots);
  const VertexTransform transform(state.transform, limits, set);
  transform.positions(draw.mesh, vertices);
  PrimitiveAssembly{state.assembly}(slots, {0, primitives}, triangles);
  Clipping{limits}(vertices, triangles);
  PerspectiveDivide(screen_map(accepted.viewport, state.viewport.depth_range, state.clipping.volume), set)(vertices);
  Culling(state.culling, accepted.clip, set)(vertices, triangles);
  transform.attributes(draw.mesh, draw.program.interface().attributes(), triangles, vertices);

  const Rasterization rasterization(accepted.clip, set, precision);
  std::vector<ScreenTriangle> screen_triangles;
  rasterization.set_up(triangles, vertices, screen_triangles);
  const ChunkView view{.triangles = screen_triangles.data(), .attributes = vertices.attributes.data(), .stride = vertices.stride};
  const FragmentShading shading(draw.program, state.rasterization.flat_shading, set, precision);
  const DepthTest depth_test(accepted.output, set, precision);
  const Blending blending(accepted.output, set, precision);
  for (const ScreenTriangle& triangle : screen_triangles)
    for (FragmentBlock& block : rasterization.blocks(triangle, target)) {
      shading(view, block);
      depth_test(block, target);
      blending(block, target);
    }
}

struct Scene {
  const char* name;
  test::Mesh mesh;
  FragmentProgram program;
  PipelineState state;
};

std::vector<Scene> scenes() {
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world({1.5, 1.25, 2.5}, 1.3);
  PipelineState lit = state, layered = state, reversed = state;
  lit.transform.vertex_lighting = Lighting{.specular = glm::vec3(0.4f), .eye = {1.5f, 1.25f, 2.5f}};
  layered.blend.mode = BlendMode::source_over;
  layered.depth.test = Compare::less_equal;
  layered.rasterization.scissor = PixelRect{5, 3, 88, 61};
  reversed.viewport.depth_range = {1, 0};
  reversed.viewport.viewport = Viewport{-20, 10, 110, 70};
  reversed.depth.test = Compare::greater;
  reversed.culling.cull = CullFace::back;
  Image<Rgba8> holes = test::checkerboard(32, 4, {200, 30, 60, 255}, {0, 0, 0, 0});
  const TexturedUniforms texture{.texture = test::texture_of(holes, TextureEncoding::srgb), .sampler = {}, .alpha_cutoff = 0.5f};
  const test::Mesh floor = test::rectangle({-9, -1, -9}, {0, 0, 18}, {18, 0, 0}, {0, 1, 0}, 7);
  return {{"gouraud", test::sphere(12), gouraud(), lit},
          {"phong", test::sphere(12), phong(*lit.transform.vertex_lighting), reversed},
          {"flat, blended", test::sphere(9), flat(), layered},
          {"textured", floor, textured(texture), state},
          {"textured, cut out", floor, textured(texture, true), state},
          {"textured, lit, blended", test::sphere(9), textured_lit({.texture = texture.texture, .sampler = {}, .lighting = {}}), layered}};
}

}  // namespace

TEST_CASE("pipeline: a draw stage by stage leaves the bits of a draw at one go", "[pipeline][exact]") {
  for (const Scene& scene : scenes())
    for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f})
      for (const Precision precision : {Precision::exact, Precision::fast})
        test::for_every_instruction_set([&](InstructionSet set) {
          INFO(scene.name << ", format " << static_cast<int>(format) << ", precision " << static_cast<int>(precision));
          const test::Canvas canvas{.width = 101, .height = 77, .colour = format, .background = {0.2f, 0.3f, 0.1f, 1},
                                    .far_depth = scene.state.depth.test == Compare::greater ? 0.0f : 1.0f,
                                    .options = {.threads = 2, .instruction_set = set, .precision = precision}};
          test::Studio fast(canvas), slow(canvas);
          const std::string empty = fast.digest();
          fast.draw(scene.mesh.view(), scene.program, scene.state);
          draw_slowly(slow.target(), {.mesh = scene.mesh.view(), .program = scene.program, .state = scene.state}, set, precision);
          CHECK(fast.digest() != empty);
          CHECK(slow.digest() == fast.digest());
        });
}

}  // namespace tuberia
