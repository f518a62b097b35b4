#include "bench/trade/settings.hpp"

namespace tuberia::bench::trade {
namespace {

Setting filter(const char* name, TexelFilter texels, MipmapFilter mipmaps, float max_anisotropy = 1) {
  return {name, [=](Recipe& recipe) {
            recipe.sampler.texels = texels;
            recipe.sampler.mipmaps = mipmaps;
            recipe.sampler.max_anisotropy = max_anisotropy;
          }};
}

Setting shading(const char* name, Shading way) {
  return {name, [=](Recipe& recipe) { recipe.shading = way; }};
}

Setting phong_normals(const char* name, NormalInterpolation normals) {
  return {name, [=](Recipe& recipe) {
            recipe.shading = Shading::phong;
            recipe.normals = normals;
          }};
}

Setting fog(const char* name, bool per_vertex) {
  return {name, [=](Recipe& recipe) { recipe.state.fog.per_vertex = per_vertex; }};
}

Setting samples(int count) {
  return {std::to_string(count).append(count == 1 ? " sample" : " samples"),
          [=](Recipe& recipe) { recipe.target.samples = count; }};
}

Setting grid(int count) {
  std::string name = "1 sample";
  if (count > 1) name = std::to_string(count).append("x").append(std::to_string(count)).append(" grid");
  return {name, [=](Recipe& recipe) { recipe.supersampling = count; }};
}

Setting colours(const char* name, ColourFormat format) {
  return {name, [=](Recipe& recipe) { recipe.target.colour = format; }};
}

Setting depths(const char* name, DepthFormat format, bool is_reversed) {
  return {name, [=](Recipe& recipe) {
            recipe.target.depth = format;
            recipe.reversed_depth = is_reversed;
          }};
}

Setting precision(const char* name, Precision chosen) {
  return {name, [=](Recipe& recipe) { recipe.pipeline.precision = chosen; }};
}

Setting edges(const char* name, EdgeArithmetic arithmetic) {
  return {name, [=](Recipe& recipe) { recipe.state.rasterization.edge_arithmetic = arithmetic; }};
}

Setting perspective(const char* name, PerspectiveCorrection correction) {
  return {name, [=](Recipe& recipe) { recipe.state.rasterization.perspective = correction; }};
}

Setting weights(const char* name, FilterWeights chosen) {
  return {name, [=](Recipe& recipe) { recipe.sampler.weights = chosen; }};
}

Setting footprint(const char* name, Footprint chosen) {
  return {name, [=](Recipe& recipe) { recipe.sampler.footprint = chosen; }};
}

}  // namespace

std::vector<Setting> subpixel_settings() {
  std::vector<Setting> settings;
  for (const int bits : {8, 6, 4, 2, 0})
    settings.push_back({std::to_string(bits).append(" bits"),
                        [=](Recipe& recipe) { recipe.state.rasterization.subpixel_bits = bits; }});
  return settings;
}

std::vector<Setting> precision_settings() {
  return {precision("exact", Precision::exact), precision("fast", Precision::fast)};
}

std::vector<Setting> ingredient_settings() {
  using enum Precision;
  return {precision("exact", exact),
          precision("reciprocal", fast_reciprocal),
          precision("1/sqrt", fast_inverse_sqrt),
          precision("fused multiply-add", fused_multiply_add),
          precision("power", fast_power),
          precision("fast", fast)};
}

std::vector<Setting> fog_settings() { return {fog("fog at fragments", false), fog("fog at vertices", true)}; }

std::vector<Setting> edge_arithmetic_settings() {
  using enum EdgeArithmetic;
  return {edges("int32 in tiles", exact), edges("int64", exact_64), edges("float, anchored", float_anchored),
          edges("float, plane", float_plane)};
}

std::vector<Setting> perspective_settings() {
  using enum PerspectiveCorrection;
  return {perspective("each pixel", each_pixel), perspective("every 8 px", every_8_pixels),
          perspective("every 16 px", every_16_pixels), perspective("every 32 px", every_32_pixels),
          perspective("affine", none)};
}

std::vector<Setting> weight_settings() {
  return {weights("float weights", FilterWeights::floats), weights("8-bit weights", FilterWeights::eight_bits)};
}

std::vector<Setting> footprint_settings() {
  return {footprint("ellipse", Footprint::ellipse), footprint("steps", Footprint::steps)};
}

std::vector<Setting> filter_settings() {
  using enum TexelFilter;
  return {filter("anisotropic 16", bilinear, MipmapFilter::linear, 16),
          filter("anisotropic 8", bilinear, MipmapFilter::linear, 8),
          filter("anisotropic 4", bilinear, MipmapFilter::linear, 4),
          filter("anisotropic 2", bilinear, MipmapFilter::linear, 2),
          filter("trilinear", bilinear, MipmapFilter::linear),
          filter("bilinear, nearest level", bilinear, MipmapFilter::nearest),
          filter("nearest, nearest level", nearest, MipmapFilter::nearest),
          filter("bilinear, no levels", bilinear, MipmapFilter::none),
          filter("nearest, no levels", nearest, MipmapFilter::none)};
}

std::vector<Setting> smooth_shading_settings() {
  return {shading("Phong", Shading::phong), shading("Gouraud", Shading::gouraud)};
}

std::vector<Setting> shading_settings() {
  using enum NormalInterpolation;
  return {phong_normals("Phong", renormalized),
          phong_normals("Phong, one step", one_step),
          phong_normals("Phong, not renormalized", not_renormalized),
          shading("dot product", Shading::dot_product),
          shading("Gouraud", Shading::gouraud),
          shading("flat", Shading::flat)};
}

std::vector<Setting> sample_settings() { return {samples(1), samples(2), samples(4), samples(8), samples(16)}; }

std::vector<Setting> supersampling_settings() { return {grid(1), grid(2), grid(3), grid(4), grid(8)}; }

std::vector<Setting> colour_format_settings() {
  return {colours("rgba32f", ColourFormat::rgba32f), colours("rgba16f", ColourFormat::rgba16f),
          colours("srgb8", ColourFormat::srgb8), colours("rgba8", ColourFormat::rgba8)};
}

std::vector<Setting> depth_format_settings() {
  return {depths("d32f reversed", DepthFormat::d32f, true), depths("d32f", DepthFormat::d32f, false),
          depths("d24 reversed", DepthFormat::d24, true), depths("d24", DepthFormat::d24, false),
          depths("d16", DepthFormat::d16, false)};
}

}  // namespace tuberia::bench::trade
