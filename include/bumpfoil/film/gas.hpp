#pragma once

namespace bumpfoil {

/// An isothermal ideal gas.
struct Gas {
  double viscosity{};         ///< mu, Pa s
  double ambient_pressure{};  ///< pa at all edges of the film, Pa
  double mean_free_path{};    ///< lambda_a at ambient pressure, m; 0: no slip at the walls
};

/// Scales that make the film of a bearing dimensionless: P = p / pa, H = h / c, zeta = z / R. Forces are in units of pa
/// R^2, flows in volumes at ambient pressure.
struct FilmScales {
  Gas gas;
  double radius{};     ///< R, m
  double thickness{};  ///< c, m; any length works, the clearance is the natural one

  /// Lam = 6 mu sigma Omega R^2 / (pa c^2), positive where the surface of the journal moves towards increasing theta.
  /// @param surface_speed  sigma Omega R, m/s
  [[nodiscard]] double bearing_number(double surface_speed) const;
  /// T0 = 12 mu R^2 / (pa c^2), s: time of the squeeze term.
  [[nodiscard]] double squeeze_time() const;
  /// Kn = lambda_a / c.
  [[nodiscard]] double knudsen() const { return gas.mean_free_path / thickness; }
  /// pa R^2, N.
  [[nodiscard]] double force() const;
  /// pa c^3 / (12 mu), m^3/s: of what crosses an edge of length R in zeta or theta, at ambient pressure.
  [[nodiscard]] double flow() const;
  /// mu U R^3 / c, N m: torque of Couette shear, times its integral.
  [[nodiscard]] double couette_torque(double surface_speed) const;
  /// pa c R^2 / 2, N m: torque of the shear that the pressure gradient makes, times its integral.
  [[nodiscard]] double poiseuille_torque() const;
};

}  // namespace bumpfoil
