#pragma once

#include <complex>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/film_bearing.hpp"
#include "bumpfoil/bearing/impedance.hpp"
#include "bumpfoil/bearing/joint_law.hpp"
#include "bumpfoil/bearing/journal_law.hpp"
#include "bumpfoil/film/film_solver.hpp"
#include "bumpfoil/model/control.hpp"

namespace bumpfoil {

class FilmNewton;

/// Settings of the search for states of a running bearing.
struct FilmBearingOptions {
  FilmSolverOptions newton{};
  double first_time_step{0.025};  ///< of a march in time, in units of T0
  /// In place of FilmSolverOptions::step_tolerance, in steps of implicit Euler and in those of solve_together().
  double marching_tolerance{1e-6};
  double time_growth{1.5};         ///< of time steps that converged; others are quartered
  double last_time_step{10e-3};    ///< s; the march ends at steps longer than this that change little:
  double resting_change{1e-4};     ///< of P and U
  double position_step{0.1};       ///< first length of a step of follow(), in units of c
  double speed_step{0.1};          ///< the same, of the speed at the start or end, whichever is larger
  double smallest_fraction{1e-3};  ///< of the first step: where shorter ones fail, the path ends
  /// The same under a load, where steps locate the contacts at which the branch turns back.
  double smallest_load_fraction{1e-6};
  /// Under a load a step is halved where the state lies farther from the tangent's prediction than this part of the
  /// predicted change, and than the second number, of P, U and position over c: a contact that changes bends the
  /// branch by no more in a step that is short enough, while another branch stays as far away as it is.
  double largest_departure{0.3};
  double resolved_departure{1e-4};
  int max_ends{24};                    ///< of branches, in one follow()
  int max_time_steps{200};             ///< of a march: what does not rest by then oscillates
  std::function<bool()> keep_going{};  ///< called before every solve; false ends the search
};

/// Operating conditions of a running bearing: a prescribed journal position or load, at a speed. A plain value.
struct OperatingPoint {
  Control control{Control::displacement};
  Eigen::Vector2d journal{Eigen::Vector2d::Zero()};  ///< its position, m, or the load on it, N
  double speed{};                                    ///< Omega, rad/s
  double clearance_offset{};                         ///< by which the clearance is wider than that of the bearing, m
  JournalTilt tilt{};                                ///< only where the journal may tilt

  bool operator==(const OperatingPoint&) const = default;
  [[nodiscard]] bool by_load() const { return control == Control::load; }

  static OperatingPoint held_at(const Eigen::Vector2d& position, double speed, double clearance_offset = 0.0) {
    return {
        .control = Control::displacement, .journal = position, .speed = speed, .clearance_offset = clearance_offset};
  }
  static OperatingPoint loaded_by(const Eigen::Vector2d& load, double speed, double clearance_offset = 0.0) {
    return {.control = Control::load, .journal = load, .speed = speed, .clearance_offset = clearance_offset};
  }
};

/// How an increment goes through time, see BackwardDifference.
enum class TimeScheme : std::uint8_t {
  bdf2,            ///< as the bearing moves; leaves BearingState::last_step
  implicit_euler,  ///< to find states: it damps what grows
};

/// The target of an increment of a running bearing, and its time step. A plain value.
struct Move {
  JournalLaw law;             ///< what holds the journal
  double speed{};             ///< Omega, rad/s
  double clearance_offset{};  ///< as in OperatingPoint, m
  double dt{};                ///< time step, journal and foils without mass, s; 0: quasi-static
  TimeScheme scheme{TimeScheme::bdf2};
};

/// The same for several bearings whose journals are connected by one body.
struct JointMove {
  JointLaw law;
  double speed{};
  double clearance_offset{};
  double dt{};
  TimeScheme scheme{TimeScheme::bdf2};
};

/// The operating point of a state: by the position of its journal or by the load that it carries, by its tilt or by the
/// moment, as those of another one. @param like  whose controls count
OperatingPoint point_of(const BearingModel& bearing, const BearingState& state, const OperatingPoint& like);

/// How a state responds to slow motions of the journal.
struct SlowMotion {
  JournalMatrix stiffness;  ///< dF/dq, N/m. Not symmetric
  /// Largest displacement of the top foil per displacement of the journal in any of its motions. About 1 where the foil
  /// follows the journal; without bound where the state becomes singular, as at the end of its branch.
  double foil_response{};
};

/// The free motion e^{s t} of film and foils about a state, with the journal held, that grows fastest or, where the
/// state lasts, dies out last.
struct HeldMotion {
  std::complex<double> rate{};  ///< s, 1/s: its real part is the growth rate; imaginary part not negative
  double residual{};            ///< of the linearised equations of all unknowns, as part of what the motion stores
  Eigen::Index column{};        ///< of all pads, where the top foil moves most
};

/// The same where sliding contacts slip on, and where all closed ones stick.
struct HeldMotions {
  std::optional<HeldMotion> sliding, stuck;

