// What a fragment costs in every program, alone and combined: script/bench programs.

#include <nlohmann/json.hpp>

#include <cstdio>

#include "bench/figures/command_line.hpp"
#include "bench/figures/text_file.hpp"
#include "bench/programs/page.hpp"

namespace tuberia::bench {
namespace {

struct Options {
  std::string page_file = "out/bench/programs.html", json_file, markdown_file, instruction_set, commit;
  bool quick = false;
};

void add_options(CommandLine& line, Options& options) {
  line.flag("--quick", options.quick, "A few rounds: to try it out, not to quote");
  line.page(options.page_file);
  line.json(options.json_file);
  line.text("--markdown", options.markdown_file, "Write the table to this file, too");
  line.instruction_set(options.instruction_set);
  line.commit(options.commit);
}

int fail(const std::string& message) {
  std::fprintf(stderr, "script/bench programs: %s\n", message.c_str());
  return 1;
}

std::string json_of(std::span<const ProgramCost> costs, const Machine& machine) {
  using Json = nlohmann::ordered_json;
  constexpr const char* kKinds[] = {"program", "base", "technique", "combination"};
  Json list = Json::array();
  for (const ProgramCost& c : costs) {
    Json row{{"kind", kKinds[static_cast<int>(c.kind)]}, {"name", c.name}, {"exact_ns", c.exact}, {"fast_ns", c.fast},
             {"exact_first_quarter_ns", c.exact_low}, {"exact_third_quarter_ns", c.exact_high}};
    if (c.exact_ratio) row.update(Json{{"exact_by_sum_of_parts", *c.exact_ratio}, {"fast_by_sum_of_parts", *c.fast_ratio}});
    list.push_back(row);
  }
  return Json{{"machine", sentence_of(machine)}, {"programs", list}}.dump(2) + "\n";
}

/// The combinations that cost more than they may, a line each.
std::string too_dear(std::span<const ProgramCost> costs) {
  std::string names;
  for (const ProgramCost& c : costs)
    if ((c.exact_ratio && *c.exact_ratio > kMostForCombination) || (c.fast_ratio && *c.fast_ratio > kMostForCombination)) names += "\n  " + c.name;
  return names;
}

int run(const Options& options) {
  MeasureOptions how;
  if (options.quick) how.seconds = 3, how.fewest_rounds = 5;
  const auto chosen = instruction_set_from(options.instruction_set);
  if (!chosen) return fail(chosen.error().message);
  how.instruction_set = *chosen;
  const Machine machine = this_machine(options.commit);
  std::printf("%s\n\n", sentence_of(machine).c_str());
  std::fflush(stdout);
  const std::vector<ProgramCost> costs = measure_programs(how);
  std::fputs(programs_text(costs).c_str(), stdout);
  if (const auto written = programs_page(costs, machine, how, options.quick).write(options.page_file); !written) return fail(written.error().message);
  if (const auto written = write_text(options.json_file, json_of(costs, machine)); !written) return fail(written.error().message);
  if (const auto written = write_text(options.markdown_file, programs_markdown(costs)); !written) return fail(written.error().message);
  std::printf("\nThe page: %s\n", options.page_file.c_str());
  const std::string dear = too_dear(costs);
  return dear.empty() ? 0 : fail("combinations that cost more than their parts allow:" + dear);
}

}  // namespace
}  // namespace tuberia::bench

int main(int argc, char** argv) {
  tuberia::bench::CommandLine line("Times a fragment in every program, alone and combined, and writes a page.", "tuberia_programs");
  tuberia::bench::Options options;
  tuberia::bench::add_options(line, options);
  if (const auto status = line.parse(argc, argv)) return *status;
  return tuberia::bench::run(options);
}
