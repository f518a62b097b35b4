// How the cost of a draw grows, as curves on a page: script/bench curves.

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "bench/curves/curves.hpp"
#include "bench/figures/command_line.hpp"
#include "bench/figures/machine.hpp"
#include "bench/figures/text_file.hpp"

namespace tuberia::bench {
namespace {

struct Options {
  std::vector<std::string> prefixes;
  std::string page_file = "out/bench/curves.html", json_file, csv_file, instruction_set, precision = "exact", commit;
  int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 64u));
  bool quick = false;
};

struct NamedCurve {
  const char* name;
  Curve (*measure)(const CurveOptions&);
};
constexpr NamedCurve kCurves[] = {
    {"triangles", triangle_count_curve}, {"triangle_size", triangle_size_curve}, {"layers", layer_curve},
    {"target_size", target_size_curve},  {"attributes", attribute_curve},        {"threads", thread_curve}};

int fail(const std::string& message) {
  std::fprintf(stderr, "script/bench curves: %s\n", message.c_str());
  return 1;
}

void add_options(CommandLine& line, Options& options) {
  std::vector<std::string> names;
  for (const NamedCurve& curve : kCurves) names.emplace_back(curve.name);
  line.words("curve", options.prefixes, "Only these curves", names);
  line.flag("--quick", options.quick, "Fewer points and repetitions: to try it out, not to quote");
  line.whole("--threads", options.threads, 1, 64, "The most threads");
  line.page(options.page_file);
  line.json(options.json_file);
  line.text("--csv", options.csv_file, "Write the points to this file, too");
  line.instruction_set(options.instruction_set);
  line.precision(options.precision);
  line.commit(options.commit);
}

/// Only points with a positive x have a logarithm.
void fit(Curve& curve) {
  for (Series& series : curve.chart.series) {
    std::vector<CurvePoint> points;
    std::copy_if(series.points.begin(), series.points.end(), std::back_inserter(points),
                 [](const CurvePoint& point) { return point.x > 0; });
    series.law = fit_upper_end(points);
  }
}

std::string verdict_of(const std::vector<Curve>& curves) {
  std::string steep;
  for (const Curve& curve : curves)
    for (const Series& series : curve.chart.series)
      if (series.law && is_superlinear(*series.law))
        steep += (steep.empty() ? "" : ", ") + curve.name + " (" + series.name + ")";
  char limit[16];
  std::snprintf(limit, sizeof limit, "%g", kSuperlinear);
  if (steep.empty()) return std::string("Nothing grows faster than in proportion: no exponent is above ") + limit + ".";
  return std::string("Exponents above ") + limit + ": " + steep + ".";
}

std::string csv_of(const std::vector<Curve>& curves) {
  std::string text = "curve,series,x,y\n";
  for (const Curve& curve : curves)
    for (const Series& series : curve.chart.series)
      for (const CurvePoint& point : series.points) {
        char numbers[64];
        std::snprintf(numbers, sizeof numbers, ",%.9g,%.9g\n", point.x, point.y);
        text += "\"" + curve.name + "\",\"" + series.name + "\"" + numbers;
      }
  return text;
}

std::string json_of(const std::vector<Curve>& curves, const Machine& machine) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Curve& curve : curves)
    for (const Series& series : curve.chart.series) {
      Json points = Json::array();
      for (const CurvePoint& point : series.points) points.push_back({point.x, point.y});
      Json entry{{"curve", curve.name},
                 {"series", series.name},
                 {"x", curve.chart.x.label},
                 {"y", curve.chart.y.label},
                 {"points", points}};
      if (series.law) entry["exponent"] = series.law->exponent;
      if (series.law && series.law->standard_error) entry["standard_error"] = *series.law->standard_error;
      list.push_back(std::move(entry));
    }
  return Json{{"machine", sentence_of(machine)}, {"curves", list}}.dump(2) + "\n";
}

