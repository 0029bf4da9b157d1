#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/fields.hpp"
#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/bearing/increment.hpp"
#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A change of mode of one contact, as the event-driven solver saw it.
struct CycleEvent {
  Branch branch{};
  double displacement{};  ///< of the journal along the direction, m
  Interface interface {};
  int index{};  ///< bump or, at the sleeve, foot; from 0
  ContactMode from{};
  ContactMode to{};
};

/// Response at the turning point: present once the run got that far.
struct TurningPoint {
  double max_force{};       ///< direct force at full displacement, N
  double cross_force{};     ///< N
  double elastic_energy{};  ///< J
  TangentStiffnesses tangent;
  Vector journal_loads;  ///< N, per bump; empty where there is no top foil
  Vector bump_loads;     ///< on the crests, N, per bump
  Vector foot_loads;     ///< N, per foot
  Vector pad_forces_x;   ///< N, per pad of several: what each takes of the force on the journal
  Vector pad_forces_y;   ///< N
  Vector strip_loads;    ///< N, per strip of several that do not move alike
};

/// Where a foil is bent most.
enum class StressPlace {
  weld,   ///< where it is clamped
  crest,  ///< at a crest; of the top foil, over it
  foot,   ///< at an end of an arc
  arc,    ///< between crest and foot
};

/// The largest bending stress of a foil during a cycle, and where and when it acts first.
struct StressPeak {
  double stress{};  ///< Pa
  StressPlace place{};
  int bump{-1};           ///< from 0, of all pads; -1 at the weld
  int pad{};              ///< from 0, at the weld; elsewhere it follows from the bump, see find_bump()
  int increment{};        ///< of the cycle
  double displacement{};  ///< at that increment, m

  bool operator==(const StressPeak&) const = default;
};

/// The largest compression of a bump during a cycle, and where and when it is reached first.
struct CompressionPeak {
  double compression{};   ///< see bump_compression(), m
  int bump{};             ///< from 0
  int increment{};        ///< of the cycle
  double displacement{};  ///< at that increment, m

  bool operator==(const CompressionPeak&) const = default;
};

/// Displacement at which the direct force first rises through a threshold, counted from the centred journal.
struct Clearance {
  double force{};                      ///< threshold, N
  std::optional<double> displacement;  ///< m; 0 if it lies above from the start, absent if it never gets there

  bool operator==(const Clearance&) const = default;
};

/// Energy of one orbit of a path, and its closure error.
struct OrbitLoop {
  double energy{};           ///< closed integral of F.dx, J; 0 without dissipation, see docs/theory/energies.md
  double force_defect{};     ///< from the force where it began to that where it ended, N
  double position_defect{};  ///< the same of the position, m

  bool operator==(const OrbitLoop&) const = default;
};

/// A point of a loop.
struct LoopPoint {
  double displacement{};            ///< along the direction, m
  Eigen::Vector2d force{0.0, 0.0};  ///< that holds the journal, N
  Eigen::Matrix2Xd pad_forces{};    ///< what each of several pads takes of it, N
};

/// How a cycle goes round.
enum class Course {
  one_sided,       ///< from its start to full displacement and back
  fully_reversed,  ///< through its start as far to the other side, and back
};

/// A cycle of the journal in one direction, or one of a strip between plates, along the direction 0, and what is
/// derived from it. Increment 0 of a first cycle without a preload is the assembly at the centred journal, solved in
/// one step from the unstressed foils. Of cycles that were repeated this is the last; what the run cost is that of all.
/// Quantities that could not be computed are absent.
struct Cycle {
  double direction{};  ///< rad
  Course course{Course::one_sided};
  double amplitude{};                ///< displacement from the start to the turning point, m
  int steps{};                       ///< from the start to the turning point
  int due{};                         ///< increments of the whole cycle, the first included
  Status status{Status::converged};  ///< of the whole: that of the increment that ended it, or `interrupted`

  /// All that were taken, unless quantities alone were requested. Where a cycle fails, the last is the one that failed.
  std::vector<Increment> increments;
  FoilFields fields;               ///< one row per increment that was solved; empty with quantities alone
  std::vector<CycleEvent> events;  ///< only from the event-driven solver
  std::optional<Increment> start;  ///< increment 0
  std::vector<LoopPoint> curve;    ///< where it was requested: the loop, linear between its points
  std::vector<Increment> turns;    ///< ends of the legs that were reached; the first is the turning point

