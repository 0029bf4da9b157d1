#include "bumpfoil/motion/speed_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "bumpfoil/motion/rotor_equilibria.hpp"

namespace bumpfoil {
namespace {

/// Motions at neighbouring speeds that differ by more are different. Orthogonal shapes count as much as rates that
/// differ by a given number of rotation speeds.
constexpr double another_motion = 0.3;
constexpr double shape_counts = 0.2;

/// Free motions, not yet numbered.
std::optional<SpeedMotions> free_motions(const Rotor& rotor, const RotorEquilibria& equilibria,
                                         const std::vector<BearingState>& states, bool stuck) {
  const double speed = states.front().speed;
  const WhirlWindow window = usual_window(speed);
  auto free = find_whirls(rotor, equilibria.carrying(states), window, stuck);
  if (!free) return std::nullopt;
  SpeedMotions found{.whirls = std::move(free->whirls), .numbers = {}, .by_coefficients = {}};
  const std::vector<Whirl> linear = whirls_on_coefficients(rotor, speed, free->bearings, window);
  if (!linear.empty()) found.by_coefficients = linear.front().rate;
  return found;
}

bool any_slips(const std::vector<BearingState>& states) {
  return std::any_of(states.begin(), states.end(),
                     [](const BearingState& state) { return state.contacts.any_slips(); });
}

/// Rate of the motion that grows fastest.
std::optional<std::complex<double>> fastest_rate(const std::optional<SpeedMotions>& motions, bool by_coefficients) {
  if (!motions) return std::nullopt;
  if (by_coefficients) return motions->by_coefficients;
  return motions->whirls.empty() ? std::nullopt : std::optional(motions->whirls.front().rate);
}

/// Adds the onsets of one kind. @param kind  which contact modes, and whether by coefficients
void add_onsets(const Rotor& rotor, const RotorEquilibria& equilibria, const WhirlOnset& kind, SpeedMap& map) {
  for (std::size_t i = 1; i < map.points.size() && !map.interrupted; ++i) {
    const SpeedPoint& a = map.points[i - 1];
    const SpeedPoint& b = map.points[i];
    const auto rate_a = fastest_rate(a.motions(kind.stuck), kind.by_coefficients);
    const auto rate_b = fastest_rate(b.motions(kind.stuck), kind.by_coefficients);
    if (!rate_a || !rate_b || (rate_a->real() > 0.0) == (rate_b->real() > 0.0)) continue;
    WhirlOnset found = kind;
    const auto rate_at = [&](double speed) {
      // No contact slips in a step to the same speed: the ends keep the modes in which they were reached.
      if (speed == a.speed) return rate_a;
      if (speed == b.speed) return rate_b;
      std::vector<BearingState> states = a.states;
      const Status status = equilibria.go_to(speed, states);
      map.interrupted |= status == Status::interrupted;
      if (status != Status::converged) return std::optional<std::complex<double>>();
      const std::optional<SpeedMotions> motions = free_motions(rotor, equilibria, states, kind.stuck);
      found.of_foils = motions && !motions->whirls.empty() && motions->whirls.front().is_of_foils();
      return fastest_rate(motions, kind.by_coefficients);
    };
    const std::optional<Onset> onset = find_onset(rate_at, a.speed, b.speed);
    if (!onset) continue;
    found.begins = (rate_b->real() > 0.0) == (std::abs(b.speed) > std::abs(a.speed));
    found.of_foils = found.of_foils && !kind.by_coefficients;
    found.onset = *onset;
    map.onsets.push_back(found);
  }
}

/// A motion at the last speeds at which it was found.
struct Track {
  std::optional<std::size_t> behind{};  ///< index of the speed after the last of them
  std::complex<double> rate;            ///< at the last
  std::complex<double> change;          ///< from the speed before
  Eigen::VectorXcd shape;
};

/// Difference between a motion and the prediction of a track: distance of rates over the speed, and of shapes.
double unlikeness(const Track& track, const Whirl& whirl, double speed) {
  const double overlap = std::abs(track.shape.dot(whirl.shape));
  return std::abs(whirl.rate - track.rate - track.change) / std::abs(speed) + shape_counts * (1.0 - overlap);
}

/// Assigns motions the numbers of their tracks: from speed to speed the most similar pairs are matched first. An
/// unmatched motion starts a new track.
void number_motions(bool stuck, std::vector<Track>& tracks, SpeedMap& map) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  struct Pair {
    double unlikeness{};
    std::size_t track{}, whirl{};
  };
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    SpeedPoint& point = map.points[i];
    std::optional<SpeedMotions>& motions = stuck ? point.stuck : point.sliding;
    if (!motions) continue;
    std::vector<Pair> pairs;
    for (std::size_t k = 0; k < tracks.size(); ++k) {
      if (tracks[k].behind != i) continue;
      for (std::size_t w = 0; w < motions->whirls.size(); ++w) {
        const double unlike = unlikeness(tracks[k], motions->whirls[w], point.speed);
        if (unlike < another_motion) pairs.push_back({unlike, k, w});
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.unlikeness < b.unlikeness; });
    motions->numbers.assign(motions->whirls.size(), none);
    for (const auto& [unlike, k, w] : pairs) {
      if (motions->numbers[w] != none || tracks[k].behind != i) continue;
      motions->numbers[w] = k;
      const Whirl& whirl = motions->whirls[w];
      tracks[k] = {i + 1, whirl.rate, whirl.rate - tracks[k].rate, whirl.shape};
    }
    for (std::size_t w = 0; w < motions->whirls.size(); ++w) {
      if (motions->numbers[w] != none) continue;
      motions->numbers[w] = tracks.size();
      tracks.push_back({i + 1, motions->whirls[w].rate, 0.0, motions->whirls[w].shape});
    }
  }
}

