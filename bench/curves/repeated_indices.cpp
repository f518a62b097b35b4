#include "bench/curves/repeated_indices.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "base/assertion.hpp"

namespace tuberia::bench {
namespace {

Error system_error(const char* what) { return Error{std::string(what) + ": " + std::strerror(errno)}; }

/// A file without a name, closed when this goes.
struct MemoryFile {
  int descriptor = memfd_create("tuberia_indices", 0);
  MemoryFile() = default;
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    if (descriptor >= 0) close(descriptor);
  }
};

}  // namespace

Result<RepeatedIndices> RepeatedIndices::create(std::span<const std::uint32_t> period, std::size_t indices) {
  const std::size_t bytes = period.size_bytes();
  TUBERIA_ASSERT(bytes > 0 && bytes % static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) == 0,
                 "a period fills whole pages");
  const MemoryFile file;
  if (file.descriptor < 0) return system_error("no file in memory");
  if (write(file.descriptor, period.data(), bytes) != static_cast<ssize_t>(bytes))
    return system_error("cannot write the indices");

  // Addresses for all of it, then the file's pages into each piece.
  const std::size_t pieces = (indices + period.size() - 1) / period.size();
  void* const all = mmap(nullptr, pieces * bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (all == MAP_FAILED) return system_error("no addresses for the indices");
  RepeatedIndices repeated(static_cast<const std::uint32_t*>(all), indices, pieces * bytes);
  for (std::size_t i = 0; i < pieces; ++i) {
    void* const piece = static_cast<char*>(all) + i * bytes;
    if (mmap(piece, bytes, PROT_READ, MAP_SHARED | MAP_FIXED | MAP_POPULATE, file.descriptor, 0) == MAP_FAILED)
      return system_error("cannot map the indices");
  }
  return Result<RepeatedIndices>(std::move(repeated));
}

RepeatedIndices::RepeatedIndices(RepeatedIndices&& other) noexcept
    : first_(std::exchange(other.first_, nullptr)),
      count_(std::exchange(other.count_, 0)),
      mapped_bytes_(std::exchange(other.mapped_bytes_, 0)) {}

RepeatedIndices::~RepeatedIndices() {
  if (first_ != nullptr) munmap(const_cast<std::uint32_t*>(first_), mapped_bytes_);
}

}  // namespace tuberia::bench
