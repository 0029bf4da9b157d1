#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "experiments/equilibrium/small_motions.hpp"
#include "experiments/fit/fit_columns.hpp"
#include "experiments/fit/measured_data.hpp"

namespace bumpfoil {
namespace {

/// Measuring condition of a row.
struct PlaceOfRow {
  double speed{};
  Eigen::Vector2d load{0.0, 0.0};
  std::optional<double> frequency{};
};

bool is_coefficient(FitColumn column) {
  return column >= FitColumn::kxx;
}

/// The quantity of a running bearing in a column.
const RunningQuantity& running_quantity_of(FitColumn column, FittedContacts contacts) {
  std::string name(name_of(column));
  if (is_coefficient(column)) name += contacts == FittedContacts::stuck ? "_whirl_stuck" : "_whirl";
  const auto all = all_running_quantities();
  return *std::find_if(all.begin(), all.end(), [&name](const RunningQuantity& one) { return one.name == name; });
}

class MeasuredEquilibriumData final : public MeasuredData {
 public:
  explicit MeasuredEquilibriumData(const FitData& data) : contacts_(data.contacts) {
    const std::vector<double>& speeds = data.column(FitColumn::speed).values;
    const std::vector<double>& frequencies = data.column(FitColumn::frequency).values;
    for (std::size_t row = 0; row < speeds.size(); ++row) {
      PlaceOfRow& place = places_.emplace_back();
      place.speed = speeds[row];
      place.load = load_in_row(data, row);
      if (!frequencies.empty()) place.frequency = frequencies[row];
    }
    measured_ = measured_table(data);
    for (const FittedQuantity& quantity : measured_.quantities) {
      quantities_.push_back(running_quantity_of(quantity.column, data.contacts));
      has_coefficients_ = has_coefficients_ || is_coefficient(quantity.column);
    }
    add_points(data);
  }

  [[nodiscard]] Case case_for(Case input) const override {
    input.solver.name = SolverName::newton;  // the solver for films; loops may use another
    input.settings.keep_only<EquilibriumSettings>();
    auto& settings = input.settings.get_or_create<EquilibriumSettings>();
    settings.speeds = {places_.front().speed};
    settings.loads = {places_.front().load};
    settings.positions.clear();
    settings.frequencies.clear();
    settings.limits = settings.prefer_stable = false;
    return input;
  }

  [[nodiscard]] std::optional<DataAnswer> answer(const Case& input, const Rig& rig) const override {
    const auto bearing = std::make_shared<const BearingModel>(require_running_bearing(input));
    const EquilibriumSettings& of_case = input.settings.get<EquilibriumSettings>();
    const auto groups = groups_on(of_case.path);
    std::vector<std::vector<double>> values(quantities_.size(), std::vector<double>(places_.size(), absent));
    tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t i) {
      const EquilibriumSettings settings = settings_of(of_case, groups[i]);
      NoCheckers none;
      EquilibriumResult result = find_states(bearing, settings, thickness_floor(input), {settings.path}, {}, &none);
      for (RunningState& state : result.states) add_answers(bearing, settings, state);
      for (std::size_t k = 0; k < result.states.size(); ++k) {
        for (std::size_t q = 0; q < quantities_.size(); ++q) {
          values[q][groups[i][k]] = value_of(quantities_[q], *bearing, result.states[k]);
        }
      }
    });
    for (std::vector<double>& column : values) {
      if (std::any_of(column.begin(), column.end(), [](double value) { return !std::isfinite(value); })) {
        return std::nullopt;  // a state that was not found, or a singular matrix
      }
    }
    return table_answer(measured_, [&, q = std::size_t{0}](FitColumn column) mutable {
      std::vector<double> read = std::move(values[q++]);
      for (double& value : read) value += origin_of(column, rig);
      return read;
    });
  }

 private:
  static double origin_of(FitColumn column, const Rig& rig) {
    switch (column) {
      case FitColumn::x:
        return rig.x_origin;
      case FitColumn::y:
        return rig.y_origin;
      case FitColumn::torque:
        return rig.torque_origin;
      default:
        return 0.0;
    }
  }

