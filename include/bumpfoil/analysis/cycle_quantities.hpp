#pragma once

#include <optional>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"

namespace bumpfoil {

/// Displacement (m) at which the direct force first rises through `threshold` (N), linear between increments; 0 if it
/// lies above from the start, absent if it never gets there.
class Clearance {
 public:
  explicit Clearance(double threshold) : threshold_(threshold) {}

  /// The increments of the loading branch, one after the other.
  void add(const Increment& increment);

  [[nodiscard]] const std::optional<double>& displacement() const { return displacement_; }

 private:
  double threshold_;
  std::optional<double> displacement_;
  double last_displacement_{};
  double last_force_{};
  bool began_{};
};

/// Displacement (m) along the unit vector `direction` at which the journal first touches the top foil,
/// (r_i + u_t,i) / (n_i . n) smallest over the bumps that face the direction n, with the displacements u_t of the
/// top foil and the gaps r_i at the centred journal; 0 if it touches already, absent if no bump faces the direction.
std::optional<double> first_contact_displacement(const Vector& gaps, const Eigen::Matrix2Xd& normals,
                                                 const Vector& top_displacement, const Eigen::Vector2d& direction);

/// Loop energy over 2 pi times the elastic energy stored between start and turning point; absent if none was stored.
std::optional<double> loss_factor(double loop_energy, double elastic_energy_stored);

/// Largest stress of the top foil over all increments that have fields; absent where none is known.
std::optional<StressPeak> top_foil_peak(const StressFields& stress, const std::vector<Increment>& increments);

/// The same of the bump foil.
std::optional<StressPeak> bump_foil_peak(const StressFields& stress, const std::vector<Increment>& increments);

/// Finds the quantities of a cycle while its increments pass: what they need of an increment is kept, nothing else.
class CycleQuantities {
 public:
  /// @param cycle  receives the quantities; direction, amplitude, steps and due are filled in
  explicit CycleQuantities(Cycle& cycle) : cycle_(cycle) {}

  /// The next increment.
  /// @param judged    its energy and residuals are known
  /// @param ends_leg  a leg of the program ends with it
  void add(const Increment& increment, bool judged, bool ends_leg);

  /// Loads and tangents at the turning point, once its increment was added.
  void turn(TurningPoint response);

  /// Fills in what needs the whole cycle.
  void finish();

 private:
  Cycle& cycle_;
  int good_{};
  Clearance clearance_5N_{5.0};
  Clearance clearance_10N_{10.0};
  double work_{};
};

}  // namespace bumpfoil
