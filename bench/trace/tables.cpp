#include "bench/trace/tables.hpp"

namespace tuberia::bench {

std::string name_of_accelerator(std::size_t index) { return std::string(tracer::name_of(kAcceleratorKinds[index])); }

std::string markdown_of(const Table& table) {
  const auto row_of = [](const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) row += " " + cell + " |";
    return row + "\n";
  };
  std::string text = row_of(table.headings) + "|---|";
  for (std::size_t i = 1; i < table.headings.size(); ++i) text += "---:|";
  text += "\n";
  for (const auto& row : table.rows) text += row_of(row);
  return text;
}

nlohmann::ordered_json json_of(const ComparedAccelerators& compared) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < kAcceleratorKinds.size(); ++i) {
    const AcceleratorFigures& f = compared.figures[i];
    list.push_back({{"accelerator", name_of_accelerator(i)}, {"nanoseconds", f.nanoseconds}, {"times_faster", f.speedup},
                    {"first_quarter", f.lower_quartile}, {"third_quarter", f.upper_quartile}, {"item_tests", f.item_tests},
                    {"volume_tests", f.volume_tests}, {"volumes", f.facts.volumes}, {"depth", f.facts.depth},
                    {"build_seconds", f.facts.build_seconds}, {"memory_bytes", f.facts.memory_bytes}});
  }
  return {{"objects", compared.objects}, {"hits_compared", compared.hits_compared}, {"hits_different", compared.hits_different}, {"accelerators", list}};
}

}  // namespace tuberia::bench
