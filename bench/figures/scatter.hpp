#pragma once
// Choices as points, cost against error, with the Pareto front, inside a page of bench/figures/page.hpp or
// as a file of its own.

#include <string>
#include <vector>

#include "bench/figures/chart.hpp"

namespace tuberia::bench {

struct ScatterPoint {
  double x = 1, y = 0;        // x is positive; see Scatter::negligible
  std::string label{};        // beside the point; empty: none
  std::size_t group = 0;      // which colour, and which key
  bool is_reference = false;  // drawn as a ring
  bool is_detail = false;     // small and pale, on no front
  std::string hover{};
};

struct Scatter {
  Axis x, y;
  std::vector<std::string> groups;
  std::vector<ScatterPoint> points;
  bool front_of_each_group = false;  // or one of all points
  double negligible = 0;             // such a y, and any below, lie in a strip of their own under a logarithmic axis
};

/// A figure with a key, if it has more than one group.
std::string figure_of(const Scatter& scatter);

/// The same as an SVG file, light, with its title and its key inside.
std::string svg_file_of(const Scatter& scatter, const std::string& title);

}  // namespace tuberia::bench
