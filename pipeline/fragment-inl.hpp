// What a fragment program sees: a register of fragments, with the attributes it declared.

#if defined(TUBERIA_PIPELINE_FRAGMENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_FRAGMENT_INL
#undef TUBERIA_PIPELINE_FRAGMENT_INL
#else
#define TUBERIA_PIPELINE_FRAGMENT_INL
#endif

#include <algorithm>

#include "raster/attributes.hpp"
#include "raster/simd/interpolation-inl.hpp"
#include "raster/simd/quad-inl.hpp"
#include "raster/simd/texture-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A triangle's attributes: the values at vertex 0 and what vertices 1 and 2 have more.
template <class Program>
struct TriangleAttributes {
  static constexpr Attributes kAll = Program::interpolated | Program::flat;
  static constexpr int kCount = scalar_count(kAll);
  static constexpr int kPadded = std::max(vertex_stride(kAll), 4);
  float value[kPadded], delta1[kPadded], delta2[kPadded];

  HWY_INLINE void load(const ScreenTriangle& t, const ChunkView& chunk, bool flat_shading) {
    const auto vertex = [&](int slot) HWY_ATTR { return chunk.attributes + slot * chunk.stride; };
    const float* first = vertex(flat_shading ? t.provoking_vertex : t.vertex[0]);
    const float* second = vertex(flat_shading ? t.provoking_vertex : t.vertex[1]);
    const float* third = vertex(flat_shading ? t.provoking_vertex : t.vertex[2]);
    // Records are whole groups of four floats.
    const hn::CappedTag<float, 4> four;
    for (int i = 0; i < kCount; i += 4) {
      const auto base = hn::LoadU(four, first + i);
      hn::StoreU(base, four, value + i);
      hn::StoreU(hn::Sub(hn::LoadU(four, second + i), base), four, delta1 + i);
      hn::StoreU(hn::Sub(hn::LoadU(four, third + i), base), four, delta2 + i);
    }
    if constexpr (Program::flat != Attributes::none) load_flat(vertex(t.provoking_vertex));
  }

 private:
  HWY_INLINE void load_flat(const float* provoking) {
    for (std::uint32_t bit = 1; bit <= static_cast<std::uint32_t>(kLastAttribute); bit <<= 1) {
      const auto one = static_cast<Attributes>(bit);
      if (!contains(Program::flat, one)) continue;
      for (int i = 0; i < scalar_count(one); ++i) {
        const int at = scalar_offset(kAll, one) + i;
        value[at] = provoking[at];
        delta1[at] = delta2[at] = 0;
      }
    }
  }
};

/// What reads textures for a register of fragments, some of which are live.
template <class F>
class TextureReader {
 public:
  using Number = F;

  HWY_INLINE TextureReader(Mask live, LevelGuess& guess) : live_(live), guess_(guess) {}

  /// The texture's colour at uv, filtered by the derivatives of uv over each quad of fragments.
  HWY_INLINE Vec4<F> sample(const Texture& texture, const Sampler& sampler, Vec2<F> uv) const {
    return HWY_NAMESPACE::sample(texture, sampler, uv, live_, guess_);
  }
  /// The same of a one-dimensional texture.
  HWY_INLINE Vec4<F> sample(const Texture& texture, const Sampler& sampler, F s) const {
    return HWY_NAMESPACE::sample(texture, sampler, Vec3<F>(s, F(0.0f), F(0.0f)), F(0.0f), live_);
  }
  /// The same at (s, t, r) of a box, or in the direction (x, y, z) of a cube map. Depth textures of one or
  /// two dimensions compare their texels with r.
  HWY_INLINE Vec4<F> sample(const Texture& texture, const Sampler& sampler, Vec3<F> at) const {
    return HWY_NAMESPACE::sample(texture, sampler, at, at.z, live_);
  }
  /// The same, where a depth texture's texels are compared with a reference.
  HWY_INLINE Vec4<F> sample(const Texture& texture, const Sampler& sampler, Vec3<F> at, F reference) const {
    return HWY_NAMESPACE::sample(texture, sampler, at, reference, live_);
  }

