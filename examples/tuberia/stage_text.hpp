#pragma once
// A StageReport for people and for programs.

#include <nlohmann/json.hpp>

#include "examples/tuberia/stage_report.hpp"

namespace tuberia::cli {

/// The life of the report's primitive; `fragments`: how many of them to list.
std::string primitive_text(const StageReport& report, int fragments);
/// The history of the report's pixel, which it must have.
std::string pixel_text(const StageReport& report);

/// The same numbers; the names of spaces are part of the keys.
nlohmann::ordered_json primitive_json(const StageReport& report);
nlohmann::ordered_json pixel_json(const StageReport& report);

}  // namespace tuberia::cli
