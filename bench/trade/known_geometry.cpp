// Known figures of coverage, interpolation, filters and edges.

#include <cmath>
#include <cstdio>

#include "bench/trade/closed_forms.hpp"
#include "bench/trade/known_figures.hpp"
#include "raster/sample_positions.hpp"

namespace tuberia::bench::trade {
namespace {

std::vector<glm::dvec2> pattern(int samples) {
  std::vector<glm::dvec2> points;
  for (const SamplePosition& at : sample_positions(samples)) points.emplace_back(at.x / 16.0, at.y / 16.0);
  return points;
}

std::vector<glm::dvec2> grid(int side) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < side * side; ++i)
    points.emplace_back((i % side + 0.5) / side - 0.5, (i / side + 0.5) / side - 0.5);
  return points;
}

void add_edge(Figures& figures, const Measured& measured, bool near_axis, const std::vector<glm::dvec2>& points,
              int side, double known) {
  const std::string scene = near_axis ? "edges near the axes" : "edges in all directions";
  const std::string setting = side > 0             ? std::to_string(side) + "x" + std::to_string(side) + " grid"
                              : points.size() == 1 ? "1 sample"
                                                   : std::to_string(points.size()) + " samples";
  constexpr double kEighthTurn = 0.78539816339744831, kLean = 0.0698;  // 4 degrees
  figures.push_back(
      {.stage = "edges",
       .what = scene + ", " + setting,
       .unit = "RMS of coverage",
       .known = known,
       .derived = coverage_rms(points, near_axis ? kLean : kEighthTurn),
       .measured = measured.error("edges", side > 0 ? "supersampling" : "multisampling", scene, setting),
       .remark = near_axis ? "how near the known figure's edges lean is not on record; here up to 4 degrees" : ""});
}

}  // namespace

void add_subpixel_bits(Figures& figures, const Measured& measured) {
  struct Known {
    int bits;
    double wrong;
  };
  for (const auto& [bits, wrong] : {Known{0, 190}, {2, 48.5}, {4, 12.9}, {6, 2.3}, {8, 0.42}, {10, 0.16}}) {
    const std::string name = std::to_string(bits) + " bits";
    figures.push_back({.stage = "coverage",
                       .what = name,
                       .unit = "wrong pixels per 1000 px of edge",
                       .known = wrong,
                       .derived = wrong_pixels_by_rounding(bits),
                       .measured = measured.error("coverage", "subpixel bits", "random triangles", name),
                       .remark = bits == 10  ? "the machine has at most 8 bits"
                                 : bits >= 6 ? "every bit must halve it; the known figure is of too few pixels"
                                             : ""});
  }
}

void add_edge_arithmetic(Figures& figures, const Measured& measured) {
  struct Known {
    int size;
    double anchored, plane;
  };
  for (const auto& [size, anchored, plane] : {Known{256, 0, 20}, {1024, 15, 50}}) {
    const std::string scene = "triangles over " + std::to_string(size) + " px";
    for (const auto& [setting, known] : {std::pair{"float, anchored", anchored}, {"float, plane", plane}})
      figures.push_back(
          {.stage = "coverage",
           .what = scene + ", " + setting,
           .unit = "wrong pixels per million px of edge",
           .known = known,
           .derived = std::nullopt,
           .measured = measured.error("coverage", "edge arithmetic", scene, setting, 1000),
           .remark = "the known forms round elsewhere; pictures of 4096 px and more are beyond this run"});
  }
}

void add_perspective(Figures& figures, const Measured& measured) {
  struct Known {
    double w;
    int step;
    double texels;
  };
  for (const auto& [w, step, texels] : {Known{2, 4, 0.03},
                                        {2, 8, 0.12},
                                        {2, 16, 0.46},
                                        {2, 32, 1.7},
                                        {2, 64, 5.7},
                                        {2, 256, 43.9},
                                        {10, 8, 3.8},
                                        {10, 16, 11.4},
                                        {100, 8, 65.6}}) {
    const std::string scene = "w from 1 to " + std::to_string(static_cast<int>(w));
    const std::string setting = step == 256 ? "affine" : "every " + std::to_string(step) + " px";
    char remark[96] = "";
    if (step == 4 || step == 64) std::snprintf(remark, sizeof remark, "no setting of the machine");
    else if (w > 2)
      std::snprintf(remark, sizeof remark, "the machine's steps run from centre to centre: by theory %.3g",
                    texel_error_by_steps(w, step, 0.5));
    figures.push_back({.stage = "interpolation",
                       .what = scene + ", " + setting,
                       .unit = "texels, largest",
                       .known = texels,
                       .derived = texel_error_by_steps(w, step),
                       .measured = measured.error("interpolation", "perspective", scene, setting),
                       .remark = remark});
  }
}

void add_filters(Figures& figures, const Measured& measured) {
  struct Known {
    const char* setting;
    double rmse;
  };
  for (const auto& [setting, rmse] : {Known{"nearest, no levels", 0.242},
                                      {"bilinear, no levels", 0.212},
                                      {"bilinear, nearest level", 0.094},
                                      {"trilinear", 0.090},
                                      {"anisotropic 2", 0.057},
                                      {"anisotropic 4", 0.042},
                                      {"anisotropic 8", 0.035},
                                      {"anisotropic 16", 0.032}})
    figures.push_back(
        {.stage = "filter",
         .what = setting,
         .unit = "RMSE, 0..1",
         .known = rmse,
         .derived = std::nullopt,
         .measured = measured.error("filter", "filter", "checkered floor", setting, 1.0 / 255),
         .remark = "the known floor's camera is not on record; the order and the steps are to be the same"});
  struct KnownGrid {
    int side;
    double psnr;
  };
  for (const auto& [side, psnr] : {KnownGrid{2, 17.9}, {3, 21.9}, {4, 24.6}, {8, 28.5}}) {
    const std::string name = std::to_string(side) + "x" + std::to_string(side) + " grid";
    auto rmse = measured.error("supersampling", "filters and grids", "checkered floor", "nearest, no levels, " + name,
                               1.0 / 255);
    if (rmse) rmse = -20 * std::log10(*rmse);
    figures.push_back({.stage = "filter",
                       .what = "nearest texels, " + name,
                       .unit = "PSNR, dB",
                       .known = psnr,
                       .derived = std::nullopt,
                       .measured = rmse,
                       .remark = "as above"});
  }
}

void add_edges(Figures& figures, const Measured& measured) {
  struct Known {
    int count;
    double all, near;
  };
  for (const auto& [count, all, near] :
       {Known{1, 0.243, 0.269}, {2, 0.158, 0.135}, {4, 0.090, 0.069}, {8, 0.056, 0.036}, {16, 0.043, 0.036}}) {
    add_edge(figures, measured, false, pattern(count), 0, all);
    add_edge(figures, measured, true, pattern(count), 0, near);
  }
  for (const auto& [side, all, near] :
       {Known{2, 0.085, 0.127}, {3, 0.046, 0.081}, {4, 0.030, 0.058}, {8, 0.0105, 0.025}}) {
    add_edge(figures, measured, false, grid(side), side, all);
    add_edge(figures, measured, true, grid(side), side, near);
  }
}

}  // namespace tuberia::bench::trade
