#include "pipeline/vertex_fetch.hpp"

namespace tuberia {

std::int64_t primitive_count(Topology topology, std::int64_t elements) noexcept {
  switch (topology) {
    case Topology::triangles: return elements / 3;
    case Topology::triangle_strip:
    case Topology::triangle_fan: return elements < 3 ? 0 : elements - 2;
    case Topology::lines: return elements / 2;
    case Topology::line_strip: return elements < 2 ? 0 : elements - 1;
    case Topology::line_loop: return elements < 2 ? 0 : elements;
    case Topology::points: break;
  }
  return elements;
}

void VertexFetch::operator()(const MeshView& mesh, Topology topology, PrimitiveRange range, VertexBatch& batch,
                             std::vector<std::uint32_t>& slots) {
  cache_.fill({kNothing, 0});
  batch.source.clear();
  batch.clipped.clear();
  slots.clear();

  const auto fetch = [&](std::int64_t element) {
    const auto at = static_cast<std::size_t>(element);
    const std::uint32_t vertex = mesh.indices.empty() ? static_cast<std::uint32_t>(at) : mesh.indices[at];
    Entry& entry = cache_[vertex % kEntries];
    if (entry.vertex != vertex) {
      entry = {vertex, static_cast<std::uint32_t>(batch.source.size())};
      batch.source.push_back(vertex);
    }
    slots.push_back(entry.slot);
  };

  switch (topology) {
    case Topology::triangles:
      for (std::int64_t e = 3 * range.first; e < 3 * (range.first + range.count); ++e) fetch(e);
      break;
    case Topology::triangle_strip:
      for (std::int64_t e = range.first; e < range.first + range.count + 2; ++e) fetch(e);
      break;
    case Topology::triangle_fan:
      fetch(0);
      for (std::int64_t e = range.first + 1; e < range.first + range.count + 2; ++e) fetch(e);
      break;
    default: break;
  }
}

}  // namespace tuberia
