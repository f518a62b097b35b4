// Our fast kernel beside Embree on the same rays.

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/figures/page.hpp"
#include "bench/figures/timing.hpp"
#include "bench/trace/ray_kernel.hpp"
#include "bench/trace/section.hpp"
#include "bench/trace/tables.hpp"

namespace tuberia::bench {
namespace {

using tracer::FastHit;
using tracer::FastRay;

constexpr std::int64_t kPart = 1024;  // rays that a thread takes at a time
constexpr int kThreadCounts[] = {1, 2};

struct KernelFigures {
  std::string name;
  double build_milliseconds = 0, memory_megabytes = 0;
  /// By kThreadCounts: millions of rays a second, and times the first kernel's, the median and the quartiles of the rounds.
  struct Speed {
    double rate = 0, times = 1, lower_quartile = 1, upper_quartile = 1;
  } speed[2];
  std::int64_t hits = 0, other_than_doubles = 0, other_than_embree = 0;  // triangles of rays
};

struct Comparison {
  std::string triangles, rays;
  std::int64_t ray_count = 0;
  std::vector<KernelFigures> kernels;
};

void find_all(const RayKernel& kernel, std::span<const FastRay> rays, std::span<FastHit> hits, Workers& workers, std::int64_t every = 1) {
  const auto count = static_cast<std::int64_t>(rays.size()), parts = (count + kPart - 1) / kPart;
  parallel_for(workers, (parts + every - 1) / every, [&](std::int64_t part, int) {
    const auto begin = static_cast<std::size_t>(part * every * kPart), size = std::min<std::size_t>(kPart, rays.size() - begin);
    kernel.find(rays.subspan(begin, size), hits.subspan(begin, size));
  });
}

void time_kernels(const RayKernels& kernels, const RaySet& set, const TraceOptions& options, int threads_index, std::vector<KernelFigures>& figures) {
  const int threads = kThreadCounts[threads_index];
  Workers workers(threads);
  std::vector<FastHit> hits(set.rays.size());
  std::vector<std::function<void()>> ways;
  for (const auto& kernel : kernels) ways.emplace_back([&] { find_all(*kernel, set.rays, hits, workers, kernel->patience()); });
  const Effort effort{.seconds = options.quick ? 1.0 : 12.0, .fewest_rounds = options.quick ? 3 : 9, .of_processor = threads == 1};
  const std::vector<RelativeTime> times = time_in_turns(ways, effort);
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const double patience = kernels[i]->patience();
    figures[i].speed[threads_index] = {.rate = static_cast<double>(set.rays.size()) / (times[i].median_ms * patience) / 1000,
                                       .times = 1 / (times[i].ratio * patience),
                                       .lower_quartile = 1 / (times[i].upper_quartile * patience),
                                       .upper_quartile = 1 / (times[i].lower_quartile * patience)};
  }
}

std::int64_t count_others(const std::vector<FastHit>& hits, const std::vector<FastHit>& expected) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) count += hits[i].triangle != expected[i].triangle ? 1 : 0;
  return count;
}

/// The first kernel is Embree's, if it is there; the last is the one in doubles.
void compare_hits(const RayKernels& kernels, const RaySet& set, std::vector<KernelFigures>& figures) {
  Workers workers;
  std::vector<std::vector<FastHit>> hits;
  for (const auto& kernel : kernels) find_all(*kernel, set.rays, hits.emplace_back(set.rays.size()), workers);
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    figures[i].hits = std::count_if(hits[i].begin(), hits[i].end(), [](const FastHit& hit) { return bool(hit); });
    figures[i].other_than_doubles = count_others(hits[i], hits.back());
    figures[i].other_than_embree = count_others(hits[i], hits.front());
  }
}

Comparison compared(const RayKernels& kernels, const TriangleSoup& soup, const RaySet& set, const TraceOptions& options) {
  std::fprintf(stderr, "%s; %s rays ...\n", soup.name.c_str(), set.name.c_str());
  Comparison comparison{.triangles = soup.name, .rays = set.name, .ray_count = static_cast<std::int64_t>(set.rays.size()), .kernels = {}};
  for (const auto& kernel : kernels) {
    KernelFigures& figures = comparison.kernels.emplace_back();
    figures.name = kernel->name();
    figures.build_milliseconds = 1e3 * kernel->build_seconds;
    figures.memory_megabytes = 1e-6 * static_cast<double>(kernel->memory_bytes);
  }
  compare_hits(kernels, set, comparison.kernels);
  for (int threads_index : {0, 1}) time_kernels(kernels, set, options, threads_index, comparison.kernels);
  return comparison;
}

