// Probes of coverage and of edges.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "bench/trade/probe_geometry.hpp"
#include "bench/trade/probe_recipe.hpp"
#include "bench/trade/probes.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr Rgba32F kNothing{0, 0, 0, 0};

// ---- Coverage

constexpr int kCoverageSize = 2048, kCell = 32, kChannels = 4;

struct FineTriangles {
  Shape shape{};
  std::vector<std::array<FinePoint, 3>> triangles{};  // a quarter of them for each channel, in turns
  double edge_pixels = 0;
};

/// A coordinate in pixels that is a clip coordinate of 23 fractional bits, and so both exactly.
FinePoint random_point(Random& random, int left, int top) {
  const auto fine = [&](int from) {
    return std::llround(std::ldexp(random.between(from + 1, from + kCell - 1), kFineBits));
  };
  const std::int64_t x = fine(left);
  return {x, fine(top)};
}

std::shared_ptr<const FineTriangles> fine_triangles() {
  constexpr double kClipPerFine = 2.0 / kCoverageSize / (1 << kFineBits);
  auto all = std::make_shared<FineTriangles>();
  Random random(1);
  for (int top = 0; top < kCoverageSize; top += kCell)
    for (int left = 0; left < kCoverageSize; left += kCell)
      for (int channel = 0; channel < kChannels; ++channel) {
        std::array<FinePoint, 3> triangle;
        for (FinePoint& point : triangle) point = random_point(random, left, top);
        glm::vec4 colour(0);
        colour[channel] = 1;
        for (const FinePoint& point : triangle) {
          all->shape.clip_positions.emplace_back(static_cast<double>(point.x) * kClipPerFine - 1,
                                                 1 - static_cast<double>(point.y) * kClipPerFine, 0, 1);
          all->shape.colours.push_back(colour);
        }
        all->triangles.push_back(triangle);
        all->edge_pixels += perimeter(triangle);
      }
  return all;
}

float& component(Rgba32F& pixel, std::size_t channel) {
  return channel == 0 ? pixel.r : channel == 1 ? pixel.g : channel == 2 ? pixel.b : pixel.a;
}

Scene::Picture exact_coverage(const FineTriangles& all) {
  Scene::Picture picture(kCoverageSize, kCoverageSize, kNothing);
  constexpr int kCellsPerRow = kCoverageSize / kCell;
  for (std::size_t i = 0; i < all.triangles.size(); ++i) {
    const int cell = static_cast<int>(i / kChannels), left = cell % kCellsPerRow * kCell,
              top = cell / kCellsPerRow * kCell;
    for (int y = top; y < top + kCell; ++y)
      for (int x = left; x < left + kCell; ++x)
        if (covers_centre(all.triangles[i], x, y)) component(picture.at(x, y), i % kChannels) = 1;
  }
  return picture;
}

double wrong_pixels(const Scene::Picture& picture, const Scene::Picture& ideal) {
  std::int64_t wrong = 0;
  for (std::size_t i = 0; i < ideal.pixels().size(); ++i) {
    const Rgba32F &p = picture.pixels()[i], &q = ideal.pixels()[i];
    for (const auto& [mine, theirs] : {std::pair{p.r, q.r}, {p.g, q.g}, {p.b, q.b}, {p.a, q.a}})
      wrong += (mine > 0.5f) != (theirs > 0.5f) ? 1 : 0;
  }
  return static_cast<double>(wrong);
}

/// How often each pixel is covered by the triangles of each channel, up to 255, is its colour.
std::shared_ptr<const FineTriangles> overlapping_triangles(int size) {
  constexpr int kTriangles = 200;
  const double clip_per_fine = 2.0 / size / (1 << kFineBits);
  auto all = std::make_shared<FineTriangles>();
  Random random(5);
  for (int i = 0; i < kTriangles * kChannels; ++i) {
    std::array<FinePoint, 3> triangle;
    glm::vec4 colour(0);
    colour[i % kChannels] = 1.0f / 255;
    for (FinePoint& point : triangle) {
      point.x = std::llround(std::ldexp(random.between(0, size), kFineBits));
      point.y = std::llround(std::ldexp(random.between(0, size), kFineBits));
      all->shape.clip_positions.emplace_back(static_cast<double>(point.x) * clip_per_fine - 1,
                                             1 - static_cast<double>(point.y) * clip_per_fine, 0, 1);
      all->shape.colours.push_back(colour);
    }
    all->edge_pixels += perimeter(triangle);
  }
  return all;
}

double differing_counts(const Scene::Picture& picture, const Scene::Picture& ideal) {
  double sum = 0;
  for (std::size_t i = 0; i < ideal.pixels().size(); ++i) {
    const Rgba32F &p = picture.pixels()[i], &q = ideal.pixels()[i];
    for (const auto& [mine, theirs] : {std::pair{p.r, q.r}, {p.g, q.g}, {p.b, q.b}, {p.a, q.a}})
      sum += std::round(std::abs(mine - theirs) * 255);
  }
  return sum;
}

Scene added_up(std::string name, std::string what, int size, std::shared_ptr<const FineTriangles> triangles) {
  Scene scene{.name = std::move(name),
              .what = std::move(what),
              .recipe = probe_recipe(size, size),
              .build = [triangles](const Recipe& recipe) -> Result<Frame> {
                auto frame = Frame::create(recipe, kNothing);
                if (!frame) return frame.error();
                PipelineState state = recipe.state;
                state.depth = kDepthOff;
                state.blend.mode = BlendMode::additive;
                frame->add({triangles, &triangles->shape}, flat(), state);
                return frame;
              }};
  scene.is_picture = false;
  return scene;
}

