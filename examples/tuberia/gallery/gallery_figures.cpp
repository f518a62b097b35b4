#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "examples/tuberia/gallery/gallery.hpp"
#include "examples/tuberia/gallery/gallery_rays.hpp"
#include "examples/tuberia/gallery/gallery_spectra.hpp"
#include "examples/tuberia/gallery/plot.hpp"
#include "math/camera.hpp"
#include "math/reflection.hpp"
#include "pipeline/programs/programs.hpp"
#include "scene/shapes/shapes.hpp"

namespace tuberia::cli {
namespace {

constexpr glm::vec3 kBlue{0.13f, 0.4f, 1.0f}, kOrange{1.0f, 0.32f, 0.03f}, kGreen{0.1f, 0.75f, 0.2f}, kRed{0.9f, 0.05f, 0.08f}, kWhite{0.85f};
constexpr std::array<glm::vec3, 5> kPalette{kBlue, kGreen, kOrange, kRed, kWhite};

/// The points of a function over [from, to].
Curve curve_of(const std::function<glm::vec2(float)>& point_at, float from, float to, glm::vec3 colour) {
  constexpr int kSteps = 400;
  Curve curve{.points = {}, .colour = colour};
  for (int i = 0; i <= kSteps; ++i) curve.points.push_back(point_at(from + (to - from) * static_cast<float>(i) / kSteps));
  return curve;
}

/// A surface lit from 40 degrees to the left: how far each curve reaches in a direction is how much goes there.
Result<Image<Rgba8>> draw_lobes(const std::filesystem::path&, Pipeline& pipeline) {
  const double light = glm::radians(40.0);
  const auto share_towards = [&](double angle, double diffuse, double specular) {
    const LitPoint at{.normal = {0, 1, 0}, .to_light = {-std::sin(light), std::cos(light), 0}, .to_eye = {std::sin(angle), std::cos(angle), 0}};
    return diffuse * diffuse_share(at) + specular * phong_share(at, 20);
  };
  const auto lobe = [&](double diffuse, double specular, glm::vec3 colour) {
    return curve_of([&](float angle) {
      const auto reach = static_cast<float>(share_towards(static_cast<double>(angle), diffuse, specular));
      return glm::vec2(std::sin(angle), std::cos(angle)) * reach;
    }, -glm::half_pi<float>(), glm::half_pi<float>(), colour);
  };
  Plot plot{.width_pixels = 640, .height_pixels = 360, .lower_left = {-1.0f, -0.08f}, .upper_right = {1.0f, 1.045f}, .grid = {0.25f, 0.25f}, .curves = {}};
  const auto sine = static_cast<float>(std::sin(light)), cosine = static_cast<float>(std::cos(light));
  plot.curves = {{{{-sine, cosine}, {0, 0}}, glm::vec3(0.9f, 0.75f, 0.1f)}, {{{-1, 0}, {1, 0}}, glm::vec3(0.4f)},
                 lobe(0.5, 0, kBlue), lobe(0, 0.6, kOrange), lobe(0.5, 0.6, kWhite)};
  return drawn(plot, pipeline);
}

Result<Image<Rgba8>> draw_phong_curves(const std::filesystem::path&, Pipeline& pipeline) {
  Plot plot{.width_pixels = 640, .height_pixels = 360, .lower_left = {0, -0.02f}, .upper_right = {90, 1.02f}, .grid = {15, 0.25f}, .curves = {}};
  const std::array<float, 5> exponents{1, 3, 10, 50, 200};
  for (std::size_t i = 0; i < exponents.size(); ++i)
    plot.curves.push_back(curve_of([&](float degrees) {
      return glm::vec2(degrees, std::pow(std::max(std::cos(glm::radians(degrees)), 0.0f), exponents[i]));
    }, 0, 90, kPalette[i]));
  return drawn(plot, pipeline);
}

Result<Image<Rgba8>> draw_fresnel_curves(const std::filesystem::path&, Pipeline& pipeline) {
  Plot plot{.width_pixels = 640, .height_pixels = 360, .lower_left = {0, -0.02f}, .upper_right = {90, 1.02f}, .grid = {15, 0.25f}, .curves = {}};
  const std::array<double, 3> indices{1.33, 1.5, 2.42};
  for (std::size_t i = 0; i < indices.size(); ++i)
    plot.curves.push_back(curve_of([&](float degrees) {
      const double cosine = std::clamp(std::cos(glm::radians(static_cast<double>(degrees))), 0.0, 1.0);
      return glm::vec2(degrees, static_cast<float>(fresnel_share(cosine, indices[i])));
    }, 0, 90, kPalette[i]));
  return drawn(plot, pipeline);
}

/// The four spheres of the scene on shading, and the red along the middle of each.
Result<Image<Rgba8>> draw_mach_bands(const std::filesystem::path& scenes, Pipeline& pipeline) {
  auto shading = scene_drawing(scenes / "10_shading.json", pipeline);
  if (!shading) return shading.error();
  const Image<Rgba8>& spheres = shading->image;
  const auto width = static_cast<float>(spheres.width());
  Plot plot{.width_pixels = spheres.width(), .height_pixels = 200, .lower_left = {0, -5}, .upper_right = {width, 260}, .grid = {width / 4, 64}, .curves = {}};
  // A little above the middle, where the rows of vertices are not.
  const int row = spheres.height() * 9 / 20;
  Curve intensities{.points = {}, .colour = kWhite};
  for (int x = 0; x < spheres.width(); ++x) intensities.points.emplace_back(static_cast<float>(x) + 0.5f, spheres.at(x, row).b);
  plot.curves = {intensities};
  const auto plotted = drawn(plot, pipeline);
  if (!plotted) return plotted.error();
  return stacked({spheres, *plotted});
}

/// A torus as its net of edges, those of the far side hidden by the near one.
Result<Image<Rgba8>> draw_polygon_net(const std::filesystem::path&, Pipeline& pipeline) {
  const auto torus = torus_mesh({.slices = 40, .stacks = 20});
  if (!torus) return torus.error();
  auto target = RenderTarget::create({.width = 640, .height = 360, .colour = ColourFormat::srgb8, .samples = 8});
  if (!target) return target.error();
  pipeline.clear(*target, {0.012f, 0.013f, 0.017f, 1});

  const glm::dvec3 eye(0, 2.3, 3.2);
  const auto basis = camera_basis(eye, {0, 0, 0}, {0, 1, 0});
  const auto projection = perspective(glm::radians(38.0), 640.0 / 360, 0.1, 20, ClipVolume::minus_w_to_w);
  DrawCall draw;
  draw.mesh.positions = torus->positions;
  draw.mesh.indices = torus->indices;
  draw.state.transform.clip_from_world = *projection * view_from_world(*basis, eye);
  draw.program = flat();
  const auto draw_in = [&](PolygonMode mode, const glm::vec4& colour) {
    const std::vector<glm::vec4> colours(torus->positions.size(), colour);
    draw.mesh.colours = colours;
    draw.state.rasterization.front_mode = draw.state.rasterization.back_mode = mode;
    return pipeline.draw(*target, draw);
  };
  // The inside is pushed back, so that edges are not buried in it.
  draw.state.rasterization.polygon_offset = {.factor = 1, .units = 1};
  draw.state.rasterization.polygon_offset.line = false;
  if (const auto done = draw_in(PolygonMode::fill, {0.02f, 0.025f, 0.035f, 1}); !done) return done.error();
  if (const auto done = draw_in(PolygonMode::line, {0.25f, 0.6f, 0.9f, 1}); !done) return done.error();
  return target->colour_image();
}

struct Figure {
  const char* name;
  const char* title;
  const char* source;
  const char* caption;
  Result<Image<Rgba8>> (*draw)(const std::filesystem::path& scenes, Pipeline& pipeline);
  bool traced = false;
};

constexpr std::array<Figure, 9> kFigures{{
    {"lobes", "Where the light goes", "B Figure 5",
     "Light arrives along the yellow line. Diffuse reflection (blue) is the same in every direction; specular reflection (orange, n = 20) "
     "gathers about the mirror direction; white is their sum. The length of a line from the middle to a curve is what leaves that way.", draw_lobes},
    {"phong_curves", "cos^n", "B Figures 11, 12",
     "How the highlight falls off with the angle from the mirror direction, 0 to 90 degrees: n = 1 (blue), 3 (green), 10 (orange), 50 (red), 200 (white).", draw_phong_curves},
    {"fresnel_curves", "What clear materials reflect", "B Figure 12",
     "Fresnel's share over the angle of incidence, 0 to 90 degrees: water (blue), glass (green), diamond (orange). All rise to 1 at grazing light.", draw_fresnel_curves},
    {"polygon_net", "A curved surface as a net", "B Figure 15", "A torus of 1,600 triangles, the edges in front of it alone.", draw_polygon_net},
    {"mach_bands", "Mach bands", "B Figure 16",
     "Below each sphere the blue along a row of its pixels: steps (flat), a line with kinks (Gouraud, and cosines), a smooth curve (Phong). "
     "The eye exaggerates steps and kinks alike.", draw_mach_bands},
    {"metamers", "Alike in one light only", "B 2.9",
     "Left a grey surface, right one whose reflectance swings up and down with the wavelength. In light of equal energy (above) no eye can "
     "tell them apart; in a warm light (below) any can. Drawn with 41 wavelengths, three at a time; three channels alone would show no difference.", draw_metamers},
    {"depths_of_reflection", "How deep reflections go", "B Figure 51",
     "The two mirrors, with rays followed through 0, 1, 2 and 3 reflections: mirrors that show nothing, then the room, then the other mirror, then "
     "themselves in it. Nothing changes outside the mirrors. 250 x 250 pixels and nine samples each.", draw_depths_of_reflection, true},
    {"uniform_samples", "One, four and nine samples", "B Figure 52",
     "A small part of the two mirrors, magnified: stairs with one sample a pixel, in the middle of it; fewer and finer ones with 2 x 2 and 3 x 3.",
     draw_uniform_samples, true},
    {"jittered_samples", "The same at random", "B Figure 53",
     "The same part, each sample at a random point of its share of the pixel: edges are rough rather than stepped. Where uniform samples "
     "alias, random ones make noise, which eyes forgive; with nine, both look alike.", draw_jittered_samples, true},
}};

const Figure* find_figure(const std::string& name) {
  const auto found = std::find_if(kFigures.begin(), kFigures.end(), [&](const Figure& figure) { return figure.name == name; });
  return found == kFigures.end() ? nullptr : &*found;
}

}  // namespace

bool is_figure(const std::string& name) { return find_figure(name) != nullptr; }

Result<GalleryDrawing> figure_drawing(const std::string& name, const std::filesystem::path& scenes, Pipeline& pipeline) {
  const Figure& figure = *find_figure(name);
  const auto start = std::chrono::steady_clock::now();
  auto image = figure.draw(scenes, pipeline);
  if (!image) return Error{name + ": " + image.error().message};
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  char performance[48] = "drawn by the pipeline itself";
  if (figure.traced) std::snprintf(performance, sizeof performance, "rays traced in %.1f s", seconds);
  return GalleryDrawing{*std::move(image), figure.title, figure.source, figure.caption, performance};
}

}  // namespace tuberia::cli
