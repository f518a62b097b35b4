// Known figures of shading, approximations, targets, depth and footprints.

#include <cstdio>

#include "bench/trade/closed_forms.hpp"
#include "bench/trade/known_figures.hpp"

namespace tuberia::bench::trade {

void add_shading(Figures& figures, const Measured& measured) {
  struct Known {
    double lean, shininess, left;
  };
  for (const auto& [lean, shininess, left] : {Known{10, 20, 0.736}, {20, 50, 0.045}, {30, 10, 0.237}}) {
    char scene[64];
    std::snprintf(scene, sizeof scene, "normals +-%g deg, n = %g", lean, shininess);
    const Measurement* found = measured.find("shading", "shading", scene, "Gouraud");
    figures.push_back(
        {.stage = "shading",
         .what = std::string("Gouraud's highlight, ") + scene,
         .unit = "of 1",
         .known = left,
         .derived = gouraud_highlight(lean, shininess),
         .measured = found == nullptr ? std::nullopt : std::optional(static_cast<double>(found->middle))});
  }
  // The same is lost when the cosine is interpolated, and not the intensity.
  for (const auto& [lean, shininess, left] : {Known{10, 20, 0.736}, {20, 50, 0.045}, {30, 10, 0.237}}) {
    char scene[64];
    std::snprintf(scene, sizeof scene, "normals +-%g deg, n = %g", lean, shininess);
    const Measurement* found = measured.find("shading", "shading", scene, "dot product");
    figures.push_back(
        {.stage = "shading",
         .what = std::string("the dot product's highlight, ") + scene,
         .unit = "of 1",
         .known = left,
         .derived = gouraud_highlight(lean, shininess),
         .measured = found == nullptr ? std::nullopt : std::optional(static_cast<double>(found->middle))});
  }
  struct KnownLength {
    double degrees, length;
  };
  for (const auto& [degrees, length] : {KnownLength{10, 0.99998}, {20, 0.9997}, {40, 0.9947}, {60, 0.974}, {90, 0.884}})
    figures.push_back({.stage = "shading",
                       .what = "length after one step of renormalization, normals " +
                               std::to_string(static_cast<int>(degrees)) + " degrees apart",
                       .unit = "of 1",
                       .known = length,
                       .derived = length_after_one_step(degrees)});
}

void add_approximations(Figures& figures) {
  struct Known {
    double parameter, error;
  };
  for (const auto& [steps, error] : {Known{0, 3.4e-2}, {1, 1.75e-3}, {2, 4.7e-6}, {3, 1.4e-7}})
    figures.push_back({.stage = "precision",
                       .what = "1/sqrt by its bits, " + std::to_string(static_cast<int>(steps)) + " Newton steps",
                       .unit = "relative, largest",
                       .known = error,
                       .derived = fast_inverse_root_error(static_cast<int>(steps)),
                       .measured = std::nullopt,
                       .remark = "by theory only: the machine's fast form refines the processor's estimate"});
  for (const auto& [n, error] : {Known{5, 0.155}, {10, 0.179}, {20, 0.191}, {50, 0.199}, {200, 0.202}})
    figures.push_back({.stage = "shading",
                       .what = "Schlick's power, n = " + std::to_string(static_cast<int>(n)),
                       .unit = "of 1, largest",
                       .known = error,
                       .derived = schlick_power_error(n),
                       .measured = std::nullopt,
                       .remark = "by theory only: the machine has no such power"});
  for (const auto& [index, error] : {Known{1.33, 0.060}, {1.5, 0.036}, {2.42, 0.076}}) {
    char what[48];
    std::snprintf(what, sizeof what, "Schlick's Fresnel term, index %g", index);
    figures.push_back({.stage = "shading",
                       .what = what,
                       .unit = "of 1, largest",
                       .known = error,
                       .derived = schlick_fresnel_error(index),
                       .measured = std::nullopt,
                       .remark = "by theory only: nothing reflects yet"});
  }
}

void add_targets(Figures& figures, const Measured& measured) {
  struct Known {
    const char* format;
    double step, layers;
  };
  for (const auto& [format, step, layers] :
       {Known{"rgba8", 0.00196, 127}, {"rgba16f", 2.4e-4, 94.13}, {"rgba32f", 3e-8, 93.63}}) {
    const bool is_codes = format == std::string("rgba8"), is_half = format == std::string("rgba16f");
    figures.push_back({.stage = "target",
                       .what = std::string(format) + ", largest rounding error near 1",
                       .unit = "of 1",
                       .known = step,
                       .derived = is_codes  ? 0.5 / 255
                                  : is_half ? 0x1p-12
                                            : 0x1p-25});
    const Measurement* found = measured.find("target", "colour format", "255 layers of alpha 1/255", format);
    std::optional<double> left;
    if (found != nullptr) left = 255 * static_cast<double>(found->middle);
    figures.push_back({.stage = "target",
                       .what = std::string("white under 255 layers of alpha 1/255, ") + format,
                       .unit = "codes of 255",
                       .known = layers,
                       .derived = is_codes  ? std::optional<double>(white_under_layers_in_codes(255))
                                  : is_half ? std::nullopt
                                            : std::optional(white_under_layers(255)),
                       .measured = left});
  }
  figures.push_back({.stage = "target",
                     .what = "sRGB codes that linear 8-bit codes keep apart",
                     .unit = "of 256",
                     .known = 183,
                     .derived = srgb_codes_kept_by_linear_codes()});
  figures.push_back({.stage = "target",
                     .what = "a power of 1/2.2 in place of sRGB's curve",
                     .unit = "codes, largest",
                     .known = 9,
                     .derived = codes_missed_by_plain_gamma()});
}

void add_depth(Figures& figures, const Measured& measured) {
  struct Known {
    double gap, d16, d24, d32f, reversed;
  };
  for (const Known& each : {Known{1e-3, 54.9, 8.2, 8.2, 0},
                            {1e-4, 75.0, 26.7, 26.7, 0},
                            {1e-5, 94.2, 46.8, 46.8, 0},
                            {1e-6, 99.4, 66.7, 66.8, 0}}) {
    char scene[32];
    std::snprintf(scene, sizeof scene, "pairs %g apart", each.gap);
    const auto add = [&](const char* setting, double known, DepthCoding coding) {
      figures.push_back({.stage = "depth",
                         .what = std::string(scene) + ", " + setting,
                         .unit = "% in the wrong order",
                         .known = known,
                         .derived = 100 * misordered_pairs(coding, each.gap),
                         .measured = measured.error("depth", "depth format", scene, setting),
                         .remark = each.gap == 1e-3 && known > 0 && known < 10
                                       ? "theory rounds the depth alone; the machine's clip z is a float, too"
                                       : ""});
    };
    add("d16", each.d16, DepthCoding::unorm16);
    add("d24", each.d24, DepthCoding::unorm24);
    add("d32f", each.d32f, DepthCoding::float32);
    add("d32f reversed", each.reversed, DepthCoding::float32_reversed);
  }
}

void add_footprints(Figures& figures) {
  figures.push_back({.stage = "texels",
                     .what = "level of detail of (5, 0) (4.9, 0.5), longer and shorter step",
                     .unit = "levels",
                     .known = 2.30025,
                     .derived = axis_level_of_detail({5, 0}, {4.9, 0.5}, 16)});
  figures.push_back({.stage = "texels",
                     .what = "level of detail of (5, 0) (4.9, 0.5), true ellipse",
                     .unit = "levels",
                     .known = -1.19069,
                     .derived = ellipse_level_of_detail({5, 0}, {4.9, 0.5}, 16)});
  figures.push_back({.stage = "texels",
                     .what = "weights of 8 bits, along one axis",
                     .unit = "codes, largest",
                     .known = 0.498,
                     .derived = 255.0 / 512});
}

}  // namespace tuberia::bench::trade