  double initial_journal_load{};  ///< sum of journal loads at increment 0, N
  double assembly_dissipation{};  ///< D0: dissipated at increment 0, J
  std::optional<TurningPoint> turning_point;
  std::vector<double> loop_energies;  ///< of the cycles up to this one, J; a strip has them apart
  std::vector<OrbitLoop> orbits;      ///< of a path
  bool settled{};                     ///< its loop energy is that of the cycle before, to 1e-6
  std::optional<double> loop_energy;  ///< closed integral of F.dx by the trapezoidal rule, J
  /// Range of the force over that of the displacement, N/m: from the take-up point, or from turning point to turning
  /// point where it is fully reversed. Absent unless positive.
  std::optional<double> loaded_stiffness;
  std::optional<double> secant_stiffness;  ///< maximum force over the displacement there, N/m; if one-sided
  /// Loop energy / (pi K X^2), K the structural stiffness and X half the range of the displacement that K is taken
  /// over.
  std::optional<double> loss_factor;
  std::optional<double> specific_damping_capacity;  ///< loop energy / (E_max - E0); absent where nothing was stored
  std::optional<double> first_contact;              ///< m; if one-sided; absent if no bump faces the direction
  /// Where the direct force last rises through 1 % of its maximum, m; if one-sided. Under scatter the first touch lies
  /// micrometres before any load. Absent without a load.
  std::optional<double> take_up;
  std::vector<Clearance> clearances;           ///< at the thresholds that were requested; if one-sided
  std::optional<StressPeak> top_foil_stress;   ///< absent without a top foil
  std::optional<StressPeak> bump_foil_stress;  ///< absent where the model has none: truss, Le Lez (2007)
  std::optional<CompressionPeak> compression;  ///< absent with quantities alone
  Vector largest_pad_forces;                   ///< N, per pad of several; empty with quantities alone
  double max_residual{};                       ///< equilibrium, largest at the start and where legs end
  SolveCost cost;                              ///< of all increments
  int substeps{};                              ///< of all increments
  double wall_time{};                          ///< s

  /// Whether all increments are present, and each meets the bounds of its solver.
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// What was done to the foils.
enum class Experiment { cycle, strip, path };

struct CycleResult {
  SolverName solver{};  ///< that was used
  Experiment experiment{Experiment::cycle};
  std::size_t due{};          ///< cycles that were to be run
  bool over_width{};          ///< Case::varies_over_the_width(): results have moments, and what varies over the width
  std::vector<Cycle> cycles;  ///< one per direction, in the order of the case; of a strip, one after the other

  /// Whether all requested cycles are present and converged.
  [[nodiscard]] bool converged() const;
};

/// Called after every increment with the fraction of the whole run that is done, 0..1; returning false stops the run
/// (the cycles so far are returned, flagged as interrupted).
using ProgressCallback = std::function<bool(double)>;

/// Takes what has been recorded of a result since it was called last, before it is forgotten: increments, fields and
/// events of its last cycle, those of some hundred to thousand increments. The last call takes what is left, once the
/// cycle has ended.
using RecordSink = std::function<void(const CycleResult&)>;

/// What is recorded of a cycle in addition to its quantities.
enum class Recording {
  everything,  ///< increments and fields; every increment is checked by its residuals
  curve,       ///< the loop alone; checked as with `quantities`
  quantities,  ///< nothing: increment 0, those where legs end and the last are checked; no stresses
};

/// Runs cycles of one bearing: foils shared with others, states of its own.
class CycleRunner {
 public:
  CycleRunner(SharedBearing foils, const SolverSettings& settings);

  /// Takes other foils. Where only their gaps differ from those so far, what has been built of their stiffness is kept;
  /// results are the same to the last bit as those of a new runner.
  void set_foils(SharedBearing foils);

  /// Cycles along `direction` (rad) from the unstressed foils, until they settle. Numerical failures are reported in
  /// the result.
  ///
  /// For quantities alone the event-driven solver takes rates from a matrix of all contacts, and whole legs in one
  /// increment: between two changes of contact the response is straight. A cycle that fails this way is rerun as with
  /// all records. Quantities are the same to about 1e-9 of the largest force and of the energy stored.
  /// @param settings  all but their directions
  /// @param centre    excitation at the centred journal: its position is taken from there
  [[nodiscard]] Cycle run(double direction, const CycleSettings& settings, Recording recording = Recording::everything,
                          const ProgressCallback& progress = {}, const Excitation& centre = {});

 private:
  SharedBearing foils_;
  SolverSettings settings_;
  std::optional<FoilStepper> exact_, fast_;  ///< made when they are needed first; `fast_` for quantities alone
  Step step_;
};

/// Runs the cycles of a case, each from the unstressed foils. Numerical failures are reported in the result.
/// @throws Error (input) if the case cannot be built.
CycleResult run_cycles(const Case& input, const ProgressCallback& progress = {});

}  // namespace bumpfoil
