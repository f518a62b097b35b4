#pragma once
// The picture as [C] has it: every ray asks every item.

#include "reference/ray_tracer/accelerators/search.hpp"

namespace tuberia::tracer {

class NoAccelerator final : public SearchingAccelerator {
 public:
  explicit NoAccelerator(const Items& items) : SearchingAccelerator(items) {}

 private:
  void search(Search& search) const noexcept override;
};

}  // namespace tuberia::tracer
