#pragma once
// Whole scenes: something of everything that pictures are made of, 640 x 360 pixels, from formulas.

#include "bench/trade/scene.hpp"

namespace tuberia::bench::trade {

Scene spheres();            // 24 lit, shining spheres of few triangles
Scene floor_scene();        // a textured floor to the horizon
Scene checker_floor();      // 128 x 128 pixels of a checkered floor, black and white, against 144 samples a pixel
Scene magnified_texture();  // eight texels a side over the picture
Scene relief_scene();       // a bumpy wall with a texture of high frequency, lit
Scene model();              // a knotted tube, lit, of 38,000 triangles
Scene layers();             // 40 transparent shapes over one another
Scene close_planes();       // plates that lie closely over others, near and far
Scene foggy_street();       // boxes along a street that ends in fog

/// For switches that change too little to be seen behind what one sample a pixel gets wrong: the same scene, held
/// against what its reference setting draws.
Scene against_reference(Scene scene);

}  // namespace tuberia::bench::trade
