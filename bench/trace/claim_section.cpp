#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>
#include <vector>

#include "bench/figures/page.hpp"
#include "bench/trace/measure.hpp"
#include "bench/trace/scenes.hpp"
#include "bench/trace/tables.hpp"

namespace tuberia::bench {
namespace {

constexpr std::int64_t kObjects = 10'584;
constexpr double kNotesRatio = 40 * 24 * 60 / 15.0;  // 40 days, 15 minutes

std::string with_quartiles(const AcceleratorFigures& f) {
  return number_text(f.speedup) + " (" + number_text(f.lower_quartile) + " to " + number_text(f.upper_quartile) + ")";
}

Table table_of(const ComparedAccelerators& compared) {
  Table table{.headings = {"10,584 spheres", "µs a ray", "times faster (quartiles)", "tests a ray", "times fewer", "volumes a ray"}, .rows = {}};
  for (std::size_t i = 0; i < kAcceleratorKinds.size(); ++i) {
    const AcceleratorFigures& f = compared.figures[i];
    table.rows.push_back({name_of_accelerator(i), number_text(f.nanoseconds / 1000), i == 0 ? "1" : with_quartiles(f), number_text(f.item_tests),
                          number_text(compared.figures[0].item_tests / f.item_tests), number_text(f.volume_tests)});
  }
  return table;
}

}  // namespace

TraceSection claim_section(const TraceOptions& options) {
  const int pixels = options.quick ? 32 : 160;
  std::fprintf(stderr, "%lld spheres, %d x %d rays ...\n", static_cast<long long>(kObjects), pixels, pixels);
  const ComparedAccelerators compared = compare_accelerators(random_spheres(kObjects), eye_rays(pixels), options, true);
  const Table table = table_of(compared);
  const std::string side = std::to_string(pixels);
  const std::string told = "The notes report 15 minutes with a grid and 40 days without for a scene of 10,584 objects, " + count_text(kNotesRatio) +
                           " times. As many spheres here, a picture of " + side + " x " + side + " eye rays, the nearest hit of each: ";
  const bool are_equal = compared.hits_different == 0;
  const std::string equal = are_equal ? "all five pictures are equal to the last bit." : count_text(static_cast<double>(compared.hits_different)) + " hits differ.";
  TraceSection section{.heading = "What accelerators save: 10,584 objects", .html = "<p>" + told + equal + "</p>\n" + table.html(),
                       .markdown = told + equal + "\n\n" + markdown_of(table), .json_name = "claim", .json = json_of(compared).dump(2)};
  if (!are_equal) section.complaint = "accelerators give different pictures";
  return section;
}

}  // namespace tuberia::bench
