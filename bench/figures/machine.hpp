#pragma once
// What a page of figures must say about where they come from.

#include <string>

namespace tuberia::bench {

struct Machine {
  std::string processor = "an unknown processor", compiler, date, commit;
  int cores = 1;
  double clock_hertz = 0;  // measured
};

/// commit: what the script says of the sources; may be empty. Takes a tenth of a second: the clock
/// is measured, because the time-stamp counter and the system tell only its nominal rate.
Machine this_machine(const std::string& commit);

/// One line of text.
std::string sentence_of(const Machine& machine);

}  // namespace tuberia::bench
