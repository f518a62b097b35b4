#pragma once
// What a long measurement says meanwhile.

#include <chrono>
#include <cstdio>
#include <string>

namespace tuberia::bench::trade {

/// Lines of progress, with the time since the beginning.
class Progress {
 public:
  void tell(const std::string& what, const std::string& scene, std::size_t settings) const {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    std::printf("%5.0f s  %-34s %-30s %3zu settings\n", seconds, what.c_str(), scene.c_str(), settings);
    std::fflush(stdout);
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace tuberia::bench::trade
