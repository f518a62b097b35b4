#include "reference/ray_tracer/accelerators/none.hpp"

namespace tuberia::tracer {

void NoAccelerator::search(Search& search) const noexcept {
  const auto count = static_cast<std::uint32_t>(items().count());
  for (std::uint32_t item = 0; item < count && !search.is_over(); ++item) search.ask(item);
}

}  // namespace tuberia::tracer
