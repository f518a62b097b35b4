// A program of somebody else: it knows only the installed headers, and uses something of every
// section of docs/api.md. It exits with 1 and says what does not hold.

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "image/write_image.hpp"
#include "math/camera_motions.hpp"
#include "pipeline/blending.hpp"
#include "pipeline/clipping.hpp"
#include "pipeline/culling.hpp"
#include "pipeline/depth_test.hpp"
#include "pipeline/fragment_shading.hpp"
#include "pipeline/perspective_divide.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/pixel_recorder.hpp"
#include "pipeline/primitive_assembly.hpp"
#include "pipeline/primitive_recorder.hpp"
#include "pipeline/programs/fixed_function.hpp"
#include "pipeline/programs/programs.hpp"
#include "pipeline/rasterization.hpp"
#include "pipeline/vertex_transform.hpp"
#include "raster/cube_map.hpp"
#include "raster/sample_texture.hpp"
#include "raster/texture_target.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shapes/shapes.hpp"
#include "scene/vertex_normals.hpp"

namespace {

using namespace tuberia;

int failures = 0;

void expect(bool holds, const char* what) {
  std::printf("%s  %s\n", holds ? "ok  " : "FAIL", what);
  if (!holds) ++failures;
}

const std::vector<glm::vec4> kClipTriangle{{-1, -1, 0, 1}, {1, -1, 0, 1}, {-1, 1, 0, 1}};
const std::vector<glm::vec4> kRed(3, glm::vec4{1, 0, 0, 1});

int count_red(const Image<Rgba8>& image) {
  int count = 0;
  for (const Rgba8& pixel : image.pixels()) count += pixel == Rgba8{255, 0, 0, 255};
  return count;
}

void clip_space_primitives(Pipeline& pipeline) {
  RenderTarget target = *RenderTarget::create(8, 8);
  DrawCall draw{.mesh = {.clip_positions = kClipTriangle, .colours = kRed}, .program = gouraud(), .state = {}, .count_fragments = true};
  const auto drawn = pipeline.draw(target, draw);
  expect(drawn && drawn->samples_passed == 28 && count_red(target.colour_image()) == 28, "clip-space triangles; fragments counted");

  const auto red_pixels = [&](const DrawCall& call) {
    pipeline.clear(target, {0, 0, 0, 1});
    return pipeline.draw(target, call) ? count_red(target.colour_image()) : -1;
  };
  draw.state.assembly.topology = Topology::points;
  draw.state.rasterization.point.size_pixels = 3;
  expect(red_pixels(draw) == 1 + 2 + 4, "points, cut by the target's border");
  DrawCall line = draw;
  const std::vector<glm::vec4> across{{-1, 0.1f, 0, 1}, {1, 0.1f, 0, 1}};
  line.mesh.clip_positions = across;
  line.mesh.colours = line.mesh.colours.first(2);
  line.state.assembly.topology = Topology::lines;
  expect(red_pixels(line) == 8, "a line, a pixel in each column");
  line.state.rasterization.line.stipple = StipplePattern{.bits = 0x5555};
  expect(red_pixels(line) == 4, "every other one of a stippled line");

  const std::uint32_t wrong[3] = {0, 1, 7};
  draw.mesh.indices = wrong;
  const auto refused = pipeline.draw(target, draw);
  expect(!refused && refused.error().message.find("index 2 is 7") != std::string::npos, "a refusal names the culprit");
}

void snapped_triangles(Pipeline& pipeline) {
  RenderTarget target = *RenderTarget::create(8, 8);
  const std::vector<ScreenVertex> square{{0, 0, 0.5f, 1}, {2048, 0, 0.5f, 1}, {2048, 2048, 0.5f, 1}, {0, 2048, 0.5f, 1}};
  const std::uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  const std::vector<glm::vec4> red(4, glm::vec4{1, 0, 0, 1});
  const auto drawn = pipeline.draw(target, {.mesh = {.screen_positions = square, .colours = red, .indices = indices}, .program = gouraud(), .state = {}, .count_fragments = true});
  expect(drawn && drawn->fragments == 64, "snapped 24.8 triangles: two share a diagonal, and each pixel once");
  expect(target.depth_codes().at(3, 3) == 8388608, "depth codes");
}

void samples_and_stencil(Pipeline& pipeline) {
  RenderTarget target = *RenderTarget::create({.width = 8, .height = 8, .stencil = true, .samples = 4});
  expect(pipeline.clear(target, {.colour = Rgba32F{0, 0, 0, 1}, .depth = 1.0f, .stencil = std::uint8_t{5}}).operator bool(), "clear with a command");
  DrawCall draw{.mesh = {.clip_positions = kClipTriangle, .colours = kRed}, .program = gouraud(), .state = {}};
  draw.state.stencil.enabled = true;
  draw.state.stencil.front.pass = draw.state.stencil.back.pass = StencilOperation::increment;
  expect(pipeline.draw(target, draw).operator bool() && target.stencil_codes().at(0, 7) == 6 && target.stencil_codes().at(7, 0) == 5, "stencil codes");
  RenderTarget resolved = *RenderTarget::create(8, 8);
  expect(resolve(target, resolved, pipeline.workers()).operator bool(), "resolve");
  const int edge = resolved.colour_image().at(4, 4).r;
  expect(edge > 0 && edge < 255, "an edge pixel of four samples is neither");
}

void clipper_alone() {
  const ClipLimits volume;  // -w <= x, y, z <= w
  ClipLimits from_zero;
  from_zero.z_low = 0;
  const std::array<std::array<double, 4>, 3> hexagon{{{12, -6, -2.5, 1}, {-6, 12, -2.5, 1}, {-6, -6, 6.5, 1}}};
  expect(clip_triangle(hexagon, 0x3f, from_zero).count == 6, "clip_triangle: six corners");
  const std::vector<glm::dvec4> square{{-2, -2, 0, 1}, {2, -2, 0, 1}, {2, 2, 0, 1}, {-2, 2, 0, 1}};
  expect(clip_polygon(square, volume).size() == 4, "clip_polygon");
  const ClippedLine line = clip_line(std::array<std::array<double, 4>, 2>{{{0, 0, 0, 1}, {4, 0, 0, 1}}}, outcode::right, volume);
  expect(!line.is_empty && line.corner[1].position[0] == 1 && line.corner[1].weight[1] == 0.25, "clip_line, with weights");
  expect(outcode_of({-3, 0, 0, 1}, volume) == outcode::left, "outcodes");
}

void textures() {
  const Image<Rgba8> image(5, 3, {200, 100, 50, 255});
  const auto texture = std::make_shared<const Texture>(*Texture::create(image, TextureEncoding::linear));
  expect(texture->level_count() == 3 && texture->level(1).width == 2 && texture->level(1).height == 1, "mip chains");
  const Rgba32F texel = sample_texture(*texture, {.max_anisotropy = 4}, {.at = {0.3f, 0.9f, 0}, .dx = {0.2f, 0, 0}, .dy = {0, 0.01f, 0}});
  const Rgba32F constant = sample_texture(*texture, {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none}, {});
  expect(texel == constant && std::abs(texel.r - 200 / 255.0f) < 1e-7f, "a constant texture is its constant under every filter");
  const CubePoint corner = cube_point({1, 1, 1});
  expect(corner.face == 4 && corner.s == 1 && corner.t == 0, "cube faces: z before y before x");
  expect(cube_direction(corner) == glm::vec3(1, 1, 1), "and back");

  const std::array<Rgba8, 2> ends{{{0, 0, 0, 255}, {255, 255, 255, 255}}};
  const Texture row = *Texture::create_1d(ends, TextureEncoding::linear);
  expect(std::abs(sample_texture(row, {.mipmaps = MipmapFilter::none}, {.at = {0.5f, 0, 0}}).r - 0.5f) < 1e-6f, "rows of texels");
  const std::vector<Image<Rgba8>> slices{Image<Rgba8>(1, 1, {0, 0, 0, 255}), Image<Rgba8>(1, 1, {255, 255, 255, 255})};
  const Texture box = *Texture::create_3d(slices, TextureEncoding::linear);
  expect(std::abs(sample_texture(box, {.mipmaps = MipmapFilter::none}, {.at = {0, 0, 0.5f}}).r - 0.5f) < 1e-6f, "boxes of texels");
}

void render_to_texture(Pipeline& pipeline) {
  RenderTarget target = *RenderTarget::create(16, 16);
  pipeline.clear(target, {0, 1, 0, 1});
  Texture cube = *Texture::create_empty({.kind = TextureKind::cube, .width = 16, .height = 16});
  expect(copy_to_texture(target, cube, 0, 3).operator bool(), "render to the face of a cube");
  cube.generate_mipmaps();
  expect(sample_texture(cube, {}, {.at = {0, -1, 0}, .lod = 2.0f}).g == 1, "and its mipmaps follow");
  Texture depths = *Texture::create_empty({.format = TextureFormat::depth32f, .width = 16, .height = 16, .with_mipmaps = false});
  pipeline.clear(target, {0, 1, 0, 1}, 0.5f);
  expect(copy_depth_to_texture(target, depths).operator bool(), "depths become a texture");
  const Sampler shadow{.mipmaps = MipmapFilter::none, .compare = Compare::less};
  expect(sample_texture(depths, shadow, {.at = {0.5f, 0.5f, 0}, .reference = 0.4f}).r == 1 &&
         sample_texture(depths, shadow, {.at = {0.5f, 0.5f, 0}, .reference = 0.6f}).r == 0, "and are compared with");

  TextureUnit unit{.texture = std::make_shared<const Texture>(cube), .sampler = {}, .colour = replace_environment().colour, .alpha = replace_environment().alpha};
  const std::vector<glm::vec4> down(3, glm::vec4{0, -1, 0, 1});
  DrawCall draw{.mesh = {.clip_positions = kClipTriangle, .unit_texcoords = {down}}, .program = fixed_function({.units = {unit}}), .state = {}};
  RenderTarget screen = *RenderTarget::create(8, 8);
  expect(pipeline.draw(screen, draw).operator bool() && screen.colour_image().at(0, 7) == Rgba8{0, 255, 0, 255}, "texture units");
}

/// Stages 1 to 9 by hand give the bits of the pipeline.
void stages_alone(Pipeline& pipeline) {
  RenderTarget by_pipeline = *RenderTarget::create(8, 8), by_hand = *RenderTarget::create(8, 8);
  const DrawCall draw{.mesh = {.clip_positions = kClipTriangle, .colours = kRed}, .program = gouraud(), .state = {}};
  expect(pipeline.draw(by_pipeline, draw).operator bool(), "a draw");

  const auto [isa, precision] = std::pair{best_instruction_set(), Precision::exact};
  const AcceptedDraw accepted = *validate(draw, by_hand, pipeline.workers());
  const ClipLimits limits = clip_limits(accepted.viewport, draw.state.clipping);
  Chunk chunk;
  chunk.range = {0, 1};
  chunk.fetch(draw.mesh, draw.state.assembly.topology, chunk.range, chunk.vertices, chunk.slots);
  const VertexTransform transform(draw.state.transform, limits, isa);
  transform.positions(draw.mesh, chunk.vertices);
  PrimitiveAssembly{draw.state.assembly}(chunk.slots, chunk.range, chunk.triangles);
  Clipping{limits}(chunk.vertices, chunk.triangles);
  PerspectiveDivide(screen_map(accepted.viewport, draw.state.viewport.depth_range, draw.state.clipping.volume), isa)(chunk.vertices);
  Culling(draw.state.culling, accepted.clip, isa)(chunk.vertices, chunk.triangles);
  transform.attributes(draw.mesh, draw.program.interface().attributes(), chunk.triangles, chunk.vertices);
  const Rasterization rasterization(accepted.clip, isa, precision);
  rasterization.set_up(chunk.triangles, chunk.vertices, chunk.screen_triangles);
  const FragmentShading shading(draw.program, false, isa, precision);
  const DepthTest depth_test(accepted.output, isa, precision);
  const Blending blending(accepted.output, isa, precision);
  for (const ScreenTriangle& triangle : chunk.screen_triangles)
    for (FragmentBlock& block : rasterization.blocks(triangle, by_hand)) {
      shading(chunk.view(), block);
      depth_test(block, by_hand);
      blending(block, by_hand);
    }
  expect(by_hand.colour_image() == by_pipeline.colour_image(), "each stage alone, one after the other");
}

void observers(Pipeline& pipeline) {
  RenderTarget target = *RenderTarget::create(8, 8);
  struct Counter : Observer {
    int triangles = 0, blocks = 0;
    void after(Stage stage, const Chunk& chunk) override {
      if (stage == Stage::clipping) triangles += chunk.triangles.count;
    }
    void after(Stage stage, const Chunk&, const FragmentBlock&, const Tile&) override { blocks += stage == Stage::rasterization; }
  } counter;
  PixelRecorder pixel(target, 1, 5);
  PrimitiveRecorder primitive(0);
  Observers recorder({&counter, &pixel, &primitive});
  const DrawCall draw{.mesh = {.clip_positions = kClipTriangle, .colours = kRed}, .program = gouraud(), .state = {}};
  expect(pipeline.draw(target, draw, recorder).operator bool() && counter.triangles == 1 && counter.blocks == 1, "an observer");
  expect(pixel.history().fragments.size() == 1 && pixel.history().fragments[0].reached_the_target(), "the history of a pixel");
  expect(primitive.life().found && primitive.life().fates.covered == 28 && primitive.life().fates.reached == 28, "the life of a primitive");
  expect(count_red(target.colour_image()) == 28, "a watched draw leaves the same pixels");
}

void shapes_and_cameras(Pipeline& pipeline) {
  RenderTarget target = *RenderTarget::create(32, 32);
  const Mesh ball = *with_tangents(*with_vertex_normals(*sphere_mesh({.slices = 24, .stacks = 12}), {.crease_angle_radians = 1}));
  const Camera camera = *orbit({.eye = {0, 0, 5}, .view = *perspective_volume(0.8, 1, 1, 10)}, {.right = 1, .up = 0.5});
  DrawCall draw{.mesh = mesh_view(ball), .program = flat(), .state = {}};
  draw.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
  draw.state.culling.cull = CullFace::back;
  pipeline.clear(target, {0, 0, 0, 1});
  const bool drawn = pipeline.draw(target, draw).ok();
  const Image<Rgba8> image = target.colour_image();
  int white = 0;
  for (const Rgba8& pixel : image.pixels()) white += pixel == Rgba8{255, 255, 255, 255};
  // Its outline is a circle of the sine 1/5, so of the radius 16 tan(asin(1/5)) / tan(0.4) = 7.7 pixels.
  expect(drawn && white > 165 && white < 195, "a sphere, seen from wherever");
}

}  // namespace

int main() {
  Pipeline pipeline({.threads = 2});
  clip_space_primitives(pipeline);
  snapped_triangles(pipeline);
  samples_and_stencil(pipeline);
  clipper_alone();
  textures();
  render_to_texture(pipeline);
  shapes_and_cameras(pipeline);
  stages_alone(pipeline);
  observers(pipeline);
  return failures == 0 ? 0 : 1;
}
