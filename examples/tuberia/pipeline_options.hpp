#pragma once
// The options that every drawing command shares.

#include <CLI/CLI.hpp>
#include <string>
#include <thread>

#include "base/result.hpp"
#include "pipeline/pipeline.hpp"

namespace tuberia::cli {

struct PipelineArguments {
  std::string precision = "exact", instruction_set = "auto";
  int threads = 0;
};

inline void add_pipeline_options(CLI::App& command, PipelineArguments& arguments) {
  command.add_option("--precision", arguments.precision, "exact: the same bits everywhere; fast: may round otherwise; others: one ingredient of fast, where the program has it")
      ->check(CLI::IsMember({"exact", "fast", "reciprocal", "inverse-sqrt", "fused", "power"}));
  command.add_option("--threads", arguments.threads, "0: one a core")->check(CLI::Range(0, 1024));
  command.add_option("--isa", arguments.instruction_set, "Instruction set")->check(CLI::IsMember({"auto", "sse4", "neon", "baseline", "avx2", "avx3"}));
}

/// Error when this machine lacks the instruction set.
inline Result<PipelineOptions> options_of(const PipelineArguments& arguments) {
  PipelineOptions options;
  options.threads = arguments.threads;
  options.precision = *precision_named(arguments.precision);
  if (arguments.instruction_set == "auto") return options;
  const auto wanted = instruction_set_named(arguments.instruction_set);
  if (!wanted || !is_supported(*wanted)) {
    std::string names;
    for (const InstructionSet set : supported_instruction_sets()) names += " " + std::string(name_of(set));
    return Error{"--isa: this machine does not run " + arguments.instruction_set + "; it runs" + names};
  }
  options.instruction_set = *wanted;
  return options;
}

inline std::string description_of(const PipelineOptions& options, int threads) {
  return std::string(name_of(options.precision)) + ", " + std::string(name_of(options.instruction_set)) +
         ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

}  // namespace tuberia::cli
