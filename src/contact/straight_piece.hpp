#pragma once

#include <vector>

#include "bumpfoil/contact/problem.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {

/// A smaller gap or slip counts as zero, m.
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

/// Rates along the whole path of the free quantities of all contacts.
struct ContactRates {
  Vector normal;      ///< of the gap of open contacts, m, and of p of the others, N
  Vector tangential;  ///< of t if friction holds, N, else of x[tangential], m; 0 without friction
};

/// A straight piece of the response to a straight path of loading: from `begin` no contact changes its mode until the
/// first of `limits`.
struct StraightPiece {
  explicit StraightPiece(const ContactProblem& problem);

  ContactState begin;
  double begin_fraction{};        ///< completed fraction of the path at `begin`
  ContactState target;            ///< extrapolation to the end of the path; its modes are those of the piece
  double begin_force{};           ///< largest normal force of `begin`, or ContactProblem::least_reference_force(), N
  double target_force{};          ///< largest of `target`, N
  double force_tolerance{};       ///< a smaller force counts as zero, N
  std::vector<ModeLimit> limits;  ///< reached first, they end the piece; in the order of contacts
  double end_part{1.0};           ///< fraction of the distance to the target at the first limit; 1 if there is none

  /// Fraction of the path at which the piece ends.
  [[nodiscard]] double end_fraction() const;

  /// Completed fraction of the distance to the target at a fraction of the path.
  [[nodiscard]] double part_at(double fraction) const;

  /// The state at a fraction of the distance to the target.
  /// @param state  result; its storage is reused
  void at(double part, ContactState& state) const;

  /// Call after every change of `begin`: sets the reference force.
  void measure_begin(const ContactProblem& problem);

  /// Sets the modes of the piece. lead() or another target must follow.
  void set_modes(const std::vector<ContactMode>& mode);

  /// Sets the target by extrapolation in the current modes from a start that obeys them: gaps, forces and, of x, the
  /// tangential unknowns.
  /// @param rate  in these modes
  /// @param part  of the path
  void lead(const ContactRates& rate, double part);

  /// Call after `target` was set otherwise, with its modes, or `begin` was replaced.
  void take_target();

  /// Examines all contacts on the way to the target: collects those that may change their mode at `begin` and
  /// contradict it, and fills `limits` and `end_part` from the others. Both are valid only without changes.
  void look_ahead(std::vector<ModeChange>& changes);

  /// Whether the forces and gaps of `begin` agree with the modes of the piece.
  [[nodiscard]] bool begin_obeys_modes() const;

  /// The same for contacts whose modes have changed only.
  [[nodiscard]] bool begin_obeys_new_modes() const;

 private:
  [[nodiscard]] bool begin_obeys(Eigen::Index c) const;
  void measure_target();
  void screen(double part);
  void look_at(Eigen::Index c, std::vector<ModeChange>& changes);
  void limit(Eigen::Index c, double now, double then, ContactMode to);

  // Per contact, for branch-free vectorised loops.
  Vector friction_coefficient_;
  std::vector<int> tangential_;         ///< tangential unknown of contacts with friction
  std::vector<Eigen::Index> can_slip_;  ///< contacts with friction
  std::vector<ContactMode> mode_;       ///< of the piece, encoded by the next three
  Vector closed_;                       ///< 1; 0 for open contacts
  Vector held_;                         ///< 1 if held by friction, else 0
  Vector sense_;                        ///< slip direction: 1 or -1; 0 without slip
  Vector slip_;                         ///< on the way to the target, m
  Vector clear_;                        ///< see screen()
  std::vector<Eigen::Index> near_;      ///< contacts that are not clear
  double last_length_{1.0};             ///< of the last piece, as fraction of the path
};

}  // namespace bumpfoil
