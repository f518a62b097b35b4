#pragma once
// How a draw's cost grows, one curve after the other.

#include <string>
#include <vector>

#include "bench/figures/chart.hpp"
#include "bench/figures/page.hpp"
#include "raster/instruction_set.hpp"

namespace tuberia::bench {

struct CurveOptions {
  int threads = 2;     // the most
  bool quick = false;  // fewer points and repetitions: to try out, not to quote
  InstructionSet instruction_set = best_instruction_set();
  Precision precision = Precision::exact;
};

struct Curve {
  std::string name, title;
  std::string explanation;  // HTML
  Chart chart;
  std::string remark_html{};  // beside the chart
  std::string table_html{};   // instead of a table of the chart's points
};

Curve triangle_count_curve(const CurveOptions& options);
Curve triangle_size_curve(const CurveOptions& options);
Curve layer_curve(const CurveOptions& options);
Curve target_size_curve(const CurveOptions& options);
Curve attribute_curve(const CurveOptions& options);
Curve thread_curve(const CurveOptions& options);

}  // namespace tuberia::bench