/// A row for each x that any series has.
Table table_of(const Chart& chart) {
  Table table{.headings = {escaped(chart.x.label)}, .rows = {}};
  std::map<double, std::vector<std::string>> rows;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    table.headings.push_back(escaped(chart.series[i].name) + ",<br>" + escaped(chart.y.label));
    for (const CurvePoint& point : chart.series[i].points) {
      std::vector<std::string>& cells = rows.try_emplace(point.x, chart.series.size(), "-").first->second;
      cells[i] = number_text(point.y);
    }
  }
  for (const auto& [x, cells] : rows) {
    table.rows.push_back({x == std::floor(x) ? count_text(x) : number_text(x)});
    table.rows.back().insert(table.rows.back().end(), cells.begin(), cells.end());
  }
  return table;
}

Page page_of(const std::vector<Curve>& curves, const Machine& machine, const CurveOptions& options) {
  const std::string how = ". " + std::string(name_of(options.instruction_set)) + ", " +
                          (options.precision == Precision::exact ? "exact" : "fast") + " precision; up to " +
                          std::to_string(options.threads) + (options.threads == 1 ? " thread" : " threads") + ".";
  std::string lede = escaped(sentence_of(machine)) + how +
                     " Points are medians of up to seven runs. The bands are power laws, fitted to the upper third "
                     "of a curve's points (three at least), beyond fixed costs and the steps of the caches; &plusmn; "
                     "is the exponent's standard error. <b>" +
                     escaped(verdict_of(curves)) + "</b>";
  if (options.quick) lede += " <span class=\"alarm\">A quick run: not to be quoted.</span>";
  Page page("What it costs", lede);
  for (const Curve& curve : curves) {
    const std::string beside = curve.table_html.empty() ? table_of(curve.chart).html() : curve.table_html;
    page.add_section(curve.title, "<p>" + curve.explanation + "</p>\n<div class=\"row\">\n" + figure_of(curve.chart) +
                                      "<div>\n" + curve.remark_html + beside + "</div>\n</div>\n");
  }
  return page;
}

Result<CurveOptions> curve_options(const Options& options) {
  CurveOptions curves{.threads = options.threads, .quick = options.quick};
  curves.precision = options.precision == "exact" ? Precision::exact : Precision::fast;
  const auto chosen = instruction_set_from(options.instruction_set);
  if (!chosen) return chosen.error();
  curves.instruction_set = *chosen;
  return curves;
}

int run(const Options& options) {
  const auto how = curve_options(options);
  if (!how) return fail(how.error().message);
  const Machine machine = this_machine(options.commit);
  std::printf("%s\n\n", sentence_of(machine).c_str());
  std::vector<Curve> curves;
  for (const NamedCurve& each : kCurves) {
    if (!options.prefixes.empty() &&
        std::find(options.prefixes.begin(), options.prefixes.end(), each.name) == options.prefixes.end())
      continue;
    curves.push_back(each.measure(*how));
    fit(curves.back());
  }
  std::printf("\n%s\n", verdict_of(curves).c_str());
  if (const auto written = page_of(curves, machine, *how).write(options.page_file); !written)
    return fail(written.error().message);
  if (const auto written = write_text(options.json_file, json_of(curves, machine)); !written)
    return fail(written.error().message);
  if (const auto written = write_text(options.csv_file, csv_of(curves)); !written)
    return fail(written.error().message);
  std::printf("The page: %s\n", options.page_file.c_str());
  return 0;
}

}  // namespace
}  // namespace tuberia::bench

int main(int argc, char** argv) {
  tuberia::bench::CommandLine line("Measures how the cost of a draw grows with what is drawn, and writes a page of curves.", "tuberia_curves");
  tuberia::bench::Options options;
  tuberia::bench::add_options(line, options);
  if (const auto status = line.parse(argc, argv)) return *status;
  return tuberia::bench::run(options);
}
