#pragma once
// Figures of accelerators as text.

#include <nlohmann/json.hpp>

#include <string>

#include "bench/figures/page.hpp"
#include "bench/trace/measure.hpp"

namespace tuberia::bench {

/// Of kAcceleratorKinds[index].
std::string name_of_accelerator(std::size_t index);

/// Its cells must be plain text.
std::string markdown_of(const Table& table);

nlohmann::ordered_json json_of(const ComparedAccelerators& compared);

}  // namespace tuberia::bench