  /// Whether both decay; nothing where that is not known.
  [[nodiscard]] std::optional<bool> is_stable() const;
};

/// Advances a running bearing from state to state: gas film, sagging top foil, bump foil, unilateral contact, Coulomb
/// friction and the position of the journal in one system. Newton's method on the film; in each step the contact
/// problem of the linearised system, condensed to the crests, is solved exactly (NewtonSolver). Film and foils are
/// never solved in alternation: a foil that has lifted off its bumps is supported by the film alone, which only the
/// joint matrix represents.
///
/// There may be several states at one operating point, even without friction; the path decides which one is found.
/// solve() makes one move, advance() one increment; follow() and settle() in motion/ go further. The stepper does not
/// own states: they belong to the caller. One thread at a time; steppers may share the bearing.
class FilmStepper {
 public:
  /// @throws Error (input) if the bearing has no film
  explicit FilmStepper(SharedBearing bearing, const FilmBearingOptions& options = FilmBearingOptions());
  explicit FilmStepper(BearingModel bearing, const FilmBearingOptions& options = FilmBearingOptions());
  ~FilmStepper();

  /// The move that leads to an operating point, in the time `dt` (s).
  [[nodiscard]] Move move_to(const OperatingPoint& point, double dt = 0.0, TimeScheme scheme = TimeScheme::bdf2) const;

  /// The state near `state` at the end of a move, all in one step. Friction refers to BearingState::slip_origin, so
  /// that several moves can make one increment.
  /// @param state       receives the result, later by `dt`; stays as it was unless the status is converged
  /// @param stays_near  gives up where no more than 1/64 of a step makes the residuals smaller; else it goes on from
  ///                    there
  [[nodiscard]] FilmReport solve(const Move& move, BearingState& state, bool stays_near = false);

  /// One increment: the same with friction that refers to `state` as it was handed over.
  [[nodiscard]] FilmReport advance(const Move& move, BearingState& state);
  [[nodiscard]] FilmReport advance(const OperatingPoint& to, BearingState& state) {
    return advance(move_to(to), state);
  }

  /// Largest difference of P, U and position over c.
  [[nodiscard]] double distance(const BearingState& a, const BearingState& b) const;

  /// Linearised about `state`: consistent, closed contacts rigid, every contact keeping its mode; with `stuck` slipping
  /// contacts stick, as under a small whirl.
  /// @return nothing if the modes leave a singular system
  [[nodiscard]] std::optional<SlowMotion> slow_motion(const BearingState& state, bool stuck = false);

  /// Its stiffness.
  [[nodiscard]] std::optional<JournalMatrix> stiffness(const BearingState& state, bool stuck = false);

  /// Impedance Z = dF/dq of the bearing to motions of the journal by q e^{s t} about `state`, at every rate s (1/s):
  /// N/m. The film squeezes, foils and journal have no mass, contacts keep their modes or stick
  /// as in stiffness(), which Z is at s = 0. At a frequency omega, s = i omega, K = Re Z and C = Im Z / omega.
  ///
  /// One factorisation serves all rates (docs/theory/gas_film.md).
  /// @param rates  s, real parts not negative
  /// @return nothing if the modes leave a singular system
  [[nodiscard]] std::optional<FilmImpedance> impedance(const BearingState& state,
                                                       const std::vector<std::complex<double>>& rates,
                                                       bool stuck = false);

  /// That at the rates.
  [[nodiscard]] std::optional<std::vector<JournalMatrixC>> impedances(const BearingState& state,
                                                                      const std::vector<std::complex<double>>& rates,
                                                                      bool stuck = false);

  /// The rightmost pole of the bearing with its journal held; it is also a pole of Z, whatever the rotor. The state
  /// lasts if its real part is negative. Contacts keep their modes or stick, as in stiffness().
  /// @return nothing if the modes leave a singular system, or the equations of all unknowns are not met to 1e-8
  [[nodiscard]] std::optional<HeldMotion> held_motion(const BearingState& state, bool stuck = false);

  /// Both. Where no contact slips they are one.
  [[nodiscard]] HeldMotions held_motions(const BearingState& state);

  [[nodiscard]] const BearingModel& bearing() const { return *bearing_; }
  [[nodiscard]] const FilmModel& film() const { return *bearing_->film; }
  [[nodiscard]] const FilmBearingOptions& options() const { return options_; }

  /// Solves for several bearings at the end of a move of the body that connects their journals, all in one Newton
  /// iteration. Friction refers to BearingState::slip_origin, as in solve().
  /// @param steppers  one for each bearing: none twice
  /// @param guesses   of the states at the end, their journals where the guess of y puts them
  /// @param y         first guess of the unknowns of the law; receives the result
  /// @param states    at the start; receive the results, later by `dt`. Unless the status is converged y and states
  ///                  stay as they were
  [[nodiscard]] static FilmReport solve_together(const std::vector<FilmStepper*>& steppers, const JointMove& move,
                                                 const std::vector<BearingState>& guesses, Eigen::VectorXd& y,
                                                 std::vector<BearingState>& states);

 private:
  SharedBearing bearing_;
  FilmBearingOptions options_;
  std::unique_ptr<FilmNewton> newton_;
};

}  // namespace bumpfoil
