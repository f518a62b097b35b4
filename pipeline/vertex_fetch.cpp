#include "pipeline/vertex_fetch.hpp"

#include <algorithm>
#include <cstring>

namespace tuberia {
namespace {

/// Calls fetch(element) for the elements of a range of primitives, in the order of primitive assembly.
template <class Fetch>
void fetch_elements(std::int64_t elements, Topology topology, PrimitiveRange range, const Fetch& fetch) {
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
    case Topology::line_loop:
      fetch_run(first, std::min(end + 1, elements));
      if (end == elements) fetch(0);  // the last line goes back to where the first one began
      return;
    case Topology::points: return fetch_run(first, end);
  }
}

}  // namespace

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
  std::memset(cache_.data(), 0xff, sizeof cache_);  // no vertex has that number
  batch.clipped.clear();
  // As many as there can be, so that the loop need not ask; cut to what came at the end.
  const std::size_t most = 3 * static_cast<std::size_t>(range.count) + 2;
  slots.resize(most);
  make_room(source_, most);
  std::uint32_t* next_slot = slots.data();
  std::uint32_t* const source = source_.data();
  std::uint32_t vertices = 0;

  const glm::vec3* const positions = mesh.positions.empty() ? nullptr : mesh.positions.data();
  const std::uint32_t* const indices = mesh.indices.empty() ? nullptr : mesh.indices.data();
  const auto fetch = [&](std::int64_t element) {
    const std::uint32_t vertex = indices == nullptr ? static_cast<std::uint32_t>(element) : indices[element];
    Entry& entry = cache_[vertex % kEntries];
    std::uint32_t slot = entry.slot;
    if (entry.vertex != vertex) {
      slot = vertices++;
      entry = {vertex, slot};
      source[slot] = vertex;
      if (positions != nullptr) __builtin_prefetch(positions + vertex);  // the next stage wants it
    }
    *next_slot++ = slot;
  };
  fetch_elements(static_cast<std::int64_t>(mesh.element_count()), topology, range, fetch);
  slots.resize(static_cast<std::size_t>(next_slot - slots.data()));
  batch.source.assign(source, source + vertices);
}

}  // namespace tuberia
