#pragma once
// The commands of the command-line renderer. Each adds itself to the parser; what it returns when
// it runs is the program's exit status.

#include <CLI/CLI.hpp>
#include <functional>

namespace tuberia::cli {

inline constexpr int kFine = 0, kDifferent = 1, kFailed = 2;

using Run = std::function<int()>;

Run add_render(CLI::App& parent, CLI::App*& command);
Run add_gallery(CLI::App& parent, CLI::App*& command);
Run add_compare(CLI::App& parent, CLI::App*& command);
Run add_info(CLI::App& parent, CLI::App*& command);
Run add_stages(CLI::App& parent, CLI::App*& command);
Run add_trace(CLI::App& parent, CLI::App*& command);
Run add_requirements(CLI::App& parent, CLI::App*& command);
Run add_witness(CLI::App& parent, CLI::App*& command);

/// Prints a one-line error and gives the exit status of failure.
int fail(const std::string& message);

}  // namespace tuberia::cli
