#include "pipeline/vertex_fetch.hpp"

#include <algorithm>

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

  const std::int64_t first = range.first, end = range.first + range.count;
  const auto fetch_run = [&](std::int64_t from, std::int64_t to) {
    for (std::int64_t e = from; e < to; ++e) fetch(e);
  };
  switch (topology) {
    case Topology::triangles: return fetch_run(3 * first, 3 * end);
    case Topology::triangle_strip: return fetch_run(first, end + 2);
    case Topology::triangle_fan:
      fetch(0);
      return fetch_run(first + 1, end + 2);
    case Topology::lines: return fetch_run(2 * first, 2 * end);
    case Topology::line_strip: return fetch_run(first, end + 1);
    case Topology::line_loop: {
      const auto elements = static_cast<std::int64_t>(mesh.element_count());
      fetch_run(first, std::min(end + 1, elements));
      if (end == elements) fetch(0);  // the last line goes back to where the first one began
      return;
    }
    case Topology::points: return fetch_run(first, end);
  }
}

}  // namespace tuberia
