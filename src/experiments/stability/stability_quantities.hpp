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

/// Motion of the contacts.
enum class ContactMotion : std::uint8_t {
  sliding,  ///< sliding contacts keep sliding
  stuck,    ///< full stick
};
template <>
inline constexpr auto enum_names<ContactMotion> = std::to_array<std::string_view>({"sliding", "stuck"});

/// Direction of whirl relative to the rotation.
enum class WhirlSense : std::uint8_t { backward, forward };
template <>
inline constexpr auto enum_names<WhirlSense> = std::to_array<std::string_view>({"backward", "forward"});

WhirlSense sense_of(const Whirl& whirl);

/// A quantity of the whole run.
using StabilityQuantity = Quantity<double (*)(const StabilityResult&)>;
std::span<const StabilityQuantity> stability_quantities();

/// A quantity of the rotor at one speed.
using SpeedQuantity = Quantity<double (*)(const StabilityResult&, const SpeedPoint&)>;
std::span<const SpeedQuantity> speed_quantities();

/// A motion at one speed.
struct SpeedMotion {
  ContactMotion contacts{};
  const Whirl& whirl;
  std::size_t number{};  ///< index from 0
};

/// Its quantities.
using MotionQuantity = Quantity<double (*)(const SpeedMotion&)>;
std::span<const MotionQuantity> motion_quantities();

/// Motions at one speed, with sliding contacts first.
std::vector<SpeedMotion> motions_at(const SpeedPoint& point);

/// Whether all motions decay, both with sliding and sticking contacts; nothing if unknown.
std::optional<bool> is_stable(const SpeedPoint& point);

/// How the run ended.
RunStatus status_of(const StabilityResult& result);

/// Speeds without a result, each with the reason.
std::vector<std::string> failure_lines(const StabilityResult& result);

/// Limitations of the results, with advice.
std::vector<std::string> warning_lines(const Case& input, const StabilityResult& result);

/// An onset in messages: "whirl begins at 13072.4 rpm, whirl ratio 0.4908".
std::string onset_text(const WhirlOnset& onset);

/// The run as a text table: one line per speed, and the onsets.
std::string stability_table(const StabilityResult& result);

}  // namespace bumpfoil
