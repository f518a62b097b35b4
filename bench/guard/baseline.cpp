#include "bench/guard/baseline.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace tuberia::bench {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::string_view kCompiler = "compiler";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "'";
  quoted += text;
  return quoted += '\'';
}

const InstructionCount* find(const std::vector<InstructionCount>& counts, const std::string& workload) {
  const auto found = std::find_if(counts.begin(), counts.end(),
                                  [&](const InstructionCount& count) { return count.workload == workload; });
  return found == counts.end() ? nullptr : &*found;
}

/// What is wrong with the line, or nothing.
std::string take_line(std::string_view line, Baseline& baseline) {
  const std::size_t blank = line.find_first_of(kBlanks);
  if (blank == std::string_view::npos)
    return in_quotes(line) + " stands alone; a workload and its instructions are expected";
  const std::string name(line.substr(0, blank));
  const std::string_view rest = trimmed(line.substr(blank));
  if (name == kCompiler) {
    if (!baseline.compiler.empty()) return "a second compiler";
    baseline.compiler = rest;
    return {};
  }
  std::int64_t instructions = 0;
  const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), instructions);
  if (problem != std::errc() || end != rest.data() + rest.size() || instructions <= 0)
    return in_quotes(rest) + " is not a number of instructions";
  if (find(baseline.counts, name) != nullptr) return "a second count of " + name;
  baseline.counts.push_back({name, instructions});
  return {};
}

Verdict verdict_of(std::int64_t recorded, std::int64_t counted) {
  const double percent = 100.0 * (static_cast<double>(counted) / static_cast<double>(recorded) - 1);
  if (percent > kTolerancePercent) return Verdict::worse;
  return percent < -kTolerancePercent ? Verdict::better : Verdict::holds;
}

const char* words_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds: return "";
    case Verdict::better: return "better: worth recording";
    case Verdict::worse: return "TOO MANY";
    case Verdict::not_recorded: return "NOT RECORDED";
    case Verdict::not_counted: return "RECORDED, BUT THERE IS NO SUCH WORKLOAD";
  }
  return "";
}

std::string in_millions(std::int64_t count) {
  if (count == 0) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", static_cast<double>(count) * 1e-6);
  return text;
}

}  // namespace

Result<Baseline> parse_baseline(std::string_view text, const std::string& file) {
  Baseline baseline;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view whole = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
    if (line.empty()) continue;
    if (const std::string problem = take_line(line, baseline); !problem.empty())
      return Error{file + ":" + std::to_string(number) + ": " + problem};
  }
  if (baseline.compiler.empty()) return Error{file + ": no line says which compiler"};
  if (baseline.counts.empty()) return Error{file + ": no workload is recorded"};
  return baseline;
}

std::string text_of(const Baseline& baseline) {
  std::string text =
      "# Instructions of one frame (clearing and drawing) of each small workload: AVX2, one thread,\n"
      "# exact precision. script/bench check compares with these, script/bench check --record\n"
      "# writes them. Say in the commit why they changed.\n";
  text += std::string(kCompiler) + " " + baseline.compiler + "\n";
  for (const InstructionCount& count : baseline.counts) {
    char line[128];
    std::snprintf(line, sizeof line, "%-20s %12lld\n", count.workload.c_str(),
                  static_cast<long long>(count.instructions));
    text += line;
  }
  return text;
}

std::vector<Comparison> compare(const std::vector<InstructionCount>& recorded,
                                const std::vector<InstructionCount>& counted) {
  std::vector<Comparison> comparisons;
  for (const auto& [workload, instructions] : counted) {
    const InstructionCount* before = find(recorded, workload);
    if (before == nullptr) comparisons.push_back({workload, Verdict::not_recorded, 0, instructions});
    else
      comparisons.push_back(
          {workload, verdict_of(before->instructions, instructions), before->instructions, instructions});
  }
  for (const auto& [workload, instructions] : recorded)
    if (find(counted, workload) == nullptr) comparisons.push_back({workload, Verdict::not_counted, instructions, 0});
  return comparisons;
}

bool passes(const std::vector<Comparison>& comparisons) {
  return std::all_of(comparisons.begin(), comparisons.end(), [](const Comparison& comparison) {
    return comparison.verdict == Verdict::holds || comparison.verdict == Verdict::better;
  });
}

std::string table_of(const std::vector<Comparison>& comparisons) {
  char line[160];
  std::snprintf(line, sizeof line, "%-20s %12s %12s %9s\n", "million instructions", "recorded", "now", "");
  std::string table = line;
  for (const Comparison& each : comparisons) {
    std::string change;
    if (each.recorded > 0 && each.counted > 0) {
      char percent[32];
      std::snprintf(percent, sizeof percent, "%+.2f %%", each.percent());
      change = percent;
    }
    std::snprintf(line, sizeof line, "%-20s %12s %12s %9s  %s", each.workload.c_str(),
                  in_millions(each.recorded).c_str(), in_millions(each.counted).c_str(), change.c_str(),
                  words_of(each.verdict));
    table += std::string(trimmed(line)) + "\n";
  }
  return table;
}

}  // namespace tuberia::bench
