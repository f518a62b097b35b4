#pragma once
// The targets of probes.

#include "bench/trade/recipe.hpp"

namespace tuberia::bench::trade {

inline Recipe probe_recipe(int width, int height, ColourFormat format = ColourFormat::rgba8) {
  Recipe recipe;
  recipe.target = {.width = width, .height = height, .colour = format};
  return recipe;
}

}  // namespace tuberia::bench::trade
