// Coefficients of the foils for a rotor code, and their use: the unbalance response of a rigid rotor.
// Of the foils at rest, about 50 N downwards: in a running bearing they are in series with the gas film.
#include <fmt/format.h>
#include <Eigen/LU>
#include <bumpfoil/experiments/reference_case.hpp>
#include <bumpfoil/experiments/vibration/vibration.hpp>
#include <complex>
#include <numbers>

int main() {
  using namespace std::complex_literals;
  bumpfoil::Case bearing = bumpfoil::reference_case();
  bumpfoil::VibrationSettings& vibration = bearing.settings.set(bumpfoil::VibrationSettings{});
  vibration.loads = {{0.0, -50.0}};
  vibration.motion = bumpfoil::Motion::orbit;
  vibration.amplitudes = {1e-6};
  vibration.frequencies = {200.0 * std::numbers::pi};  // where damping is evaluated
  vibration.steps = 25;
  const bumpfoil::VibrationResult result = bumpfoil::run_vibration(bearing);
  if (!result.converged()) return 3;
  const bumpfoil::LinearFoils foils = bumpfoil::linear_foils(vibration, result).front();

  constexpr double mass = 5.0, unbalance = 5e-6;  // kg on this bearing, kg m
  for (int frequency = 50; frequency <= 500; frequency += 50) {
    const double speed = 2.0 * std::numbers::pi * frequency;
    const Eigen::Vector2cd forces = unbalance * speed * speed * Eigen::Vector2cd(1.0, -1.0i);
    const Eigen::Matrix2cd impedance = foils.stiffness + 1.0i * foils.loss.cast<std::complex<double>>() -
                                       speed * speed * mass * Eigen::Matrix2cd::Identity();
    const Eigen::Vector2d response = 1e6 * impedance.partialPivLu().solve(forces).cwiseAbs();
    fmt::print("{} Hz: {:.3f} um, {:.3f} um\n", frequency, response.x(), response.y());
  }
}