/// Numbers all motions. Those with sticking contacts take the numbers of similar ones with sliding contacts at the
/// first speed.
void number_all_motions(SpeedMap& map) {
  std::vector<Track> tracks;
  number_motions(false, tracks, map);
  for (Track& track : tracks) track.behind.reset();
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    const auto& sliding = map.points[i].sliding;
    if (!sliding || !map.points[i].stuck) continue;
    for (std::size_t w = 0; w < sliding->whirls.size(); ++w) {
      tracks[sliding->numbers[w]] = {i, sliding->whirls[w].rate, 0.0, sliding->whirls[w].shape};
    }
    break;
  }
  number_motions(true, tracks, map);
  map.motions = tracks.size();
}

}  // namespace

SpeedMap map_speeds(const Rotor& rotor, const std::vector<FilmStepper*>& steppers, const Eigen::Vector2d& gravity,
                    const std::vector<double>& speeds, const std::function<bool()>& keep_going) {
  const RotorEquilibria equilibria(rotor, steppers, gravity);
  SpeedMap map;
  std::vector<BearingState> states;
  Status status = Status::converged;
  for (const double speed : speeds) {
    SpeedPoint& point = map.points.emplace_back();
    point.speed = speed;
    if (status != Status::converged) continue;
    if (keep_going && !keep_going()) status = Status::interrupted;
    if (status == Status::converged) status = equilibria.go_to(speed, states);
    point.status = status;
    if (status != Status::converged) continue;
    point.states = states;
    point.sliding = free_motions(rotor, equilibria, states, false);
    point.stuck = any_slips(states) ? free_motions(rotor, equilibria, states, true) : point.sliding;
  }
  number_all_motions(map);
  if (status == Status::interrupted) return map;
  for (const bool by_coefficients : {false, true}) {
    for (const bool stuck : {false, true}) {
      WhirlOnset kind;
      kind.stuck = stuck;
      kind.by_coefficients = by_coefficients;
      add_onsets(rotor, equilibria, kind, map);
    }
  }
  return map;
}

}  // namespace bumpfoil
