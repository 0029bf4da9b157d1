#pragma once

#include <vector>

#include "bumpfoil/contact/problem.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {

/// A gap or a slip below this is none, m.
constexpr double displacement_tolerance = 1e-13;

/// A force below this fraction of the largest is zero; the largest at the start and the end of a piece, or
/// ContactProblem::least_reference_force().
constexpr double relative_force_tolerance = 1e-11;

/// A contact that reaches the limit of its mode on a piece.
struct ModeLimit {
  Eigen::Index contact{};
  ContactMode to{};

  bool operator==(const ModeLimit&) const = default;
};

/// Rates of all contacts along a whole path, of what their modes leave free.
struct ContactRates {
  Vector normal;      ///< of the gap of open contacts, m, and of p of the others, N
  Vector tangential;  ///< of t where friction holds, N, else of x[tangential], m; 0 without friction
};

/// A straight piece of the response to a straight path of loading: from `begin` no contact changes its mode until the
/// first of `limits`.
struct StraightPiece {
  explicit StraightPiece(const ContactProblem& problem);

  ContactState begin;
  double begin_fraction{};        ///< of the path that lies behind `begin`
  ContactState target;            ///< where it would lead by the end of the path; its modes are those of the piece
  double begin_force{};           ///< largest normal force of `begin`, or ContactProblem::least_reference_force(), N
  double target_force{};          ///< largest of `target`, N
  double force_tolerance{};       ///< a force below is none, N
  std::vector<ModeLimit> limits;  ///< that are reached first, and end it, in the order of contacts
  double end_part{1.0};           ///< of the way to the target, where the first of them lies; 1 if there is none

  /// Fraction of the path at which the piece ends.
  [[nodiscard]] double end_fraction() const;

  /// Completed fraction of the distance to the target at a fraction of the path.
  [[nodiscard]] double part_at(double fraction) const;

  /// The state at a fraction of the distance to the target.
  /// @param state  result; its storage is reused
  void at(double part, ContactState& state) const;

  /// To be called whenever `begin` has changed: sets what forces are measured by.
  void measure_begin(const ContactProblem& problem);

  /// Sets the modes of the piece. lead() or another target must follow.
  void set_modes(const std::vector<ContactMode>& mode);

  /// Sets the target to where the modes lead from a begin that obeys them: gaps, forces and, of x, the tangential
  /// unknowns.
  /// @param rate  in these modes
  /// @param part  of the path
  void lead(const ContactRates& rate, double part);

  /// To be called whenever `target` has been set otherwise, with its modes, or another begin leads to it.
  void take_target();

  /// Looks at all contacts on the way to the target: collects those that may choose their mode at `begin` and
  /// contradict it, and fills `limits` and `end_part` from the others. These mean something where there are no changes.
  void look_ahead(std::vector<ModeChange>& changes);

  /// Whether the forces and gaps of `begin` agree with the modes of the piece.
  [[nodiscard]] bool begin_obeys_modes() const;

  /// The same of those contacts alone whose modes were others so far.
  [[nodiscard]] bool begin_obeys_new_modes() const;

 private:
  [[nodiscard]] bool begin_obeys(Eigen::Index c) const;
  void measure_target();
  void screen(double part);
  void look_at(Eigen::Index c, std::vector<ModeChange>& changes);
  void limit(Eigen::Index c, double now, double then, ContactMode to);

  // Of each contact, for loops without branches that take many at once.
  Vector friction_coefficient_;
  std::vector<int> tangential_;         ///< unknown, of those with friction
  std::vector<Eigen::Index> can_slip_;  ///< contacts with friction
  std::vector<ContactMode> mode_;       ///< of the piece, which the next three tell in numbers
  Vector closed_;                       ///< 1, or 0 of open contacts
  Vector held_;                         ///< by friction: 1, or 0
  Vector sense_;                        ///< of slip: 1, -1, or 0 of those that do not slip
  Vector slip_;                         ///< on the way to the target, m
  Vector clear_;                        ///< see screen()
  std::vector<Eigen::Index> near_;      ///< contacts that are not clear
  double last_length_{1.0};             ///< of the last piece, as part of the path
};

}  // namespace bumpfoil
