#include "bench/trade/figures_of_theory.hpp"

#include "bench/trade/known_figures.hpp"

namespace tuberia::bench::trade {

std::vector<KnownFigure> known_figures(const TradeResult& result) {
  const Measured measured(result);
  Figures figures;
  add_subpixel_bits(figures, measured);
  add_edge_arithmetic(figures, measured);
  add_perspective(figures, measured);
  add_filters(figures, measured);
  add_edges(figures, measured);
  add_shading(figures, measured);
  add_approximations(figures);
  add_targets(figures, measured);
  add_depth(figures, measured);
  add_footprints(figures);
  return figures;
}

}  // namespace tuberia::bench::trade