  HWY_INLINE Mask live() const { return live_; }

 protected:
  Mask live_;
  LevelGuess& guess_;
};

/// The argument of a program's shade(). Attributes are computed where they are asked for.
template <class Program, class F>
class Fragment : public TextureReader<F> {
 public:
  using Attribs = TriangleAttributes<Program>;

  HWY_INLINE Fragment(const Attribs& attributes, Mask live, LevelGuess& guess) : TextureReader<F>(live, guess), attributes_(attributes) {}
  HWY_INLINE void set_weights(F weight1, F weight2) {
    weight_[0] = weight1;
    weight_[1] = weight2;
  }

  HWY_INLINE Vec3<F> position() const { return triple<Attributes::position>(); }  // world space
  HWY_INLINE Vec3<F> normal() const { return triple<Attributes::normal>(); }      // not unit
  HWY_INLINE Vec3<F> tangent() const { return triple<Attributes::tangent>(); }      // dp/du, world space, not unit
  HWY_INLINE Vec3<F> bitangent() const { return triple<Attributes::bitangent>(); }  // dp/dv
  HWY_INLINE Vec2<F> texcoord() const {
    constexpr int at = offset<Attributes::texcoord>();
    return {scalar(at), scalar(at + 1)};
  }
  HWY_INLINE Vec4<F> colour() const { return quadruple<Attributes::colour>(); }
  HWY_INLINE Vec4<F> custom() const { return quadruple<Attributes::custom>(); }
  /// (s, t, r, q) of texture unit kUnit, not yet divided by q.
  template <int kUnit>
  HWY_INLINE Vec4<F> texture_unit() const {
    return quadruple<static_cast<Attributes>(static_cast<std::uint32_t>(Attributes::unit0) << kUnit)>();
  }

  /// Drops fragments: they change neither colour nor depth. Only for programs with may_discard.
  HWY_INLINE void discard(Mask dropped) {
    static_assert(Program::may_discard, "a program that discards says `static constexpr bool may_discard = true`");
    this->live_ = this->live_ & !dropped;
  }

 private:
  template <Attributes kOne>
  static constexpr int offset() {
    static_assert(contains(Attribs::kAll, kOne), "a program may only read the attributes that it declares");
    return scalar_offset(Attribs::kAll, kOne);
  }
  HWY_INLINE F scalar(int i) const {
    return mul_add(weight_[1], F(attributes_.delta2[i]), mul_add(weight_[0], F(attributes_.delta1[i]), F(attributes_.value[i])));
  }
  template <Attributes kOne>
  HWY_INLINE Vec3<F> triple() const {
    constexpr int at = offset<kOne>();
    return {scalar(at), scalar(at + 1), scalar(at + 2)};
  }
  template <Attributes kOne>
  HWY_INLINE Vec4<F> quadruple() const {
    constexpr int at = offset<kOne>();
    return {scalar(at), scalar(at + 1), scalar(at + 2), scalar(at + 3)};
  }

  const Attribs& attributes_;
  F weight_[2] = {F(0.0f), F(0.0f)};  // perspective-correct weights of vertices 1 and 2
};

/// What a program derives from: nothing is read and nothing discarded unless it says so.
struct ProgramBase {
  static constexpr Attributes interpolated = Attributes::none;
  static constexpr Attributes flat = Attributes::none;
  static constexpr bool may_discard = false;
  /// Whether there are kernels for each ingredient of the precision fast alone.
  static constexpr bool has_ingredients = false;
  /// Whether shade() returns the interpolated colour as it is and reads nothing else.
  static constexpr bool passes_colour_on = false;
  /// Why a draw with these uniforms must be refused; empty when it need not.
  template <class Uniforms>
  static Refusal refusal(const Uniforms&) { return {}; }
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
