#pragma once
// The pipeline against the rational witness.

#include <array>
#include <memory>
#include <string>

#include "pipeline/pipeline.hpp"
#include "tests/witness/cases.hpp"

namespace tuberia::witness {

enum class Verdict : std::uint8_t { agreed, undecided, failed };

struct Finding {
  Verdict verdict = Verdict::agreed;
  std::string what;             // of anything but agreement
  std::int64_t pixels = 0;      // covered, with overdraw
  double depth_error = 0;       // the largest distance of a float depth from the exact plane, as a share of what is allowed
};

/// Pipelines of one thread, one for each instruction set, and targets, kept from case to case.
class Machines {
 public:
  Pipeline& pipeline(InstructionSet);
  RenderTarget& target(int width, int height, DepthFormat);

 private:
  std::array<std::unique_ptr<Pipeline>, kInstructionSetCount> pipelines_;
  std::vector<std::unique_ptr<RenderTarget>> targets_;
};

/// Draws the case and compares the coverage and the depth code of every pixel, and how many triangles
/// were cut and came of it.
Finding compare(const Case&, Machines&);

/// The case with all floats as bit patterns, as C++ that a test can hold, made as simple as it stays
/// wrong.
std::string explained(const Case&, Machines&);

}  // namespace tuberia::witness
