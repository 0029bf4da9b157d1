#include "bumpfoil/model/foil_design.hpp"

#include <cmath>

namespace bumpfoil {
namespace {

/// Positions at the same fraction of every pitch. Runs of equal pitches use multiplication, so that round-off does not
/// accumulate.
Vector positions_within_pitches(const std::vector<BumpShape>& bumps, double fraction) {
  Vector positions(static_cast<Eigen::Index>(bumps.size()));
  double run_start = 0.0;
  std::size_t first = 0;  // of the run
  for (std::size_t n = 0; n < bumps.size(); ++n) {
    const double pitch = bumps[first].pitch;
    if (bumps[n].pitch != pitch) {
      run_start += pitch * static_cast<double>(n - first);
      first = n;
    }
    positions[static_cast<Eigen::Index>(n)] = run_start + bumps[n].pitch * (static_cast<double>(n - first) + fraction);
  }
  return positions;
}

}  // namespace

BumpArc make_bump_arc(const BumpShape& bump) {
  const auto& [pitch, half_length, rise, thickness] = bump;
  return {.half_length = half_length,
          .rise = rise,
          .radius = (half_length * half_length + rise * rise) / (2.0 * rise),
          .half_angle = 2.0 * std::atan2(rise, half_length),
          .flat = pitch - 2.0 * half_length};
}

Vector crest_positions(const FoilDesign& foils) {
  return positions_within_pitches(foils.bumps, 0.5);
}

Vector foot_positions(const FoilDesign& foils) {
  const auto bumps = static_cast<Eigen::Index>(foils.bumps.size());
  if (foils.model != BumpFoilModel::frame) {
    Vector feet = Vector::Zero(foils.welded ? bumps : bumps + 1);
    feet.tail(bumps) = positions_within_pitches(foils.bumps, 1.0);
    return feet;
  }
  const Vector crests = crest_positions(foils);
  Vector feet(2 * bumps);
  for (Eigen::Index n = 0; n < bumps; ++n) {
    const double half_length = foils.bumps[static_cast<std::size_t>(n)].half_length;
    feet[2 * n] = crests[n] - half_length;
    feet[2 * n + 1] = crests[n] + half_length;
  }
  return feet;
}

}  // namespace bumpfoil
