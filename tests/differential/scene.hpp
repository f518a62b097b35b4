#pragma once
// A small scene that both machines draw: a target, and some draws over each other.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/pipeline.hpp"
#include "reference/oracle/oracle.hpp"

namespace tuberia::differential {

struct TargetDescription {
  int width = 16, height = 16, samples = 1;
  oracle::ColourFormat colour = oracle::ColourFormat::rgba8;
  oracle::DepthFormat depth = oracle::DepthFormat::d24;
  bool has_stencil = false;
  glm::vec4 clear_colour{0};
  float clear_depth = 1;
  std::uint8_t clear_stencil = 0;
};

struct Scene {
  std::uint64_t seed = 0;
  TargetDescription target;
  std::vector<oracle::Draw> draws;
  std::optional<oracle::Clear> clear;  // after the first draw
  std::vector<std::shared_ptr<const oracle::Texture>> textures;  // which the draws point to
  bool is_counted = true;  // uncounted draws may take the fused loops
  int threads = 1;
  InstructionSet instruction_set = InstructionSet::baseline;
};

/// The scene that a seed names; the same on every machine, but for the instruction set.
Scene random_scene(std::uint64_t seed);

}  // namespace tuberia::differential
