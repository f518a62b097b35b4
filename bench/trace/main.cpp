// How fast rays find what they meet: script/bench trace.

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "bench/figures/command_line.hpp"
#include "bench/figures/machine.hpp"
#include "bench/figures/page.hpp"
#include "bench/figures/text_file.hpp"
#include "bench/trace/section.hpp"

namespace tuberia::bench {
namespace {

struct NamedSection {
  const char* name;
  TraceSection (*measure)(const TraceOptions&);
};
constexpr NamedSection kSections[] = {{"accelerators", accelerators_section}, {"claim", claim_section}, {"embree", embree_section}};

struct Options {
  std::vector<std::string> names;
  std::string page_file = "out/bench/trace.html", json_file, markdown_file, commit;
  TraceOptions trace{.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 64u))};
};

void add_options(CommandLine& line, Options& options) {
  std::vector<std::string> names;
  for (const NamedSection& section : kSections) names.emplace_back(section.name);
  line.words("section", options.names, "Only these sections", names);
  line.flag("--quick", options.trace.quick, "Smaller scenes and fewer rounds: to try it out, not to quote");
  line.whole("--threads", options.trace.threads, 1, 64, "How many threads build");
  line.page(options.page_file);
  line.json(options.json_file);
  line.text("--markdown", options.markdown_file, "Write the tables to this file, too");
  line.commit(options.commit);
}

int fail(const std::string& message) {
  std::fprintf(stderr, "script/bench trace: %s\n", message.c_str());
  return 1;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

int run(const Options& options) {
  const std::string machine = sentence_of(this_machine(options.commit));
  std::printf("%s\n", machine.c_str());
  const std::string warning = options.trace.quick ? " <span class=\"alarm\">A quick run: not to be quoted.</span>" : "";
  Page page("How fast rays find what they meet", escaped(machine) + warning);
  std::string markdown, json = "{\"machine\": " + quoted(machine), complaints;
  for (const NamedSection& section : kSections) {
    if (!options.names.empty() && std::find(options.names.begin(), options.names.end(), section.name) == options.names.end()) continue;
    const TraceSection measured = section.measure(options.trace);
    const std::string text = "\n### " + measured.heading + "\n\n" + measured.markdown;
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
    markdown += text;
    json += ",\n" + quoted(measured.json_name) + ": " + measured.json;
    page.add_section(measured.heading, measured.html);
    if (!measured.complaint.empty()) complaints += (complaints.empty() ? "" : "; ") + measured.complaint;
  }
  if (const auto written = page.write(options.page_file); !written) return fail(written.error().message);
  if (const auto written = write_text(options.json_file, json + "}\n"); !written) return fail(written.error().message);
  if (const auto written = write_text(options.markdown_file, markdown); !written) return fail(written.error().message);
  std::printf("\nThe page: %s\n", options.page_file.c_str());
  return complaints.empty() ? 0 : fail(complaints);
}

}  // namespace
}  // namespace tuberia::bench

int main(int argc, char** argv) {
  tuberia::bench::CommandLine line("Measures how fast rays find what they meet, and writes a page.", "tuberia_trace");
  tuberia::bench::Options options;
  tuberia::bench::add_options(line, options);
  if (const auto status = line.parse(argc, argv)) return *status;
  return tuberia::bench::run(options);
}
