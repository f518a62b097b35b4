#include <algorithm>
#include <cmath>

#include "bench/trace/ray_kernel.hpp"
#include "reference/ray_tracer/accelerators/accelerator.hpp"
#include "reference/ray_tracer/geometry.hpp"

namespace tuberia::bench {
namespace {

using tracer::FastHit;
using tracer::FastRay;
using tracer::FastTriangles;

/// The fastest of three builds.
FastTriangles built(const TriangleSoup& soup, int threads) {
  Workers workers(threads);
  const auto build = [&] { return FastTriangles::create(soup.positions, soup.indices, workers).value(); };
  FastTriangles best = build();
  for (int i = 1; i < 3; ++i)
    if (FastTriangles again = build(); again.facts().build_seconds < best.facts().build_seconds) best = std::move(again);
  return best;
}

class FastKernel : public RayKernel {
 public:
  explicit FastKernel(std::shared_ptr<const FastTriangles> triangles) : triangles_(std::move(triangles)) {
    build_seconds = triangles_->facts().build_seconds;
    memory_bytes = triangles_->facts().memory_bytes;
  }

 protected:
  std::shared_ptr<const FastTriangles> triangles_;
};

class FastSingle final : public FastKernel {
 public:
  using FastKernel::FastKernel;
  std::string name() const override { return "ours, one by one"; }
  void find(std::span<const FastRay> rays, std::span<FastHit> hits) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = triangles_->nearest(rays[i]);
  }
};

class FastBundles final : public FastKernel {
 public:
  using FastKernel::FastKernel;
  std::string name() const override { return "ours, 16 at a time"; }
  void find(std::span<const FastRay> rays, std::span<FastHit> hits) const override { triangles_->nearest(rays, hits); }
};

Mesh mesh_of(const TriangleSoup& soup) {
  Mesh mesh;
  mesh.positions = soup.positions;
  mesh.indices = soup.indices;
  return mesh;
}

class InDoubles final : public RayKernel {
 public:
  InDoubles(const TriangleSoup& soup, int threads) {
    geometry_.add_mesh(mesh_of(soup), glm::dmat4(1), 0);
    Workers workers(threads);
    accelerator_ = tracer::make_accelerator(tracer::AcceleratorKind::bvh, geometry_, workers);
    build_seconds = accelerator_->facts().build_seconds;
    memory_bytes = accelerator_->facts().memory_bytes;
  }

  std::string name() const override { return "ours, in doubles"; }
  int patience() const override { return 16; }
  void find(std::span<const FastRay> rays, std::span<FastHit> hits) const override {
    tracer::Traversal traversal;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const FastRay& ray = rays[i];
      const tracer::Hit hit = accelerator_->nearest({glm::dvec3(ray.origin), glm::dvec3(ray.direction), ray.t_min, ray.t_max}, traversal);
      hits[i] = !hit ? FastHit{}
                     : FastHit{static_cast<float>(hit.t), static_cast<std::uint32_t>(hit.item), static_cast<float>(hit.at.x), static_cast<float>(hit.at.y)};
    }
  }

 private:
  tracer::Geometry geometry_;
  std::unique_ptr<tracer::Accelerator> accelerator_;
};

}  // namespace

RayKernels our_kernels(const TriangleSoup& triangles, int threads) {
  const auto fast = std::make_shared<const FastTriangles>(built(triangles, threads));
  RayKernels kernels;
  kernels.push_back(std::make_unique<FastSingle>(fast));
  kernels.push_back(std::make_unique<FastBundles>(fast));
  kernels.push_back(std::make_unique<InDoubles>(triangles, threads));
  return kernels;
}

}  // namespace tuberia::bench
