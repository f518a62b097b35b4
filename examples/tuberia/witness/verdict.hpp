#pragma once
// What may make the pipeline's pixel another than the tracer's, and what was found at one pixel.

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace tuberia::witness {

/// Each is a hypothesis that is tested at the pixel itself, see kCauses.
enum class Cause : std::uint8_t { edge, depth, shadow_map, mipmap, vertex_shading, environment_map, mirror_of_surroundings, transmission };
inline constexpr int kCauseCount = 8;

/// How the causes are shown together.
enum class PixelClass : std::uint8_t { same, edge, depth, shadow_map, mipmap, technique, several, unexplained };
inline constexpr int kPixelClassCount = 8;

/// A set of causes.
class Causes {
 public:
  constexpr Causes() = default;
  constexpr explicit Causes(unsigned bits) : bits_(static_cast<std::uint8_t>(bits)) {}
  constexpr Causes(Cause cause) : bits_(static_cast<std::uint8_t>(1u << static_cast<unsigned>(cause))) {}

  constexpr bool has(Cause cause) const { return (bits_ >> static_cast<unsigned>(cause) & 1u) != 0; }
  constexpr bool is_within(Causes others) const { return (bits_ & ~others.bits_) == 0; }
  constexpr int count() const { return std::popcount(bits_); }
  constexpr unsigned bits() const { return bits_; }
  friend constexpr Causes operator|(Causes a, Causes b) { return Causes(static_cast<unsigned>(a.bits_ | b.bits_)); }
  constexpr bool operator==(const Causes&) const = default;

 private:
  std::uint8_t bits_ = 0;
};

inline constexpr Causes kAllCauses{(1u << kCauseCount) - 1};

struct PixelVerdict {
  bool differs = false;    // some channel by more than one code, or the objects are not the same
  bool explained = true;   // if it differs: the causes below, tested, give what the pipeline drew
  Causes causes{};

  bool operator==(const PixelVerdict&) const = default;
};

constexpr PixelClass class_of(const PixelVerdict& verdict) {
  if (!verdict.differs) return PixelClass::same;
  if (!verdict.explained) return PixelClass::unexplained;
  if (verdict.causes.is_within(Causes(Cause::vertex_shading) | Cause::environment_map | Cause::mirror_of_surroundings | Cause::transmission)) return PixelClass::technique;
  if (verdict.causes.count() != 1) return PixelClass::several;
  if (verdict.causes.has(Cause::edge)) return PixelClass::edge;
  if (verdict.causes.has(Cause::depth)) return PixelClass::depth;
  if (verdict.causes.has(Cause::shadow_map)) return PixelClass::shadow_map;
  return PixelClass::mipmap;
}

/// A cause, in words for who has not built this.
struct CauseWords {
  Cause cause;
  std::string_view name, meaning, test;
};
extern const std::array<CauseWords, kCauseCount> kCauseWords;

struct ClassWords {
  PixelClass pixel_class;
  std::string_view name, meaning;
  std::array<std::uint8_t, 3> colour;  // on the map, sRGB codes
};
extern const std::array<ClassWords, kPixelClassCount> kClassWords;

/// "edge + shadow map"
std::string name_of(Causes causes);

}  // namespace tuberia::witness
