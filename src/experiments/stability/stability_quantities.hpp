#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "experiments/rotor_speeds.hpp"

/// Quantities of the command stability, described once for all files.
namespace bumpfoil {

/// Which contacts stick.
enum class ContactMotion : std::uint8_t {
  sliding,  ///< slipping contacts slip on
  stuck,    ///< all closed ones stick
};
template <>
inline constexpr auto enum_names<ContactMotion> = std::to_array<std::string_view>({"sliding", "stuck"});

/// Sense of a whirl in that of the rotation.
enum class WhirlSense : std::uint8_t { backward, forward };
template <>
inline constexpr auto enum_names<WhirlSense> = std::to_array<std::string_view>({"backward", "forward"});

WhirlSense sense_of(const Whirl& whirl);

/// Of the whole run.
using StabilityQuantity = Quantity<double (*)(const StabilityResult&)>;
std::span<const StabilityQuantity> stability_quantities();

/// Of the rotor at one speed.
using SpeedQuantity = Quantity<double (*)(const StabilityResult&, const SpeedPoint&)>;
std::span<const SpeedQuantity> speed_quantities();

/// A motion at one speed.
struct SpeedMotion {
  const SpeedPoint& point;
  ContactMotion contacts{};
  const Whirl* whirl{};  ///< none of a speed without
  std::size_t number{};  ///< from 0
};

namespace tag {
inline constexpr Tags of_place = first_of_experiment;  ///< says which motion; known without one, too
}

/// Of it, in the order of stability.csv.
using MotionQuantity = Quantity<double (*)(const SpeedMotion&)>;
std::span<const MotionQuantity> motion_quantities();

/// What tables tell: of the whole run, of each speed, and of each motion but which one it is.
std::vector<VariableMeaning> stability_meanings();

/// Motions at one speed, those where contacts slide on first.
std::vector<SpeedMotion> motions_at(const SpeedPoint& point);

/// Whether all motions decay, with contacts sliding and stuck; nothing where it is not known.
std::optional<bool> is_stable(const SpeedPoint& point);

/// How the run ended.
RunStatus status_of(const StabilityResult& result);

/// Speeds without a result, each with its reason.
std::vector<std::string> failure_lines(const StabilityResult& result);

/// Where an answer is less than it seems, and what to do about it.
std::vector<std::string> warning_lines(const Case& input, const StabilityResult& result);

/// An onset as messages call it: "whirl begins at 13072.4 rpm, whirl ratio 0.4908".
std::string onset_text(const WhirlOnset& onset);

/// The run as a text table: a line for each speed, and the onsets.
std::string stability_table(const StabilityResult& result);

}  // namespace bumpfoil
