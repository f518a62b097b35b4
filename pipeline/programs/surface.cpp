#include "pipeline/programs/surface.hpp"

#include "pipeline/programs/surface_refusal.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/surface.cpp"
#include "pipeline/program.hpp"

#include "pipeline/programs/bump-inl.hpp"
#include "pipeline/programs/environment-inl.hpp"
#include "pipeline/programs/lighting-inl.hpp"
#include "pipeline/programs/pattern-inl.hpp"
#include "pipeline/programs/reflection-inl.hpp"
#include "pipeline/programs/shadow-inl.hpp"
#include "pipeline/programs/texture_access-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A register of fragments whose attributes are interpolated already; those that its program does not
/// read are 0. One type for every set of attributes, so that the shading is compiled once for all.
template <class F>
class SurfaceFragment : public TextureReader<F> {
 public:
  template <class Fragment>
  HWY_INLINE explicit SurfaceFragment(const Fragment& in) : TextureReader<F>(in), position_(in.position()), normal_(in.normal()) {
    if constexpr (contains(Fragment::Attribs::kAll, Attributes::texcoord)) texcoord_ = in.texcoord();
    if constexpr (contains(Fragment::Attribs::kAll, Attributes::tangent)) tangent_ = in.tangent();
    if constexpr (contains(Fragment::Attribs::kAll, Attributes::bitangent)) bitangent_ = in.bitangent();
  }

  HWY_INLINE Vec3<F> position() const { return position_; }  // as Fragment's
  HWY_INLINE Vec3<F> normal() const { return normal_; }
  HWY_INLINE Vec2<F> texcoord() const { return texcoord_; }
  HWY_INLINE Vec3<F> tangent() const { return tangent_; }
  HWY_INLINE Vec3<F> bitangent() const { return bitangent_; }

 private:
  Vec3<F> position_, normal_;
  Vec2<F> texcoord_{F(0.0f), F(0.0f)};
  Vec3<F> tangent_{F(0.0f)}, bitangent_{F(0.0f)};
};

/// What the lights are reflected by: the point, its normal (on the eye's side; with relief, and smooth, as
/// what casts shadow is) and the direction to the eye, unit, and the colour that kd is multiplied with.
template <class F>
struct ShadedPoint {
  Vec3<F> position, normal, smooth_normal, to_eye, colour;
};

// Each technique is out of line, too: the registers and the stack that it needs are not taken from surfaces
// without it. Callers hand over copies, for what has an address in a function cannot stay in its registers.

/// The normal with relief, from the unit one without.
template <class F>
HWY_NOINLINE Vec3<F> relief_normal(SurfaceFragment<F>& in, const BumpMap& bump, const Vec3<F>& smooth) {
  return bumped_normal(in, bump, in.texcoord(), SurfaceBasis<F>{in.tangent(), in.bitangent(), smooth});
}

/// The pattern's or texture's colour and alpha.
template <class F>
HWY_NOINLINE Vec4<F> own_colour(SurfaceFragment<F>& in, const SurfaceColour& colour, const glm::vec3& eye) {
  const Vec2<F> uv = accessed_texcoord(colour.access, in.texcoord(), in.position());
  if (colour.texture) return accessed_colour(in, *colour.texture, colour.sampler, colour.access, uv, Vec3<F>(eye), in.position());
  return Vec4<F>(pattern_colour(colour.pattern, uv, in.position()), F(1.0f));
}

/// What the surroundings send to the mirror direction.
template <class F>
HWY_NOINLINE Vec3<F> mirrored_light(SurfaceFragment<F>& in, const EnvironmentMap& environment, const ShadedPoint<F>& at) {
  return environment_radiance(in, environment, reflect(-at.to_eye, at.normal));
}

/// One light's part of the sum: V Ip falloff (own kd (N.L) + ks share).
template <class F>
HWY_INLINE Vec3<F> light_of(const SurfaceFragment<F>& in, const SurfaceUniforms& surface, const SurfaceLight& source, const ShadedPoint<F>& at) {
  const Light& light = source.light;
  const Vec3<F> l = towards_light(light, at.position);
  const F cosine = dot(at.normal, l);
  const Mask is_lit = cosine > 0.0f;
  if (none(is_lit)) return Vec3<F>(F(0.0f));

  Vec3<F> reflected = at.colour * Vec3<F>(surface.reflection.diffuse) * cosine;
  if (surface.reflection.model != Reflection::lambert && surface.reflection.specular != glm::vec3(0))
    reflected = reflected + Vec3<F>(surface.reflection.specular) * specular_share(surface.reflection, at.normal, l, at.to_eye, cosine);
  if (is_attenuated(light)) reflected = reflected * attenuation(light, l, at.position);
  if (source.shadow) reflected = reflected * light_visibility(*source.shadow, Vec3<F>(at.position), Vec3<F>(at.smooth_normal), Vec3<F>(l));
  if (source.projected) reflected = reflected * projected_light(in, *source.projected, Vec3<F>(at.position));
  reflected = Vec3<F>(light.intensity) * reflected;
  const F none_at_all(0.0f);
  return {select(is_lit, reflected.x, none_at_all), select(is_lit, reflected.y, none_at_all), select(is_lit, reflected.z, none_at_all)};
}

