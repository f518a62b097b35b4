#include "examples/tuberia/stage_words.hpp"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>

#include "math/edge_function.hpp"

namespace tuberia::cli {
namespace {

void join(std::string& list, const char* name) {
  if (!list.empty()) list += ", ";
  list += name;
}

std::string stencil_words(const FragmentRecord& fragment, const SampleRecord& sample, const OutputState& output) {
  const StencilFace& face = fragment.is_back ? output.stencil.back : output.stencil.front;
  return text("stencil reference %d & mask %d %s stored %d & mask is false", face.reference, face.read_mask, sign_of(face.test),
              sample.before.stencil.value_or(0));
}

std::string alpha_words(const FragmentRecord& fragment, const OutputState& output) {
  const double alpha = number(std::clamp(fragment.colour->a, 0.0f, 1.0f));
  if (passes(output.alpha_test.test, fragment.colour->a < output.alpha_test.reference ? -1 : fragment.colour->a > output.alpha_test.reference ? 1 : 0, 0))
    return text("alpha to coverage: alpha %.6f keeps other samples", alpha);
  return text("alpha %.6f %s reference %.6f is false", alpha, sign_of(output.alpha_test.test), number(output.alpha_test.reference));
}

}  // namespace

std::string text(const char* format, ...) {
  std::array<char, 512> buffer{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer.data(), buffer.size(), format, arguments);
  va_end(arguments);
  return buffer.data();
}

std::string planes_of(std::uint32_t code) {
  struct Plane {
    std::uint32_t bit;
    const char* name;
  };
  std::string list;
  for (const Plane& plane : {Plane{outcode::near, "near"}, {outcode::far, "far"}, {outcode::left, "guard band left"},
                             {outcode::right, "guard band right"}, {outcode::bottom, "guard band bottom"},
                             {outcode::top, "guard band top"}, {outcode::behind, "behind the eye (w <= 0)"}, {outcode::invalid, "not finite"}})
    if ((code & plane.bit) != 0) join(list, plane.name);
  for (int k = 0; k < ClippingState::kMaxUserPlanes; ++k)
    if ((code & outcode::user << k) != 0) join(list, text("user plane %d", k).c_str());
  return list.empty() ? "nothing" : list;
}

std::string view_borders_of(const ClipPosition& clip, const ClipLimits& limits) {
  std::string list;
  if (clip.x < -clip.w) join(list, "left");
  if (clip.x > clip.w) join(list, "right");
  if (clip.y < -clip.w) join(list, "bottom");
  if (clip.y > clip.w) join(list, "top");
  if (clip.z < limits.z_low * clip.w) join(list, "near");
  if (clip.z > clip.w) join(list, "far");
  return list.empty() ? "none" : list;
}

const char* words_of(PrimitiveLife::Clip clip) noexcept {
  switch (clip) {
    case PrimitiveLife::Clip::untouched: return "inside all planes: it stays as it is";
    case PrimitiveLife::Clip::cut: return "it crosses the planes above and is cut";
    case PrimitiveLife::Clip::outside: return "nothing of it is inside: it is dropped";
    case PrimitiveLife::Clip::not_finite: break;
  }
  return "a vertex is not finite: it is dropped";
}

const char* words_of(PrimitivePiece::Verdict verdict) noexcept {
  switch (verdict) {
    case PrimitivePiece::Verdict::drawn: return "drawn";
    case PrimitivePiece::Verdict::no_area: return "dropped: no area after snapping";
    case PrimitivePiece::Verdict::turned_away: return "culled: it faces the way that is left out";
    case PrimitivePiece::Verdict::drawn_as_others: return "drawn as its edges or corners, below";
    case PrimitivePiece::Verdict::no_pixel_centre: break;
  }
  return "dropped: its bounds hold no pixel centre that may be drawn";
}

const char* sign_of(Compare test) noexcept {
  constexpr std::array<const char*, 8> kSigns{"never", "<", "=", "<=", ">", "!=", ">=", "always"};
  return kSigns[static_cast<std::size_t>(test)];
}

const char* name_of(ColourFormat format) noexcept {
  constexpr std::array<const char*, 4> kNames{"rgba8", "srgb8", "rgba32f", "rgba16f"};
  return kNames[static_cast<std::size_t>(format)];
}

const char* name_of(DepthFormat format) noexcept {
  constexpr std::array<const char*, 3> kNames{"d16", "d24", "d32f"};
  return kNames[static_cast<std::size_t>(format)];
}

std::vector<NamedAttribute> named_attributes(Attributes attributes) {
  constexpr std::array<const char*, 9> kNames{"position (world)", "normal (world)", "texcoord (texture)", "colour (linear)", "custom",
                                              "unit 0 (s t r q)", "unit 1 (s t r q)", "unit 2 (s t r q)", "unit 3 (s t r q)"};
  std::vector<NamedAttribute> named;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const auto one = static_cast<Attributes>(1u << i);
    if (contains(attributes, one)) named.push_back({kNames[i], scalar_offset(attributes, one), scalar_count(one)});
  }
  return named;
}

std::string colour_text(const Rgba32F& c) { return text("(%.4f %.4f %.4f %.4f) linear", number(c.r), number(c.g), number(c.b), number(c.a)); }

std::string colour_text(const SampleContents& contents) {
  std::string words = colour_text(contents.colour);
  if (contents.codes) words += text(", codes %d %d %d %d", contents.codes->r, contents.codes->g, contents.codes->b, contents.codes->a);
  return words;
}

std::string fate_of(const FragmentRecord& fragment, const SampleRecord& sample, const RecordedDraw& draw) {
  if (!sample.died_at) return draw.output.blend.write ? "it reached the target" : "it passed; the draw writes no colours";
  const std::string died = "died at " + std::string(name_of(*sample.died_at)) + ": ";
  if (*sample.died_at == Stage::fragment_shading)
    return died + "the program '" + draw.program + text("' discarded it (alpha %.6f)", fragment.colour ? number(fragment.colour->a) : 0.0);
  if (*sample.died_at == Stage::alpha_test) return died + alpha_words(fragment, draw.output);
  if (sample.stencil_failed) return died + stencil_words(fragment, sample, draw.output);
  return died + text("code %d %s stored %d is false", sample.depth_code.value_or(0), sign_of(draw.output.depth.test), sample.before.depth);
}

EdgeWords edge_of(const PrimitiveLife& life, const PrimitivePiece& piece, std::size_t k) {
  const auto place = [&](std::size_t i) {
    const PrimitiveCorner& corner = life.corners[piece.clockwise[i % 3]];
    return SnappedPoint{corner.x_units, corner.y_units};
  };
  const EdgeFunction edge(place(k + 1), place(k + 2));
  const char* kind = edge.per_x > 0 ? "left" : edge.per_x < 0 ? "right" : edge.per_y > 0 ? "top" : "bottom";
  return {edge.per_x, edge.per_y, edge.is_top_left(), kind};
}

}  // namespace tuberia::cli
