#include "bench/trade/tables.hpp"

#include <algorithm>
#include <cmath>

#include "bench/trade/plots.hpp"

namespace tuberia::bench::trade {
namespace {

std::string percent(double share) { return number_text(100 * share) + " %"; }

std::string decibels(double value) { return std::isfinite(value) ? number_text(value) : "equal"; }

std::string spread(const RelativeTime& time) {
  return number_text(time.lower_quartile) + " to " + number_text(time.upper_quartile);
}

void add_picture_cells(std::vector<std::string>& row, const PictureError& error) {
  row.insert(row.end(), {number_text(error.largest_code), number_text(error.rmse_codes), percent(error.differing_share),
                         decibels(error.psnr_db), number_text(error.ssim), number_text(error.mean_ciede2000),
                         number_text(error.largest_ciede2000)});
}

std::string optional_text(const std::optional<double>& value) { return value ? number_text(*value) : "-"; }

}  // namespace

Table table_of(const StageResult& stage) {
  Table table{.headings = {"switch", "scene", "setting", "ms", "time ratio", "quartiles", stage.error_label,
                           "largest code", "RMSE", "differing", "PSNR dB", "SSIM", "mean dE00", "largest dE00"},
              .rows = {}};
  for (const SwitchResult& each : stage.switches)
    for (const Measurement& m : each.measurements) {
      std::vector<std::string> row{
          each.switch_name,          each.scene,     m.setting,           number_text(m.time.median_ms),
          number_text(m.time.ratio), spread(m.time), number_text(m.error)};
      if (each.is_picture) add_picture_cells(row, m.to_ideal);
      else row.insert(row.end(), 7, "-");
      table.rows.push_back(std::move(row));
    }
  return table;
}

Table table_of(const WholeResult& scene) {
  Table table{.headings = {"setting", "ms", "time ratio", "quartiles", "largest code", "RMSE", "differing", "PSNR dB",
                           "SSIM", "mean dE00", "largest dE00", "RMSE to the reference"},
              .rows = {}};
  std::vector<std::size_t> shown = front_of(scene.measurements);
  if (std::find(shown.begin(), shown.end(), 0u) == shown.end()) shown.push_back(0);
  for (const std::size_t i : shown) {
    const Measurement& m = scene.measurements[i];
    std::vector<std::string> row{i == 0 ? std::string("reference: ").append(m.setting) : m.setting,
                                 number_text(m.time.median_ms), number_text(m.time.ratio), spread(m.time)};
    add_picture_cells(row, m.to_ideal);
    row.push_back(number_text(m.to_reference.rmse_codes));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table table_of(const std::vector<KnownFigure>& figures) {
  Table table{.headings = {"stage", "what", "unit", "known", "by theory", "measured", "remark"}, .rows = {}};
  for (const KnownFigure& each : figures)
    table.rows.push_back({each.stage, each.what, each.unit, number_text(each.known), optional_text(each.derived),
                          optional_text(each.measured), each.remark});
  return table;
}

std::string markdown_of(const Table& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text.append(" ").append(cell).append(" |");
    return text.append("\n");
  };
  std::string text = line(table.headings) + line(std::vector<std::string>(table.headings.size(), "---"));
  for (const auto& row : table.rows) text += line(row);
  return text;
}

std::string html_of(const Table& table) {
  Table safe = table;
  for (std::string& heading : safe.headings) heading = escaped(heading);
  for (auto& row : safe.rows)
    for (std::string& cell : row) cell = escaped(cell);
  return safe.html();
}

}  // namespace tuberia::bench::trade
