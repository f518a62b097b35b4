#include "examples/tuberia/picture_options.hpp"

#include <algorithm>
#include <charconv>

namespace tuberia::cli {
namespace {

/// In the order of their enumeration.
const std::vector<std::string> kPerspectives{"each-pixel", "every-8", "every-16", "every-32", "none"};
const std::vector<std::string> kEdges{"exact", "exact-64", "float-anchored", "float-plane"};
const std::vector<std::string> kFilterWeights{"float", "8-bit"}, kFootprints{"usual", "steps", "ellipse"};
const std::vector<std::string> kFogs{"off", "linear", "exp", "exp2"};
const std::vector<std::string> kNormals{"renormalized", "one-step", "not-renormalized"};

template <class Choice>
Choice choice_named(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<Choice>(std::find(names.begin(), names.end(), name) - names.begin());
}

Sampler sampler_of(const PictureArguments& arguments) {
  const std::string& filter = arguments.filter;
  Sampler sampler{.max_anisotropy = arguments.anisotropy, .weights = choice_named<FilterWeights>(kFilterWeights, arguments.filter_weights),
                  .footprint = choice_named<Footprint>(kFootprints, arguments.footprint)};
  if (filter == "nearest" || filter == "mipmap-nearest") sampler.texels = TexelFilter::nearest;
  if (filter == "nearest" || filter == "bilinear") sampler.mipmaps = MipmapFilter::none;
  if (filter == "mipmap-nearest") sampler.mipmaps = MipmapFilter::nearest;
  return sampler;
}

void add_camera_options(CLI::App& command, CameraOptions& camera) {
  command.add_option("--azimuth", camera.azimuth_degrees, "Degrees around the model, 0 is in front")->group("Camera");
  command.add_option("--elevation", camera.elevation_degrees, "Degrees above the horizon")->check(CLI::Range(-90.0, 90.0))->group("Camera");
  command.add_option("--fovy", camera.fovy_degrees, "Vertical opening in degrees")->check(CLI::Range(0.1, 179.0))->group("Camera");
  command.add_option("--zoom", camera.zoom, "Magnification by a narrower field")->check(CLI::Range(1e-3, 1e4))->group("Camera");
  command.add_option("--eye", camera.eye, "Eye position, X Y Z")->expected(3)->group("Camera");
  command.add_option("--look-at", camera.look_at, "Point of interest, X Y Z")->expected(3)->group("Camera");
  command.add_option("--up", camera.up, "The vertical, X Y Z; with --eye")->expected(3)->group("Camera");
  command.add_option("--up-axis", camera.up_axis, "Which way is up in the model's file")
      ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}))->group("Camera");
  command.add_option("--near", camera.near_distance, "Distance of the near plane; 0: just before the model")->check(CLI::NonNegativeNumber)->group("Camera");
  command.add_flag("--orthographic", camera.orthographic, "Parallel projection")->group("Camera");
}

void add_fog_options(CLI::App& command, PictureArguments& arguments) {
  FogState& fog = arguments.options.fog;
  command.add_option("--fog", arguments.fog, "How it thickens with the distance")->check(CLI::IsMember(kFogs))->group("Fog");
  command.add_option("--fog-density", fog.density, "Of exp and exp2, per world unit")->check(CLI::NonNegativeNumber)->group("Fog");
  command.add_option("--fog-range", arguments.fog_range, "Of linear: START and END in world units")->expected(2)->group("Fog");
  command.add_option("--fog-colour", arguments.fog_colour, "Linear R G B")->expected(3)->group("Fog");
  command.add_flag("--fog-per-vertex", fog.per_vertex, "Compute it at the vertices and interpolate, not at each fragment")->group("Fog");
}

