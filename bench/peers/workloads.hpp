#pragma once
// What the peers draw: a mesh, two matrices and a little fixed-function state, in terms that
// OpenGL and Tuberia share.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "bench/peers/meshes.hpp"
#include "image/image.hpp"

namespace tuberia::bench {

/// How a workload reads its textures, magnified / minified; `none` means untextured. Wrap repeats.
enum class Filter {
  none,
  nearest,                 // nearest / nearest, level 0 only
  linear,                  // linear / linear, level 0 only
  nearest_mipmap_nearest,  // nearest / nearest in the nearest level
  linear_mipmap_nearest,   // linear / linear in the nearest level
  linear_mipmap_linear,    // linear / trilinear
};

inline constexpr int kTextureSizeTexels = 1024;  // each way

/// One kind of frame: clear colour to (0, 0, 0, 0) and depth to 1, then draw the mesh (if any).
/// Clip volume -w <= z <= w; depth passes when less; counter-clockwise is front.
/// Colour of a fragment: lit, Gouraud, by kLighting when `lit`; white when only textured; else the
/// vertices' colours. It is multiplied by the texture, if there is one.
struct Workload {
  std::string name{};
  WorkloadMesh mesh{};
  glm::mat4 view_from_object{1.0f}, clip_from_view{1.0f};
  Filter filter = Filter::none;
  bool flat = false;         // the colour of the triangle's last vertex, not interpolated
  bool depth_test = true;    // without it depth is not written either
  bool blend = false;        // source alpha over target; depth is tested, not written
  bool cull_back = false;
  bool lit = false;
  bool specular = false;     // only read when lit
  bool depth_only = false;   // no colour target
  int width_pixels = 1920, height_pixels = 1080;
  int texture_size_texels = kTextureSizeTexels;
};

/// The one light and the one material of the lit workloads, as OpenGL 1.x computes them at each
/// vertex: clamp(ambient + diffuse max(0, N.L) + specular max(0, N.H)^shininess), where
/// H = normalize(L + (0, 0, 1)), no specular where N.L <= 0, alpha 1.
struct Lighting {
  glm::vec3 to_light{0.4f, 0.6f, 0.7f};    // view space, not unit
  glm::vec3 ambient{0.18f, 0.18f, 0.18f};  // material 0.15 x (light 1 + OpenGL's scene ambient 0.2)
  glm::vec3 diffuse{0.75f, 0.7f, 0.6f};
  float specular = 1.0f;
  float shininess = 32.0f;
};
inline constexpr Lighting kLighting{};

/// The two textures of the textured workloads, square, linear codes; make mipmaps by box.
std::vector<Image<Rgba8>> workload_textures(int size_texels = kTextureSizeTexels);

/// All workloads, in the order in which they are run.
std::vector<std::string> workload_names();

/// Error for an unknown name, or when the bunny's file is not installed (Debian: glmark2-data).
Result<Workload> make_workload(std::string_view name);

}  // namespace tuberia::bench
