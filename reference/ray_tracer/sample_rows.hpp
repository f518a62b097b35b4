#pragma once
// The samples of a picture, no more of them at once than filters reach for.

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace tuberia::tracer {

/// The light of all cells of some rows of pixels, cells x cells a pixel; 24 bytes each.
class SampleRows {
 public:
  SampleRows(int width, int cells) : row_(width * cells), cells_(cells) {}

  int end() const noexcept { return end_; }
  /// Forgets what lies above row `first` and makes room up to row `end`.
  void hold(int first, int end) {
    light_.erase(light_.begin(), light_.begin() + offset(0, first * cells_));
    first_ = first;
    end_ = end;
    light_.resize(static_cast<std::size_t>(offset(0, end * cells_)));
  }
  glm::dvec3& at(const glm::ivec2& cell) noexcept { return light_[static_cast<std::size_t>(offset(cell.x, cell.y))]; }

 private:
  std::ptrdiff_t offset(int x, int y) const noexcept { return static_cast<std::ptrdiff_t>(y - first_ * cells_) * row_ + x; }

  int row_, cells_, first_ = 0, end_ = 0;
  std::vector<glm::dvec3> light_;
};

}  // namespace tuberia::tracer
