#pragma once
// The parts of what script/bench trace measures and tells.

#include <string>

namespace tuberia::bench {

struct TraceOptions {
  bool quick = false;  // to try it out, not to quote
  int threads = 1;     // of what is built or traced by several
};

/// What one part found, in three forms.
struct TraceSection {
  std::string heading;
  std::string html;        // below the heading
  std::string markdown;    // without the heading
  std::string json_name, json;
  std::string complaint{};  // not empty: something is wrong that must not be, and the program fails
};

/// The accelerators against each other on scenes of 10 to a million objects.
TraceSection accelerators_section(const TraceOptions& options);

/// The notes' 10,584 objects: what accelerators save.                                  [B 5.7]
TraceSection claim_section(const TraceOptions& options);

/// The fast kernel beside Embree, on the bunny and on one of a million triangles.
TraceSection embree_section(const TraceOptions& options);

}  // namespace tuberia::bench