std::vector<Comparison> compared_on(int subdivisions, const std::vector<RaySet>& sets, const TraceOptions& options) {
  const TriangleSoup soup = bunny(subdivisions);
  RayKernels kernels = embree_kernels(soup, options.threads);
  for (auto& kernel : our_kernels(soup, options.threads)) kernels.push_back(std::move(kernel));
  std::vector<Comparison> comparisons;
  for (const RaySet& set : sets) comparisons.push_back(compared(kernels, soup, set, options));
  return comparisons;
}

std::string times_text(const KernelFigures::Speed& speed) {
  return number_text(speed.times) + " (" + number_text(speed.lower_quartile) + " to " + number_text(speed.upper_quartile) + ")";
}

std::string count_text_of(std::int64_t count) { return count_text(static_cast<double>(count)); }

Table table_of(const std::vector<Comparison>& comparisons) {
  Table table{.headings = {"kernel", "Mrays/s, 1 thread", "times the first's", "Mrays/s, 2 threads", "times the first's", "hits", "others than doubles",
                           "others than the first", "build ms", "MB"},
              .rows = {}};
  for (const Comparison& comparison : comparisons) {
    std::vector<std::string>& heading = table.rows.emplace_back(table.headings.size());
    heading.front() = comparison.triangles + "; " + comparison.rays + " rays";
    for (const KernelFigures& f : comparison.kernels)
      table.rows.push_back({f.name, number_text(f.speed[0].rate), times_text(f.speed[0]), number_text(f.speed[1].rate), times_text(f.speed[1]),
                            count_text_of(f.hits), count_text_of(f.other_than_doubles), count_text_of(f.other_than_embree),
                            number_text(f.build_milliseconds), number_text(f.memory_megabytes)});
  }
  return table;
}

nlohmann::ordered_json json_of(const Comparison& comparison) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const KernelFigures& f : comparison.kernels)
    list.push_back({{"kernel", f.name},
                    {"mrays_1_thread", f.speed[0].rate},
                    {"times_1_thread", f.speed[0].times},
                    {"mrays_2_threads", f.speed[1].rate},
                    {"times_2_threads", f.speed[1].times},
                    {"hits", f.hits},
                    {"other_than_doubles", f.other_than_doubles},
                    {"other_than_first", f.other_than_embree},
                    {"build_ms", f.build_milliseconds},
                    {"memory_mb", f.memory_megabytes}});
  return {{"triangles", comparison.triangles}, {"rays", comparison.rays}, {"ray_count", comparison.ray_count}, {"kernels", list}};
}

}  // namespace

TraceSection embree_section(const TraceOptions& options) {
  const int height = options.quick ? 360 : 1080, width = options.quick ? 640 : 1920;
  const RaySet primary = primary_rays(width, height), incoherent = incoherent_rays(options.quick ? 100'000 : 300'000);
  std::vector<Comparison> comparisons = compared_on(0, {primary, incoherent}, options);
  for (Comparison& larger : compared_on(2, {primary, incoherent}, options)) comparisons.push_back(std::move(larger));

  const std::string embree = embree_sentence();
  const std::string peer = embree.empty() ? "Embree was not found when this was configured; the first kernel is ours." : embree + ". The first kernel is Embree's.";
  const std::string how = peer + " Ours: " + std::string(tracer::FastTriangles::instruction_sets().back()) +
                          ". The primary rays are in squares of 4 x 4 pixels. Medians of rounds in which every kernel had its turn (quartiles); of one thread its "
                          "processor time. Nobody is kept to a core. Builds: " +
                          std::to_string(options.threads) + " threads, ours and Embree's the fastest of three.";
  const Table table = table_of(comparisons);
  TraceSection section{.heading = "The fast kernel beside Embree",
                       .html = "<p>" + how + "</p>\n" + table.html(),
                       .markdown = how + "\n\n" + markdown_of(table),
                       .json_name = "embree",
                       .json = {}};
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Comparison& comparison : comparisons) {
    json.push_back(json_of(comparison));
    for (const KernelFigures& f : comparison.kernels)
      if (f.name.starts_with("ours") && f.other_than_doubles > 0) section.complaint = "the fast kernel meets other triangles than the tracer in doubles";
  }
  section.json = json.dump(2);
  return section;
}

}  // namespace tuberia::bench
