#pragma once
// Supersampling's second half: many pixels to one.

#include "image/image.hpp"

namespace tuberia {

/// The mean of each square of factor x factor pixels, of every channel by itself, summed in double and
/// rounded once. Linear intensities. factor >= 1; both sizes must be multiples of it.
Image<Rgba32F> box_filtered(const Image<Rgba32F>& image, int factor);

}  // namespace tuberia
