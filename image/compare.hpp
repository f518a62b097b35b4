#pragma once
// How far two images are apart, for tests and for the trade of speed for accuracy.

#include <cstdint>

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// A colour in CIE L*a*b* under D65: l in 0..100, a and b about -130..130.
struct Lab {
  double l = 0, a = 0, b = 0;
};

/// The colour difference of Sharma, Wu and Dalal 2005, weights 1: about 1 is just noticeable.
/// [CIEDE2000] in docs/sources.md
double ciede2000(const Lab& first, const Lab& second) noexcept;

/// The first three look at alpha too; the others only at r, g and b, as sRGB codes.
struct Comparison {
  bool equal = false;
  int largest_difference = 0;         // of one component, in codes 0..255
  std::int64_t differing_pixels = 0;  // with any component different
  double psnr_db = 0;                 // infinity if no colour differs
  double ssim = 0;                    // of the luma, at most 1, which means equal
  double mean_ciede2000 = 0;          // over all pixels
  double largest_ciede2000 = 0;
};

/// Compares two images of the same size, of at least one pixel.
/// Errors: the sizes differ, or the images are empty.
Result<Comparison> compare(const Image<Rgba8>& a, const Image<Rgba8>& b);

/// What differs, on black: each colour component becomes 0 where equal, else 64 + 8 times the
/// difference, at most 255; a difference in alpha alone shows white. Where only one image has a
/// pixel, magenta; as wide and high as the larger of both.
Image<Rgba8> difference_image(const Image<Rgba8>& a, const Image<Rgba8>& b);

}  // namespace tuberia
