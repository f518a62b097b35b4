// FragmentShading on blocks in memory, program by program. The floor is the program `flat`, which
// does little more than store its colour.

#include "bench/peers/meshes.hpp"
#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"
#include "pipeline/fragment_shading.hpp"

namespace tuberia::bench {
namespace {

constexpr std::size_t kBlocks = 128;  // less than the second cache

using MakeProgram = FragmentProgram (*)();

FragmentProgram shiny_phong() { return phong(Lighting{.specular = glm::vec3(0.5f), .eye = {0, 0, 3}}); }

FragmentProgram textured_with(TexelFilter texels, MipmapFilter mipmaps) {
  auto texture = std::make_shared<const Texture>(*Texture::create(noisy_checkerboard(512, 0), TextureEncoding::linear));
  return textured({.texture = std::move(texture), .sampler = {.texels = texels, .mipmaps = mipmaps}});
}

FragmentProgram bilinear() { return textured_with(TexelFilter::bilinear, MipmapFilter::nearest); }
FragmentProgram trilinear() { return textured_with(TexelFilter::bilinear, MipmapFilter::linear); }

void shade(benchmark::State& state, const GridShape& grid, MakeProgram make, InstructionSet isa, Precision precision) {
  StageChain chain({.grid = grid, .program = make()}, isa, precision);
  chain.run_through(Stage::bin);
  std::vector<FragmentBlock> blocks = chain.some_blocks(kBlocks);
  const FragmentShading shading(chain.draw.program, false, isa, precision);
  const ChunkView view = chain.chunk.view();
  for (auto _ : state)
    for (FragmentBlock& block : blocks) shading(view, block);
  set_rate(state, live_fragments(blocks));
}

void register_program(const char* what, MakeProgram make, const GridShape& grid, const char* size) {
  add_both_precisions("fragment_shading", what, size, [=](benchmark::State& state, InstructionSet isa, Precision precision) {
    shade(state, grid, make, isa, precision);
  });
}

}  // namespace

void register_fragment_shading() {
  constexpr struct {
    const char* what;
    MakeProgram make;
  } kPrograms[] = {{"flat_floor", flat}, {"gouraud", gouraud}, {"phong", shiny_phong},
                   {"textured_bilinear", bilinear}, {"textured_trilinear", trilinear}};
  for (const auto& [what, make] : kPrograms) {
    register_program(what, make, kSmallTriangles, kSmallName);
    register_program(what, make, kLargeTriangles, kLargeName);
  }
}

}  // namespace tuberia::bench
