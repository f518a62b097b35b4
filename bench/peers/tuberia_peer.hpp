#pragma once
// This project behind the interface that all peers share; and, for those who look closer, its draws.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bench/peers/peer.hpp"
#include "pipeline/pipeline.hpp"
#include "raster/texture.hpp"

namespace tuberia::bench {

class TuberiaPeer final : public Peer {
 public:
  /// threads: all it uses, 1 or more. The instruction set must be supported.
  TuberiaPeer(int threads, InstructionSet instruction_set, Precision precision)
      : pipeline_({.threads = threads, .instruction_set = instruction_set, .precision = precision}) {}

  std::string name() const override { return "tuberia"; }
  Result<Nothing> prepare(const Workload& workload) override;
  void frame() override;
  Image<Rgba8> picture() override;

  // A frame in pieces; only after prepare.
  void clear();
  std::span<const DrawCall> draws() const noexcept { return draws_; }
  Pipeline& pipeline() noexcept { return pipeline_; }
  RenderTarget& target() noexcept { return *target_; }

 private:
  void take_mesh(const WorkloadMesh& mesh);
  void take_textures(int size_texels);
  DrawCall draw_of(const Workload& workload, std::size_t texture, std::span<const std::uint32_t> indices) const;

  Pipeline pipeline_;
  std::optional<RenderTarget> target_;
  bool depth_only_ = false;
  std::vector<std::shared_ptr<const Texture>> textures_;
  std::vector<glm::vec3> positions_, normals_;
  std::vector<glm::vec2> texcoords_;
  std::vector<glm::vec4> colours_;
  std::vector<std::uint32_t> indices_;
  std::vector<DrawCall> draws_;
};

}  // namespace tuberia::bench
