#pragma once
// Colours that are computed instead of stored: procedural textures.

#include "math/patterns.hpp"  // struct Pattern, which references share
