#pragma once

namespace bumpfoil {

/// Quantity prescribed for the journal of a bearing, or the plate of a strip.
enum class Control {
  displacement,  ///< its displacement, m
  load,          ///< the applied force, N
};

}  // namespace bumpfoil
