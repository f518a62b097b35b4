// Lesson 2: a fragment program of your own, outside the library. It is compiled once for every
// instruction set, runs on a register of fragments at a time, and is fused with the depth test and
// blending as the library's own programs are.

#include <filesystem>
#include <glm/gtc/constants.hpp>

#include "image/write_image.hpp"
#include "math/transforms.hpp"
#include "pipeline/pipeline.hpp"

#ifndef RIPPLES_UNIFORMS  // exists once, although the file is compiled several times
#define RIPPLES_UNIFORMS
struct RipplesUniforms {
  glm::vec3 dark{0.02f, 0.07f, 0.2f}, light{0.9f, 0.95f, 1.0f};
  float rings = 9;
};
#endif

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "examples/02_your_own_program.cpp"
#include "pipeline/program.hpp"

TUBERIA_PROGRAM_BEGIN
struct Ripples : ProgramBase {
  using Uniforms = RipplesUniforms;
  static constexpr Attributes interpolated = Attributes::texcoord;  // all that is interpolated

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms& u) {
    using F = typename Fragment::Number;
    const Vec2<F> from_centre = in.texcoord() - Vec2<F>{F(0.5f), F(0.5f)};
    const F ring = sqrt(dot(from_centre, from_centre)) * (2.0f * u.rings);
    const F wave = abs(ring - floor(ring) - 0.5f) * 2.0f;
    return Vec4<F>(mix(Vec3<F>(u.dark), Vec3<F>(u.light), smoothstep(0.2f, 0.8f, wave)), F(1.0f));
  }
};
TUBERIA_PROGRAM_END(ripples, Ripples)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(ripples, Ripples)

int main() {
  using namespace tuberia;
  const std::vector<glm::vec3> corners{{-3, 0, -8}, {3, 0, -8}, {3, 0, 4}, {-3, 0, 4}};
  const std::vector<glm::vec2> texcoords{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  DrawCall draw{.mesh = {.positions = corners, .normals = {}, .texcoords = texcoords, .colours = {}, .custom = {}, .indices = {}},
                .program = {ripples_interface(), RipplesUniforms{}}, .state = {}};
  draw.state.assembly.topology = Topology::triangle_fan;
  const glm::dvec3 eye(0, 2, 4);
  draw.state.transform.clip_from_world = *perspective(glm::pi<double>() / 3, 4.0 / 3, 0.1, 100, ClipVolume::minus_w_to_w) *
                                         view_from_world(*camera_basis(eye, {0, 0, -1}, {0, 1, 0}), eye);
  RenderTarget target = *RenderTarget::create(640, 480, ColourFormat::srgb8);
  const auto drawn = Pipeline().draw(target, draw);
  std::filesystem::create_directories("out");
  return drawn && write_image("out/ripples.png", target.colour_image()) ? 0 : 1;
}
#endif
