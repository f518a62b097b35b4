#pragma once
// The measured programs as a table, for a terminal and for a browser.

#include <span>
#include <string>

#include "bench/figures/machine.hpp"
#include "bench/figures/page.hpp"
#include "bench/programs/measure.hpp"

namespace tuberia::bench {

/// For a terminal, and as Markdown for the README.
std::string programs_text(std::span<const ProgramCost> costs);
std::string programs_markdown(std::span<const ProgramCost> costs);

/// quick: the page says that it is not to be quoted.
Page programs_page(std::span<const ProgramCost> costs, const Machine& machine, const MeasureOptions& options, bool quick);

}  // namespace tuberia::bench
