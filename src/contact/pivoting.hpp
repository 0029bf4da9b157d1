#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/solver.hpp"

namespace bumpfoil {

/// Calls visit(contact) for each contact whose modes differ, in order, until it returns false. Most modes agree: eight
/// are compared at once.
/// @return whether no call returned false
template <typename Visitor>
bool for_each_difference(const std::vector<ContactMode>& a, const std::vector<ContactMode>& b, Visitor&& visit) {
  static_assert(sizeof(ContactMode) == 1);
  constexpr bool first_is_lowest = std::endian::native == std::endian::little;
  std::size_t c = 0;
  for (; c + 8 <= a.size(); c += 8) {
    std::uint64_t eight_of_a = 0;
    std::uint64_t eight_of_b = 0;
    std::memcpy(&eight_of_a, &a[c], 8);
    std::memcpy(&eight_of_b, &b[c], 8);
    for (std::uint64_t differing = eight_of_a ^ eight_of_b; differing != 0;) {
      const int i = (first_is_lowest ? std::countr_zero(differing) : std::countl_zero(differing)) / 8;
      if (!visit(c + static_cast<std::size_t>(i))) return false;
      differing &= ~(std::uint64_t{0xff} << 8 * (first_is_lowest ? i : 7 - i));
    }
  }
  for (; c < a.size(); ++c) {
    if (a[c] != b[c] && !visit(c)) return false;
  }
  return true;
}

/// Quantities of one contact to check after a solve for its mode.
struct ContactTrial {
  double gap{};       ///< m
  double normal{};    ///< N
  double friction{};  ///< N
  double slip{};      ///< m
};

/// Quantities of a contact in `state` to check, its slip measured from `previous_x`.
inline ContactTrial trial_of(const CoulombContact& contact, const ContactState& state, const Vector& previous_x) {
  return {.gap = state.gap[contact.index],
          .normal = state.normal_force[contact.index],
          .friction = state.friction_force[contact.index],
          .slip = contact.tangential(state.x) - contact.tangential(previous_x)};
}

/// Solves for the unknowns and contact forces under the modes `mode`, and counts the cost.
/// @param state  result; its storage is reused
/// @return false if no such state exists
[[nodiscard]] inline bool solve_modes(ModeSystem& system, const std::vector<ContactMode>& mode,
                                      const ContactLoading& loading, const Vector& previous_x, ContactState& state,
                                      SolveCost& cost) {
  const int factorisations = system.factorisations();
  const bool regular = system.set_modes(mode);
  cost.factorisations += system.factorisations() - factorisations;
  if (!regular) return false;
  system.solve(loading, previous_x, state);
  ++cost.iterations;
  return state.x.allFinite();
}

/// The mode that a contact should be tried in next: its own where the trial obeys the inequalities of the mode.
///
/// A contact that closes is tried slipping the way it moved while open, and one that sticks in tension only because it
/// is held sideways is tried slipping before it is opened: holding a contact that must slip falsifies its normal force.
inline ContactMode next_mode(ContactMode mode, double f, const ContactTrial& trial, double length_tolerance,
                             double force_tolerance) {
  if (mode == ContactMode::open) {
    if (trial.gap >= -length_tolerance) return mode;
    return f > 0.0 && std::abs(trial.slip) > length_tolerance ? slip_mode(trial.slip) : ContactMode::stick;
  }
  if (slips(mode)) {
    if (trial.normal < -force_tolerance) return ContactMode::open;
    const double along = mode == ContactMode::slip_forward ? trial.slip : -trial.slip;
    return along < -length_tolerance ? ContactMode::stick : mode;
  }
  if (f > 0.0 && std::abs(trial.friction) - f * std::abs(trial.normal) > force_tolerance) {
    return slip_mode(-trial.friction);
  }
  return trial.normal < -force_tolerance ? ContactMode::open : mode;
}

/// A contact whose solution contradicts its mode, and its new mode.
struct ModeChange {
  Eigen::Index contact{};
  ContactMode to{};
  double excess{};  ///< violation of the inequality: m or N, comparable between changes of the same kind

