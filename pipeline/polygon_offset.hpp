#pragma once
// Polygon offset: depths pushed away from (or towards) the eye, the steeper the polygon the more.

#include <span>

#include "pipeline/state.hpp"
#include "pipeline/vertex_batch.hpp"

namespace tuberia {

class PolygonOffsetting {
 public:
  PolygonOffsetting(const PolygonOffset& state, DepthFormat format) noexcept : state_(state), format_(format) {}

  bool applies_to(PolygonMode mode) const noexcept;

  /// What the depth of the triangle with these slots grows by; 0 slope when it has no area. [rules Z3]
  double bias(const VertexBatch& vertices, std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept;

  /// Moves filled triangles.
  void move(const VertexBatch& vertices, std::span<ScreenTriangle> triangles) const noexcept;

 private:
  PolygonOffset state_;
  DepthFormat format_;
};

}  // namespace tuberia
