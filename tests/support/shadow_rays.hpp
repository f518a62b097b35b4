#pragma once
// Shadows by brute force: a segment against every triangle, in double. It shares nothing with the maps.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "tests/support/mesh.hpp"

namespace tuberia::test {

/// A ray's points are origin + t direction.
struct Ray {
  glm::dvec3 origin, direction;
  glm::dvec3 at(double t) const { return origin + t * direction; }
};

struct RayHit {
  double t = std::numeric_limits<double>::infinity();
  glm::dvec3 normal{0};  // of the triangle, unit, to the side from which it is counter-clockwise
  glm::dvec3 shading_normal{0};  // the mesh's normals, interpolated, unit
  explicit operator bool() const { return std::isfinite(t); }
};

/// One mesh in world space, with a sphere around it so that far rays are soon done with.
class RayMesh {
 public:
  explicit RayMesh(const Mesh& mesh, const glm::dmat4& world_from_object = glm::dmat4(1)) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      Corner corners[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t index = mesh.indices[i + k];
        corners[k].position = glm::dvec3(world_from_object * glm::dvec4(glm::dvec3(mesh.positions[index]), 1));
        corners[k].normal = glm::dmat3(world_from_object) * glm::dvec3(mesh.normals[index]);
        centre_ += corners[k].position;
      }
      triangles_.push_back({corners[0], corners[1], corners[2]});
    }
    centre_ /= static_cast<double>(3 * triangles_.size());
    for (const Triangle& t : triangles_)
      for (const Corner* c : {&t.a, &t.b, &t.c}) squared_radius_ = std::max(squared_radius_, glm::dot(c->position - centre_, c->position - centre_));
  }

  /// The first hit with nearest < t < hit.t, if there is one, replaces `hit`.
  void hit(const Ray& ray, double nearest, RayHit& hit) const {
    const glm::dvec3 to_centre = centre_ - ray.origin;
    const double along = glm::dot(to_centre, ray.direction) / glm::dot(ray.direction, ray.direction);
    const glm::dvec3 apart = to_centre - along * ray.direction;
    if (glm::dot(apart, apart) > squared_radius_ * (1 + 1e-9)) return;
    for (const Triangle& t : triangles_) hit_triangle(t, ray, nearest, hit);
  }

 private:
  struct Corner {
    glm::dvec3 position, normal;
  };
  struct Triangle {
    Corner a, b, c;
  };

  /// By Cramer's rule for the point's weights in the triangle and its place on the ray.
  static void hit_triangle(const Triangle& triangle, const Ray& ray, double nearest, RayHit& hit) {
    const glm::dvec3 e1 = triangle.b.position - triangle.a.position, e2 = triangle.c.position - triangle.a.position;
    const glm::dvec3 p = glm::cross(ray.direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0) return;
    const glm::dvec3 from_a = ray.origin - triangle.a.position;
    const double u = glm::dot(from_a, p) / determinant;
    if (u < 0 || u > 1) return;
    const glm::dvec3 q = glm::cross(from_a, e1);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (v < 0 || u + v > 1) return;
    const double t = glm::dot(e2, q) / determinant;
    if (!(t > nearest && t < hit.t)) return;
    hit = {t, glm::normalize(glm::cross(e1, e2)), glm::normalize((1 - u - v) * triangle.a.normal + u * triangle.b.normal + v * triangle.c.normal)};
  }

  std::vector<Triangle> triangles_;
  glm::dvec3 centre_{0};
  double squared_radius_ = 0;
};

class RayScene {
 public:
  void add(const Mesh& mesh, const glm::dmat4& world_from_object = glm::dmat4(1)) { meshes_.emplace_back(mesh, world_from_object); }

  RayHit first_hit(const Ray& ray, double nearest = 0, double farthest = std::numeric_limits<double>::infinity()) const {
    RayHit hit{.t = farthest};
    for (const RayMesh& mesh : meshes_) mesh.hit(ray, nearest, hit);
    return hit.t < farthest ? hit : RayHit{};
  }

  /// V of [A 1.3]: whether nothing lies strictly between a point of a surface and a light. to_light: all
  /// the way for a point light, any length for a directional one.
  bool is_visible(const glm::dvec3& point, const glm::dvec3& to_light, bool is_directional) const {
    return !first_hit({point, to_light}, 1e-7, is_directional ? std::numeric_limits<double>::infinity() : 1.0);
  }

 private:
  std::vector<RayMesh> meshes_;
};

}  // namespace tuberia::test
