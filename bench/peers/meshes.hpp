#pragma once
// The geometry that the peers draw: made by formulas and hashes, so that every program that
// follows them draws the same triangles. Counter-clockwise is front.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia::bench {

/// Triangles with everything a workload may read a vertex. The four vertex arrays have the same
/// size; indices come in threes.
struct WorkloadMesh {
  std::vector<glm::vec3> positions;  // object space
  std::vector<glm::vec3> normals;    // unit
  std::vector<glm::vec2> texture_coordinates;
  std::vector<Rgba8> colours;
  std::vector<std::uint32_t> indices;
  std::size_t second_texture_begins = 0;  // indices from here on use texture 1, those before it 0
};

/// In which order the layers of a mesh come.
enum class LayerOrder { back_to_front, front_to_back };

/// `layers` quads that fill clip space (w = 1), z from 0.9 to -0.9 or the reverse. smooth: a colour
/// a vertex, otherwise a colour a quad.
WorkloadMesh filling_quads(int layers, bool smooth, std::uint8_t alpha, LayerOrder order);

/// `layers` planes, nearer and nearer, that each fill the view of a 60-degree perspective of this
/// aspect. They lean away by 38 degrees: a texture is magnified below and minified above.
WorkloadMesh leaning_planes(int layers, float aspect);

/// A columns x rows grid of quads that fills clip space (w = 1), `layers` times. Inner vertices are
/// moved by up to a quarter of a cell, so that edges have every slope.
WorkloadMesh jittered_grids(int columns, int rows, int layers, LayerOrder order);

/// The unit sphere of segments x segments quads.
WorkloadMesh unit_sphere(int segments);

/// A Wavefront file of `v x y z` and `f a b c` lines, centred and scaled to height 2, white, with
/// smooth normals. Error when it cannot be opened or is empty.
Result<WorkloadMesh> model_of_height_2(const std::filesystem::path& path);

/// Each triangle split in four at its edges' midpoints, which are pulled towards the curved surface
/// that the normals suggest.
WorkloadMesh subdivided(const WorkloadMesh& coarse);

/// A floor (texture 0) with blocks x blocks boxes of different heights (texture 1) on it; 3 units a
/// block, the centre at the origin.
WorkloadMesh city(int blocks);

/// A size x size checkerboard with noise, opaque. `variant` chooses the noise.
Image<Rgba8> noisy_checkerboard(int size, std::uint32_t variant);

}  // namespace tuberia::bench
