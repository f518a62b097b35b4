#include "examples/tuberia/gallery/gallery.hpp"

namespace tuberia::cli {

std::vector<GallerySection> gallery_sections() {
  return {
      {.title = "Light and local reflection",
       .lede = "What a surface sends to the eye of the light that reaches it, each surface for itself: ambient, diffuse and specular reflection, "
               "lights near and far, and what to do where there is too much of it.",
       .names = {"01_ambient_light", "02_diffuse_reflection", "03_ambient_and_diffuse", "lobes", "phong_curves", "04_phong", "05_coloured_lights", "metamers",
                 "06a_falloff_none", "06b_falloff_linear", "06c_falloff_inverse_square", "07_spot_light", "08a_overflow_clamp",
                 "08b_overflow_global_scale", "08c_overflow_hue_preserving", "fresnel_curves", "09_cook_torrance"}},
      {.title = "Shading polygons",
       .lede = "Curved surfaces become nets of polygons. How intensities between the vertices are found decides whether the net shows.",
       .names = {"polygon_net", "10_shading", "mach_bands", "11_zigzag_strip", "12_lost_highlight", "13_creases"}},
      {.title = "Textures and mipmaps",
       .lede = "Colour as a function of the place on a surface, or of the point in space; and what to do when a pixel sees many texels.",
       .names = {"20_sphere_mapping", "24_planet", "21_parametric_mapping", "22a_tunnel_bilinear", "22b_tunnel_trilinear", "22c_mipmap_levels", "23_solid_patterns"}},
      {.title = "Relief", .lede = "Only the normals are tilted, yet the light finds dents and bumps. The outline stays smooth.",
       .names = {"30a_torus_texture", "30b_torus_bump", "33_bricks", "31_roughness", "32_water"}},
      {.title = "Surroundings",
       .lede = "Mirrors without tracing a ray: the surroundings as a picture that is looked up by direction.",
       .names = {"40_mirror_sphere", "41a_teapot_cube_map", "41b_teapot_sphere_map", "41c_teapot_panorama_map", "42_combined", "43_rendered_surroundings",
                 "44_film"}},
      {.title = "Shadows",
       .lede = "What a light does not see lies in its shadow. Two passes through the same pipeline, and the errors of the method.",
       .names = {"50_shadows", "51_directional_shadows", "52a_bias_acne", "52b_bias_right", "52c_bias_detached", "53_near_the_shadow", "54_slide_projector",
                 "55_area_light"}},
      {.title = "Rays",
       .lede = "The same descriptions, pictured by following light back from the eye: Whitted's algorithm, a second witness that knows nothing of "
               "how triangles are drawn. Mirrors show mirrors, glass bends what is behind it, and shadows need no map.",
       .names = {"60_one_of_each", "61_ray_tree", "62_two_mirrors", "depths_of_reflection", "63_glass_ball", "uniform_samples", "jittered_samples", "64_all_at_once"},
       .traced = true},
      {.title = "Models from files", .lede = "Real models of Debian's packages, drawn with the programs that the fixed-function machine has.",
       .names = {"bunny", "bunny-gouraud", "bunny-flat", "horse", "cat", "asteroid", "duck", "spider", "box", "engine", "wuson", "teapots"}},
  };
}

}  // namespace tuberia::cli
