// Lesson 1: one triangle through the pipeline, stage by stage. Each stage is an object that works
// on a batch and can be called alone; this program calls them in order on a batch of one triangle
// and prints what each made of it. pipeline/pipeline.cpp chains the same objects.

#include <bit>
#include <cstdio>
#include <filesystem>

#include "image/write_image.hpp"
#include "math/camera.hpp"
#include "pipeline/blending.hpp"
#include "pipeline/clipping.hpp"
#include "pipeline/culling.hpp"
#include "pipeline/depth_test.hpp"
#include "pipeline/fragment_shading.hpp"
#include "pipeline/perspective_divide.hpp"
#include "pipeline/primitive_assembly.hpp"
#include "pipeline/programs/programs.hpp"
#include "pipeline/rasterization.hpp"
#include "pipeline/validate.hpp"
#include "pipeline/vertex_transform.hpp"

using namespace tuberia;

namespace {

constexpr int kWidth = 48, kHeight = 32;

void print_vertices(const char* space, const VertexBatch& batch) {
  std::printf("\n%s\n", space);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.size()); ++i)
    std::printf("  vertex %zu  x %8.4f  y %8.4f  z %8.4f  w %8.4f%s\n", i, static_cast<double>(batch.clip_x[i]),
                static_cast<double>(batch.clip_y[i]), static_cast<double>(batch.clip_z[i]), static_cast<double>(batch.clip_w[i]),
                i >= batch.source.size() ? "  (made by clipping)" : "");
}

void print_blocks(const std::vector<FragmentBlock>& blocks) {
  char picture[kHeight][kWidth + 1];
  for (auto& row : picture) {
    for (int x = 0; x < kWidth; ++x) row[x] = '.';
    row[kWidth] = 0;
  }
  for (const FragmentBlock& block : blocks)
    for (int i = 0; i < kBlockPixels; ++i)
      if ((block.live >> i & 1) != 0 && block.top + block_y(i) < kHeight) picture[block.top + block_y(i)][block.left + block_x(i)] = '#';
  for (const auto& row : picture) std::printf("  %s\n", row);
}

int live_fragments(const std::vector<FragmentBlock>& blocks) {
  int count = 0;
  for (const FragmentBlock& block : blocks) count += std::popcount(block.live);
  return count;
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

  std::printf("0 validate: the only stage that can refuse\n");
  const AcceptedDraw accepted = *validate(draw, target, workers);
  const ClipLimits limits = clip_limits(accepted.viewport, draw.state.clipping.volume);
  std::printf("  accepted; viewport %d x %d pixels\n", accepted.viewport.width_pixels, accepted.viewport.height_pixels);

  VertexBatch vertices;
  TriangleBatch triangles;
  std::vector<std::uint32_t> slots;
  VertexFetch()(draw.mesh, Topology::triangles, {0, 1}, vertices, slots);
  const VertexTransform vertex_transform(draw.state.transform, limits, isa);
  vertex_transform.positions(draw.mesh, vertices);
  print_vertices("1 VertexTransform: object space -> clip space", vertices);

  PrimitiveAssembly(draw.state.assembly)(slots, {0, 1}, triangles);
  std::printf("\n2 PrimitiveAssembly: vertices -> triangles\n  triangle 0 joins vertices %u, %u, %u\n", triangles.v0[0],
              triangles.v1[0], triangles.v2[0]);

  const int cut = Clipping(limits)(vertices, triangles);
  print_vertices("3 Clipping: clip space -> clip space", vertices);
  std::printf("  %d triangle cut; now there are %d\n", cut, triangles.count);

  PerspectiveDivide(screen_map(accepted.viewport, {}, draw.state.clipping.volume), isa)(vertices);
  std::printf("\n4 PerspectiveDivide: clip space -> ndc -> screen, snapped to 1/256 pixel\n");
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices.size()); ++i)
    if (!(vertices.clip_w[i] > 0)) std::printf("  vertex %zu  behind the eye: it has no place on the screen\n", i);
    else std::printf("  vertex %zu  x %8d/256  y %8d/256  depth %.6f\n", i, vertices.screen[i].x, vertices.screen[i].y,
                static_cast<double>(vertices.screen[i].depth));

  Culling(draw.state.culling, accepted.clip, isa)(vertices, triangles);
  std::printf("\n5 Culling: %d triangles have an area, face the right way and hold a pixel centre\n", triangles.count);

  const Rasterization rasterization(accepted.clip, isa, Precision::exact);
  vertex_transform.attributes(draw.mesh, draw.program.interface().attributes(), triangles, vertices);
  std::vector<ScreenTriangle> screen_triangles;
  rasterization.set_up(triangles, vertices, screen_triangles);
  std::vector<FragmentBlock> blocks;
  for (const ScreenTriangle& triangle : screen_triangles)
    for (const FragmentBlock& block : rasterization.blocks(triangle, target)) blocks.push_back(block);
  std::printf("\n6 Rasterization: %zu blocks of 8x8 with %d fragments\n", blocks.size(), live_fragments(blocks));
  print_blocks(blocks);

  const ChunkView chunk{.triangles = screen_triangles.data(), .attributes = vertices.attributes.data(), .stride = vertices.stride};
  const FragmentShading shading(draw.program, false, isa, Precision::exact);
  for (FragmentBlock& block : blocks) shading(chunk, block);
  const int first = std::countr_zero(blocks[0].live);
  std::printf("\n7 FragmentShading: the first fragment, at pixel (%d, %d), is (%.3f, %.3f, %.3f)\n", blocks[0].left + block_x(first),
              blocks[0].top + block_y(first), static_cast<double>(blocks[0].colour[0][first]),
              static_cast<double>(blocks[0].colour[1][first]), static_cast<double>(blocks[0].colour[2][first]));

  const DepthTest depth_test(accepted.output, isa, Precision::exact);
  for (FragmentBlock& block : blocks) depth_test(block, target);
  std::printf("\n8 DepthTest: %d fragments pass; the first one's code is %d of 16777215\n", live_fragments(blocks), blocks[0].depth[0][first]);

  const Blending blending(accepted.output, isa, Precision::exact);
  for (const FragmentBlock& block : blocks) blending(block, target);
  std::filesystem::create_directories("out");
  const auto written = write_image("out/one_triangle.png", target.colour_image());
  std::printf("\n9 Blending: the pixels are in the target%s\n", written ? ", and in out/one_triangle.png" : "");
  return 0;
}
