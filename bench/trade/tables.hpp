#pragma once
// Tables of what was measured, in Markdown or HTML.

#include <string>
#include <vector>

#include "bench/figures/page.hpp"
#include "bench/trade/figures_of_theory.hpp"
#include "bench/trade/measure.hpp"

namespace tuberia::bench::trade {

/// Cells are plain text.
Table table_of(const StageResult& stage);
/// The combinations on the front, and the reference.
Table table_of(const WholeResult& scene);
Table table_of(const std::vector<KnownFigure>& figures);

std::string markdown_of(const Table& table);
std::string html_of(const Table& table);

}  // namespace tuberia::bench::trade
