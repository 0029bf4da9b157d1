#pragma once

#include "bumpfoil/film/foil_film.hpp"

namespace bumpfoil {

/// Coefficients of the dimensionless balance and compatibility of one column (see FoilFilm):
/// |     balance        kink_before (M_before - M) + kink_after (M_after - M) + arc M - load sum_j omega_j (P_j - 1)
///     compatibility  the same of U, minus bend_before M_before + bend M + bend_after M_after
struct FoilColumn {
  double kink_before{}, kink_after{}, arc{};
  double bend_before{}, bend{}, bend_after{};
  double load{};

  FoilColumn(const FoilFilm& foil, int k) {
    const TopFoilMoments& form = foil.top_foil;
    const double p = foil.pitch;
    const double compliance = foil.stiffness * p * p;  // EI' / p
    const bool free_end = k == foil.mesh.columns;
    if (k > 0) {
      kink_before = p * form.inverse_sine[k - 1];
      arc += p * form.half_tangent[k - 1];
    }
    load = foil.load_scale * foil.mesh.column_weight(k);
    if (free_end) return;
    kink_after = p * form.inverse_sine[k];
    arc += p * form.half_tangent[k];
    if (k > 0) bend_before = compliance * form.compliance_off[k - 1];
    bend = compliance * form.compliance_diagonal[k];
    if (k + 1 < foil.mesh.columns) bend_after = compliance * form.compliance_off[k];
  }

  /// Coefficient of the column's own M or U.
  [[nodiscard]] double own() const { return arc - kink_before - kink_after; }
};

}  // namespace bumpfoil
