#pragma once
// The files of examples/tuberia/stages_page, in the program.

#include <string_view>

namespace tuberia::cli {

extern const std::string_view kStagesPage, kStagesStyle, kStagesScripts[4];

}  // namespace tuberia::cli
