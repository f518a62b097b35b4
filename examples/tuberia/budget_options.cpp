#include "examples/tuberia/budget_options.hpp"

#include <charconv>
#include <cmath>

#include "scene/adviser/model_picture.hpp"

namespace tuberia::cli {
namespace {

/// A positive number at the beginning of a text, which it is taken from.
std::optional<double> take_number(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value) || value < 0) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

Result<double> error_of(const std::string& argument) {
  std::string_view text = argument;
  const auto value = take_number(text);
  if (value && text.empty() && *value <= 1) return *value;
  if (value && text == "/255" && *value <= 255) return *value / 255;
  return Error{"--error-budget: '" + argument + "' is neither a part of full intensity like 0.002 nor codes like 0.5/255"};
}

Result<double> seconds_of(const std::string& argument) {
  std::string_view text = argument;
  const auto value = take_number(text);
  if (value && *value > 0 && text == "ms") return *value / 1000;
  if (value && *value > 0 && text == "s") return *value;
  return Error{"--time-budget: '" + argument + "' is not a time like 16ms or 0.5s"};
}

constexpr double kCodes = 255, kMilliseconds = 1000;

void print_trial(const Trial& trial, double reference_seconds) {
  std::printf("  %-64s predicted %5.2f/255 at %4.2f of the time; measured %5.2f/255 (picture: at most %.2f) at %4.2f, %.2f ms\n",
              words_of(trial.quality).c_str(), trial.predicted.rmse * kCodes, trial.predicted.time_ratio, trial.rmse * kCodes,
              trial.rmse_at_most * kCodes, trial.seconds / reference_seconds, trial.seconds * kMilliseconds);
}

void print_choices(const Advice& advice, const SurfaceTraits& traits) {
  const MeasuredTrade& trade = MeasuredTrade::built_in();
  for (std::size_t i = 0; i < kQualitySwitches; ++i) {
    const QualitySwitch& each = quality_switches()[i];
    const int choice = advice.chosen.quality.choice[i];
    const std::string_view unturned = reason_not_to_turn(i, traits);
    std::printf("  %-12s %-26s ", std::string(each.name).c_str(), std::string(each.settings[static_cast<std::size_t>(choice)].name).c_str());
    if (!unturned.empty()) {
      std::printf("%s\n", std::string(unturned).c_str());
      continue;
    }
    const auto effect = [&](int setting) { return trade.effect(kind_of(traits), i, setting); };
    if (choice > 0) std::printf("%.2f of the time for %.2f/255", effect(choice).time_ratio, effect(choice).rmse * kCodes);
    else std::printf("the reference");
    if (static_cast<std::size_t>(choice) + 1 < each.settings.size())
      std::printf("; next, %s: %.2f for %.2f/255", std::string(each.settings[static_cast<std::size_t>(choice) + 1].name).c_str(),
                  effect(choice + 1).time_ratio, effect(choice + 1).rmse * kCodes);
    std::printf("  (measured on other %s surfaces)\n", std::string(name_of(kind_of(traits))).c_str());
  }
}

void print_advice(const Advice& advice, const Budget& budget, const SurfaceTraits& traits, bool explain) {
  const Trial& chosen = advice.chosen;
  std::printf("budget: ");
  if (budget.rmse) std::printf("RMSE %.2f/255%s", *budget.rmse * kCodes, budget.seconds ? ", " : "");
  if (budget.seconds) std::printf("%.2f ms", *budget.seconds * kMilliseconds);
  std::printf(" -> %s\n", words_of(chosen.quality).c_str());
  std::printf("predicted: RMSE %.2f/255 in %.2f of the reference's time\n", chosen.predicted.rmse * kCodes, chosen.predicted.time_ratio);
  std::printf("measured:  RMSE %.2f/255 on %d of %d tiles (whole picture: at most %.2f); %.2f ms, %.2f of the reference's %.2f ms\n",
              chosen.rmse * kCodes, advice.sampled_tiles, advice.tiles, chosen.rmse_at_most * kCodes, chosen.seconds * kMilliseconds,
              chosen.seconds / advice.reference_seconds, advice.reference_seconds * kMilliseconds);
  if (advice.stepped_up > 0)
    std::printf("the prediction was wrong %d time%s: what it allowed broke the budget, and the next better was tried\n", advice.stepped_up,
                advice.stepped_up == 1 ? "" : "s");
  if (!advice.keeps_budget) std::printf("NO setting keeps this budget; this one comes nearest\n");
  if (!explain) return;
  std::printf("why each switch stands so:\n");
  print_choices(advice, traits);
  std::printf("tried on this picture:\n");
  for (const Trial& trial : advice.trials) print_trial(trial, advice.reference_seconds);
  std::printf("predictions come from: %s", MeasuredTrade::built_in().circumstances().c_str());
}

}  // namespace

void add_budget_options(CLI::App& command, BudgetArguments& arguments) {
  command.add_option("--error-budget", arguments.error, "The cheapest settings whose RMSE against the reference is no larger: 0.5/255, 0.002")->group("Budget");
  command.add_option("--time-budget", arguments.time, "The most accurate settings that draw a frame in this time: 16ms")->group("Budget");
  command.add_flag("--explain", arguments.explain, "Say why each switch got its value; with a budget")->group("Budget");
  for (const char* turned : {"--filter", "--anisotropy", "--perspective", "--precision", "--supersample"})
    for (const char* budget : {"--error-budget", "--time-budget"}) command.get_option(turned)->excludes(command.get_option(budget));
}

Result<Budget> budget_of(const BudgetArguments& arguments) {
  Budget budget;
  if (!arguments.error.empty()) {
    const auto error = error_of(arguments.error);
    if (!error) return error.error();
    budget.rmse = *error;
  }
  if (!arguments.time.empty()) {
    const auto seconds = seconds_of(arguments.time);
    if (!seconds) return seconds.error();
    budget.seconds = *seconds;
  }
  return budget;
}

Result<Nothing> refusal_of(const BudgetArguments& arguments, bool is_map) {
  if (const auto budget = budget_of(arguments); !budget) return budget.error();
  if (is_map && arguments.is_given()) return Error{"--view draws a map; a budget goes with the model's colours"};
  if (arguments.explain && !arguments.is_given()) return Error{"--explain explains a budget: give --error-budget or --time-budget, too"};
  return Nothing{};
}

Result<Nothing> keep_budget(const BudgetArguments& arguments, const Model& model, RenderOptions& options, PipelineOptions& pipeline) {
  const auto budget = budget_of(arguments);
  if (!budget) return budget.error();
  const auto scene = place(model, options);
  if (!scene) return scene.error();
  ModelPicture picture(scene->drawable, scene->view, options.background, pipeline);
  const SurfaceTraits traits = traits_of(model, options.shading);
  const RenderTargetDescription target{.width = options.width_pixels, .height = options.height_pixels, .colour = options.colour_format,
                                       .depth = options.depth_format};
  Adviser adviser(picture, target, traits);
  const auto advice = adviser.advise(*budget);
  if (!advice) return advice.error();
  print_advice(*advice, *budget, traits, arguments.explain);

  const QualityState chosen = with_quality({.view = scene->view}, advice->chosen.quality);
  options.sampler = chosen.view.sampler;
  options.lit_at_vertices = chosen.view.lit_at_vertices;
  options.rasterization = chosen.view.rasterization;
  pipeline.precision = chosen.precision;
  return Nothing{};
}

}  // namespace tuberia::cli
