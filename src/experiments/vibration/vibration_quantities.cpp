#include "experiments/vibration/vibration_quantities.hpp"

#include <fmt/format.h>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

double known(const std::optional<double>& number) {
  return number.value_or(absent);
}

/// Part of the first harmonic: outward is in phase with the displacement, ahead leads it by 90 degrees.
enum class Part { outward, ahead };

/// Along the direction of the vibration; for an orbit the mean along and across the radius, see orbit_harmonic().
template <Part part>
double direct(const Vibration& vibration) {
  if (!vibration.harmonic) return absent;
  const auto& [stiffness, loss, residual] = *vibration.harmonic;
  if (!vibration.sense) return unit_vector(vibration.cycle.direction).dot(part == Part::outward ? stiffness : loss);
  const double s = *vibration.sense == Sense::counterclockwise ? 1.0 : -1.0;
  return part == Part::outward ? 0.5 * (stiffness.x() - s * loss.y()) : 0.5 * (loss.x() + s * stiffness.y());
}

/// Across it, to the left; undefined for an orbit.
template <Part part>
double cross(const Vibration& vibration) {
  if (!vibration.harmonic || vibration.sense) return absent;
  const Eigen::Vector2d n = unit_vector(vibration.cycle.direction);
  return Eigen::Vector2d(-n.y(), n.x())
      .dot(part == Part::outward ? vibration.harmonic->stiffness : vibration.harmonic->loss);
}

using namespace tag;  // NOLINT(google-build-using-namespace): for the table below

constexpr auto vibration_list = std::to_array<VibrationQuantity>({
    {"stiffness_direct", "N/m",
     "first harmonic of the force along the direction in phase with the displacement, over the amplitude; for an orbit "
     "the mean radial force over the radius",
     direct<Part::outward>, headline, "stiffness", shown::stiffness},
    {"stiffness_cross", "N/m", "stiffness of the force across the direction, turned by +90 degrees",
     cross<Part::outward>, none, "stiffness across the direction"},
    {"loss_stiffness_direct", "N/m",
     "first harmonic of the force along the direction 90 degrees ahead of the displacement, over the amplitude: "
     "frequency times damping; for an orbit the mean tangential force over the radius",
     direct<Part::ahead>, headline, "loss", shown::stiffness},
    {"loss_stiffness_cross", "N/m", "loss stiffness of the force across the direction", cross<Part::ahead>, none,
     "loss stiffness across the direction"},
    {"harmonic_residual", "1", "norm of the higher harmonics of the force over that of the first",
     [](const Vibration& v) { return v.harmonic ? v.harmonic->residual : absent; }, headline, "residual",
     shown::unitless},
    {"loaded_stiffness", "N/m", "range of the force along the direction over that of the displacement",
     [](const Vibration& v) { return known(v.cycle.loaded_stiffness); }},
    {"loop_energy", "J", "closed integral of force over displacement",
     [](const Vibration& v) { return known(v.cycle.loop_energy); }, shown_first},
    {"loss_factor", "1", "loop energy over (pi K X^2): K structural stiffness, X half the range of the displacement",
     [](const Vibration& v) { return known(v.cycle.loss_factor); }, headline, "loss factor", shown::unitless},
    {"loops", "1", "number of loops; the last is shown",
     [](const Vibration& v) { return static_cast<double>(v.cycle.loop_energies.size()); }, shown_first, "loops",
     shown::unitless, whole_number},
    {"settled", "1", "whether the energy of the loop equals that of the previous loop",
     [](const Vibration& v) { return v.cycle.settled ? 1.0 : 0.0; }, shown_first, "", shown::in_files, yes_or_no},
    {"status", "", "how the vibration ended", [](const Vibration& v) { return static_cast<double>(v.cycle.status); },
     shown_first, "status", shown::unitless, flags<Status>},
    {"max_residual", "1", "largest residual where branches end",
     [](const Vibration& v) { return v.harmonic ? v.cycle.max_residual : absent; }},
    {"total_iterations", "1", "linear solves of all loops",
     [](const Vibration& v) { return static_cast<double>(v.cycle.cost.iterations); }, none, "", shown::in_files,
     whole_number},
    {"total_substeps", "1", "extra solves because increments had to be halved",
     [](const Vibration& v) { return static_cast<double>(v.cycle.substeps); }, none, "", shown::in_files, whole_number},
    {"wall_time", "s", "time that the vibration took", [](const Vibration& v) { return v.cycle.wall_time; }},
});

constexpr auto linear_list = std::to_array<LinearQuantity>({
    {"residual", "1", "norm of the higher harmonics over that of the first, the larger of the directions",
     [](const LinearFoils& foils) { return foils.residual; }},
    {"loss_factor_x", "1", "loss factor of the vibration along X",
     [](const LinearFoils& foils) { return foils.loss_factor.x(); }},
    {"loss_factor_y", "1", "loss factor of the vibration along Y",
     [](const LinearFoils& foils) { return foils.loss_factor.y(); }},
});

std::string load_text(const Eigen::Vector2d& load) {
  return fmt::format("load ({:.4g}, {:.4g}) N", load.x(), load.y());
}

}  // namespace

std::span<const VibrationQuantity> vibration_quantities() {
  return vibration_list;
}

std::span<const LinearQuantity> linear_quantities() {
  return linear_list;
}

VibrationPlace place_of(const VibrationSettings& settings, std::size_t vibration) {
  const std::size_t amplitudes = settings.amplitudes.size();
  const std::size_t motions = settings.motions();
  return {vibration / amplitudes / motions, vibration / amplitudes % motions, vibration % amplitudes};
}

std::string name_of_vibration(const VibrationSettings& settings, std::size_t vibration) {
  const auto [load, motion, amplitude] = place_of(settings, vibration);
  return fmt::format("{}, {}, {:.4g} um", load_text(settings.loads[load]),
                     settings.orbits() ? name_of(static_cast<Sense>(motion))
                                       : fmt::format("{:.6g} deg", to_degrees(settings.directions[motion])),
                     1e6 * settings.amplitudes[amplitude]);
}

std::vector<std::string> failure_lines(const VibrationSettings& settings, const VibrationResult& result) {
  std::vector<std::string> lines;
  const auto tell = [&lines](const std::string& place, Status status) {
    if (status == Status::converged || status == Status::interrupted) return;
    lines.push_back(fmt::format("{}: {}", place, explanation(status)));
  };
  for (const StaticLoad& load : result.loads) tell(load_text(load.load) + " was not reached", load.status);
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    if (result.loads[place_of(settings, i).load].status != Status::converged) continue;  // already reported
    tell(name_of_vibration(settings, i), result.vibrations[i].cycle.status);
  }
  return lines;
}

std::vector<std::string> warning_lines(const VibrationSettings& settings, const VibrationResult& result) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    const Cycle& cycle = result.vibrations[i].cycle;
    if (!cycle.converged() || cycle.settled) continue;
    lines.push_back(fmt::format("{}: {}", name_of_vibration(settings, i), unsettled(cycle, "loops")));
  }
  return lines;
}

}  // namespace bumpfoil
