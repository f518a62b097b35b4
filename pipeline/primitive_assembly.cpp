#include "pipeline/primitive_assembly.hpp"

namespace tuberia {

void PrimitiveAssembly::operator()(std::span<const std::uint32_t> slots, PrimitiveRange range, TriangleBatch& out) const {
  out.resize(range.count);
  for (std::size_t i = 0; i < static_cast<std::size_t>(range.count); ++i) {
    std::size_t first = 3 * i, second = 3 * i + 1, third = 3 * i + 2;
    if (topology_ == Topology::triangle_strip) {
      // Every other triangle of a strip would turn round; two of its vertices change places.
      const bool odd = (range.first + static_cast<std::int64_t>(i)) % 2 != 0;
      first = i;
      second = odd ? i + 2 : i + 1;
      third = odd ? i + 1 : i + 2;
    } else if (topology_ == Topology::triangle_fan) {
      first = i + 1;
      second = i + 2;
      third = 0;
    }
    out.v0[i] = slots[first];
    out.v1[i] = slots[second];
    out.v2[i] = slots[third];
    out.provoking[i] = slots[first];
    out.primitive[i] = static_cast<std::uint32_t>(range.first + static_cast<std::int64_t>(i));
  }
}

void PrimitiveAssembly::operator()(std::span<const std::uint32_t> slots, PrimitiveRange range, LineBatch& out) const {
  out.resize(static_cast<std::size_t>(range.count));
  const std::size_t step = topology_ == Topology::lines ? 2 : 1;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = {.v0 = slots[step * i], .v1 = slots[step * i + 1], .provoking = slots[step * i],
              .primitive = static_cast<std::uint32_t>(range.first + static_cast<std::int64_t>(i)),
              .begins_pattern = topology_ == Topology::lines};
}

void PrimitiveAssembly::operator()(std::span<const std::uint32_t> slots, PrimitiveRange range, PointBatch& out) const {
  out.resize(static_cast<std::size_t>(range.count));
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = {.vertex = slots[i], .provoking = slots[i],
              .primitive = static_cast<std::uint32_t>(range.first + static_cast<std::int64_t>(i))};
}

}  // namespace tuberia
