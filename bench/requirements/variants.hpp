#pragma once
// The pipelines that a scene is drawn with, and what each takes.

#include <optional>
#include <string>
#include <vector>

#include "bench/requirements/scenes.hpp"
#include "pipeline/pipeline.hpp"
#include "scene/requirements.hpp"

namespace tuberia::bench {

/// A way to draw a scene.
struct Variant {
  enum class Kind { bare, needed_alone, smallest, as_asked, neutral_alone, everything };
  Kind kind;
  std::string name;
  std::vector<DrawCall> draws;
  bool has_same_picture = true;     // as the scene: asserted of all but the bare ones
  double milliseconds = 0;          // median
  double first_quarter = 0, third_quarter = 0;
};

struct MeasuredScene {
  std::string name, caption;
  std::vector<Variant> variants;
  Requirements requirements;        // of its first draw that can be seen
  int draws = 0, needed_draws = 0;
  double examining_milliseconds = 0;
  bool pictures_are_equal = true;

  const Variant& of(Variant::Kind kind) const;
};

struct MeasureOptions {
  int threads = 1, rounds = 11;
  InstructionSet instruction_set = best_instruction_set();
};

/// Draws the scene in all its ways, in turns, `rounds` times.
MeasuredScene measure(const RequirementScene& scene, const MeasureOptions& options);

}  // namespace tuberia::bench
