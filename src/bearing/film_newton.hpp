#pragma once

#include <array>
#include <complex>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/newton.hpp"

namespace bumpfoil {

/// What a solve looks for.
struct NewtonAim {
  double tolerance{};      ///< largest change of P, H and position over c in a full step of a state that has converged
  bool stays_near{false};  ///< gives up where no part of a step makes the residuals smaller; else it goes on from there
};

/// Newton's method for film, foils, contacts and the journal in one system. Keeps its storage between solves.
class FilmNewton {
 public:
  FilmNewton(SharedFilmBearing bearing, const FilmSolverOptions& options);

  /// Takes `state` to the end of a move: the journal goes with the film from where it is.
  /// @param state  first guess, whose position, pressure and lift count, and whose slip_origin friction refers to;
  ///               receives the result, and stays as it was unless the status is converged
  [[nodiscard]] FilmReport solve(const Move& to, const NewtonAim& aim, BearingState& state);

  /// With contacts in the modes of `state`, or with all closed ones stuck.
  /// @return nothing if the modes leave a singular system
  [[nodiscard]] std::optional<SlowMotion> slow_motion(const BearingState& state, bool stuck);

  /// The same for motions e^{s t}, at rates s (1/s).
  /// @return nothing if the modes leave a singular system
  [[nodiscard]] std::optional<FilmImpedance> impedance(const BearingState& state,
                                                       const std::vector<std::complex<double>>& rates, bool stuck);

  /// @return nothing if the modes leave a singular system, or the pole is not found
  [[nodiscard]] std::optional<HeldMotion> held_motion(const BearingState& state, bool stuck);

  /// Largest difference of P, U and position over c.
  [[nodiscard]] double distance(const BearingState& a, const BearingState& b) const;

 private:
  /// Change of all unknowns.
  struct Step {
    FoilFilmState film;
    ContactState contact;  ///< x as its change, the rest as it is at the end of the step
    Eigen::Vector2d displacement{Eigen::Vector2d::Zero()};
    double opening{};
  };
  /// What is kept for a pad.
  struct Part {
    explicit Part(const FilmPad& of_pad);

    const FilmPad& pad;
    FoilFilmSystem system;
    FoilFilmState state;  ///< where the residuals are, or the system was linearised
    FoilFilmResidual residual;
    Matrix support_step;
    FoilFilmState change;
  };

  Vector& find_bump_forces(const ContactState& state);
  double find_residual(const Move& to, const FilmEquations& equations, const BearingState& state);
  void assemble();
  void load_condensed();
  void expand(const Vector& x, FoilFilmState& change);
  bool find_step(const BearingState& state, FilmReport& report);
  bool linearise_films(const FilmEquations& equations, const BearingState& state);
  bool linearise(const FilmEquations& equations, const BearingState& state, bool stuck);
  bool linearise_at(double shift, const BearingState& state, bool stuck);
  void answer(Step& change);
  [[nodiscard]] Eigen::Index unknown_pressures() const;
  [[nodiscard]] Vector content_of(const FoilFilmState& change, const FilmState& state) const;
  void store(const Vector& rates);
  [[nodiscard]] double contact_square(const ContactState& change) const;
  double equation_square(const Step& change);
  [[nodiscard]] Eigen::Vector2d force_of(const FoilFilmState& change) const;
  [[nodiscard]] Eigen::Vector2d asperity_force_of(const FoilFilmState& change) const;
  static Vector asperity_change(const Part& part, const Matrix& thickness);
  Eigen::Vector2d find_rate(const Matrix& rigid, Step& rate);
  Eigen::Matrix2d find_rates();
  void move_journal(const JournalLaw& law, const BearingState& state);
  void move_foils(double opening, const BearingState& state);
  void add_to_step(double way, const Step& rate);
  [[nodiscard]] Matrix thinning(const Eigen::Vector2d& displacement) const;
  void take_step(double fraction, const BearingState& from, BearingState& to) const;
  /// Calls visit(place in the block of contacts, row of the film's block) for the unknowns of block b of a pad that the
  /// film knows.
  template <typename Visitor>
  void for_each_place(const FilmPad& pad, int b, Visitor&& visit) const;

  SharedFilmBearing shared_;
  const FilmBearing& bearing_{*shared_};
  FilmSolverOptions options_;
  std::deque<Part> parts_;             ///< one per pad
  std::shared_ptr<ModeSystem> modes_;  ///< shared with `contacts_`, which leaves it as the step has it
  NewtonSolver contacts_;
  BlockTridiagonal K_, bump_K_;
  ContactLoading loading_;
  ContactState begin_;
  Vector bump_forces_;
  Step step_;
  std::array<Step, 2> rates_;  ///< per displacement of the journal along X and Y, m
  Step opening_rate_;          ///< per opening of the clearance, m
  BearingState iterate_, trial_;
  double friction_{};       ///< of asperities where the system was linearised last
  BearingState predicted_;  ///< where the tangent leads from the first guess
};

}  // namespace bumpfoil
