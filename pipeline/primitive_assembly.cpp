#include "pipeline/primitive_assembly.hpp"

#include <algorithm>
#include <numeric>

namespace tuberia {

void PrimitiveAssembly::operator()(std::span<const std::uint32_t> slots, PrimitiveRange range, TriangleBatch& out) const {
  out.resize(range.count);
  const auto count = static_cast<std::size_t>(range.count);
  const std::uint32_t* const from = slots.data();
  std::uint32_t *const v0 = out.v0.data(), *const v1 = out.v1.data(), *const v2 = out.v2.data();
  if (topology_ == Topology::triangles) {
    for (std::size_t i = 0; i < count; ++i) v0[i] = from[3 * i], v1[i] = from[3 * i + 1], v2[i] = from[3 * i + 2];
  } else if (topology_ == Topology::triangle_strip) {
    // Every other triangle of a strip would turn round; two of its vertices change places.
    const auto odd_one = static_cast<std::size_t>(range.first % 2 == 0);
    for (std::size_t i = 0; i < count; ++i) {
      const bool odd = i % 2 == odd_one;
      v0[i] = from[i];
      v1[i] = from[odd ? i + 2 : i + 1];
      v2[i] = from[odd ? i + 1 : i + 2];
    }
  } else {
    for (std::size_t i = 0; i < count; ++i) v0[i] = from[i + 1], v1[i] = from[i + 2], v2[i] = from[0];
  }
  std::copy_n(v0, count, out.provoking.data());
  std::iota(out.primitive.data(), out.primitive.data() + count, static_cast<std::uint32_t>(range.first));
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
