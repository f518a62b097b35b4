#include "examples/tuberia/witness/verdict.hpp"

namespace tuberia::witness {

const std::array<CauseWords, kCauseCount> kCauseWords{{
    {Cause::edge, "edge",
     "The pipeline puts corners of triangles on a grid of 1/256 pixel, so what is seen at a pixel's centre may be what lies a little beside it.",
     "Rays through places up to 2/256 pixel from the centre meet the object that was drawn, and what they see there encloses the colour that was drawn."},
    {Cause::depth, "depth quantum",
     "Two surfaces lie so close together that the depth buffer's numbers cannot tell which is in front.",
     "The ray is followed through the first surface; the next one lies within the depth buffer's quantum behind it, is the object that was drawn, and has its colour."},
    {Cause::shadow_map, "shadow-map texel",
     "The pipeline finds shadows in a picture of depths that the light sees, whose texels are coarse, and in which clear bodies are not; rays go to the light itself.",
     "The depths of the very texels that the filter reads are traced from the light through their middles and compared as the documents say; the light that then arrives gives the colour that was drawn."},
    {Cause::mipmap, "mipmap filtering",
     "The pipeline reads textures at a level of detail that follows from the steps between neighbouring pixels; the tracer at one that follows from the rays through the next ones.",
     "The texture is read again at the level that the steps within the pixel's 2 x 2 block ask for; that gives the colour that was drawn."},
    {Cause::vertex_shading, "shading at vertices",
     "The scene asks for flat, Gouraud or dot-product shading: light is worked out at the corners of triangles only. The tracer does so at every point.",
     "The three corners of the triangle that the ray meets are lit in double precision and interpolated as the documents say; that gives the colour that was drawn."},
    {Cause::environment_map, "environment map",
     "The pipeline looks the surroundings up in a picture with texels and mipmaps; rays see them as they are.",
     "The same picture is made and read once more, in double precision, in the direction of the ray and at the level that the neighbouring pixels' directions ask for; that gives the colour that was drawn."},
    {Cause::mirror_of_surroundings, "mirror of the surroundings alone",
     "The pipeline's mirrors show the surroundings, but no other object: a rasterizer does not know where reflected light comes from.",
     "The mirrored ray is let through all objects, so that it sees only the surroundings; that gives the colour that was drawn."},
    {Cause::transmission, "nothing is bent",
     "What lies behind a clear body the pipeline shows straight on; rays are refracted, and mirrored inside.",
     "The ray goes straight on through the body's sides, each of which adds its own light and takes its share; that gives the colour that was drawn."},
}};

const std::array<ClassWords, kPixelClassCount> kClassWords{{
    {PixelClass::same, "same", "The same object, and no channel differs by more than one code of 255.", {24, 27, 33}},
    {PixelClass::edge, "edge", "Within 2/256 pixel of an edge: of an object, of a triangle where attributes change quickly, of a shadow or a texel.", {90, 160, 255}},
    {PixelClass::depth, "depth quantum", "Two surfaces that the depth buffer cannot tell apart.", {170, 120, 255}},
    {PixelClass::shadow_map, "shadow-map texel", "The shadow's edge runs along texels of the light's picture.", {255, 190, 70}},
    {PixelClass::mipmap, "mipmap filtering", "A texture read at a level of detail.", {80, 210, 140}},
    {PixelClass::technique, "technique", "A technique that the rasterizer has in place of rays; which one is said below.", {70, 205, 215}},
    {PixelClass::several, "several", "More than one of the causes at once, tested together.", {235, 130, 190}},
    {PixelClass::unexplained, "unexplained", "No hypothesis gives what was drawn: one of the two is wrong.", {255, 40, 40}},
}};

std::string name_of(Causes causes) {
  std::string name;
  for (const CauseWords& words : kCauseWords)
    if (causes.has(words.cause)) name += (name.empty() ? "" : " + ") + std::string(words.name);
  return name;
}

}  // namespace tuberia::witness
