#pragma once

#include <vector>

#include "bumpfoil/contact/problem.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {

/// A gap or a slip below this is none, m.
constexpr double displacement_tolerance = 1e-13;

/// A force below this part of the largest is none; the largest of where a piece begins and where it leads, or
/// ContactProblem::least_reference_force().
constexpr double relative_force_tolerance = 1e-11;

/// A contact that reaches the limit of its mode on a piece.
struct ModeLimit {
  Eigen::Index contact{};
  ContactMode to{};
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

  /// Part of the way to the target that lies behind at a fraction of the path.
  [[nodiscard]] double part_at(double fraction) const;

  /// The state at a part of the way to the target.
  /// @param state  result; its storage is reused
  void at(double part, ContactState& state) const;

  /// To be called whenever `begin` has changed, and then whenever `target` has: set what forces are measured by.
  void measure_begin(const ContactProblem& problem);
  void measure_target();

  /// Looks at all contacts on the way to the target: collects those that may choose their mode at `begin` and
  /// contradict it, and fills `limits` and `end_part` from the others. These mean something where there are no changes.
  void look_ahead(const ContactProblem& problem, std::vector<ModeChange>& changes);

  /// Whether the forces and gaps of `begin` are such as the modes of the piece ask for.
  [[nodiscard]] bool begin_obeys_modes(const ContactProblem& problem) const;

  /// The same of those contacts alone whose modes were others so far.
  [[nodiscard]] bool begin_obeys_new_modes(const ContactProblem& problem) const;

 private:
  [[nodiscard]] bool begin_obeys(Eigen::Index c, double f) const;
  void limit(Eigen::Index c, double now, double then, ContactMode to);
};

}  // namespace bumpfoil
