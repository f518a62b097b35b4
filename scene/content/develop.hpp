#pragma once
// From the light of a scene to a picture: exposure, what overflows, and codes.          [B 2.8, 2.9] [C 2.6]

#include "image/image.hpp"
#include "scene/description/camera.hpp"

namespace tuberia {

/// What a screen shows of linear intensities: times 2 to the power of the exposure, and brought into [0, 1]
/// as the picture wants it. What is not a number becomes 0.
Image<Rgba32F> developed(Image<Rgba32F> light, const description::Picture& picture);

/// The nearest sRGB codes; alpha is linear.
Image<Rgba8> srgb_codes_of(const Image<Rgba32F>& image);

}  // namespace tuberia
