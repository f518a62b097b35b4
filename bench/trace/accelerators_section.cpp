#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/figures/chart.hpp"
#include "bench/figures/page.hpp"
#include "bench/figures/statistics.hpp"
#include "bench/trace/measure.hpp"
#include "bench/trace/scenes.hpp"
#include "bench/trace/tables.hpp"

namespace tuberia::bench {
namespace {

constexpr int kRays = 4096;

struct MeasuredKind {
  std::string name;
  std::vector<ComparedAccelerators> sizes;

  Series curve(std::size_t accelerator) const {
    Series series{.name = name_of_accelerator(accelerator), .points = {}};
    for (const ComparedAccelerators& size : sizes) series.points.push_back({static_cast<double>(size.objects), size.figures[accelerator].nanoseconds});
    series.law = fit_power_law(series.points);
    return series;
  }
};

MeasuredKind measured(const std::string& name, tracer::Geometry (*scene)(std::int64_t), const TraceOptions& options) {
  MeasuredKind kind{name, {}};
  const std::vector<tracer::Ray> rays = mixed_rays(kRays);
  for (const std::int64_t objects : {std::int64_t{10}, std::int64_t{1000}, std::int64_t{100'000}, std::int64_t{1'000'000}}) {
    if (options.quick && objects > 1000) break;
    std::fprintf(stderr, "%lld %s ...\n", static_cast<long long>(objects), name.c_str());
    kind.sizes.push_back(compare_accelerators(scene(objects), rays, options, false));
  }
  return kind;
}

/// Rays a second, a column for each number of objects, and how the time of a ray grows with it.
Table speed_table(const MeasuredKind& kind) {
  Table table{.headings = {kind.name + ": rays/s"}, .rows = {}};
  for (const ComparedAccelerators& size : kind.sizes) table.headings.push_back(count_text(static_cast<double>(size.objects)));
  table.headings.push_back("exponent of time");
  for (std::size_t i = 0; i < kAcceleratorKinds.size(); ++i) {
    std::vector<std::string> row{name_of_accelerator(i)};
    for (const ComparedAccelerators& size : kind.sizes) row.push_back(number_text(1e9 / size.figures[i].nanoseconds));
    const auto law = kind.curve(i).law;
    row.push_back(law ? exponent_text(*law) : "");
    table.rows.push_back(row);
  }
  return table;
}

/// A row for each number of objects and accelerator but none, which asks every object and needs no volumes.
Table detail_table(const MeasuredKind& kind) {
  Table table{.headings = {"accelerator", kind.name, "tests a ray", "volumes a ray", "volumes", "built, ms", "bytes each"}, .rows = {}};
  for (const ComparedAccelerators& size : kind.sizes)
    for (std::size_t i = 1; i < kAcceleratorKinds.size(); ++i) {
      const AcceleratorFigures& f = size.figures[i];
      const auto objects = static_cast<double>(size.objects);
      table.rows.push_back({name_of_accelerator(i), count_text(objects), number_text(f.item_tests), number_text(f.volume_tests),
                            count_text(static_cast<double>(f.facts.volumes)), number_text(1e3 * f.facts.build_seconds),
                            number_text(static_cast<double>(f.facts.memory_bytes) / objects)});
    }
  return table;
}

Chart chart_of(const MeasuredKind& kind) {
  Chart chart{.x = {.label = kind.name}, .y = {.label = "ns of a ray"}, .series = {}};
  for (std::size_t i = 0; i < kAcceleratorKinds.size(); ++i) chart.series.push_back(kind.curve(i));
  return chart;
}

}  // namespace

TraceSection accelerators_section(const TraceOptions& options) {
  const MeasuredKind kinds[] = {measured("spheres", random_spheres, options), measured("triangles", hills, options)};
  const std::string how =
      "Half of the rays come from an eye, half go from anywhere to anywhere; one thread, processor time, medians of rounds in which every "
      "accelerator had its turn. Builds: " + std::to_string(options.threads) + " threads, the fastest of three. Exponents: of the time of a ray "
      "against the number of objects, all that were measured.";
  TraceSection section{.heading = "Accelerators against each other", .html = "<p>" + how + "</p>\n", .markdown = how + "\n\n",
                       .json_name = "accelerators", .json = {}};
  nlohmann::ordered_json json;
  std::int64_t compared = 0, different = 0;
  std::string figures, details;
  for (const MeasuredKind& kind : kinds) {
    figures += "<div>" + figure_of(chart_of(kind)) + speed_table(kind).html() + "</div>\n";
    details += "<div>" + detail_table(kind).html() + "</div>\n";
    section.markdown += markdown_of(speed_table(kind)) + "\n" + markdown_of(detail_table(kind)) + "\n";
    for (const ComparedAccelerators& size : kind.sizes) {
      json[kind.name].push_back(json_of(size));
      compared += size.hits_compared;
      different += size.hits_different;
    }
  }
  const std::string equal = count_text(static_cast<double>(compared)) + " hits compared with those of asking every object: " +
                            count_text(static_cast<double>(different)) + " differ in any bit.";
  section.html += "<div class=\"row\">" + figures + "</div>\n<p>" + equal + "</p>\n<div class=\"row\">" + details + "</div>\n";
  section.markdown += equal + "\n";
  section.json = json.dump(2);
  if (different > 0) section.complaint = "accelerators find different hits";
  return section;
}

}  // namespace tuberia::bench
