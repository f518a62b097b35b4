#pragma once
// Bringing intensities into the range that a screen can show, whole images at a time.     [B 2.8] [C 2.6]

#include "image/image.hpp"

namespace tuberia {

/// Multiplies red, green and blue with a factor >= 0: how sensitive the film is, how long the shutter open.
void expose(Image<Rgba32F>& image, float factor);

/// The largest finite value of red, green and blue; 0 if none is above 0.
float largest_channel(const Image<Rgba32F>& image);

/// Divides all colours by the image's largest channel if that exceeds 1: what was too bright fits, and all
/// proportions stay. Channels that are not finite stay as they are. Returns what it divided by, >= 1.
float scale_to_range(Image<Rgba32F>& image);

}  // namespace tuberia
