// What the features of the pipeline cost that a scene does not require: script/bench requirements.

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "bench/figures/command_line.hpp"
#include "bench/figures/text_file.hpp"
#include "bench/requirements/report.hpp"

namespace tuberia::bench {

std::string requirements_json(std::span<const MeasuredScene> scenes, const Machine& machine) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const MeasuredScene& scene : scenes) {
    Json ways = Json::array();
    for (const Variant& v : scene.variants)
      ways.push_back({{"way", v.name}, {"milliseconds", v.milliseconds}, {"first_quarter", v.first_quarter}, {"third_quarter", v.third_quarter}});
    list.push_back({{"scene", scene.name}, {"draws", scene.draws}, {"needed_draws", scene.needed_draws}, {"examining_milliseconds", scene.examining_milliseconds},
                    {"pictures_are_equal", scene.pictures_are_equal}, {"ways", ways}});
  }
  return Json{{"machine", sentence_of(machine)}, {"scenes", list}}.dump(2) + "\n";
}

namespace {

struct Options {
  std::vector<std::string> scenes;
  std::string page_file = "out/bench/requirements.html", json_file, markdown_file, instruction_set, commit;
  int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 64u));
  bool quick = false;
};

int fail(const std::string& message) {
  std::fprintf(stderr, "script/bench requirements: %s\n", message.c_str());
  return 1;
}

void add_options(CommandLine& line, Options& options) {
  line.words("scene", options.scenes, "Only these scenes", requirement_scene_names());
  line.flag("--quick", options.quick, "Three rounds: to try it out, not to quote");
  line.whole("--threads", options.threads, 1, 64, "How many threads draw");
  line.page(options.page_file);
  line.json(options.json_file);
  line.text("--markdown", options.markdown_file, "Write the tables to this file, too");
  line.instruction_set(options.instruction_set);
  line.commit(options.commit);
}

void tell(const MeasuredScene& scene) {
  const double smallest = scene.of(Variant::Kind::smallest).milliseconds;
  for (const Variant& v : scene.variants)
    std::printf("%-16s %-42s %8.2f ms %6.2f%s\n", scene.name.c_str(), v.name.c_str(), v.milliseconds, v.milliseconds / smallest,
                v.has_same_picture ? "" : "  ANOTHER PICTURE");
  std::fflush(stdout);
}

Result<MeasureOptions> measure_options(const Options& options) {
  MeasureOptions how{.threads = options.threads, .rounds = options.quick ? 3 : 11};
  const auto chosen = instruction_set_from(options.instruction_set);
  if (!chosen) return chosen.error();
  how.instruction_set = *chosen;
  return how;
}

int run(const Options& options) {
  const auto how = measure_options(options);
  if (!how) return fail(how.error().message);
  const Machine machine = this_machine(options.commit);
  std::printf("%s\n\n", sentence_of(machine).c_str());
  std::vector<MeasuredScene> measured;
  for (const std::string& name : options.scenes.empty() ? requirement_scene_names() : options.scenes) {
    measured.push_back(measure(make_requirement_scene(name), *how));
    tell(measured.back());
  }
  if (const auto written = requirements_page(measured, machine, *how, options.quick).write(options.page_file); !written) return fail(written.error().message);
  if (const auto written = write_text(options.json_file, requirements_json(measured, machine)); !written) return fail(written.error().message);
  if (const auto written = write_text(options.markdown_file, requirements_markdown(measured)); !written) return fail(written.error().message);
  std::printf("The page: %s\n", options.page_file.c_str());
  const bool all_equal = std::all_of(measured.begin(), measured.end(), [](const MeasuredScene& s) { return s.pictures_are_equal; });
  return all_equal ? 0 : fail("the pictures of a scene differ");
}

}  // namespace
}  // namespace tuberia::bench

int main(int argc, char** argv) {
  tuberia::bench::CommandLine line("Draws scenes with the smallest pipeline, with everything enabled, and with single features, and writes a page.", "tuberia_requirements");
  tuberia::bench::Options options;
  tuberia::bench::add_options(line, options);
  if (const auto status = line.parse(argc, argv)) return *status;
  return tuberia::bench::run(options);
}
