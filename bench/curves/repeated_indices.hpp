#pragma once
// An index list of any length that occupies the memory of one period.

#include <cstdint>
#include <span>

#include "base/result.hpp"

namespace tuberia::bench {

/// The same pages of a file in memory, mapped one after the other as often as needed. So a mesh of
/// 100 million triangles can be handed over in one draw without storing it: 1.2 GB of addresses, but
/// less than a megabyte of memory.
class RepeatedIndices {
 public:
  /// period: a multiple of 3 indices whose bytes fill whole pages. Error when the system refuses.
  static Result<RepeatedIndices> create(std::span<const std::uint32_t> period, std::size_t indices);

  RepeatedIndices(RepeatedIndices&& other) noexcept;
  RepeatedIndices& operator=(RepeatedIndices&&) = delete;
  ~RepeatedIndices();

  std::span<const std::uint32_t> indices() const noexcept { return {first_, count_}; }

 private:
  RepeatedIndices(const std::uint32_t* first, std::size_t count, std::size_t mapped_bytes)
      : first_(first), count_(count), mapped_bytes_(mapped_bytes) {}

  const std::uint32_t* first_;
  std::size_t count_, mapped_bytes_;
};

}  // namespace tuberia::bench
