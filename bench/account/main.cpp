// Where each frame's time goes, and how it would scale: script/bench account.

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/account/report.hpp"
#include "bench/figures/command_line.hpp"
#include "bench/guard/counting.hpp"

namespace tuberia::bench {
namespace {

struct Options {
  std::vector<std::string> prefixes;
  std::string page_file = "out/bench/account.html", json_file, instruction_set, precision = "exact", commit, drawn;
  int frames = 7;
  bool instructions = false;
};

int fail(const std::string& message) {
  std::fprintf(stderr, "script/bench account: %s\n", message.c_str());
  return 1;
}

void add_options(CommandLine& line, Options& options) {
  line.words("workload", options.prefixes, "Only workloads whose names begin with one of these");
  line.whole("--frames", options.frames, 1, 1000, "Frames of each workload; of every piece the shortest time counts");
  line.page(options.page_file);
  line.json(options.json_file);
  line.instruction_set(options.instruction_set);
  line.precision(options.precision);
  line.flag("--instructions", options.instructions, "Count instructions, too, with callgrind: minutes; only with --isa avx2");
  line.text("--draw", options.drawn, "Only draw this workload: what runs under callgrind");
  line.commit(options.commit);
}

bool is_chosen(const std::string& name, const std::vector<std::string>& prefixes) {
  return prefixes.empty() || std::any_of(prefixes.begin(), prefixes.end(),
                                         [&](const std::string& prefix) { return name.starts_with(prefix); });
}

Result<AccountOptions> account_options(const Options& options) {
  AccountOptions account{.precision = options.precision == "exact" ? Precision::exact : Precision::fast,
                         .frames = options.frames};
  const auto chosen = instruction_set_from(options.instruction_set);
  if (!chosen) return chosen.error();
  account.instruction_set = *chosen;
  return account;
}

Result<Nothing> count(Account& account, const MachineLimits& limits, double clock_hertz, const ScratchFolder& scratch) {
  const auto counted = count_instructions(account.workload, scratch);
  if (!counted) return counted.error();
  account.instructions = *counted;
  account.bounds.instructions = static_cast<double>(*counted) / (limits.instructions_per_cycle * clock_hertz);
  return Nothing{};
}

Result<std::vector<Account>> all_accounts(const Options& options, const AccountOptions& how, double clock_hertz) {
  const ScratchFolder scratch;
  std::vector<Account> accounts;
  for (const std::string& name : workload_names()) {
    if (!is_chosen(name, options.prefixes)) continue;
    const auto workload = make_workload(name);
    if (!workload) return Error{name + ": " + workload.error().message};
    auto account = account_for(*workload, how);
    if (!account) return Error{name + ": " + account.error().message};
    if (options.instructions)
      if (const auto counted = count(*account, how.limits, clock_hertz, scratch); !counted) return counted.error();
    if (accounts.empty()) print_account_heading();
    print(*account, clock_hertz);
    accounts.push_back(*std::move(account));
  }
  if (accounts.empty()) return Error{"no workload has such a name"};
  return accounts;
}

int run(const Options& options) {
  if (!options.drawn.empty()) {
    const auto drawn = draw_counted_frame(options.drawn);
    return drawn ? 0 : fail(drawn.error().message);
  }
  const auto how = account_options(options);
  if (!how) return fail(how.error().message);
  if (options.instructions && how->instruction_set != InstructionSet::avx2)
    return fail("--instructions counts AVX2 instructions, so it needs --isa avx2");
  const Machine machine = this_machine(options.commit);
  std::printf("%s\n\n", sentence_of(machine).c_str());
  const auto accounts = all_accounts(options, *how, machine.clock_hertz);
  if (!accounts) return fail(accounts.error().message);
  if (const auto written = account_page(*accounts, machine, *how).write(options.page_file); !written)
    return fail(written.error().message);
  if (!options.json_file.empty())
    if (const auto written = write_json(options.json_file, *accounts, machine); !written)
      return fail(written.error().message);
  std::printf("\nThe page: %s\n", options.page_file.c_str());
  return 0;
}

}  // namespace
}  // namespace tuberia::bench

int main(int argc, char** argv) {
  tuberia::bench::CommandLine line("Says where each workload's frame spends its time, against what bounds, and how it would scale.", "tuberia_account");
  tuberia::bench::Options options;
  tuberia::bench::add_options(line, options);
  if (const auto status = line.parse(argc, argv)) return *status;
  return tuberia::bench::run(options);
}
