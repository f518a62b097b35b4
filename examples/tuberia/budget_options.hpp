#pragma once
// tuberia render --error-budget, --time-budget, --explain.

#include <CLI/CLI.hpp>

#include "examples/tuberia/pipeline_options.hpp"
#include "examples/tuberia/render_model.hpp"
#include "scene/adviser/adviser.hpp"

namespace tuberia::cli {

struct BudgetArguments {
  std::string error, time;
  bool explain = false;
  bool is_given() const noexcept { return !error.empty() || !time.empty(); }
};

void add_budget_options(CLI::App& command, BudgetArguments& arguments);

/// "0.5/255", "0.002"; "16ms", "0.016s". Error for anything else, naming it.
Result<Budget> budget_of(const BudgetArguments& arguments);

/// Error for a budget that cannot be read, and for one of a map, which has no switches.
Result<Nothing> refusal_of(const BudgetArguments& arguments, bool is_map);

/// Turns the switches of both options to what the budget allows, and says on stdout what it found. Error
/// when the model cannot be drawn.
Result<Nothing> keep_budget(const BudgetArguments& arguments, const Model& model, RenderOptions& options, PipelineOptions& pipeline);

}  // namespace tuberia::cli
