// Lesson 1: one triangle through the pipeline, stage by stage. Each stage is an object that works on a batch; this program
// calls them in order and prints what each made of one triangle. pipeline/pipeline.cpp chains the same objects.

#include <bit>
#include <cstdio>
#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera.hpp"
#include "pipeline/blending.hpp"
#include "pipeline/depth_test.hpp"
#include "pipeline/fragment_shading.hpp"
#include "pipeline/geometry_stages.hpp"
#include "pipeline/programs/programs.hpp"

using namespace tuberia;

namespace {
constexpr int kWidth = 48, kHeight = 32;

void print_vertices(const char* space, const VertexBatch& batch) {
  std::printf("\n%s\n", space);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.size()); ++i)
    std::printf("  vertex %zu  x %8.4f  y %8.4f  z %8.4f  w %8.4f%s\n", i, double(batch.clip_x[i]), double(batch.clip_y[i]),
                double(batch.clip_z[i]), double(batch.clip_w[i]), i >= batch.source.size() ? "  (made by clipping)" : "");
}

void print_blocks(const std::vector<FragmentBlock>& blocks) {
  std::vector<std::string> picture(kHeight, std::string(kWidth, '.'));
  for (const FragmentBlock& block : blocks)
    for (int i = 0; i < kBlockPixels; ++i)
      if ((block.live >> i & 1) != 0) picture.at(std::size_t(block.top + block_y(i))).at(std::size_t(block.left + block_x(i))) = '#';
  std::printf("\n6 Rasterization: %zu blocks of 8x8 pixels\n", blocks.size());
  for (const std::string& row : picture) std::printf("  %s\n", row.c_str());
}
}  // namespace

int main() {
  // A triangle in object space, one corner behind the eye, and a camera that looks at it.
  const std::vector<glm::vec3> positions{{-1.5f, -0.8f, 0}, {1.2f, -0.6f, 0}, {0.1f, 0.9f, 4.5f}};
  const std::vector<glm::vec4> colours{{1, 0.1f, 0.1f, 1}, {0.1f, 1, 0.1f, 1}, {0.1f, 0.1f, 1, 1}};
  const Camera camera{.eye = {0, 0, 3}, .view = *perspective_volume(1.0, double(kWidth) / kHeight, 0.5, 10)};
  DrawCall draw;
  draw.mesh.positions = positions;
  draw.mesh.colours = colours;
  draw.program = gouraud();
  draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;

  const InstructionSet isa = best_instruction_set();
  RenderTarget target = *RenderTarget::create(kWidth, kHeight);
  Workers workers(1);
  target.clear_colour({0.1f, 0.1f, 0.12f, 1}, workers);
  const AcceptedDraw accepted = *validate(draw, target, workers);
  std::printf("0 validate: the only stage that can refuse\n");

  VertexBatch vertices;
  TriangleBatch triangles;
  const ClipLimits limits = clip_limits(accepted.viewport, draw.state.clipping.volume);
  std::vector<std::uint32_t> slots;  // of the vertices, in the order of their arrival
  const VertexTransform vertex_transform(draw.state.transform, limits, isa);
  VertexFetch()(draw.mesh, Topology::triangles, {0, 1}, vertices, slots);
  vertex_transform.positions(draw.mesh, vertices);
  print_vertices("1 VertexTransform: object space -> clip space", vertices);
  PrimitiveAssembly(draw.state.assembly)(slots, {0, 1}, triangles);
  std::printf("\n2 PrimitiveAssembly: triangle 0 joins vertices %u, %u, %u\n", triangles.v0[0], triangles.v1[0], triangles.v2[0]);
  const int cut = Clipping(limits)(vertices, triangles);
  print_vertices("3 Clipping: clip space -> clip space", vertices);
  std::printf("  %d triangle cut; now there are %d\n", cut, triangles.count);
  PerspectiveDivide(screen_map(accepted.viewport, {}, draw.state.clipping.volume), isa)(vertices);
  std::printf("\n4 PerspectiveDivide: clip space -> ndc -> screen, snapped to 1/256 pixel\n");
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices.size()); ++i)
    if (vertices.clip_w[i] > 0)  // what lies behind the eye has no place on the screen
      std::printf("  vertex %zu  x %8d/256  y %8d/256  depth %.6f\n", i, vertices.screen[i].x, vertices.screen[i].y, double(vertices.screen[i].depth));
  Culling(draw.state.culling, accepted.clip, isa)(vertices, triangles);
  std::printf("\n5 Culling: %d triangles have an area, face the right way and hold a pixel centre\n", triangles.count);

  const Rasterization rasterization(accepted.clip, isa, Precision::exact);
  vertex_transform.attributes(draw.mesh, draw.program.interface().attributes(), triangles, vertices);
  std::vector<ScreenTriangle> screen_triangles;
  rasterization.set_up(triangles, vertices, screen_triangles);
  std::vector<FragmentBlock> blocks;
  for (const ScreenTriangle& triangle : screen_triangles)
    for (const FragmentBlock& block : rasterization.blocks(triangle, target)) blocks.push_back(block);
  print_blocks(blocks);

  const ChunkView chunk{.triangles = screen_triangles.data(), .attributes = vertices.attributes.data(), .stride = vertices.stride};
  for (FragmentBlock& block : blocks) FragmentShading(draw.program, false, isa, Precision::exact)(chunk, block);
  const FragmentBlock& block = blocks[0];
  const int first = std::countr_zero(block.live);
  std::printf("\n7 FragmentShading: the first fragment, at pixel (%d, %d), is (%.3f, %.3f, %.3f)\n", block.left + block_x(first),
              block.top + block_y(first), double(block.colour[0][first]), double(block.colour[1][first]), double(block.colour[2][first]));
  for (FragmentBlock& each : blocks) DepthTest(accepted.output, isa, Precision::exact)(each, target);
  std::printf("\n8 DepthTest: the first fragment's code is %d of 16777215\n", block.depth[0][first]);
  for (const FragmentBlock& each : blocks) Blending(accepted.output, isa, Precision::exact)(each, target);
  std::filesystem::create_directories("out");
  const bool written = write_image("out/one_triangle.png", target.colour_image()).ok();
  std::printf("\n9 Blending: the pixels are in the target, and in out/one_triangle.png\n");
  return written ? 0 : 1;
}
