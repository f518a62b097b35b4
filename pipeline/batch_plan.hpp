#pragma once
// Into which pieces a draw's primitives are cut.

#include <algorithm>
#include <cstdint>

#include "pipeline/vertex_fetch.hpp"

namespace tuberia {

/// Batches of chunks of primitives. Batches and chunks are numbered in the order of submission, the last ones may be smaller.
struct BatchPlan {
  std::int64_t primitives = 0;
  std::int64_t primitives_per_chunk = 1;
  std::int64_t chunks_per_batch = 1;

  std::int64_t chunks() const noexcept { return (primitives + primitives_per_chunk - 1) / primitives_per_chunk; }
  std::int64_t batches() const noexcept { return (chunks() + chunks_per_batch - 1) / chunks_per_batch; }
  std::int64_t chunks(std::int64_t batch) const noexcept { return std::min(chunks_per_batch, chunks() - batch * chunks_per_batch); }
  std::int64_t most_chunks() const noexcept { return std::min(chunks_per_batch, chunks()); }

  PrimitiveRange range(std::int64_t batch, std::int64_t chunk) const noexcept {
    const std::int64_t first = (batch * chunks_per_batch + chunk) * primitives_per_chunk;
    return {first, static_cast<int>(std::min(primitives_per_chunk, primitives - first))};
  }
};

}  // namespace tuberia
