#pragma once
// How much fog there is at a distance.

#include "reference/oracle/interval.hpp"
#include "reference/oracle/state.hpp"

namespace tuberia::oracle {

/// The share of the colour that the fog lets through at a coordinate that is not negative.
Interval fog_share(const Fog& fog, Interval coordinate);

}  // namespace tuberia::oracle
