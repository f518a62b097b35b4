#include "scene/adviser/measured_trade.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "scene/adviser/built_in_trade.hpp"

namespace tuberia {
namespace {

constexpr std::array<std::string_view, 3> kKinds{"textured", "textured-lit", "lit"};

std::string quoted(std::string_view text) { return std::string(1, '\'').append(text).append(1, '\''); }

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(';', begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value) || value < 0) return {};
  return value;
}

template <class Names>
std::optional<std::size_t> place_of(std::string_view name, const Names& names) {
  for (std::size_t i = 0; i < std::size(names); ++i)
    if (names[i] == name) return i;
  return {};
}

struct Row {
  std::size_t kind, switch_number, setting;
  Effect effect;
};

Result<Row> row_of(std::string_view line) {
  const std::vector<std::string_view> fields = fields_of(line);
  if (fields.size() != 5) return Error{"five fields are expected, but there are " + std::to_string(fields.size())};
  const auto kind = place_of(fields[0], kKinds);
  if (!kind) return Error{"no kind of surface is called " + quoted(fields[0])};
  for (std::size_t i = 0; i < kQualitySwitches; ++i) {
    if (quality_switches()[i].name != fields[1]) continue;
    const auto settings = quality_switches()[i].settings;
    for (std::size_t setting = 0; setting < settings.size(); ++setting) {
      if (settings[setting].name != fields[2]) continue;
      const auto ratio = number_of(fields[3]), codes = number_of(fields[4]);
      if (!ratio || !codes) return Error{quoted(line) + " does not end in two numbers"};
      return Row{*kind, i, setting, {*ratio, *codes / 255}};
    }
    return Error{"the switch " + quoted(fields[1]) + " has no setting " + quoted(fields[2])};
  }
  return Error{"no switch is called " + quoted(fields[1])};
}

}  // namespace

std::string_view name_of(SurfaceKind kind) noexcept { return kKinds[static_cast<std::size_t>(kind)]; }

SurfaceKind kind_of(const SurfaceTraits& traits) noexcept {
  if (!traits.textured) return SurfaceKind::lit;
  return traits.lit ? SurfaceKind::textured_lit : SurfaceKind::textured;
}

SurfaceTraits traits_of(SurfaceKind kind) noexcept {
  return {.textured = kind != SurfaceKind::lit, .lit = kind != SurfaceKind::textured};
}

Result<MeasuredTrade> MeasuredTrade::parse(std::string_view text) {
  MeasuredTrade trade;
  for (auto& kind : trade.effects_)
    for (std::size_t i = 0; i < kQualitySwitches; ++i) kind[i].assign(quality_switches()[i].settings.size(), {-1, -1});

  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.empty()) continue;
    if (line.front() == '#') {
      trade.circumstances_ += std::string(trimmed(line.substr(1))) + "\n";
      continue;
    }
    const auto row = row_of(line);
    if (!row) return Error{"line " + std::to_string(number) + ": " + row.error().message};
    trade.effects_[row->kind][row->switch_number][row->setting] = row->effect;
  }

  for (const SurfaceKind kind : {SurfaceKind::textured, SurfaceKind::textured_lit, SurfaceKind::lit})
    if (const auto whole = trade.check_whole(kind); !whole) return whole.error();
  return trade;
}

Result<Nothing> MeasuredTrade::check_whole(SurfaceKind kind) const {
  for (std::size_t i = 0; i < kQualitySwitches; ++i) {
    if (!reason_not_to_turn(i, traits_of(kind)).empty()) continue;
    const auto settings = quality_switches()[i].settings;
    for (std::size_t setting = 0; setting < settings.size(); ++setting)
      if (effect(kind, i, static_cast<int>(setting)).time_ratio < 0)
        return Error{std::string(name_of(kind)) + ": the setting " + quoted(settings[setting].name) + " of the switch " +
                     quoted(quality_switches()[i].name) + " is missing"};
  }
  return Nothing{};
}

const MeasuredTrade& MeasuredTrade::built_in() {
  static const MeasuredTrade trade = [] {
    auto parsed = parse(kBuiltInTrade);
    TUBERIA_ASSERT(parsed.ok(), "the table of this build is whole: a test parses it");
    return *std::move(parsed);
  }();
  return trade;
}

Effect MeasuredTrade::predict(SurfaceKind kind, const Quality& quality) const noexcept {
  Effect sum;
  double squares = 0;
  for (std::size_t i = 0; i < kQualitySwitches; ++i) {
    if (quality.choice[i] == 0) continue;
    const Effect& one = effect(kind, i, quality.choice[i]);
    sum.time_ratio *= one.time_ratio;
    squares += one.rmse * one.rmse;
  }
  sum.rmse = std::sqrt(squares);
  return sum;
}

}  // namespace tuberia
