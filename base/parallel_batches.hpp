#pragma once
// Work in batches of two halves, on all threads, with hardly a wait between the halves.

#include <cstdint>
#include <span>

#include "base/parallel_for.hpp"

namespace tuberia {

/// Batch by batch, pieces are produced, gathered and consumed item by item: triangles by the chunk, then by the tile. What
/// is produced stays in a slot, a number for the memory that it lives in, until its batch is consumed.
class BatchedWork {
 public:
  virtual ~BatchedWork() = default;

  /// How many pieces the batch has: 1 or more, at most as many as parallel_batches was told. Asked at any time.
  virtual int pieces(std::int64_t batch) const noexcept = 0;
  /// Side by side with other pieces of this batch and of the next, and with items of the one before. Nobody else has the slot.
  virtual void produce(std::int64_t batch, int piece, int slot) = 0;
  /// Once a batch, in the order of the batches: when all its pieces are there and all items of the batches before are consumed.
  /// slots[i] has piece i. Returns how many items the batch has: 0 or more, below 2^32. Side by side with pieces of the next
  /// batch that have begun; nobody finds other work meanwhile, so be brief.
  virtual std::int64_t gather(std::int64_t batch, std::span<const int> slots) = 0;
  /// Of the batch gathered last: side by side with its other items. No two running calls share the worker.
  virtual void consume(std::int64_t item, int worker) = 0;
};

/// How many slots parallel_batches uses: those of a batch, and as many as there are threads to go ahead with.
int slot_count(const Workers& workers, int most_pieces) noexcept;

/// Does all of it and returns when it is done. What a call throws is thrown here; what has not begun is then left out.
void parallel_batches(Workers& workers, std::int64_t batches, int most_pieces, BatchedWork& work);

}  // namespace tuberia
