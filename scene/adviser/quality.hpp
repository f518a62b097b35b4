#pragma once
// The switches of a model's picture that trade accuracy for speed, as the adviser turns them.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/pipeline.hpp"
#include "scene/draw_model.hpp"

namespace tuberia {

/// What of a picture the switches turn.
struct QualityState {
  ModelView view;
  Precision precision = Precision::exact;
};

struct QualitySetting {
  std::string_view name;
  void (*apply)(QualityState&);
};

/// The first setting is the reference; the errors of the others grow from one to the next.
struct QualitySwitch {
  std::string_view name;
  std::span<const QualitySetting> settings;
};

inline constexpr std::size_t kQualitySwitches = 4;
/// "filter", "lighting", "perspective", "precision".
const std::array<QualitySwitch, kQualitySwitches>& quality_switches() noexcept;

/// The number of the setting of every switch; all 0 is the reference.
struct Quality {
  std::array<int, kQualitySwitches> choice{};
  bool operator==(const Quality&) const = default;
  bool is_reference() const noexcept { return *this == Quality{}; }
  /// In no switch further from the reference.
  bool is_at_least(const Quality& other) const noexcept;
};

/// The state with the switches turned. Those that are at their reference set what is most accurate.
QualityState with_quality(QualityState state, const Quality& quality);

/// "trilinear, lit at vertices, fast": what differs from the reference; "reference" if nothing does.
std::string words_of(const Quality& quality);

/// What of a model decides which switches matter to it.
struct SurfaceTraits {
  bool textured = false, lit = false;  // whether any mesh is
  bool operator==(const SurfaceTraits&) const = default;
};
SurfaceTraits traits_of(const Model& model, Shading shading);

/// Why a switch cannot change such a model's picture; empty when it can.
std::string_view reason_not_to_turn(std::size_t switch_number, const SurfaceTraits& traits) noexcept;

/// All qualities that can make a difference; the reference first.
std::vector<Quality> qualities_for(const SurfaceTraits& traits);

}  // namespace tuberia
