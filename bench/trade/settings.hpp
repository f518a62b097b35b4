#pragma once
// The positions of every switch; the first is the reference, the most accurate where that can be said.

#include "bench/trade/table.hpp"

namespace tuberia::bench::trade {

std::vector<Setting> subpixel_settings();         // 8 bits to none
std::vector<Setting> edge_arithmetic_settings();  // exact in as few bits as do, in 64, floats
std::vector<Setting> perspective_settings();      // each pixel to nowhere
std::vector<Setting> precision_settings();        // exact, fast
std::vector<Setting> ingredient_settings();       // exact, each ingredient of fast alone, fast
std::vector<Setting> fog_settings();              // at fragments, at vertices
std::vector<Setting> filter_settings();           // anisotropic 16 to nearest
std::vector<Setting> weight_settings();           // floats, 8 bits
std::vector<Setting> footprint_settings();        // ellipse, steps
std::vector<Setting> shading_settings();          // Phong and its normals, dot product, Gouraud, flat
std::vector<Setting> smooth_shading_settings();   // without flat, which would flatten texture coordinates, too
std::vector<Setting> sample_settings();           // 1 to 16 samples a pixel in Direct3D's patterns
std::vector<Setting> supersampling_settings();    // 1, 2x2, 3x3, 4x4, 8x8 pixels for one
std::vector<Setting> colour_format_settings();    // rgba32f, rgba16f, srgb8, rgba8
std::vector<Setting> depth_format_settings();     // d32f reversed to d16

}  // namespace tuberia::bench::trade
