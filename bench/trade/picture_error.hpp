#pragma once
// How far a picture is from what it should be.

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia::bench::trade {

/// What the intensities of a picture mean to the one who looks at it.
enum class Signal {
  as_it_is,  // intensities times 255 are the codes that a screen shows
  linear,    // light: encoded as sRGB before anything is compared
};

/// Of r, g and b. Codes are those of an 8-bit screen, 0..255, but not rounded: so the error of a float picture can
/// be below one code. Intensities are clamped to [0, 1] before.
struct CodeError {
  double largest_code = 0;  // of one component of one pixel
  double rmse_codes = 0;    // root of the mean square over all components of all pixels
};

struct PictureError : CodeError {
  double differing_share = 0;  // pixels whose rounded codes differ, 0..1
  double psnr_db = 0;          // of the rounded codes; infinity if they are equal
  double ssim = 1;
  double mean_ciede2000 = 0, largest_ciede2000 = 0;
};

/// The codes that a screen shows, rounded.
Image<Rgba8> screen_codes(const Image<Rgba32F>& picture, Signal signal);

/// Error when the sizes differ or there is no pixel.
Result<CodeError> code_error(const Image<Rgba32F>& picture, const Image<Rgba32F>& ideal,
                             Signal signal = Signal::as_it_is);

/// The same, and what takes longer to compute.
Result<PictureError> picture_error(const Image<Rgba32F>& picture, const Image<Rgba32F>& ideal,
                                   Signal signal = Signal::as_it_is);

}  // namespace tuberia::bench::trade
