#include <algorithm>
#include <array>
#include <cstdio>

#include "bench/account/report.hpp"

namespace tuberia::bench {
namespace {

// Items that are shown in one colour, so that colours stay few enough to be told apart.
struct Group {
  const char* name;
  Item first, last;
};
constexpr std::array<Group, 8> kGroups{{{"clear, validation", Item::clear, Item::validation},
                                        {"vertex fetch, transform", Item::fetch, Item::transform},
                                        {"assembly, clipping, divide, culling", Item::assembly, Item::culling},
                                        {"attributes", Item::attributes, Item::attributes},
                                        {"set-up, binning", Item::set_up, Item::binning},
                                        {"coverage, depth", Item::coverage_and_depth, Item::coverage_and_depth},
                                        {"shading, blending", Item::shading_and_blending, Item::shading_and_blending},
                                        {"between", Item::other, Item::other}}};

double seconds_of(const Account& account, const Group& group) {
  double sum = 0;
  for (int i = static_cast<int>(group.first); i <= static_cast<int>(group.last); ++i)
    sum += account.seconds[static_cast<std::size_t>(i)];
  return sum;
}

std::string percent(double part, double whole) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %%", whole > 0 ? 100 * part / whole : 0.0);
  return text;
}

std::string milliseconds(double seconds) {
  const double value = 1e3 * seconds;
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", value >= 100 ? 1 : value >= 10 ? 2 : 3, value);
  return text;
}

std::string plain(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// So that a table of many columns fits a page.
std::string in_two_lines(std::string_view words) {
  const std::size_t blank = words.find(' ');
  if (blank == std::string_view::npos) return std::string(words);
  return std::string(words.substr(0, blank)) + "<br>" + std::string(words.substr(blank + 1));
}

std::string per(double seconds, double count, double scale) {
  return count > 0 ? number_text(seconds * scale / count) : "-";
}

std::string colour_key() {
  std::string key = "<div class=\"key\">";
  for (std::size_t i = 0; i < kGroups.size(); ++i)
    key += "<span><span class=\"swatch\" style=\"background:var(--c" + std::to_string(i) + ")\"></span>" +
           kGroups[i].name + "</span>";
  return key + "</div>\n";
}

/// One bar a workload, each of the same length, divided as its time is.
std::string bars(std::span<const Account> accounts) {
  constexpr int kRow = 22, kLabels = 190, kWidth = 860, kTimes = 90;
  const int height = kRow * static_cast<int>(accounts.size()) + 4;
  std::string svg = "<svg viewBox=\"0 0 " + std::to_string(kLabels + kWidth + kTimes) + " " + std::to_string(height) +
                    "\" width=\"" + std::to_string(kLabels + kWidth + kTimes) + "\" role=\"img\">\n";
  int y = 2;
  for (const Account& account : accounts) {
    const std::string baseline = std::to_string(y + 15);
    svg += "<text x=\"" + std::to_string(kLabels - 8) + "\" y=\"" + baseline + "\" text-anchor=\"end\">" +
           escaped(account.workload) + "</text>";
    double x = kLabels;
    for (std::size_t i = 0; i < kGroups.size(); ++i) {
      const double seconds = seconds_of(account, kGroups[i]), width = kWidth * seconds / account.frame_seconds;
      char rectangle[200];
      std::snprintf(rectangle, sizeof rectangle,
                    "<rect x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"%d\" fill=\"var(--c%zu)\"><title>", x, y, width,
                    kRow - 4, i);
      svg += rectangle + std::string(kGroups[i].name) + ": " + milliseconds(seconds) + " ms, " +
             percent(seconds, account.frame_seconds) + "</title></rect>";
      x += width;
    }
    svg += "<text x=\"" + std::to_string(kLabels + kWidth + kTimes) + "\" y=\"" + baseline + "\" text-anchor=\"end\">" +
           milliseconds(account.frame_seconds) + " ms</text>\n";
    y += kRow;
  }
  return svg + "</svg>\n";
}

Table table_of_items(std::span<const Account> accounts) {
  Table table{.headings = {"milliseconds"}, .rows = {}};
  for (int i = 0; i < kItems; ++i) table.headings.push_back(in_two_lines(name_of(static_cast<Item>(i))));
  table.headings.push_back("frame");
  for (const Account& account : accounts) {
    std::vector<std::string> row{escaped(account.workload)};
    const Item largest = account.largest_item();
    for (int i = 0; i < kItems; ++i) {
      const std::string text = milliseconds(account.seconds[static_cast<std::size_t>(i)]);
      row.push_back(static_cast<Item>(i) == largest ? "<b>" + text + "</b>" : text);
    }
    row.push_back(milliseconds(account.frame_seconds));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table table_of_rates(std::span<const Account> accounts, double clock_hertz) {
  Table table{.headings = {"workload", "triangles", "drawn", "fragments", "visible", "geometry:<br>ns a<br>triangle",
                           "geometry:<br>cycles a<br>triangle", "coverage, depth:<br>cycles a<br>fragment",
                           "shading, blending:<br>cycles a<br>visible fragment", "tiles:<br>ns a<br>fragment",
                           "tiles:<br>cycles a<br>drawn triangle"},
              .rows = {}};
  for (const Account& account : accounts) {
    const auto triangles = static_cast<double>(account.triangles);
    const auto drawn = static_cast<double>(account.counts.triangles_drawn);
    const auto fragments = static_cast<double>(account.counts.fragments);
    const auto visible = static_cast<double>(account.visible);
    table.rows.push_back(
        {escaped(account.workload), count_text(triangles), count_text(drawn), count_text(fragments), count_text(visible),
         per(account.geometry_seconds(), triangles, 1e9), per(account.geometry_seconds(), triangles, clock_hertz),
         per(account.of(Item::coverage_and_depth), fragments, clock_hertz),
         per(account.of(Item::shading_and_blending), visible, clock_hertz), per(account.tile_seconds(), fragments, 1e9),
         per(account.tile_seconds(), drawn, clock_hertz)});
  }
  return table;
}

Table table_of_bounds(std::span<const Account> accounts, double clock_hertz) {
  Table table{.headings = {"workload", "frame ms", "memory ms", "first cache ms", "texels ms", "largest bound / frame"},
              .rows = {}};
  const bool counted =
      std::any_of(accounts.begin(), accounts.end(), [](const Account& account) { return account.instructions > 0; });
  if (counted)
    table.headings.insert(table.headings.end() - 1,
                          {"million<br>instructions", "instructions ms", "instructions<br>a cycle"});
  for (const Account& account : accounts) {
    std::vector<std::string> row{escaped(account.workload), milliseconds(account.frame_seconds),
                                 milliseconds(account.bounds.memory), milliseconds(account.bounds.first_cache),
                                 milliseconds(account.bounds.texels)};
    if (counted) {
      const auto instructions = static_cast<double>(account.instructions);
      row.push_back(number_text(1e-6 * instructions));
      row.push_back(milliseconds(account.bounds.instructions));
      row.push_back(number_text(instructions / (account.frame_seconds * clock_hertz)));
    }
    row.push_back(percent(account.bounds.largest(), account.frame_seconds));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table table_of_schedules(std::span<const Account> accounts) {
  Table table{.headings = {"workload", "work<br>ms", "alone<br>ms", "longest<br>chain ms"}, .rows = {}};
  for (const int threads : kSimulatedThreads)
    table.headings.push_back("balance,<br>" + std::to_string(threads) + " thr.");
  table.headings.push_back("gain of 64<br>simulated");
  table.headings.push_back("gain of 2<br>simulated");
  table.headings.push_back("gain of 2<br>measured");
  for (const Account& account : accounts) {
    const Work& work = account.work;
    std::vector<std::string> row{escaped(account.workload), milliseconds(work.total()), milliseconds(work.alone),
                                 milliseconds(work.longest_chain(kMostSimulatedThreads))};
    for (const int threads : kSimulatedThreads) row.push_back(percent(work.balance(threads), 1));
    row.push_back(number_text(work.total() / work.duration(kMostSimulatedThreads)));
    row.push_back(number_text(work.total() / work.duration(2)));
    const std::string measured = number_text(account.speed_up_of_two);
    row.push_back(scales_too_little(account) ? "<span class=\"alarm\">" + measured + "</span>" : measured);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string limits_sentence(const MachineLimits& limits) {
  return "Each bound is what the frame would take if only this were to be done, on one core: "
         "<b>memory</b>, vertices and indices read once and the target written once, at " +
         plain(limits.memory_bytes_per_second * 1e-9) +
         " GB/s; <b>first cache</b>, depth and colour of every visible fragment, at " +
         plain(limits.first_cache_bytes_per_second * 1e-9) +
         " GB/s; <b>texels</b>, 1, 4 or 8 a visible fragment, at " + plain(limits.texels_per_second * 1e-9) +
         " G/s; <b>instructions</b>, where they were counted, " + plain(limits.instructions_per_cycle) + " a cycle.";
}

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

constexpr const char* kAboutStages = R"(A clock is read between the stages of every chunk and around every tile. Coverage
with depth is what the tiles take when no colour is written; shading with blending is the rest. Hover for figures.)";

constexpr const char* kAboutCycles = R"(At the measured clock. Geometry is everything from vertex fetch to binning.
Visible are those fragments that must be shaded: of opaque draws one a pixel that is covered, of blended ones all that
pass the depth test.)";

constexpr const char* kAboutSchedule = R"(The durations of all chunks and tiles, as measured on one thread, dealt to more
threads: whoever is free takes the next tile, or a chunk of the next batch, and tiles wait for the chunks of theirs, as in a draw, whose batches
are the larger the more threads there are. <b>Balance</b> is work / (threads &times; duration). The longest chain is what 64 threads cannot
beat. The last column is measured, the least frame on one thread over the least on two, in turns; below )";

}  // namespace

Page account_page(std::span<const Account> accounts, const Machine& machine, const AccountOptions& options) {
  const std::string precision = options.precision == Precision::exact ? "exact" : "fast";
  Page page("Where the time goes", escaped(sentence_of(machine)) + ". One thread, " +
                                       std::string(name_of(options.instruction_set)) + ", " + precision +
                                       " precision; of every piece the shortest time of " +
                                       std::to_string(options.frames) + " frames.");
  page.add_section("Each frame, by stage", paragraph(kAboutStages) + colour_key() + bars(accounts));
  page.add_section("Milliseconds", paragraph("The largest item of each row is bold.") + table_of_items(accounts).html());
  page.add_section("Cycles", paragraph(kAboutCycles) + table_of_rates(accounts, machine.clock_hertz).html());
  page.add_section("Bounds", paragraph(limits_sentence(options.limits)) +
                                 table_of_bounds(accounts, machine.clock_hertz).html());
  const std::string marked = kAboutSchedule + plain(kSpeedUpOfTwo) + " it is marked, for frames over " +
                             plain(1e3 * kSpeedUpFromSeconds) + " ms.";
  page.add_section("Schedule", paragraph(marked) + table_of_schedules(accounts).html());
  return page;
}

}  // namespace tuberia::bench
