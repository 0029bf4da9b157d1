#pragma once

#include <complex>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/newton.hpp"

namespace bumpfoil {

/// Contribution of one bearing to Newton's method for films, foils, contacts and journals in one system, see
/// joint_newton.hpp: its own equations, linearised about an iterate. Storage is reused between solves.
class FilmNewton {
 public:
  FilmNewton(SharedBearing bearing, const FilmSolverOptions& options);

  /// Starts a solve: the first trial is the guess.
  /// @param from   state at the start, whose slip_origin is the reference of friction
  /// @param guess  of the state at the end: its position, film and contacts are used
  /// @return whether the film thickness is positive
  [[nodiscard]] bool set_out(const JointMove& to, const BearingState& from, const BearingState& guess);
  /// Square of the norm of the residuals of film and foils at the trial.
  double find_residual();
  /// The force on the journal at the trial, N: valid after find_residual().
  [[nodiscard]] const JournalVector& force() const { return force_; }
  void keep_trial() { std::swap(iterate_, trial_); }
  /// Stores the trial, or restores the stored one.
  void swap_instead() { std::swap(instead_, trial_); }
  /// Linearises about the iterate and computes Newton's step with the journal at rest, including the change of
  /// clearance, as far as one step allows.
  /// @param keeps_factors  reuses the linearisation of the previous step
  [[nodiscard]] bool find_step(bool keeps_factors, FilmReport& report);
  /// The force on the journal at the end of the step, from the linearised equations, N.
  [[nodiscard]] JournalVector stepped_force() const;
  /// Rates of all unknowns per displacement of the journal at the last linearisation, in the modes set last: computed
  /// once per factorisation. @return rates of the force on the journal, N/m
  JournalMatrix find_rates();
  /// Adds a displacement of the journal (m) to the step: the linearised equations stay satisfied, in the modes of the
  /// step without it.
  void move_journal(const JournalVector& displacement);
  /// Stores the end of this step, which leads along the tangent.
  void note_prediction() { take_step(1.0, iterate_, predicted_); }
  /// Largest fraction of the step that keeps P and H positive with a margin.
  [[nodiscard]] double longest_part() const { return longest_step(options_, iterate_.film, step_.film); }
  /// Largest change of P, U, and journal position or clearance offset over c in the step.
  [[nodiscard]] double largest_change() const;
  void try_step(double part) { take_step(part, iterate_, trial_); }
  [[nodiscard]] bool touches() const { return trial_.film.thickness.minCoeff() < options_.thickness_floor; }
  /// Accepts the trial as the state. Adds its distance from the tangent prediction.
  /// @param state  at the start; receives the one at the end
  void finish(const JournalVector& journal, BearingState& state, FilmReport& report);

  [[nodiscard]] const BearingModel& bearing() const { return bearing_; }
  [[nodiscard]] const FilmSolverOptions& options() const { return options_; }

  /// With contacts in the modes of `state`, or with all closed ones sticking.
  /// @return nothing if the system is singular in these modes
  [[nodiscard]] std::optional<SlowMotion> slow_motion(const BearingState& state, bool stuck);

  /// The same for motions e^{s t}, at rates s (1/s).
  /// @return nothing if the system is singular in these modes
  [[nodiscard]] std::optional<FilmImpedance> impedance(const BearingState& state,
                                                       const std::vector<std::complex<double>>& rates, bool stuck);

  /// @return nothing if the system is singular in these modes, or no pole is found
  [[nodiscard]] std::optional<HeldMotion> held_motion(const BearingState& state, bool stuck);

  /// Largest difference of P, U and journal position over c.
  [[nodiscard]] double distance(const BearingState& a, const BearingState& b) const;

 private:
  /// Change of all unknowns.
  struct Step {
    FoilFilmState film;
    ContactState contact;  ///< x as its change, the rest as at the end of the step
    JournalVector displacement;
    double clearance_offset{};
  };
  /// Storage per pad.
  struct Part {
    explicit Part(const FilmPad& of_pad);

    const FilmPad& pad;
    FoilFilmSystem system;
    FoilFilmState state;                      ///< of the residuals, or of the last linearisation
    std::vector<FoilFilmResidual> residuals;  ///< solved for together; the first is the trial's
    Matrix support_steps;
    std::vector<FoilFilmState> changes;
  };

  Vector& find_bump_forces(const ContactState& state);
  void add_supports(const FilmPad& pad, Vector& forces, Matrix& balance) const;
  void assemble();
  void set_sides(std::size_t count);
  void condense();
  void load_condensed(std::size_t side);
  void expand(std::span<Step> changes);
  bool find_step_at_rest(FilmReport& report);
  bool linearise_films(const FilmEquations& equations, const BearingState& state);
  bool linearise(const FilmEquations& equations, const BearingState& state, bool stuck);
  bool linearise_at(double shift, const BearingState& state, bool stuck);
  void answer(std::span<Step> changes);
  [[nodiscard]] Eigen::Index unknown_pressures() const;
  [[nodiscard]] Vector content_of(const FoilFilmState& change, const FilmState& state) const;
  void store(std::span<const Vector> rates);
  [[nodiscard]] double contact_square(const ContactState& change) const;
  double equation_square(const Step& change);
  [[nodiscard]] JournalVector force_of(const FoilFilmState& change) const;
  [[nodiscard]] JournalVector asperity_force_of(const FoilFilmState& change) const;
  static Matrix asperity_change(const Part& part, const Matrix& thickness);
  void find_rates(std::span<const Matrix> rigid, std::span<Step> rates);
  void move_foils();
  void add_to_step(double displacement, const Step& rate);
  void take_step(double fraction, const BearingState& from, BearingState& to) const;
  /// Calls visit(index in the contact block, row of the film's block) for the film's unknowns over a support of a pad
  /// or, after the last one, at the free end.
  template <typename Visitor>
  void for_each_place(const FilmPad& pad, int support, Visitor&& visit) const;

  SharedBearing shared_;
  const BearingModel& bearing_{*shared_};
  const FilmModel& film_{*bearing_.film};
  FilmSolverOptions options_;
  std::deque<Part> parts_;             ///< one per pad
  std::shared_ptr<ModeSystem> modes_;  ///< shared with `contacts_`, which leaves it in the modes of the step
  NewtonSolver contacts_;
  BlockTridiagonal K_, bump_K_;
  ContactLoading loading_;
  ContactState begin_;
  Vector bump_forces_;
  Step step_;
  std::vector<Step> rates_;  ///< per displacement of the journal in each of its motions, m
  JournalMatrix K_film_;     ///< rates of the force, see find_rates()
  int factors_of_rates_{};   ///< ModeSystem::factorisations() at their computation
  Step clearance_rate_;      ///< per change of the clearance, m
  BearingState iterate_, trial_;
  BearingState instead_;  ///< of a full step that may be undone
  FilmEquations equations_;
  double clearance_offset_{};  ///< target of the clearance, m
  LastStep taken_;
  JournalVector force_;
  double friction_{};       ///< of asperities at the last linearisation
  BearingState predicted_;  ///< end of the tangent from the first guess
};

}  // namespace bumpfoil
