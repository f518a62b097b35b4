#include "bench/programs/page.hpp"

#include <algorithm>
#include <cstdio>

namespace tuberia::bench {
namespace {

std::string with(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

const ProgramCost& base_of(std::span<const ProgramCost> costs) {
  return *std::find_if(costs.begin(), costs.end(), [](const ProgramCost& c) { return c.kind == ProgramCost::Kind::base; });
}

/// What is added to the surface program is told from the programs that stand alone.
std::string label_of(const ProgramCost& cost) { return (cost.kind == ProgramCost::Kind::technique || cost.kind == ProgramCost::Kind::combination ? "+ " : "") + cost.name; }

/// What the figure beside the time is compared with: flat, or for what is added to the surface, its base.
struct Row {
  std::string name, exact, fast, by_flat, more, ratio;
};

Row row_of(const ProgramCost& cost, std::span<const ProgramCost> costs) {
  Row row{.name = label_of(cost), .exact = with("%.2f", cost.exact), .fast = with("%.2f", cost.fast), .by_flat = with("%.1f", cost.exact / costs.front().exact), .more = {}, .ratio = {}};
  const bool is_added = cost.kind == ProgramCost::Kind::technique || cost.kind == ProgramCost::Kind::combination;
  if (is_added) row.more = with("%+.2f", cost.exact - base_of(costs).exact);
  if (cost.exact_ratio) row.ratio = with("%.2f", *cost.exact_ratio) + ", " + with("%.2f", *cost.fast_ratio);
  return row;
}

const std::vector<std::string> kHeadings{"program", "exact, ns", "fast, ns", "exact / flat", "more than base, ns", "by sum of parts (exact, fast)"};

/// A bar for each program, its part that is more than the base in another colour.
std::string bars(std::span<const ProgramCost> costs) {
  constexpr int kRow = 20, kLabels = 680, kWidth = 400, kNumbers = 90;
  double largest = 0;
  for (const ProgramCost& c : costs) largest = std::max(largest, c.exact);
  const double base = base_of(costs).exact;
  std::string svg;
  int y = 2;
  for (const ProgramCost& c : costs) {
    const bool is_added = c.kind == ProgramCost::Kind::technique || c.kind == ProgramCost::Kind::combination;
    const double first = is_added ? std::min(base, c.exact) : c.exact;
    char shapes[512];
    std::snprintf(shapes, sizeof shapes,
                  "<text x=\"%d\" y=\"%d\" text-anchor=\"end\">%s</text>"
                  "<rect x=\"%d\" y=\"%d\" width=\"%.1f\" height=\"%d\" fill=\"var(--c0)\"/>"
                  "<rect x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"%d\" fill=\"var(--c1)\"/>"
                  "<text x=\"%.1f\" y=\"%d\">%.2f</text>\n",
                  kLabels - 8, y + 12, escaped(label_of(c)).c_str(), kLabels, y, kWidth * first / largest, kRow - 5, kLabels + kWidth * first / largest, y,
                  kWidth * (c.exact - first) / largest, kRow - 5, kLabels + kWidth * c.exact / largest + 6, y + 12, c.exact);
    svg += shapes;
    y += kRow;
  }
  const int width = kLabels + kWidth + kNumbers;
  return "<svg viewBox=\"0 0 " + std::to_string(width) + " " + std::to_string(y) + "\" width=\"" + std::to_string(width) + "\" role=\"img\">\n" + svg + "</svg>\n";
}

Table table_of(std::span<const ProgramCost> costs) {
  Table table{.headings = kHeadings, .rows = {}};
  for (const ProgramCost& c : costs) {
    const Row row = row_of(c, costs);
    table.rows.push_back({escaped(row.name), row.exact, row.fast, row.by_flat, row.more, row.ratio});
  }
  return table;
}

}  // namespace

std::string programs_text(std::span<const ProgramCost> costs) {
  std::string text;
  char line[200];
  std::snprintf(line, sizeof line, "%-64s %9s %9s %9s %9s  %s\n", "program", "exact ns", "fast ns", "by flat", "increment", "by sum of parts");
  text += line;
  for (const ProgramCost& c : costs) {
    const Row row = row_of(c, costs);
    std::snprintf(line, sizeof line, "%-64.64s %9s %9s %9s %9s  %s\n", row.name.c_str(), row.exact.c_str(), row.fast.c_str(), row.by_flat.c_str(), row.more.c_str(), row.ratio.c_str());
    text += line;
  }
  return text;
}

std::string programs_markdown(std::span<const ProgramCost> costs) {
  std::string text;
  for (const std::string& heading : kHeadings) text += "| " + heading + " ";
  text += "|\n|---|---:|---:|---:|---:|---:|\n";
  for (const ProgramCost& c : costs) {
    const Row row = row_of(c, costs);
    for (const std::string& cell : {row.name, row.exact, row.fast, row.by_flat, row.more, row.ratio}) text += "| " + cell + " ";
    text += "|\n";
  }
  return text;
}

Page programs_page(std::span<const ProgramCost> costs, const Machine& machine, const MeasureOptions& options, bool quick) {
  std::string lede = escaped(sentence_of(machine)) + ". " + std::string(name_of(options.instruction_set)) +
                     ", one thread, processor time. Nanoseconds of a fragment of one slanted square that fills 512 x 512 pixels; medians of rounds in which "
                     "every program had its turn, as ratios to flat in the same round.";
  if (quick) lede += " <span class=\"alarm\">A quick run: not to be quoted.</span>";
  Page page("What a fragment costs", lede);
  page.add_section("Every program, exact precision", "<p>The surface program adds techniques to its base, Lambert's law for one directional light; what they add is the second "
                                                     "part of a bar.</p>\n" + bars(costs));
  page.add_section("The figures", "<p>A combination may cost " + with("%.2f", kMostForCombination) + " times the sum of what its parts cost alone, over the base.</p>\n" + table_of(costs).html());
  return page;
}

}  // namespace tuberia::bench
