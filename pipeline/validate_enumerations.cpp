#include "pipeline/validate_enumerations.hpp"

#include <initializer_list>

namespace tuberia {
namespace {

struct Value {
  const char* field;
  int number, largest;
};

template <class Enumeration>
Value value(const char* field, Enumeration number, Enumeration largest) {
  return {field, static_cast<int>(number), static_cast<int>(largest)};
}

Refusal check(std::initializer_list<Value> values) {
  for (const auto& [field, number, largest] : values)
    if (number < 0 || number > largest)
      return Error{std::string(field) + " is " + std::to_string(number) + "; its enumeration ends with " + std::to_string(largest)};
  return {};
}

Refusal check_geometry_stages(const PipelineState& s) {
  return check({value("assembly.topology", s.assembly.topology, Topology::points),
                value("clipping.volume", s.clipping.volume, ClipVolume::zero_to_w),
                value("culling.front_face", s.culling.front_face, Winding::clockwise),
                value("culling.cull", s.culling.cull, CullFace::front),
                value("rasterization.front_mode", s.rasterization.front_mode, PolygonMode::point),
                value("rasterization.back_mode", s.rasterization.back_mode, PolygonMode::point),
                value("rasterization.perspective", s.rasterization.perspective, PerspectiveCorrection::none),
                value("rasterization.edge_arithmetic", s.rasterization.edge_arithmetic, EdgeArithmetic::float_plane)});
}

Refusal check_stencil_face(const StencilFace& face) {
  constexpr StencilOperation kLast = StencilOperation::decrement_wrap;
  return check({value("stencil's test", face.test, Compare::always), value("stencil's fail", face.fail, kLast),
                value("stencil's depth_fail", face.depth_fail, kLast), value("stencil's pass", face.pass, kLast)});
}

Refusal check_blend_function(const BlendFunction& function) {
  constexpr BlendFactor kLast = BlendFactor::source_alpha_saturate;
  return check({value("blend's source", function.source, kLast), value("blend's destination", function.destination, kLast),
                value("blend's equation", function.equation, BlendEquation::max)});
}

Refusal check_fragment_stages(const PipelineState& s) {
  if (auto refusal = check({value("fog.mode", s.fog.mode, FogMode::exp2), value("alpha_test.test", s.alpha_test.test, Compare::always),
                            value("depth.test", s.depth.test, Compare::always), value("blend.mode", s.blend.mode, BlendMode::function),
                            value("blend.logic", s.blend.logic, LogicOperation::set)}))
    return refusal;
  for (const StencilFace& face : {s.stencil.front, s.stencil.back})
    if (auto refusal = check_stencil_face(face)) return refusal;
  for (const BlendFunction& function : {s.blend.colour, s.blend.alpha})
    if (auto refusal = check_blend_function(function)) return refusal;
  return {};
}

}  // namespace

Refusal check_enumerations(const PipelineState& state) {
  if (auto refusal = check_geometry_stages(state)) return refusal;
  if (auto refusal = check_fragment_stages(state)) return refusal;
  for (const TexCoordUnit& unit : state.transform.texture_units)
    for (const TexCoordSource source : unit.source)
      if (auto refusal = check({value("a texture unit's source", source, TexCoordSource::normal_map)})) return refusal;
  return {};
}

}  // namespace tuberia
