#pragma once
// What the stages do to primitives and fragments, in words.

#include "pipeline/fragment_record.hpp"
#include "pipeline/primitive_recorder.hpp"

namespace tuberia::cli {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

/// What printing takes.
constexpr double number(float x) noexcept { return static_cast<double>(x); }

/// "near, behind"; "nothing" for 0.
std::string planes_of(std::uint32_t outcode);
/// The borders of the view that a clip position is beyond, the guard band notwithstanding: "left, near".
std::string view_borders_of(const ClipPosition& clip, const ClipLimits& limits);

const char* words_of(PrimitiveLife::Clip clip) noexcept;
const char* words_of(PrimitivePiece::Verdict verdict) noexcept;
const char* sign_of(Compare test) noexcept;  // "<", "always"
const char* name_of(ColourFormat format) noexcept;
const char* name_of(DepthFormat format) noexcept;

struct NamedAttribute {
  const char* name;      // with its space
  int offset, scalars;
};
std::vector<NamedAttribute> named_attributes(Attributes attributes);

/// "(0.250 0.500 1.000 1.000) linear, codes 64 128 255 255".
std::string colour_text(const SampleContents& contents);
std::string colour_text(const Rgba32F& colour);

/// Why a sample went no further, with the numbers; or that it reached the target.
std::string fate_of(const FragmentRecord& fragment, const SampleRecord& sample, const RecordedDraw& draw);

/// Edge k of a drawn triangle, opposite its corner k, from corner k+1 to k+2.
struct EdgeWords {
  std::int64_t per_x = 0, per_y = 0;  // square units per unit
  bool top_left = false;
  const char* kind = "";              // "left", "top", "right", "bottom"
};
EdgeWords edge_of(const PrimitiveLife& life, const PrimitivePiece& piece, std::size_t k);

}  // namespace tuberia::cli
