#pragma once
// What was measured, as a page, as text for the documents and as JSON.

#include <span>
#include <string>

#include "bench/figures/machine.hpp"
#include "bench/figures/page.hpp"
#include "bench/requirements/variants.hpp"

namespace tuberia::bench {

Page requirements_page(std::span<const MeasuredScene> scenes, const Machine& machine, const MeasureOptions& options, bool quick);

/// The table of whole scenes, and the one of single features, in Markdown.
std::string requirements_markdown(std::span<const MeasuredScene> scenes);

std::string requirements_json(std::span<const MeasuredScene> scenes, const Machine& machine);

}  // namespace tuberia::bench
