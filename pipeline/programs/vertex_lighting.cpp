#include "pipeline/vertex_lighting.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/vertex_lighting.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "pipeline/programs/lighting-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

inline void light_vertices(const Lighting& lighting, const float* points, const float* normals, int pitch, float* colours) {
  using F = Float<Precision::exact>;
  const auto triple = [&](const float* arrays, int i) HWY_ATTR {
    return Vec3<F>{load<F>(arrays + i), load<F>(arrays + pitch + i), load<F>(arrays + 2 * pitch + i)};
  };
  for (int i = 0; i < pitch; i += kLanes) {
    const Vec3<F> point = triple(points, i);
    const Vec3<F> eye = normalize(Vec3<F>(lighting.eye) - point);
    const Vec3<F> colour = illuminate(lighting, point, triple(normals, i), eye, Vec3<F>(lighting.diffuse));
    // As OpenGL does, colours are clamped at the vertices, before they are interpolated.
    store(saturate(colour.x), colours + i);
    store(saturate(colour.y), colours + pitch + i);
    store(saturate(colour.z), colours + 2 * pitch + i);
    store(F(lighting.alpha), colours + 3 * pitch + i);
  }
}

/// Makes the cosines smaller, so that at the vertices light and highlight are as if the intensity were:
/// the share s times c^n is (s^(1/n) c)^n.
template <class F>
HWY_INLINE void attenuate(const Lighting& lighting, F share, F& of_light, F& of_highlight) {
  of_light = of_light * share;
  if (lighting.shininess > 0) of_highlight = of_highlight * pow(share, F(1.0f / lighting.shininess));
}

inline void find_cosines(const Lighting& lighting, const float* points, const float* normals, int pitch, float* cosines) {
  using F = Float<Precision::exact>;
  const auto triple = [&](const float* arrays, int i) HWY_ATTR {
    return Vec3<F>{load<F>(arrays + i), load<F>(arrays + pitch + i), load<F>(arrays + 2 * pitch + i)};
  };
  for (int i = 0; i < pitch; i += kLanes) {
    const Vec3<F> point = triple(points, i);
    const Vec3<F> eye = normalize(Vec3<F>(lighting.eye) - point), normal = facing_normal(lighting, triple(normals, i), eye);
    for (int k = 0; k < 2; ++k) {
      const Light& light = lighting.lights[static_cast<std::size_t>(k)];
      const Vec3<F> l = towards_light(light, point);
      const bool is_on = k < lighting.light_count;
      F of_light = is_on ? dot(normal, l) : F(0.0f), of_highlight = is_on ? highlight_cosine(lighting.halfway, normal, l, eye) : F(0.0f);
      if (is_on && is_attenuated(light)) attenuate(lighting, attenuation(light, l, point), of_light, of_highlight);
      store(of_light, cosines + 2 * k * pitch + i);
      store(of_highlight, cosines + (2 * k + 1) * pitch + i);
    }
  }
}

inline VertexLightingKernel vertex_cosines() { return &find_cosines; }
inline VertexLightingKernel light_vertices_kernel() { return &light_vertices; }

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tuberia {

VertexLightingKernel vertex_lighting_kernel(InstructionSet instruction_set) noexcept {
  TUBERIA_RETURN_FOR(instruction_set, light_vertices_kernel())
}

VertexLightingKernel vertex_cosines_kernel(InstructionSet instruction_set) noexcept {
  TUBERIA_RETURN_FOR(instruction_set, vertex_cosines())
}

}  // namespace tuberia
#endif
