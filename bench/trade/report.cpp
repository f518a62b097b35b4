#include "bench/trade/report.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/trade/plots.hpp"

namespace tuberia::bench::trade {
namespace {

using Json = nlohmann::ordered_json;

std::string csv_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, ",%.6g", value);
  return text;
}

/// As RFC 4180 wants it.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

std::string csv_line(const std::string& kind, const std::string& name, const std::string& scene, const Measurement& m,
                     bool is_reference, const std::string& unit, bool is_picture) {
  std::string text =
      quoted(kind) + "," + quoted(name) + "," + quoted(scene) + "," + quoted(m.setting) + (is_reference ? ",1" : ",0");
  for (const double value : {m.time.median_ms, m.time.ratio, m.time.lower_quartile, m.time.upper_quartile,
                             static_cast<double>(m.time.rounds), m.error})
    text += csv_number(value);
  text.append(",").append(quoted(unit));
  if (!is_picture) return text.append(9, ',').append("\n");
  const PictureError& e = m.to_ideal;
  for (const double value : {e.largest_code, e.rmse_codes, e.differing_share, e.psnr_db, e.ssim, e.mean_ciede2000,
                             e.largest_ciede2000, m.to_reference.largest_code, m.to_reference.rmse_codes})
    text += csv_number(value);
  return text.append("\n");
}

/// JSON has no infinity: equal pictures have no finite PSNR.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const PictureError& error) {
  return {{"largest_code", error.largest_code},
          {"rmse_codes", error.rmse_codes},
          {"differing_share", error.differing_share},
          {"psnr_db", finite(error.psnr_db)},
          {"ssim", error.ssim},
          {"mean_ciede2000", error.mean_ciede2000},
          {"largest_ciede2000", error.largest_ciede2000}};
}

Json json_of(const RelativeTime& time) {
  return {{"median_ms", time.median_ms},
          {"ratio", time.ratio},
          {"lower_quartile", time.lower_quartile},
          {"upper_quartile", time.upper_quartile},
          {"rounds", time.rounds}};
}

Json json_of(const std::vector<Measurement>& measurements, bool is_picture) {
  Json list = Json::array();
  for (const Measurement& each : measurements) {
    Json entry{{"setting", each.setting}, {"time", json_of(each.time)}, {"error", finite(each.error)}};
    if (is_picture) {
      entry["to_ideal"] = json_of(each.to_ideal);
      entry["to_reference"] = {{"largest_code", each.to_reference.largest_code},
                               {"rmse_codes", each.to_reference.rmse_codes}};
    }
    list.push_back(std::move(entry));
  }
  return list;
}

Json json_of(const std::vector<KnownFigure>& figures) {
  Json list = Json::array();
  for (const KnownFigure& each : figures) {
    Json entry{{"stage", each.stage}, {"what", each.what}, {"unit", each.unit}, {"known", each.known}};
    entry["derived"] = each.derived ? finite(*each.derived) : Json(nullptr);
    entry["measured"] = each.measured ? finite(*each.measured) : Json(nullptr);
    if (!each.remark.empty()) entry["remark"] = each.remark;
    list.push_back(std::move(entry));
  }
  return list;
}

Json heading_of(const Circumstances& circumstances) {
  const Machine& machine = circumstances.machine;
  return {{"date", machine.date},
          {"processor", machine.processor},
          {"clock_hertz", machine.clock_hertz},
          {"compiler", machine.compiler},
          {"commit", machine.commit},
          {"threads", circumstances.pipeline.threads},
          {"instruction_set", std::string(name_of(circumstances.pipeline.instruction_set))},
          {"quick", circumstances.is_quick}};
}

}  // namespace

std::string csv_of(const TradeResult& result) {
  std::string text =
      "stage,switch,scene,setting,is_reference,median_ms,time_ratio,lower_quartile,upper_quartile,rounds,error,error_"
      "unit,"
      "largest_code,rmse_codes,differing_share,psnr_db,ssim,mean_ciede2000,largest_ciede2000,largest_code_to_reference,"
      "rmse_codes_to_reference\n";
  for (const StageResult& stage : result.stages)
    for (const SwitchResult& each : stage.switches)
      for (std::size_t i = 0; i < each.measurements.size(); ++i)
        text += csv_line(stage.name, each.switch_name, each.scene, each.measurements[i], i == 0, stage.error_label,
                         each.is_picture);
  for (const WholeResult& whole : result.scenes)
    for (std::size_t i = 0; i < whole.measurements.size(); ++i)
      text += csv_line("whole scene", "all", whole.scene, whole.measurements[i], i == 0, "RMSE, codes of 255", true);
  return text;
}

std::string json_of(const TradeResult& result, const Circumstances& circumstances) {
  Json stages = Json::array(), scenes = Json::array();
  for (const StageResult& stage : result.stages) {
    Json switches = Json::array();
    for (const SwitchResult& each : stage.switches)
      switches.push_back({{"switch", each.switch_name},
                          {"scene", each.scene},
                          {"what", each.what},
                          {"measurements", json_of(each.measurements, each.is_picture)}});
    stages.push_back(
        {{"stage", stage.name}, {"title", stage.title}, {"error_unit", stage.error_label}, {"switches", switches}});
  }
  for (const WholeResult& whole : result.scenes)
    scenes.push_back(
        {{"scene", whole.scene}, {"what", whole.what}, {"measurements", json_of(whole.measurements, true)}});
  return Json{{"circumstances", heading_of(circumstances)},
              {"stages", stages},
              {"scenes", scenes},
              {"known_figures", json_of(known_figures(result))}}
             .dump(1) +
         "\n";
}

}  // namespace tuberia::bench::trade
