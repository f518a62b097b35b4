#include "scene/adviser/quality.hpp"

#include <algorithm>

namespace tuberia {
namespace {

template <TexelFilter texels, MipmapFilter mipmaps, int anisotropy>
void set_filter(QualityState& state) {
  state.view.sampler.texels = texels;
  state.view.sampler.mipmaps = mipmaps;
  state.view.sampler.max_anisotropy = anisotropy;
}

constexpr auto kNearest = TexelFilter::nearest, kBilinear = TexelFilter::bilinear;
constexpr QualitySetting kFilters[] = {
    {"anisotropic 16", set_filter<kBilinear, MipmapFilter::linear, 16>},
    {"anisotropic 4", set_filter<kBilinear, MipmapFilter::linear, 4>},
    {"anisotropic 2", set_filter<kBilinear, MipmapFilter::linear, 2>},
    {"trilinear", set_filter<kBilinear, MipmapFilter::linear, 1>},
    {"bilinear, nearest level", set_filter<kBilinear, MipmapFilter::nearest, 1>},
    {"nearest, nearest level", set_filter<kNearest, MipmapFilter::nearest, 1>},
    {"nearest, no levels", set_filter<kNearest, MipmapFilter::none, 1>}};

constexpr QualitySetting kLighting[] = {{"at fragments", [](QualityState& state) { state.view.lit_at_vertices = false; }},
                                        {"at vertices", [](QualityState& state) { state.view.lit_at_vertices = true; }}};

// Segments are not among them: they take longer than a division at each pixel (docs/trade.md).
template <PerspectiveCorrection correction>
void set_perspective(QualityState& state) { state.view.rasterization.perspective = correction; }
constexpr QualitySetting kPerspective[] = {{"each pixel", set_perspective<PerspectiveCorrection::each_pixel>},
                                           {"none", set_perspective<PerspectiveCorrection::none>}};

constexpr QualitySetting kPrecision[] = {{"exact", [](QualityState& state) { state.precision = Precision::exact; }},
                                         {"fast", [](QualityState& state) { state.precision = Precision::fast; }}};

constexpr std::array<QualitySwitch, kQualitySwitches> kSwitches{{
    {"filter", kFilters}, {"lighting", kLighting}, {"perspective", kPerspective}, {"precision", kPrecision}}};
constexpr std::size_t kFilter = 0, kLight = 1;

}  // namespace

const std::array<QualitySwitch, kQualitySwitches>& quality_switches() noexcept { return kSwitches; }

bool Quality::is_at_least(const Quality& other) const noexcept {
  return std::equal(choice.begin(), choice.end(), other.choice.begin(), std::less_equal<>{});
}

QualityState with_quality(QualityState state, const Quality& quality) {
  for (std::size_t i = 0; i < kSwitches.size(); ++i) kSwitches[i].settings[static_cast<std::size_t>(quality.choice[i])].apply(state);
  return state;
}

std::string words_of(const Quality& quality) {
  std::string words;
  for (std::size_t i = 0; i < kSwitches.size(); ++i) {
    if (quality.choice[i] == 0) continue;
    if (!words.empty()) words += "; ";
    words += std::string(kSwitches[i].name) + " " + std::string(kSwitches[i].settings[static_cast<std::size_t>(quality.choice[i])].name);
  }
  return words.empty() ? "reference" : words;
}

SurfaceTraits traits_of(const Model& model, Shading shading) {
  SurfaceTraits traits;
  for (const Mesh& mesh : model.meshes) {
    const Shading shown = shading_of(model, mesh, shading);
    traits.textured |= is_textured(shown);
    traits.lit |= shown == Shading::phong || shown == Shading::blinn || shown == Shading::textured_lit;
  }
  return traits;
}

std::string_view reason_not_to_turn(std::size_t switch_number, const SurfaceTraits& traits) noexcept {
  if (switch_number == kFilter && !traits.textured) return "nothing is textured";
  if (switch_number == kLight && !traits.lit) return "nothing is lit at its fragments";
  return {};
}

std::vector<Quality> qualities_for(const SurfaceTraits& traits) {
  std::vector<Quality> all{Quality{}};
  for (std::size_t i = 0; i < kSwitches.size(); ++i) {
    if (!reason_not_to_turn(i, traits).empty()) continue;
    const std::size_t begun = all.size();
    for (std::size_t setting = 1; setting < kSwitches[i].settings.size(); ++setting)
      for (std::size_t k = 0; k < begun; ++k) {
        all.push_back(all[k]);
        all.back().choice[i] = static_cast<int>(setting);
      }
  }
  return all;
}

}  // namespace tuberia
