#pragma once
// What is drawn to measure a trade, and what it should look like.

#include <functional>
#include <string>
#include <vector>

#include "bench/trade/frame.hpp"
#include "bench/trade/picture_error.hpp"

namespace tuberia::bench::trade {

struct Scene {
  using Picture = Image<Rgba32F>;

  std::string name, what;  // a word or two; a sentence
  Recipe recipe;           // to which a setting is applied
  std::function<Result<Frame>(const Recipe&)> build;

  // What the picture should be: by a formula, or else as the reference setting draws it with so many samples each
  // way in a pixel. With 1 the reference setting is right by definition.
  std::function<Picture()> ideal{};
  int ideal_supersampling = 1;

  // How wrong a picture is, in the unit of its stage; without a function, the RMSE in codes.
  std::function<double(const Picture& picture, const Picture& ideal)> error{};
  bool is_picture = true;  // false: the colours are numbers that nobody looks at
  Signal signal = Signal::as_it_is;
};

}  // namespace tuberia::bench::trade
