#pragma once
// One renderer among those compared: everything the comparison needs of it.

#include <memory>
#include <string>

#include "base/result.hpp"
#include "bench/peers/workloads.hpp"
#include "image/image.hpp"
#include "raster/instruction_set.hpp"

namespace tuberia::bench {

class Peer {
 public:
  virtual ~Peer() = default;

  /// A short name for tables and file names, like "llvmpipe".
  virtual std::string name() const = 0;

  /// Takes over what a renderer keeps between frames: vertices, textures, compiled state. Not
  /// timed. The workload outlives the frames; the next call replaces this one's.
  virtual Result<Nothing> prepare(const Workload& workload) = 0;

  /// Clears, draws, and returns when the last pixel is in memory. Timed.
  virtual void frame() = 0;

  /// The last frame, upper row first. Of a depth-only workload: depth as grey, 0 black, 1 white,
  /// rounded to the nearest code. Not timed.
  virtual Image<Rgba8> picture() = 0;
};

/// Mesa's software renderer through OSMesa. threads: its rasterizer threads, 1..16; the calling
/// thread does the geometry beside them. Sets environment variables that Mesa reads; at most one at
/// a time, used by the thread that made it. Error when OSMesa refuses.
Result<std::unique_ptr<Peer>> make_osmesa_peer(int threads);

/// This project. threads: all it uses, 1 or more.
Result<std::unique_ptr<Peer>> make_tuberia_peer(int threads, InstructionSet instruction_set, Precision precision);

}  // namespace tuberia::bench
