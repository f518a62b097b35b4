// Embree behind the interface that all kernels share.

#include <embree3/rtcore.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>

#include "bench/trace/ray_kernel.hpp"

namespace tuberia::bench {
namespace {

using tracer::FastHit;
using tracer::FastRay;

constexpr std::size_t kPacket = 16;

/// Tiny numbers are zeros as long as it lives, as Embree's manual asks of every thread.
class TinyNumbersAreZeros {
 public:
#if defined(__SSE__)
  TinyNumbersAreZeros() { _mm_setcsr(before_ | 0x8040); }
  ~TinyNumbersAreZeros() { _mm_setcsr(before_); }

 private:
  unsigned before_ = _mm_getcsr();
#endif
};

struct DeviceDeleter {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneDeleter {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceDeleter>;
using Scene = std::unique_ptr<RTCSceneTy, SceneDeleter>;

/// A scene of one mesh that shares its arrays.
class EmbreeScene {
 public:
  EmbreeScene(const TriangleSoup& triangles, int threads, RTCSceneFlags flags) : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())) {
    rtcSetDeviceMemoryMonitorFunction(device_.get(), count_bytes, &bytes_);
    for (int build = 0; build < 3; ++build) {
      scene_.reset();
      const auto start = std::chrono::steady_clock::now();
      scene_.reset(rtcNewScene(device_.get()));
      rtcSetSceneFlags(scene_.get(), flags);
      add_mesh(triangles);
      rtcCommitScene(scene_.get());
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      build_seconds = std::min(build_seconds, elapsed.count());
    }
  }

  RTCScene get() const { return scene_.get(); }
  std::int64_t memory_bytes() const { return bytes_; }
  double build_seconds = 1e9;  // the fastest of three

 private:
  static bool count_bytes(void* sum, ssize_t bytes, bool) {
    *static_cast<std::atomic<std::int64_t>*>(sum) += bytes;
    return true;
  }

  void add_mesh(const TriangleSoup& triangles) {
    RTCGeometry mesh = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto& [name, positions, indices] = triangles;
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0, sizeof(glm::vec3), positions.size());
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices.data(), 0, 3 * sizeof(std::uint32_t), indices.size() / 3);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_.get(), mesh);
    rtcReleaseGeometry(mesh);
  }

  std::atomic<std::int64_t> bytes_{0};
  Device device_;
  Scene scene_;
};

FastHit hit_of(float t, unsigned geometry, unsigned triangle, float u, float v) {
  return geometry == RTC_INVALID_GEOMETRY_ID ? FastHit{} : FastHit{t, triangle, u, v};
}

FastHit nearest(RTCScene scene, RTCIntersectContext& context, const FastRay& ray) {
  RTCRayHit asked;
  asked.ray = {ray.origin.x, ray.origin.y, ray.origin.z, ray.t_min, ray.direction.x, ray.direction.y, ray.direction.z, 0, ray.t_max, ~0u, 0, 0};
  asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &asked);
  return hit_of(asked.ray.tfar, asked.hit.geomID, asked.hit.primID, asked.hit.u, asked.hit.v);
}

class EmbreeSingle final : public RayKernel {
 public:
  EmbreeSingle(std::string name, const TriangleSoup& triangles, int threads, RTCSceneFlags flags) : name_(std::move(name)), scene_(triangles, threads, flags) {
    build_seconds = scene_.build_seconds;
    memory_bytes = scene_.memory_bytes();
  }

  std::string name() const override { return name_; }
  void find(std::span<const FastRay> rays, std::span<FastHit> hits) const override {
    const TinyNumbersAreZeros guard;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = nearest(scene_.get(), context, rays[i]);
  }

 private:
  std::string name_;
  EmbreeScene scene_;
};

class EmbreePackets final : public RayKernel {
 public:
  EmbreePackets(const TriangleSoup& triangles, int threads) : scene_(triangles, threads, RTC_SCENE_FLAG_NONE) {
    build_seconds = scene_.build_seconds;
    memory_bytes = scene_.memory_bytes();
  }

  std::string name() const override { return "Embree, 16 at a time, as coherent"; }
  void find(std::span<const FastRay> rays, std::span<FastHit> hits) const override {
    const TinyNumbersAreZeros guard;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (std::size_t first = 0; first < rays.size(); first += kPacket) {
      const std::size_t count = std::min(kPacket, rays.size() - first);
      trace(context, rays.subspan(first, count), hits.subspan(first, count));
    }
  }

 private:
  void trace(RTCIntersectContext& context, std::span<const FastRay> rays, std::span<FastHit> hits) const {
    alignas(64) int valid[kPacket] = {};
    RTCRayHit16 asked;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const FastRay& ray = rays[i];
      valid[i] = -1;
      asked.ray.org_x[i] = ray.origin.x, asked.ray.org_y[i] = ray.origin.y, asked.ray.org_z[i] = ray.origin.z;
      asked.ray.dir_x[i] = ray.direction.x, asked.ray.dir_y[i] = ray.direction.y, asked.ray.dir_z[i] = ray.direction.z;
      asked.ray.tnear[i] = ray.t_min, asked.ray.tfar[i] = ray.t_max, asked.ray.time[i] = 0;
      asked.ray.mask[i] = ~0u, asked.ray.flags[i] = 0;
      asked.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, scene_.get(), &context, &asked);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = hit_of(asked.ray.tfar[i], asked.hit.geomID[i], asked.hit.primID[i], asked.hit.u[i], asked.hit.v[i]);
  }

  EmbreeScene scene_;
};

}  // namespace

RayKernels embree_kernels(const TriangleSoup& triangles, int threads) {
  RayKernels kernels;
  kernels.push_back(std::make_unique<EmbreeSingle>("Embree, one by one", triangles, threads, RTC_SCENE_FLAG_NONE));
  kernels.push_back(std::make_unique<EmbreeSingle>("Embree, robust, one by one", triangles, threads, RTC_SCENE_FLAG_ROBUST));
  kernels.push_back(std::make_unique<EmbreePackets>(triangles, threads));
  return kernels;
}

std::string embree_sentence() {
  const Device device(rtcNewDevice(nullptr));
  const auto has = [&](RTCDeviceProperty property) { return rtcGetDeviceProperty(device.get(), property) != 0; };
  const char* const widest = has(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)  ? "AVX-512"
                             : has(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? "AVX or AVX2"
                                                                              : "SSE";
  return "Embree " RTC_VERSION_STRING " with its kernels for " + std::string(widest);
}

}  // namespace tuberia::bench
