#include "bench/curves/memory.hpp"

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>

namespace tuberia::bench {
namespace {

std::atomic<std::int64_t> in_use{0}, peak{0};

void note_taken(void* memory) noexcept {
  const std::int64_t now = in_use += static_cast<std::int64_t>(malloc_usable_size(memory));
  std::int64_t most = peak.load(std::memory_order_relaxed);
  while (now > most && !peak.compare_exchange_weak(most, now)) {}
}

std::int64_t bytes_after(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key)) return 1024 * std::strtoll(line.c_str() + key.size(), nullptr, 10);
  return 0;
}

}  // namespace

std::int64_t heap_bytes() noexcept { return in_use; }
std::int64_t heap_peak_bytes() noexcept { return peak; }
void restart_heap_peak() noexcept { peak = in_use.load(); }
std::int64_t private_resident_bytes() { return bytes_after("/proc/self/status", "RssAnon:"); }
std::int64_t available_bytes() { return bytes_after("/proc/meminfo", "MemAvailable:"); }

/// What the operators below have in common.
void* take_counted(std::size_t bytes, std::size_t alignment) {
  void* memory = alignment <= alignof(std::max_align_t)
                     ? std::malloc(bytes)
                     : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  note_taken(memory);
  return memory;
}

void give_counted(void* memory) noexcept {
  if (memory == nullptr) return;
  in_use -= static_cast<std::int64_t>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace tuberia::bench

// The forms that the standard's other ones call.
void* operator new(std::size_t bytes) { return tuberia::bench::take_counted(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return tuberia::bench::take_counted(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { tuberia::bench::give_counted(memory); }
void operator delete(void* memory, std::size_t) noexcept { tuberia::bench::give_counted(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { tuberia::bench::give_counted(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { tuberia::bench::give_counted(memory); }
