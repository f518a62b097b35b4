// What every switch that trades speed for accuracy costs and gives: script/bench trade.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/figures/command_line.hpp"
#include "bench/figures/text_file.hpp"
#include "bench/trade/adviser_table.hpp"
#include "bench/trade/plots.hpp"
#include "bench/trade/progress.hpp"
#include "bench/trade/report.hpp"
#include "image/write_image.hpp"

namespace tuberia::bench::trade {
namespace {

struct Options {
  std::vector<std::string> only;
  std::string folder = "out/bench", instruction_set, commit, advice_file, images_folder;
  int threads = 1;
  bool quick = false;
};

int fail(const std::string& message) {
  std::fprintf(stderr, "script/bench trade: %s\n", message.c_str());
  return 1;
}

void add_options(CommandLine& line, Options& options) {
  line.words("stage", options.only, "Only these stages or whole scenes (\"scenes\": all of those)");
  line.flag("--quick", options.quick, "Three rounds of everything: to try it out, not to quote");
  line.whole("--threads", options.threads, 1, 64, "Threads of the pipeline");
  line.instruction_set(options.instruction_set);
  line.text("--folder", options.folder, "Where trade.html, .csv, .json and .md go");
  line.text("--advice", options.advice_file, "Instead, measure what `tuberia render --error-budget` predicts from, and write it to this file");
  line.text("--images", options.images_folder, "Write every plot as an SVG file into this folder, too");
  line.commit(options.commit);
}

bool is_chosen(const Options& options, const std::string& name, const std::string& kind) {
  const auto names = [&](const std::string& text) {
    return std::find(options.only.begin(), options.only.end(), text) != options.only.end();
  };
  return options.only.empty() || names(name) || names(kind);
}

Result<StageResult> measure_stage(const Stage& stage, const Effort& effort, const PipelineOptions& pipeline,
                                  const Progress& progress) {
  StageResult result{stage.name, stage.title, stage.what, stage.error_label, {}};
  for (const Switch& each : stage.switches)
    for (const Scene& scene : each.scenes) {
      progress.tell(stage.name + ": " + each.name, scene.name, each.settings.size());
      auto measured = measure(scene, each.settings, effort, pipeline);
      if (!measured) return measured.error();
      result.switches.push_back({each.name, scene.name, scene.what, scene.is_picture, *std::move(measured)});
    }
  return result;
}

std::string file_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// The reference's picture, beside the page.
Result<std::string> write_picture(const WholeScene& whole, const Setting& reference, const PipelineOptions& pipeline,
                                  const std::string& folder) {
  const auto picture = screen_picture(whole.scene, reference, pipeline);
  if (!picture) return picture.error();
  const std::string name = "trade_" + file_name(whole.scene.name) + ".png";
  std::error_code ignored;  // the file's own failure says it, too
  std::filesystem::create_directories(folder, ignored);
  if (const auto written = write_image(folder + "/" + name, *picture); !written) return written.error();
  return name;
}

Result<WholeResult> measure_whole(const WholeScene& whole, const Effort& effort, const PipelineOptions& pipeline,
                                  const Progress& progress) {
  WholeResult result{whole.scene.name, whole.scene.what, {}, {}, {}, {}};
  for (const Switch& each : whole.switches) {
    result.switches.push_back(each.name);
    result.settings.emplace_back();
    for (const Setting& setting : each.settings) result.settings.back().push_back(setting.name);
  }
  const std::vector<Combination> all = combinations(whole.switches);
  std::vector<Setting> settings;
  for (const Combination& each : all) settings.push_back(each.setting);
  progress.tell("whole scene", whole.scene.name, settings.size());
  auto measured = measure(
      whole.scene, settings,
      {.seconds = 3 * effort.seconds, .fewest_rounds = effort.fewest_rounds, .of_processor = effort.of_processor},
      pipeline);
  if (!measured) return measured.error();
  for (std::size_t i = 0; i < all.size(); ++i) (*measured)[i].choices = all[i].choices;
  result.measurements = *std::move(measured);
  return result;
}

Result<TradeResult> measure_all(const Options& options, const PipelineOptions& pipeline) {
  Effort effort = options.quick ? Effort{.seconds = 0, .fewest_rounds = 3} : Effort{.seconds = 1.5, .fewest_rounds = 7};
  effort.of_processor = pipeline.threads == 1;
  const Progress progress;
  TradeResult result;
  for (const Stage& stage : all_stages()) {
    if (!is_chosen(options, stage.name, "stages")) continue;
    auto measured = measure_stage(stage, effort, pipeline, progress);
    if (!measured) return measured.error();
    result.stages.push_back(*std::move(measured));
  }
  for (const WholeScene& whole : whole_scenes()) {
    if (!is_chosen(options, whole.scene.name, "scenes")) continue;
    auto measured = measure_whole(whole, effort, pipeline, progress);
    if (!measured) return measured.error();
    const auto picture = write_picture(whole, combinations(whole.switches).front().setting, pipeline, options.folder);
    if (!picture) return picture.error();
    measured->picture_file = *picture;
    result.scenes.push_back(*std::move(measured));
  }
  if (result.stages.empty() && result.scenes.empty()) return Error{"no stage and no scene has such a name"};
  return result;
}

Result<Nothing> write_images(const std::string& folder, const TradeResult& result) {
  if (!result.scenes.empty())
    if (const auto written =
            write_text(folder + "/trade_scenes.svg", svg_file_of(plot_of(result.scenes), "Whole scenes"));
        !written)
      return written;
  for (const WholeResult& whole : result.scenes)
    if (const auto written = write_text(folder + "/trade_scene_" + file_name(whole.scene) + ".svg",
                                        svg_file_of(plot_of(whole), "Whole scene: " + whole.scene));
        !written)
      return written;
  for (const StageResult& stage : result.stages)
    if (const auto written =
            write_text(folder + "/trade_" + file_name(stage.name) + ".svg", svg_file_of(plot_of(stage), stage.title));
        !written)
      return written;
  return Nothing{};
}

Result<Nothing> write_all(const Options& options, const TradeResult& result, const Circumstances& circumstances) {
  const std::string path = options.folder + "/trade";
  if (const auto written = page_of(result, circumstances).write(path + ".html"); !written) return written;
  if (const auto written = write_text(path + ".csv", csv_of(result)); !written) return written;
  if (const auto written = write_text(path + ".json", json_of(result, circumstances)); !written) return written;
  if (const auto written = write_text(path + ".md", markdown_of(result, circumstances)); !written) return written;
  if (!options.images_folder.empty())
    if (const auto written = write_images(options.images_folder, result); !written) return written;
  return Nothing{};
}

Result<Nothing> write_advice(const Options& options, const Circumstances& circumstances) {
  const Progress progress;
  Effort effort = options.quick ? Effort{.seconds = 0, .fewest_rounds = 3} : Effort{.seconds = 4, .fewest_rounds = 9};
  effort.of_processor = circumstances.pipeline.threads == 1;
  const auto table = measure_adviser_table(sentence_of(circumstances.machine), effort, circumstances.pipeline, progress);
  if (!table) return table.error();
  return write_text(options.advice_file, *table);
}

int run(const Options& options) {
  const auto chosen = instruction_set_from(options.instruction_set);
  if (!chosen) return fail(chosen.error().message);
  const PipelineOptions pipeline{.threads = options.threads, .instruction_set = *chosen};
  const Circumstances circumstances{this_machine(options.commit), pipeline, options.quick};
  std::printf("%s\n\n", sentence_of(circumstances.machine).c_str());
  if (!options.advice_file.empty()) {
    const auto written = write_advice(options, circumstances);
    return written ? 0 : fail(written.error().message);
  }
  const auto result = measure_all(options, pipeline);
  if (!result) return fail(result.error().message);
  if (const auto written = write_all(options, *result, circumstances); !written) return fail(written.error().message);
  std::printf("\nThe page: %s/trade.html\n", options.folder.c_str());
  return 0;
}

}  // namespace
}  // namespace tuberia::bench::trade

int main(int argc, char** argv) {
  tuberia::bench::CommandLine line("Measures what every switch that trades speed for accuracy costs and gives, and writes a page of plots.", "tuberia_trade");
  tuberia::bench::trade::Options options;
  tuberia::bench::trade::add_options(line, options);
  if (const auto status = line.parse(argc, argv)) return *status;
  return tuberia::bench::trade::run(options);
}
