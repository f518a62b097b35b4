#pragma once
// What script/bench trade measured of the adviser's switches, one at a time, and what follows for several.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "scene/adviser/quality.hpp"

namespace tuberia {

/// Against the reference setting: how long a picture takes, and how far it is from the reference's.
struct Effect {
  double time_ratio = 1;
  double rmse = 0;  // of r, g and b as the screen shows them, 0..1
};

/// The surfaces that the effects were measured on.
enum class SurfaceKind { textured, textured_lit, lit };
std::string_view name_of(SurfaceKind) noexcept;
SurfaceKind kind_of(const SurfaceTraits& traits) noexcept;
SurfaceTraits traits_of(SurfaceKind kind) noexcept;

class MeasuredTrade {
 public:
  /// Reads lines "KIND; SWITCH; SETTING; TIME RATIO; RMSE in codes of 255"; those that begin with # say where
  /// and when. Error, with the line's number, for anything else, and for a setting that is missing
  /// of a switch that matters to the kind.
  static Result<MeasuredTrade> parse(std::string_view text);

  /// The table that this build carries.
  static const MeasuredTrade& built_in();

  const Effect& effect(SurfaceKind kind, std::size_t switch_number, int setting) const noexcept {
    return effects_[static_cast<std::size_t>(kind)][switch_number][static_cast<std::size_t>(setting)];
  }

  /// As if the switches knew nothing of one another: times multiply, and squares of errors add up.
  Effect predict(SurfaceKind kind, const Quality& quality) const noexcept;

  /// The lines that begin with #, without it.
  const std::string& circumstances() const noexcept { return circumstances_; }

 private:
  Result<Nothing> check_whole(SurfaceKind kind) const;

  std::array<std::array<std::vector<Effect>, kQualitySwitches>, 3> effects_;
  std::string circumstances_;
};

}  // namespace tuberia