/// Colours above 1 divided by their largest channel: hue and saturation stay.             [B 2.9]
template <class F>
HWY_INLINE Vec3<F> divided_by_largest(Vec3<F> colour) {
  const F largest = max(max(colour.x, colour.y), max(colour.z, 1.0f));
  return {colour.x / largest, colour.y / largest, colour.z / largest};
}

/// The whole program but for interpolation, out of line: inlined into every loop that the program is
/// compiled into, for each set of attributes, it would take twelve times as long to build.
template <class F>
HWY_NOINLINE Vec4<F> shade_surface(SurfaceFragment<F>& in, const SurfaceUniforms& surface) {
  const Vec3<F> position = in.position(), to_eye = normalize(Vec3<F>(surface.eye) - position);
  const Vec3<F> smooth = fragment_normal(surface.normals, in.normal());
  // Which side is seen remains the smooth normal's to say.
  const Vec3<F> bumped = surface.bump.kind == BumpMap::Kind::none ? smooth : relief_normal(in, surface.bump, Vec3<F>(smooth));
  const Vec3<F> normal = surface.two_sided ? turned_to(smooth, to_eye, bumped) : bumped;
  const Vec3<F> smooth_normal = surface.two_sided ? turned_to(smooth, to_eye, smooth) : smooth;

  const bool has_own_colour = surface.colour.texture || surface.colour.pattern.kind != Pattern::Kind::none;
  const Vec4<F> own = has_own_colour ? own_colour(in, surface.colour, surface.eye) : Vec4<F>(glm::vec4(1));
  const ShadedPoint<F> at{position, normal, smooth_normal, to_eye, own.rgb()};
  Vec3<F> sum = at.colour * Vec3<F>(surface.reflection.ambient * surface.ambient_light);
  for (const SurfaceLight& light : surface.lights) sum = sum + light_of(in, surface, light, at);
  if (surface.environment.kind != EnvironmentMap::Kind::none && surface.mirror != glm::vec3(0))
    sum = sum + Vec3<F>(surface.mirror) * mirrored_light(in, surface.environment, ShadedPoint<F>(at));
  if (surface.overflow == Overflow::hue_preserving) sum = divided_by_largest(sum);
  return Vec4<F>(sum, own.a() * F(surface.alpha));
}

/// A program of its own for each set of attributes, since a program says what it reads.
template <Attributes kRead>
struct SurfaceProgram : ProgramBase {
  using Uniforms = SurfaceUniforms;
  static constexpr Attributes interpolated = Attributes::position | Attributes::normal | kRead;
  static Refusal refusal(const SurfaceUniforms& uniforms) { return refusal_of(uniforms); }

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const SurfaceUniforms& uniforms) {
    SurfaceFragment<typename Fragment::Number> interpolated_here(in);
    return shade_surface(interpolated_here, uniforms);
  }
};
using PlainSurface = SurfaceProgram<Attributes::none>;
using TexturedSurface = SurfaceProgram<Attributes::texcoord>;
using BumpedSurface = SurfaceProgram<Attributes::texcoord | Attributes::tangent | Attributes::bitangent>;
inline const ProgramKernels& textured_surface_kernels(Precision precision) { return kernels_of<TexturedSurface>(precision); }
inline const ProgramKernels& bumped_surface_kernels(Precision precision) { return kernels_of<BumpedSurface>(precision); }
}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

TUBERIA_PROGRAM_BEGIN
TUBERIA_PROGRAM_END(surface, PlainSurface)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(surface, PlainSurface)
TUBERIA_DEFINE_PROGRAM(textured_surface, TexturedSurface)
TUBERIA_DEFINE_PROGRAM(bumped_surface, BumpedSurface)

namespace tuberia {

FragmentProgram surface(SurfaceUniforms uniforms) {
  const bool is_bumped = uniforms.bump.kind != BumpMap::Kind::none;
  const bool is_mapped = uniforms.colour.texture || is_of_texture_coordinates(uniforms.colour.pattern);
  const bool is_textured = is_mapped && uniforms.colour.access.coordinates == TextureAccess::Coordinates::vertices;
  const ProgramInterface& interface = is_bumped ? bumped_surface_interface() : is_textured ? textured_surface_interface() : surface_interface();
  return {interface, std::move(uniforms)};
}

}  // namespace tuberia
#endif
