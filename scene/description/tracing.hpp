#pragma once
// How a picture is made of rays.                                                [B 5.5, 5.8]

#include <cstdint>
#include <glm/vec3.hpp>

namespace tuberia::description {

/// Where the samples of a pixel lie, and how they become its colour. Who draws triangles reads
/// Picture::supersampling instead.
struct Sampling {
  enum class Pattern : std::uint8_t { uniform, jittered };  // the centres of k x k equal parts, or a random point of each
  enum class Filter : std::uint8_t { box, gaussian };       // their mean, or weighted by the distance to the pixel's centre
  Pattern pattern = Pattern::uniform;
  int per_pixel = 1;                             // a square number, 1..1024
  bool adaptive = false;                         // so many only where the corners of a pixel, or of a part of it, differ much in contrast
  glm::dvec3 contrast{0.25, 0.20, 0.40};         // adaptive: above which (max - min) / (max + min) of red, green and blue a part is split
  Filter filter = Filter::box;
  double filter_radius = 1;                      // gaussian: pixels from the centre, in (0, 8]
  std::uint32_t seed = 1;                        // of jittered
  bool operator==(const Sampling&) const = default;
};

struct Tracing {
  int depth = 5;               // level of the last rays that are followed, eye rays being 0; 0..1000
  double least_weight = 0;     // branches that weigh less are not followed, 0..1
  Sampling sampling;
  bool operator==(const Tracing&) const = default;
};

}  // namespace tuberia::description
