#include "scene/shapes/teapot.hpp"

#include <span>

namespace tuberia {
namespace {

// How far along its tangent the inner control point of a quarter circle of radius 1 lies. A circle is nearer
// with 0.5523; the teapot is as it is.
constexpr double kQuarter = 0.56, kKnobQuarter = 0.5625;

/// A control point of a profile that turns about the axis.
struct ProfilePoint {
  double radius, height, quarter = kQuarter;
};

/// Four control points across a tube: y and x of its two edges in the plane of symmetry, and how far its sides bulge.
struct TubeRow {
  double first_x, first_height, second_x, second_height, half_width;
};

// From above to below; each four points make a ring of four patches, whose last point is the next ring's first.  [Newell]
constexpr ProfilePoint kLid[] = {{0, 3.15}, {0.8, 3.15, kKnobQuarter}, {0, 2.85}, {0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}};
constexpr ProfilePoint kBody[] = {{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4},  {1.75, 1.875},
                                  {2, 1.35},  {2, 0.9},          {2, 0.45},         {1.5, 0.225}, {1.5, 0.15}};
constexpr ProfilePoint kBottom[] = {{1.5, 0.15}, {1.5, 0.075}, {1.425, 0}, {0, 0}};
constexpr TubeRow kHandle[] = {{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3}, {-2.7, 2.025, -3, 2.25, 0.3},
                               {-2.7, 1.8, -3, 1.8, 0.3},      {-2.7, 1.575, -3, 1.35, 0.3},   {-2.5, 1.125, -2.65, 0.9375, 0.3},
                               {-2, 0.9, -1.9, 0.6, 0.3}};
constexpr TubeRow kSpout[] = {{1.7, 1.425, 1.7, 0.6, 0.66},       {2.6, 1.425, 3.1, 0.825, 0.66},  {2.3, 2.1, 2.4, 2.025, 0.25},
                              {2.7, 2.4, 3.3, 2.4, 0.25},         {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
                              {2.8, 2.4, 3.2, 2.4, 0.15}};

constexpr int kLidPatches = 8, kBodyPatches = 12, kBottomPatches = 4;

/// The direction from the axis after so many quarter turns from +x, counter-clockwise seen from above.
glm::dvec3 after_quarters(int quarters) {
  constexpr double kX[] = {1, 0, -1, 0}, kZ[] = {0, -1, 0, 1};
  return {kX[quarters % 4], 0, kZ[quarters % 4]};
}

/// Rings of four patches. Their v runs from v_from to v_to.
void append_rings(std::vector<BezierPatch>& patches, std::span<const ProfilePoint> profile, double v_from, double v_to) {
  const std::size_t rings = (profile.size() - 1) / 3;
  for (std::size_t ring = 0; ring < rings; ++ring)
    for (int quarter = 0; quarter < 4; ++quarter) {
      const glm::dvec3 begin = after_quarters(quarter), end = after_quarters(quarter + 1);
      BezierPatch patch;
      for (std::size_t row = 0; row < 4; ++row) {
        const ProfilePoint& point = profile[3 * ring + row];
        const glm::dvec3 height(0, point.height, 0);
        patch.points[4 * row + 0] = height + point.radius * begin;
        patch.points[4 * row + 1] = height + point.radius * (begin + point.quarter * end);
        patch.points[4 * row + 2] = height + point.radius * (point.quarter * begin + end);
        patch.points[4 * row + 3] = height + point.radius * end;
      }
      const auto v_at = [&](std::size_t border) { return v_from + (v_to - v_from) * static_cast<double>(border) / static_cast<double>(rings); };
      patch.texcoord_from = {0.25 * quarter, v_at(ring)};
      patch.texcoord_to = {0.25 * (quarter + 1), v_at(ring + 1)};
      patches.push_back(patch);
    }
}

/// Two lengths of tube, each of a half that bulges to +z and one that bulges to -z.
void append_tube(std::vector<BezierPatch>& patches, std::span<const TubeRow, 7> rows) {
  for (std::size_t length = 0; length < 2; ++length)
    for (const double side : {1.0, -1.0}) {
      BezierPatch patch;
      for (std::size_t i = 0; i < 4; ++i) {
        const TubeRow& row = rows[3 * length + i];
        const glm::dvec3 first(row.first_x, row.first_height, 0), second(row.second_x, row.second_height, 0);
        const glm::dvec3 bulge(0, 0, side * row.half_width);
        const glm::dvec3 &from = side > 0 ? second : first, &to = side > 0 ? first : second;
        patch.points[4 * i + 0] = from;
        patch.points[4 * i + 1] = from + bulge;
        patch.points[4 * i + 2] = to + bulge;
        patch.points[4 * i + 3] = to;
      }
      patch.texcoord_from = {side > 0 ? 0.0 : 0.5, 0.5 * static_cast<double>(length)};
      patch.texcoord_to = patch.texcoord_from + 0.5;
      patches.push_back(patch);
    }
}

}  // namespace

std::vector<BezierPatch> teapot_patches() {
  std::vector<BezierPatch> patches;
  append_rings(patches, kLid, 0, 1);
  append_rings(patches, kBody, 0, 0.75);
  append_rings(patches, kBottom, 0.75, 1);
  append_tube(patches, kHandle);
  append_tube(patches, kSpout);
  return patches;
}

Result<Mesh> teapot_mesh(const TeapotShape& shape) {
  std::vector<BezierPatch> patches = teapot_patches();
  const auto body = patches.begin() + kLidPatches, bottom = body + kBodyPatches;
  if (!shape.bottom) patches.erase(bottom, bottom + kBottomPatches);
  if (!shape.lid) patches.erase(patches.begin(), body);
  auto mesh = bezier_mesh({.patches = std::move(patches), .segments = shape.segments});
  if (!mesh) return Error{"teapot: " + mesh.error().message};
  mesh->name = "teapot";
  return mesh;
}

}  // namespace tuberia