  /// Adds the measured quantities of a state that was found: small motions have the frequency of the settings or that
  /// of the rotation.
  void add_answers(const SharedBearing& bearing, const EquilibriumSettings& settings, RunningState& state) const {
    if (!state.found()) return;
    state.outcome = film_bearing_outcome(*bearing, *state.last);
    if (!has_coefficients_) return;
    FilmWhirl& whirl = state.whirls.emplace_back();
    whirl.frequency = frequencies_of(settings, state.requested.speed).front();
    const bool stuck = contacts_ == FittedContacts::stuck;
    const auto found = FilmStepper(bearing).impedances(*state.last, {{0.0, whirl.frequency}}, stuck);
    // For a tilting journal, entries other than force by displacement have other units and are not measured.
    if (found) (stuck ? whirl.stuck_impedance : whirl.impedance) = found->front();
  }

  /// Uses the coordinate that varies most from row to row.
  void add_points(const FitData& data) {
    std::set<double> speeds, frequencies;
    std::set<std::pair<double, double>> loads;
    for (const PlaceOfRow& place : places_) {
      speeds.insert(place.speed);
      loads.emplace(place.load.x(), place.load.y());
      if (place.frequency) frequencies.insert(*place.frequency);
    }
    const bool over_frequency = frequencies.size() > std::max(speeds.size(), loads.size());
    const bool over_speed = !over_frequency && speeds.size() > loads.size();
    const FitColumn axis = over_frequency ? FitColumn::frequency : over_speed ? FitColumn::speed : FitColumn::load_x;
    measured_.axis = axis == FitColumn::load_x ? "Load" : title_of(axis);
    measured_.axis_unit = unit_of(axis);
    std::vector<double> at;
    std::vector<std::string> series;
    for (const PlaceOfRow& place : places_) {
      at.push_back(over_frequency ? *place.frequency : over_speed ? place.speed : place.load.norm());
      std::string name = over_speed ? "" : fmt::format("{:.6g} rpm", place.speed / shown::revolutions.size);
      if (over_speed || over_frequency) {
        name += fmt::format("{}load ({:.6g}, {:.6g}) N", name.empty() ? "" : ", ", place.load.x(), place.load.y());
      } else {
        name += fmt::format(", load towards {:.6g} deg", to_degrees(std::atan2(place.load.y(), place.load.x())));
      }
      if (place.frequency && !over_frequency) name += fmt::format(", {:.6g} rad/s", *place.frequency);
      series.push_back(std::move(name));
    }
    add_table_points(measured_, data, at, series);
  }

  /// Rows that are states of one path, in measured order: of one load for a speed ramp, of one speed on all other
  /// paths.
  [[nodiscard]] std::vector<std::vector<std::size_t>> groups_on(FilmPath path) const {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t row = 0; row < places_.size(); ++row) {
      const PlaceOfRow& own = places_[row];
      const auto same = [&](const std::vector<std::size_t>& group) {
        const PlaceOfRow& other = places_[group.front()];
        return other.frequency == own.frequency &&
               (path == FilmPath::speed_ramp ? other.load == own.load : other.speed == own.speed);
      };
      const auto known = std::find_if(groups.begin(), groups.end(), same);
      (known == groups.end() ? groups.emplace_back() : *known).push_back(row);
    }
    return groups;
  }

  [[nodiscard]] EquilibriumSettings settings_of(EquilibriumSettings settings,
                                                const std::vector<std::size_t>& rows) const {
    settings.speeds.clear();
    settings.loads.clear();
    const PlaceOfRow& first = places_[rows.front()];
    if (first.frequency) settings.frequencies = {*first.frequency};
    const bool over_speed = settings.path == FilmPath::speed_ramp;
    for (const std::size_t row : rows) {
      if (over_speed || settings.speeds.empty()) settings.speeds.push_back(places_[row].speed);
      if (!over_speed || settings.loads.empty()) settings.loads.push_back(places_[row].load);
    }
    return settings;
  }

  std::vector<PlaceOfRow> places_;
  std::vector<RunningQuantity> quantities_;
  FittedContacts contacts_;
  bool has_coefficients_{};  ///< any stiffness or damping column
};

}  // namespace

std::unique_ptr<const MeasuredData> measured_equilibria(const FitData& data) {
  return std::make_unique<MeasuredEquilibriumData>(data);
}

}  // namespace bumpfoil