  bool operator==(const ModeChange&) const = default;
};

/// The change that a contact needs; `to` is its own mode if it needs none.
inline ModeChange check_mode(Eigen::Index contact, ContactMode mode, double f, const ContactTrial& trial,
                             double length_tolerance, double force_tolerance) {
  const ContactMode to = next_mode(mode, f, trial, length_tolerance, force_tolerance);
  double excess = std::abs(trial.slip);  // slip in the wrong direction
  if (mode == ContactMode::open) {
    excess = -trial.gap;
  } else if (to == ContactMode::open) {
    excess = -trial.normal;
  } else if (mode == ContactMode::stick) {
    excess = std::abs(trial.friction) - f * std::abs(trial.normal);
  }
  return {contact, to, excess};
}

/// Block principal pivoting with a safeguard [Judice1994]: change all contradicting contacts at once while their number
/// falls, and a few times after that; then one at a time, always the last one, which cannot cycle for P-matrices
/// [Murty1974], until the number has fallen below its best.
class PivotingRule {
 public:
  explicit PivotingRule(int max_rounds) : rounds_left_(max_rounds) {}

  /// Applies to `mode` as many of the proposed changes as the rule allows.
  /// @return false once the rounds are used up
  [[nodiscard]] bool apply(const std::vector<ModeChange>& changes, std::vector<ContactMode>& mode) {
    if (rounds_left_-- <= 0) return false;
    if (changes.size() < fewest_) {
      fewest_ = changes.size();
      patience_ = full_patience;
    } else {
      --patience_;
    }
    const std::size_t first = patience_ > 0 ? 0 : changes.size() - 1;
    for (std::size_t i = first; i < changes.size(); ++i) {
      mode[static_cast<std::size_t>(changes[i].contact)] = changes[i].to;
    }
    return true;
  }

 private:
  static constexpr int full_patience = 3;

  int rounds_left_;
  int patience_{full_patience};
  std::size_t fewest_{std::numeric_limits<std::size_t>::max()};
};

/// Changes only the worst contact of each run of neighbours that all need the same change. If a long section of foil is
/// slightly wrong, closing (or opening) all of it at once bends the foil sharply at its ends, and wrong modes travel
/// along the foil contact by contact; its worst contact alone often puts the rest right.
class WorstOfRuns {
 public:
  /// Neighbours are contacts of the same rank in neighbouring blocks.
  explicit WorstOfRuns(const std::vector<ContactSite>& sites) {
    places_.reserve(sites.size());
    for (const ContactSite& site : sites) {
      const bool same_block = !places_.empty() && places_.back().block == site.block;
      places_.push_back({site.block, same_block ? places_.back().rank + 1 : 0});
      runs_.resize(std::max(runs_.size(), places_.back().rank + 1));
    }
  }

  /// @param changes  in the order of contacts
  void apply(const std::vector<ModeChange>& changes, std::vector<ContactMode>& mode) {
    for (Run& run : runs_) run.last = nullptr;
    for (const ModeChange& change : changes) {
      const Place& place = place_of(change);
      Run& run = runs_[place.rank];
      const bool continues = run.last != nullptr && place_of(*run.last).block + 1 == place.block &&
                             run.last->to == change.to && mode_of(*run.last, mode) == mode_of(change, mode);
      if (!continues) finish(run, mode);
      if (!continues || change.excess > run.worst->excess) run.worst = &change;
      run.last = &change;
    }
    for (Run& run : runs_) finish(run, mode);
  }

 private:
  struct Place {
    int block{};
    std::size_t rank{};  ///< among the contacts of the block
  };
  struct Run {
    const ModeChange* last{};
    const ModeChange* worst{};
  };

  [[nodiscard]] const Place& place_of(const ModeChange& change) const {
    return places_[static_cast<std::size_t>(change.contact)];
  }
  static ContactMode& mode_of(const ModeChange& change, std::vector<ContactMode>& mode) {
    return mode[static_cast<std::size_t>(change.contact)];
  }
  static void finish(const Run& run, std::vector<ContactMode>& mode) {
    if (run.last != nullptr) mode_of(*run.worst, mode) = run.worst->to;
  }

  std::vector<Place> places_;  ///< of the contacts
  std::vector<Run> runs_;      ///< one for each rank
};

}  // namespace bumpfoil