// ---- Edges

constexpr int kEdgesSize = 512, kEdgeCell = 64;
using Corners = std::vector<glm::dvec2>;  // of one convex polygon, pixels

std::vector<Corners> polygons(bool near_axis) {
  std::vector<Corners> all;
  Random random(near_axis ? 3 : 2);
  for (int top = 0; top < kEdgesSize; top += kEdgeCell)
    for (int left = 0; left < kEdgesSize; left += kEdgeCell) {
      Corners corners;
      glm::dvec2 middle(left + kEdgeCell / 2, top + kEdgeCell / 2);
      middle.x += random.between(-1, 1);
      middle.y += random.between(-1, 1);
      const double lean = glm::radians(random.between(0.5, 4.0)) * (random.bits() % 2 == 0 ? 1 : -1);
      const double turn = near_axis ? lean + glm::pi<double>() / 4 : random.between(0, 2 * glm::pi<double>());
      const int count = near_axis ? 4 : 3;
      for (int i = 0; i < count; ++i) {
        const double angle = turn + 2 * glm::pi<double>() * i / count;
        corners.push_back(middle +
                          random.between(near_axis ? 30 : 24, 30) * glm::dvec2(std::cos(angle), std::sin(angle)));
      }
      all.push_back(corners);
    }
  return all;
}

std::shared_ptr<const Shape> shape_of(const std::vector<Corners>& all) {
  auto shape = std::make_shared<Shape>();
  for (const Corners& corners : all) {
    const auto first = static_cast<std::uint32_t>(shape->clip_positions.size());
    for (const glm::dvec2& corner : corners)
      shape->clip_positions.emplace_back(2 * corner.x / kEdgesSize - 1, 1 - 2 * corner.y / kEdgesSize, 0, 1);
    for (std::uint32_t i = 2; i < corners.size(); ++i)
      shape->indices.insert(shape->indices.end(), {first, first + i - 1, first + i});
  }
  return shape;
}

Scene::Picture exact_areas(const std::vector<Corners>& all) {
  Scene::Picture picture(kEdgesSize, kEdgesSize, kNothing);
  constexpr int kCellsPerRow = kEdgesSize / kEdgeCell;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int cell = static_cast<int>(i), left = cell % kCellsPerRow * kEdgeCell, top = cell / kCellsPerRow * kEdgeCell;
    for (int y = top; y < top + kEdgeCell; ++y)
      for (int x = left; x < left + kEdgeCell; ++x) {
        const auto covered = static_cast<float>(covered_area(all[i], x, y));
        picture.at(x, y) = {covered, covered, covered, covered};
      }
  }
  return picture;
}

double rms_over_edges(const Scene::Picture& picture, const Scene::Picture& ideal) {
  double squares = 0, crossed = 0;
  for (std::size_t i = 0; i < ideal.pixels().size(); ++i) {
    const double exact = static_cast<double>(ideal.pixels()[i].r);
    if (exact <= 1e-6 || exact >= 1 - 1e-6) continue;
    const double difference = static_cast<double>(picture.pixels()[i].r) - exact;
    squares += difference * difference;
    ++crossed;
  }
  return std::sqrt(squares / crossed);
}

}  // namespace

Scene random_triangles() {
  const auto triangles = fine_triangles();
  Scene scene =
      added_up("random triangles",
               "16,384 triangles of some 15 pixels, at positions of 13 fractional bits, against exact coverage",
               kCoverageSize, triangles);
  scene.ideal = [triangles] { return exact_coverage(*triangles); };
  scene.error = [triangles](const Scene::Picture& picture, const Scene::Picture& ideal) {
    return 1000 * wrong_pixels(picture, ideal) / triangles->edge_pixels;
  };
  return scene;
}

Scene large_triangles(int size) {
  const auto triangles = overlapping_triangles(size);
  Scene scene = added_up("triangles over " + std::to_string(size) + " px",
                         "800 triangles over the whole target, against exact edge functions", size, triangles);
  scene.error = [triangles](const Scene::Picture& picture, const Scene::Picture& ideal) {
    return 1000 * differing_counts(picture, ideal) / triangles->edge_pixels;
  };
  return scene;
}

Scene polygon_edges(bool near_axis) {
  const auto all = polygons(near_axis);
  Scene scene{.name = near_axis ? "edges near the axes" : "edges in all directions",
              .what = near_axis
                          ? "64 rectangles whose sides lean 0.5 to 4 degrees, against the exact area in every pixel"
                          : "64 triangles in all directions, against the exact area in every pixel",
              .recipe = probe_recipe(kEdgesSize, kEdgesSize),
              .build = [shape = shape_of(all)](const Recipe& recipe) -> Result<Frame> {
                auto frame = Frame::create(recipe, kNothing);
                if (!frame) return frame.error();
                PipelineState state = recipe.state;
                state.depth = kDepthOff;
                frame->add(shape, flat(), state);
                return frame;
              }};
  scene.ideal = [all] { return exact_areas(all); };
  scene.error = rms_over_edges;
  return scene;
}

}  // namespace tuberia::bench::trade
