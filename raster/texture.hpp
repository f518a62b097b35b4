#pragma once
// A texture with its mipmaps, ready to be sampled.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/aligned_vector.hpp"
#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// What the 8-bit codes of an image mean: intensities themselves, or sRGB codes of intensities
/// (photographs and painted textures). Alpha is linear in both.
enum class TextureEncoding : std::uint8_t { linear, srgb };

/// A row, a rectangle or a box of texels; or the six faces of a cube, looked up by a direction.
enum class TextureKind : std::uint8_t { one_dimensional, two_dimensional, three_dimensional, cube };

/// rgba8: codes, see TextureEncoding. rgba32f: linear intensities of any size. depth32f: one float,
/// compared with a reference if the sampler says so; otherwise read as (d, d, d, 1).
enum class TextureFormat : std::uint8_t { rgba8, rgba32f, depth32f };

/// What a texture is made of, before there is anything in it.
struct TextureShape {
  TextureKind kind = TextureKind::two_dimensional;
  TextureFormat format = TextureFormat::rgba8;
  TextureEncoding encoding = TextureEncoding::linear;  // of rgba8 only
  int width = 1, height = 1, depth = 1;  // texels; height 1 in one dimension, depth 1 but in three; cubes: width = height
  bool with_mipmaps = true;
  bool operator==(const TextureShape&) const = default;
};

/// One level of the mipmap chain; texels row by row, row 0 at the top, slice after slice or face
/// after face (+x, -x, +y, -y, +z, -z).
struct TextureLevel {
  int width = 0, height = 0;              // texels
  const std::uint32_t* texels = nullptr;  // rgba8: red in the lowest byte, then green, blue, alpha
  int slices = 1;                         // of a box; 6 for a cube
  const float* floats = nullptr;          // rgba32f: 4 a texel, depth32f: 1
  bool is_opaque = false;                 // a rectangle of codes whose alphas are all 255: then no alpha is filtered
};

class Texture {
 public:
  static constexpr int kMaxSize = 16384;      // texels, each way, in one and two dimensions
  static constexpr int kMaxCubeSize = 4096;   // texels along an edge
  static constexpr int kMaxVolumeSize = 512;  // texels, each way, in three dimensions

  /// Builds level i+1 from level i by means over its halves, in linear light, each level from the
  /// unrounded one before it and rounded once. An odd size is halved with fractional weights so
  /// that no texel is lost.                                            [A 1.1] [rules T6]
  static Result<Texture> create(const Image<Rgba8>& image, TextureEncoding encoding, bool with_mipmaps = true);
  static Result<Texture> create(const Image<Rgba32F>& image, bool with_mipmaps = true);
  static Result<Texture> create_depth(const Image<float>& depths);
  static Result<Texture> create_1d(std::span<const Rgba8> texels, TextureEncoding encoding, bool with_mipmaps = true);
  /// Slices from r = 0 to r = 1, all of one size.
  static Result<Texture> create_3d(std::span<const Image<Rgba8>> slices, TextureEncoding encoding, bool with_mipmaps = true);
  /// Faces +x, -x, +y, -y, +z, -z, all squares of one size; see raster/cube_map.hpp.
  static Result<Texture> create_cube(std::span<const Image<Rgba8>, 6> faces, TextureEncoding encoding, bool with_mipmaps = true);
  static Result<Texture> create_cube(std::span<const Image<Rgba32F>, 6> faces, bool with_mipmaps = true);
  /// All zeros: to be filled by `replace` or copy_to_texture, and generate_mipmaps.
  static Result<Texture> create_empty(const TextureShape& shape);

  Texture(const Texture& other);
  Texture& operator=(const Texture& other);
  Texture(Texture&&) noexcept = default;
  Texture& operator=(Texture&&) noexcept = default;
  ~Texture() = default;

  TextureKind kind() const noexcept { return shape_.kind; }
  TextureFormat format() const noexcept { return shape_.format; }
  TextureEncoding encoding() const noexcept { return shape_.encoding; }
  const TextureShape& shape() const noexcept { return shape_; }
  /// Rectangles of codes, the usual ones, are read by a shorter way.
  bool is_rectangle_of_codes() const noexcept {
    return shape_.kind == TextureKind::two_dimensional && shape_.format == TextureFormat::rgba8;
  }
  int level_count() const noexcept { return static_cast<int>(levels_.size()); }
  const TextureLevel& level(int i) const noexcept { return levels_[static_cast<std::size_t>(i)]; }
  std::span<const TextureLevel> levels() const noexcept { return levels_; }

  /// Replaces a slice (or the face of a cube) of one level. Error for a level or slice that is not
  /// there, an image of another size, or texels of another format. No other level changes.
  Result<Nothing> replace(int level, int slice, const Image<Rgba8>& codes);
  Result<Nothing> replace(int level, int slice, const Image<Rgba32F>& intensities);
  Result<Nothing> replace(int level, int slice, const Image<float>& depths);
  /// Makes all levels but the first anew from it, if there are any.
  void generate_mipmaps();

  /// A level, or a slice of it, as an image, for looking at; of the texture's own format.
  Image<Rgba8> level_image(int i, int slice = 0) const;
  Image<Rgba32F> float_level_image(int i, int slice = 0) const;
  Image<float> depth_level_image(int i, int slice = 0) const;

 private:
  Texture() = default;
  void point_levels_at_texels() noexcept;
  void note_opacity(std::size_t level) noexcept;
  template <class Pixel>
  Result<Nothing> replace_slice(int level, int slice, const Image<Pixel>& image, TextureFormat format);
  template <class Pixel>
  static Result<Texture> create_from(const TextureShape& shape, std::span<const Image<Pixel>> slices);

  TextureShape shape_;
  std::vector<AlignedVector<std::uint32_t>> texels_;  // rgba8, a vector each level
  std::vector<AlignedVector<float>> floats_;          // the others
  std::vector<TextureLevel> levels_;
};

}  // namespace tuberia
