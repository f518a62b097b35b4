#pragma once
// How far a picture is.

#include <chrono>
#include <functional>
#include <mutex>

namespace tuberia::tracer {

/// How far along, 0..1, and how long it will still take, in seconds, judged by what is done. One call at a time, of any thread.
using TraceProgress = std::function<void(double done, double seconds_left)>;

/// Adds up what workers have done, and tells it.
class ProgressReport {
 public:
  ProgressReport(const TraceProgress& progress, double whole) : progress_(progress), whole_(whole) {}

  void add(double part) {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    done_ += part;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    progress_(done_ / whole_, seconds * (whole_ - done_) / done_);
  }

 private:
  const TraceProgress& progress_;
  double whole_, done_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
};

}  // namespace tuberia::tracer
