#pragma once
// Models for looking at the stages, small enough to see every pixel.

#include "base/result.hpp"
#include "examples/tuberia/render_model.hpp"

namespace tuberia::cli {

struct Demo {
  std::string name, caption;
  Model model;
  RenderOptions options;  // size and camera
};

std::vector<std::string> demo_names();

/// name: one of demo_names().
Demo demo_named(const std::string& name);

}  // namespace tuberia::cli
