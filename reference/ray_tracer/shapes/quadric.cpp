#include "reference/ray_tracer/shapes/quadric.hpp"

#include <algorithm>
#include <string>

#include "reference/ray_tracer/shapes/centred_line.hpp"
#include "reference/ray_tracer/shapes/crossing.hpp"
#include "reference/ray_tracer/shapes/quadratic.hpp"
#include "reference/ray_tracer/shapes/revolution.hpp"

namespace tuberia::tracer {
namespace {

double largest_of(const glm::dmat4& matrix) noexcept {
  double largest = 0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
  return largest;
}

std::optional<Error> complaint(const glm::dmat4& matrix, const Box& box) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row]))
        return Error{"quadric: row " + std::to_string(row) + ", column " + std::to_string(column) + " is not finite"};
  const double largest = largest_of(matrix);
  if (largest == 0) return Error{"quadric: the matrix is 0"};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < column; ++row)
      if (std::abs(matrix[column][row] - matrix[row][column]) > 1e-12 * largest)
        return Error{"quadric: the matrix is not symmetric: row " + std::to_string(row) + ", column " + std::to_string(column) + " is " +
                     std::to_string(matrix[column][row]) + ", but its mirror image " + std::to_string(matrix[row][column])};
  if (box.empty()) return Error{"quadric: the box's lower corner is not below its upper one"};
  return std::nullopt;
}

/// Whether x'Ax >= 0 for all x: no principal minor is negative.
bool is_nowhere_negative(const glm::dmat4& m) noexcept {
  const double size = largest_of(m), square = 1e-12 * size * size, cube = square * size;
  const auto minor = [&](int i, int j) { return m[i][i] * m[j][j] - m[i][j] * m[j][i]; };
  const bool lengths = m[0][0] >= 0 && m[1][1] >= 0 && m[2][2] >= 0;
  const bool areas = minor(0, 1) >= -square && minor(1, 2) >= -square && minor(0, 2) >= -square;
  return lengths && areas && glm::dot(glm::dvec3(m[0]), glm::cross(glm::dvec3(m[1]), glm::dvec3(m[2]))) >= -cube;
}

double finite_middle(double lower, double upper) noexcept { return std::isfinite(lower) && std::isfinite(upper) ? 0.5 * (lower + upper) : 0; }

}  // namespace

Result<std::shared_ptr<const Quadric>> Quadric::create(const glm::dmat4& matrix, const glm::dvec3& lower, const glm::dvec3& upper) {
  const Box box{lower, upper};
  if (const std::optional<Error> error = complaint(matrix, box)) return *error;
  return std::shared_ptr<const Quadric>(new Quadric(matrix, box));
}

Quadric::Quadric(const glm::dmat4& matrix, const Box& box) noexcept
    : matrix_(matrix), box_(box), centre_(0), size_(0), is_convex_(is_nowhere_negative(matrix)) {
  for (int axis = 0; axis < 3; ++axis) {
    centre_[axis] = finite_middle(box.lower[axis], box.upper[axis]);
    for (const double side : {box.lower[axis], box.upper[axis]})
      if (std::isfinite(side)) size_ = std::max(size_, std::abs(side));
  }
}

double Quadric::value(const glm::dvec3& point) const noexcept {
  const glm::dvec4 p(point, 1);
  return glm::dot(p, matrix_ * p);
}

glm::dvec3 Quadric::gradient(const glm::dvec3& point) const noexcept { return 2.0 * glm::dvec3(matrix_ * glm::dvec4(point, 1)); }

std::optional<ShapeHit> Quadric::intersect(const Ray& ray) const noexcept {
  const CentredLine line(ray, centre_);
  const glm::dvec4 origin(centre_ + line.origin, 1), direction(line.direction, 0);
  const glm::dvec4 turned = matrix_ * direction;
  const QuadraticRoots roots = solve_quadratic(glm::dot(direction, turned), 2 * glm::dot(origin, turned), value(glm::dvec3(origin)));
  if (roots.count == 0 || (roots.count == 2 && roots.first == roots.second)) return std::nullopt;

  // A little more than the box, so that what just fits in it has no holes where rounding puts points beyond.
  const double margin = 1e-13 * size_;
  for (const double s : {roots.first, roots.second}) {
    const double t = line.t_of(s);
    const glm::dvec3 at = centre_ + line.at(s);
    bool is_inside = true;
    for (int axis = 0; axis < 3; ++axis) is_inside = is_inside && at[axis] >= box_.lower[axis] - margin && at[axis] <= box_.upper[axis] + margin;
    if (is_inside && is_within(ray, t)) return ShapeHit{.t = t};
  }
  return std::nullopt;
}

SurfacePoint Quadric::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  SurfacePoint point;
  point.position = ray.at(hit.t);
  for (int i = 0; i < 2; ++i) {
    const glm::dvec3 slope = gradient(point.position);
    const double square = glm::dot(slope, slope);
    if (square > 0) point.position -= value(point.position) / square * slope;
  }
  const glm::dvec3 slope = gradient(point.position);
  const double steepness = glm::length(slope);
  point.normal = point.geometric_normal = steepness > 0 ? slope / steepness : glm::dvec3(0, 1, 0);
  point.magnitude = std::max({size_, std::abs(point.position.x), std::abs(point.position.y), std::abs(point.position.z)});
  lay_image(point);
  return point;
}

/// The surface's own directions in which only u grows, at one height, or only v, in one half-plane through the axis.
void Quadric::lay_image(SurfacePoint& point) const noexcept {
  const bool has_height = std::isfinite(box_.lower.y) && std::isfinite(box_.upper.y) && box_.upper.y > box_.lower.y;
  const double height = has_height ? box_.upper.y - box_.lower.y : 1, top = has_height ? box_.upper.y : 0;
  const MeridianPlane at = meridian_plane(point.position - glm::dvec3(centre_.x, 0, centre_.z));
  point.texcoord = {at.u, (top - point.position.y) / height};

  const glm::dvec3 level = glm::cross({0, 1, 0}, point.normal), descent = glm::cross(point.normal, at.around);
  const double turning = glm::dot(level, at.around), falling = -descent.y;
  // Horizontal surfaces and those along a half-plane have no such directions.
  if (std::abs(turning) > 1e-9 && std::abs(falling) > 1e-9 && at.radius > 0) {
    point.tangent = kTurn * at.radius / turning * level;
    point.bitangent = height / falling * descent;
    return;
  }
  const glm::dvec3 axis = std::abs(point.normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  point.tangent = glm::normalize(axis - glm::dot(axis, point.normal) * point.normal);
  point.bitangent = glm::cross(point.tangent, point.normal);
}

}  // namespace tuberia::tracer
