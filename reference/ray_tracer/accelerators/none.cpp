#include "reference/ray_tracer/accelerators/none.hpp"

namespace tuberia::tracer {

void NoAccelerator::search(Search& search) const noexcept { search.ask_all(); }

}  // namespace tuberia::tracer
