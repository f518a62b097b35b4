#pragma once
// All stages of one primitive on a page of their own.

#include "examples/tuberia/stage_report.hpp"

namespace tuberia::cli {

/// A page that needs nothing but itself: data, pictures, style and scripts are inside.
std::string stages_page(const StageReport& report, const Model& model);

}  // namespace tuberia::cli
