// What the features of the pipeline cost that a scene does not require: script/bench requirements.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <thread>

#include "bench/figures/command_line.hpp"
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

void add_options(CLI::App& app, Options& options) {
  app.add_option("scene", options.scenes, "Only these scenes")->check(CLI::IsMember(requirement_scene_names()));
  app.add_flag("--quick", options.quick, "Three rounds: to try it out, not to quote");
  app.add_option("--threads", options.threads, "How many threads draw")->check(CLI::Range(1, 64))->capture_default_str();
  app.add_option("--page", options.page_file, "The page to write")->capture_default_str();
  app.add_option("--json", options.json_file, "Write the figures to this file, too");
  app.add_option("--markdown", options.markdown_file, "Write the tables to this file, too");
  app.add_option("--isa", options.instruction_set, "Instruction set: sse4, avx2 or avx3 (default: the widest)");
  app.add_option("--commit", options.commit, "What the page calls the measured sources");
}

Result<Nothing> write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) return Error{"cannot write " + path};
  return Nothing{};
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
  if (!options.json_file.empty())
    if (const auto written = write_text(options.json_file, requirements_json(measured, machine)); !written) return fail(written.error().message);
  if (!options.markdown_file.empty())
    if (const auto written = write_text(options.markdown_file, requirements_markdown(measured)); !written) return fail(written.error().message);
  std::printf("The page: %s\n", options.page_file.c_str());
  const bool all_equal = std::all_of(measured.begin(), measured.end(), [](const MeasuredScene& s) { return s.pictures_are_equal; });
  return all_equal ? 0 : fail("the pictures of a scene differ");
}

}  // namespace
}  // namespace tuberia::bench

int main(int argc, char** argv) {
  CLI::App app{"Draws scenes with the smallest pipeline, with everything enabled, and with single features, and writes a page.", "tuberia_requirements"};
  tuberia::bench::Options options;
  tuberia::bench::add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  return tuberia::bench::run(options);
}
