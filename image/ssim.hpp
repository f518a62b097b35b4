#pragma once
// Structural similarity, a part of compare().

#include "image/image.hpp"

namespace tuberia {

/// Mean SSIM of the lumas of two images of one size, at most 1. Windows of 11x11 pixels, Gaussian
/// with sigma 1.5, wholly inside the image, K1 = .01, K2 = .03, L = 255 as in the paper; an image
/// narrower or lower than 11 pixels gets windows of its own width or height.
/// [SSIM] in docs/sources.md
double mean_ssim(const Image<Rgba8>& a, const Image<Rgba8>& b);

}  // namespace tuberia
