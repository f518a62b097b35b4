#pragma once
// The accounts of all workloads, for people and for programs.

#include <span>
#include <string>

#include "bench/account/account.hpp"
#include "bench/figures/machine.hpp"
#include "bench/figures/page.hpp"

namespace tuberia::bench {

/// For how many threads the schedule is simulated.
inline constexpr int kSimulatedThreads[] = {2, 4, 8, 16, 32, 64};
inline constexpr int kMostSimulatedThreads = 64;

/// What two threads must gain on a frame that takes so long on one.
inline constexpr double kSpeedUpOfTwo = 1.85, kSpeedUpFromSeconds = 0.010;

/// Whether the measured gain of a second thread is less than it must be.
bool scales_too_little(const Account& account) noexcept;

/// Lines for the terminal.
void print_account_heading();
void print(const Account& account, double clock_hertz);

Page account_page(std::span<const Account> accounts, const Machine& machine, const AccountOptions& options);

Result<Nothing> write_json(const std::string& path, std::span<const Account> accounts, const Machine& machine);

}  // namespace tuberia::bench
