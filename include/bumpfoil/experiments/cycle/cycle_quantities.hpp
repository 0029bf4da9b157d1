#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Direct force over displacement from the start of a cycle to its turning point, linear between its points.
class LoadingCurve {
 public:
  struct Point {
    double displacement{};  ///< m
    double force{};         ///< N
  };

  /// @param first_contact  the force stays as it is until there, m; absent where that is not known
  explicit LoadingCurve(const std::optional<double>& first_contact = {}) : first_contact_(first_contact) {}

  /// The next point.
  void add(const Point& point);

  /// Displacement at which the force first rises to `threshold`; 0 if it lies there from the start, absent if it never
  /// gets there.
  [[nodiscard]] std::optional<double> first_reaches(double threshold) const;

  /// Where the force rises through `threshold` for the last time; the start if it never lies below.
  /// @pre  it ends above, and has a point
  [[nodiscard]] Point last_rises_through(double threshold) const;

 private:
  std::optional<double> first_contact_;
  std::vector<Point> points_;
};

/// Displacement (m) along the unit vector `direction` at which the journal first touches the top foil, the smallest
/// gap_i / (n_i . n) over the bumps that face the direction n, with the gaps between journal and top foil where it
/// starts; 0 if it touches already, absent if no bump faces the direction.
std::optional<double> first_contact_displacement(const Vector& gaps, const Eigen::Matrix2Xd& normals,
                                                 const Eigen::Vector2d& direction);

/// Largest stress of the top foil over all increments that have fields; absent where none is known.
std::optional<StressPeak> top_foil_peak(const StressFields& stress, const std::vector<Increment>& increments);

/// The same of the bump foil.
std::optional<StressPeak> bump_foil_peak(const StressFields& stress, const std::vector<Increment>& increments);

/// Largest compression of a bump over all increments that have fields; absent where there are none.
std::optional<CompressionPeak> compression_peak(const FieldMatrix& compression,
                                                const std::vector<Increment>& increments);

/// Finds the quantities of a cycle while its increments pass: what they need of an increment is kept, nothing else.
class CycleQuantities {
 public:
  /// @param cycle  receives the quantities; direction, course, amplitude, steps, due, forces of the clearances and,
  ///               where it is known, first contact are filled in
  explicit CycleQuantities(Cycle& cycle) : cycle_(cycle), loading_(cycle.first_contact) {}

  /// The next increment.
  /// @param checked    its energy and residuals are known
  /// @param ends_leg  a leg of the program ends with it
  /// @param between   known points of the response since the increment before
  void add(const Increment& increment, bool checked, bool ends_leg, std::span<const LoadingCurve::Point> between = {});

  /// Loads and tangents at the turning point, once its increment was added.
  void turn(TurningPoint response);

  /// Takes the peaks of the increments and fields in the cycle, which may be forgotten afterwards.
  void take_recorded();

  /// Takes those that are left, and fills in what needs the whole cycle.
  void finish();

 private:
  void find_stiffness();
  void find_losses();

  Cycle& cycle_;
  LoadingCurve loading_;
  int good_{};
  double work_{};
  double largest_work_{};
  double half_range_{};  ///< X of the loss factor, m
};

}  // namespace bumpfoil