/// Speed for accuracy, and the other way round.
void add_trade_options(CLI::App& command, PictureArguments& arguments) {
  command.add_option("--subpixel-bits", arguments.options.rasterization.subpixel_bits, "Vertices are rounded to 2^-BITS pixels")
      ->check(CLI::Range(0, kSubpixelBits))->group("Accuracy");
  command.add_option("--perspective", arguments.perspective, "Where weights are divided by w: each pixel, every so many pixels of a row, nowhere")
      ->check(CLI::IsMember(kPerspectives))->group("Accuracy");
  command.add_option("--edges", arguments.edges, "Arithmetic of the edge functions")->check(CLI::IsMember(kEdges))->group("Accuracy");
  command.add_option("--anisotropy", arguments.anisotropy, "Samples along a pixel's footprint on the texture, at most")->check(CLI::Range(1.0f, 16.0f))->group("Accuracy");
  command.add_option("--filter-weights", arguments.filter_weights, "Weights of texels")->check(CLI::IsMember(kFilterWeights))->group("Accuracy");
  command.add_option("--footprint", arguments.footprint, "A pixel's size on the texture: by its steps, by their ellipse; usual: ellipse if anisotropic")
      ->check(CLI::IsMember(kFootprints))->group("Accuracy");
  command.add_option("--normals", arguments.normals, "What lit fragments do with interpolated normals")->check(CLI::IsMember(kNormals))->group("Accuracy");
}

}  // namespace

Result<std::pair<int, int>> parse_size(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == 'x') {
    const auto second = std::from_chars(first.ptr + 1, end, height);
    if (second.ec == std::errc{} && second.ptr == end) return std::pair{width, height};
  }
  return Error{"--size: '" + text + "' is not a size like 1920x1080"};
}

void add_picture_options(CLI::App& command, PictureArguments& arguments) {
  command.add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels");
  std::vector<std::string> names;
  for (const std::string_view name : shading_names()) names.emplace_back(name);
  command.add_option("--program", arguments.shading, "How surfaces are shaded")->check(CLI::IsMember(names));
  command.add_option("--filter", arguments.filter, "Texture filter")
      ->check(CLI::IsMember({"nearest", "bilinear", "mipmap-nearest", "trilinear"}));
  command.add_option("--format", arguments.format, "Colours of the target")->check(CLI::IsMember({"srgb8", "rgba8", "rgba32f"}));
  command.add_option("--depth-format", arguments.depth_format, "Depths of the target")->check(CLI::IsMember({"d16", "d24", "d32f"}));
  command.add_flag("--reversed-depth", arguments.options.reversed_depth, "Near depths are 1: even precision with d32f");
  command.add_flag("--cull", arguments.options.cull_back, "Leave out triangles seen from behind");
  command.add_option("--background", arguments.background, "Linear R G B")->expected(3);
  add_camera_options(command, arguments.options.camera);
  add_fog_options(command, arguments);
  add_trade_options(command, arguments);
}

Result<RenderOptions> render_options_of(const PictureArguments& arguments) {
  const auto size = parse_size(arguments.size);
  if (!size) return size.error();
  RenderOptions options = arguments.options;
  std::tie(options.width_pixels, options.height_pixels) = *size;
  options.shading = *shading_named(arguments.shading);
  options.rasterization.perspective = choice_named<PerspectiveCorrection>(kPerspectives, arguments.perspective);
  options.rasterization.edge_arithmetic = choice_named<EdgeArithmetic>(kEdges, arguments.edges);
  options.fog.mode = choice_named<FogMode>(kFogs, arguments.fog);
  options.fog.start = arguments.fog_range[0], options.fog.end = arguments.fog_range[1];
  options.fog.colour = {arguments.fog_colour[0], arguments.fog_colour[1], arguments.fog_colour[2], 1};
  options.normals = choice_named<NormalInterpolation>(kNormals, arguments.normals);
  options.sampler = sampler_of(arguments);
  options.background = {arguments.background[0], arguments.background[1], arguments.background[2], 1};
  options.colour_format = arguments.format == "rgba8" ? ColourFormat::rgba8 : arguments.format == "rgba32f" ? ColourFormat::rgba32f : ColourFormat::srgb8;
  options.depth_format = arguments.depth_format == "d16" ? DepthFormat::d16 : arguments.depth_format == "d32f" ? DepthFormat::d32f : DepthFormat::d24;
  return options;
}

}  // namespace tuberia::cli
