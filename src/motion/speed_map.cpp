#include "bumpfoil/motion/speed_map.hpp"

#include <cstddef>
#include <utility>

#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/rest.hpp"

namespace bumpfoil {
namespace {

/// Where journals are held at the cold start, in what a journal at the centre has everywhere, along their loads.
constexpr double held_along_load = 0.1;

/// The bearings of a rotor, and what each of them carries.
class Carriers {
 public:
  Carriers(const Rotor& rotor, const std::vector<FilmStepper*>& steppers, const Eigen::Vector2d& gravity)
      : rotor_(rotor), steppers_(steppers), loads_(weights_on_bearings(rotor, gravity)) {}

  /// @param states  receives those at a speed, from a cold start
  Status start(double speed, std::vector<BearingState>& states) const {
    states.resize(steppers_.size());
    for (std::size_t i = 0; i < steppers_.size(); ++i) {
      const double room = steppers_[i]->bearing().room;
      const FilmReport held =
          cold_start(*steppers_[i], held_along_load * room * loads_[i].normalized(), speed, states[i]);
      if (held.status != Status::converged) return held.status;
      const FilmReport loaded = settle(*steppers_[i], OperatingPoint::loaded_by(loads_[i], speed), states[i]);
      if (loaded.status != Status::converged) return loaded.status;
    }
    return Status::converged;
  }

  Status go_on(double speed, std::vector<BearingState>& states) const {
    for (std::size_t i = 0; i < steppers_.size(); ++i) {
      const FilmReport report = follow(*steppers_[i], OperatingPoint::loaded_by(loads_[i], speed), states[i]);
      if (report.status != Status::converged) return report.status;
    }
    return Status::converged;
  }

  [[nodiscard]] std::optional<std::vector<Whirl>> whirls(const std::vector<BearingState>& states, bool stuck) const {
    std::vector<CarryingBearing> bearings;
    bearings.reserve(states.size());
    for (std::size_t i = 0; i < states.size(); ++i) bearings.push_back({*steppers_[i], states[i]});
    return find_whirls(rotor_, bearings, usual_window(states.front().speed), stuck);
  }

  /// Rate of the motion that grows fastest, in one increment from these states.
  [[nodiscard]] std::optional<std::complex<double>> rate_at(double speed, std::vector<BearingState> states,
                                                            bool stuck) const {
    if (go_on(speed, states) != Status::converged) return std::nullopt;
    const auto found = whirls(states, stuck);
    return found && !found->empty() ? std::optional(found->front().rate) : std::nullopt;
  }

 private:
  const Rotor& rotor_;
  const std::vector<FilmStepper*>& steppers_;
  std::vector<Eigen::Vector2d> loads_;
};

bool grows(const std::vector<Whirl>& whirls) {
  return whirls.front().rate.real() > 0.0;
}

void add_onsets(const Carriers& carriers, bool stuck, SpeedMap& map) {
  for (std::size_t i = 1; i < map.points.size(); ++i) {
    const SpeedPoint& a = map.points[i - 1];
    const SpeedPoint& b = map.points[i];
    const auto is_known = [stuck](const SpeedPoint& point) {
      return point.whirls(stuck) && !point.whirls(stuck)->empty();
    };
    if (!is_known(a) || !is_known(b) || grows(*a.whirls(stuck)) == grows(*b.whirls(stuck))) continue;
    const auto rate_at = [&](double speed) { return carriers.rate_at(speed, a.states, stuck); };
    if (const auto onset = find_onset(rate_at, a.speed, b.speed)) map.onsets.push_back({stuck, *onset});
  }
}

}  // namespace

SpeedMap map_speeds(const Rotor& rotor, const std::vector<FilmStepper*>& steppers, const Eigen::Vector2d& gravity,
                    const std::vector<double>& speeds, const std::function<bool()>& keep_going) {
  const Carriers carriers(rotor, steppers, gravity);
  SpeedMap map;
  std::vector<BearingState> states;
  Status status = Status::converged;
  for (const double speed : speeds) {
    SpeedPoint& point = map.points.emplace_back();
    point.speed = speed;
    if (status != Status::converged) continue;
    if (keep_going && !keep_going()) status = Status::interrupted;
    if (status == Status::converged) {
      status = states.empty() ? carriers.start(speed, states) : carriers.go_on(speed, states);
    }
    point.status = status;
    if (status != Status::converged) continue;
    point.states = states;
    point.sliding = carriers.whirls(states, false);
    point.stuck = carriers.whirls(states, true);
  }
  if (status == Status::interrupted) return map;
  for (const bool stuck : {false, true}) add_onsets(carriers, stuck, map);
  return map;
}

}  // namespace bumpfoil
