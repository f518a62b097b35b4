#pragma once
// Features that a draw does not need, added so that they are computed and change nothing: what it would
// cost to have everything on.

#include <optional>
#include <span>

#include "scene/requirements.hpp"

namespace tuberia {

/// The features that can be added so, in the order of the pipeline.
std::span<const Feature> neutral_features() noexcept;

/// The draw with a feature more that leaves every bit of the picture as it is; nothing if this draw, or this
/// target, has no neutral form of it, or has it already. The target must be of 8-bit codes.
std::optional<DrawCall> with_neutral(const DrawCall& draw, Feature feature, const RenderTargetDescription& target);

/// With all of them that there are for it.
DrawCall with_everything(const DrawCall& draw, const RenderTargetDescription& target);

}  // namespace tuberia
