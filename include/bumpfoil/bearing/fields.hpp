#pragma once

#include <Eigen/Core>

#include "bumpfoil/bearing/bearing_state.hpp"

namespace bumpfoil {

/// A quantity over increments (rows) and bumps or feet (columns).
using FieldMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ModeMatrix = Eigen::Matrix<ContactMode, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

enum class Interface { journal_top, top_bump, bump_sleeve };

/// One interface: column i belongs to bump i or, at the sleeve, to foot i. Without columns where there is none.
struct InterfaceFields {
  FieldMatrix gap;             ///< m, 0 where closed
  FieldMatrix normal_force;    ///< N, compression >= 0
  FieldMatrix friction_force;  ///< N, on the bump-foil node, positive away from the weld; zero at the journal
  ModeMatrix mode;

  void resize(Eigen::Index increments, Eigen::Index columns);
  /// Keeps the first increments.
  void truncate(Eigen::Index increments);
};

/// Bending stress, Pa; without columns where a model knows none, see FoilStress.
struct StressFields {
  FieldMatrix top_weld;   ///< per pad
  FieldMatrix top_crest;  ///< per bump
  FieldMatrix bump_weld;  ///< per pad
  FieldMatrix bump_crest;
  FieldMatrix bump_foot;  ///< per foot
  FieldMatrix bump_largest;
};

/// Everything known of the foils at every increment that was recorded.
struct FoilFields {
  FieldMatrix top_displacement;  ///< u_t, m, per bump; without columns where there is no top foil
  FieldMatrix crest_u, crest_v;  ///< m, per bump
  FieldMatrix foot_u, foot_v;    ///< m, per foot
  FieldMatrix compression;       ///< m, per bump: how far its crest came nearer to its feet
  /// What varies over the width, at zeta = 1 beyond the mean, m; without columns where nothing does: linearly, and as a
  /// parabola. Per bump, per foot.
  FieldMatrix top_slope, crest_u_slope, crest_v_slope, foot_u_slope, foot_v_slope;
  FieldMatrix top_parabola, crest_u_parabola, crest_v_parabola, foot_u_parabola, foot_v_parabola;
  FieldMatrix pad_force_x, pad_force_y;  ///< N, per pad of several: what each takes of the force on the journal
  FieldMatrix strip_load;                ///< N, per strip of several that do not move alike: of all its crests
  InterfaceFields journal_top;           ///< per bump; without columns under a film
  InterfaceFields top_bump;              ///< per bump
  InterfaceFields bump_sleeve;           ///< per foot
  StressFields stress;

  [[nodiscard]] Eigen::Index increments() const { return crest_u.rows(); }
  /// Keeps the first increments.
  void truncate(Eigen::Index increments);
};

/// Largest size of the force that each of several pads takes at any increment, N; nothing without increments.
Vector largest_pad_forces(const FoilFields& fields);

/// Loads of one interface at a state, N: what is reported as open carries nothing.
Vector interface_loads(const BearingModel& foils, const ContactState& state, Interface interface);

/// Stresses of a pad (from 0) at unknowns of the problem: of the mean over the width; of bump foils whose strips differ
/// in thickness the largest of all strips.
FoilStress pad_stress(const BearingModel& foils, const Vector& x, int pad);

/// Load of the top foil on all crests of each strip, N; nothing where they move alike.
Vector strip_loads(const BearingModel& foils, const ContactState& state);

/// Fields for `increments` increments of the foils, to be filled by record().
FoilFields make_fields(const BearingModel& foils, int increments);

/// How far the crest of each bump came nearer to the middle between its feet, m. The weld is a foot that stays in
/// place.
/// @param x  unknowns of the structure
Vector bump_compression(const FoilStructure& structure, const Vector& x);

/// Writes the fields of a state into row `increment`.
void record(const BearingModel& foils, const BearingState& state, Eigen::Index increment, FoilFields& fields);

}  // namespace bumpfoil
