#pragma once
// Draws a scene on both machines and compares what they leave.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/pipeline.hpp"
#include "tests/differential/scene.hpp"

namespace tuberia::differential {

/// What was compared, and what of it differed.
struct Tally {
  std::int64_t states = 0, draws = 0;
  std::int64_t fragments = 0;           // drawn by the oracle
  std::int64_t samples = 0;             // compared, with their colour, depth and stencil
  std::int64_t drawn_channels = 0;      // colour channels of samples that the scene changed
  std::int64_t tied_channels = 0;       // of these: codes too near to a tie, or floats with bounds too far apart
  std::int64_t uncertain_samples = 0;   // a tie decided whether something is drawn there
  std::int64_t colour = 0, depth = 0, stencil = 0, counts = 0, refusals = 0;  // disagreements

  std::int64_t disagreements() const { return colour + depth + stencil + counts + refusals; }
  Tally& operator+=(const Tally&);
};

/// Pipelines for every instruction set and number of threads, kept from scene to scene.
class Machines {
 public:
  Pipeline& pipeline(int threads, InstructionSet);

 private:
  std::array<std::unique_ptr<Pipeline>, 16> pipelines_;
};

/// `first` receives a sentence about the first disagreement, if there is one.
Tally compare(const Scene&, Machines&, std::string& first);

}  // namespace tuberia::differential
