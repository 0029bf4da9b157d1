#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

using namespace tag;  // NOLINT(google-build-using-namespace): for the table below

/// Residual relative to the power, the torque or the largest flow.
double relative(double part, double whole_of_it) {
  return whole_of_it == 0.0 ? 0.0 : part / std::abs(whole_of_it);
}

template <Control control, int axis>
double requested_journal(const BearingModel&, const RunningState& state) {
  return state.requested.control == control ? state.requested.journal[axis] : absent;
}

template <int axis>
double position(const BearingModel&, const RunningState& state) {
  return state.last->position[axis];
}

template <int axis>
double force(const BearingModel&, const RunningState& state) {
  return state.outcome->force[axis];
}

template <int axis>
double tilt(const BearingModel& bearing, const RunningState& state) {
  return state.last->tilt[axis] / bearing.film->half_width();
}

template <int axis>
double moment(const BearingModel&, const RunningState& state) {
  return state.outcome->moment[axis];
}

template <double FilmBearingOutcome::*member>
double of(const BearingModel&, const RunningState& state) {
  return (*state.outcome).*member;
}

template <double FilmBearingOutcome::*member>
double length(const BearingModel& bearing, const RunningState& state) {
  return (*state.outcome).*member * bearing.film->scales.thickness;
}

template <double FilmBearingOutcome::*member>
double pressure(const BearingModel& bearing, const RunningState& state) {
  return (*state.outcome).*member * bearing.film->scales.gas.ambient_pressure;
}

template <double FilmFlows::*member>
double flow(const BearingModel&, const RunningState& state) {
  return state.outcome->flows.*member;
}

template <int FilmBearingOutcome::*member>
double bump_number(const BearingModel&, const RunningState& state) {
  const int bump = (*state.outcome).*member;
  return bump < 0 ? absent : bump + 1;
}

template <std::optional<JournalMatrix> RunningState::*member, int row, int column>
double entry(const BearingModel&, const RunningState& state) {
  return state.*member ? (*(state.*member))(row, column) : absent;
}

/// At the first of the frequencies.
template <std::optional<JournalMatrixC> FilmWhirl::*member, int row, int column>
double whirl_stiffness(const BearingModel&, const RunningState& state) {
  if (state.whirls.empty() || !(state.whirls.front().*member)) return absent;
  return (*(state.whirls.front().*member))(row, column).real();
}
template <std::optional<JournalMatrixC> FilmWhirl::*member, int row, int column>
double whirl_damping(const BearingModel&, const RunningState& state) {
  if (state.whirls.empty() || !(state.whirls.front().*member)) return absent;
  const double frequency = state.whirls.front().frequency;
  return frequency == 0.0 ? absent : (*(state.whirls.front().*member))(row, column).imag() / frequency;
}

/// A rate of motion with the journal held over the rotation speed; undefined at rest.
double over_speed(double rate, const RunningState& state) {
  return state.last->speed == 0.0 ? absent : rate / std::abs(state.last->speed);
}
template <std::optional<HeldMotion> HeldMotions::*member>
double held_growth(const BearingModel&, const RunningState& state) {
  const auto& motion = state.held.*member;
  return motion ? over_speed(motion->rate.real(), state) : absent;
}
template <std::optional<HeldMotion> HeldMotions::*member>
double held_whirl_ratio(const BearingModel&, const RunningState& state) {
  const auto& motion = state.held.*member;
  return motion ? over_speed(motion->rate.imag(), state) : absent;
}

template <std::optional<CriticalMass> RunningState::*member>
double critical_mass_of(const BearingModel&, const RunningState& state) {
  return state.*member ? (*(state.*member)).mass : absent;
}
template <std::optional<CriticalMass> RunningState::*member>
double critical_whirl_ratio(const BearingModel&, const RunningState& state) {
  return state.*member ? over_speed((*(state.*member)).frequency, state) : absent;
}

/// A limit, if requested and found.
using LimitOfState = std::optional<FilmLimit> RunningState::*;
template <LimitOfState limit>
double limit_value(const BearingModel&, const RunningState& state) {
  return state.*limit ? (*(state.*limit)).value : absent;
}
template <LimitOfState limit>
double limit_bound(const BearingModel&, const RunningState& state) {
  return state.*limit && (*(state.*limit)).found() ? static_cast<double>((*(state.*limit)).bounded_by) : absent;
}
template <LimitOfState limit>
double unstable_from(const BearingModel&, const RunningState& state) {
  return state.*limit && !(*(state.*limit)).unstable.empty() ? (*(state.*limit)).unstable.front().from : absent;
}
template <LimitOfState limit>
double unstable_to(const BearingModel&, const RunningState& state) {
  return state.*limit && !(*(state.*limit)).unstable.empty() ? (*(state.*limit)).unstable.back().to : absent;
}

template <int FilmReport::*member>
double cost(const BearingModel&, const RunningState& state) {
  return state.report.*member;
}
using B = BearingModel;
using S = RunningState;
using By = Control;

constexpr auto running_quantity_table = std::to_array<RunningQuantity>({
    {"speed", "rad/s", "speed of the journal, positive from X to Y",
     [](const B&, const S& state) { return state.requested.speed; }, csv | requested | demand, "speed", shown::revolutions},
    {"load_x", "N", "requested load on the journal, X", requested_journal<By::load, 0>, csv | requested | demand, "load, X",
     shown::newtons},
    {"load_y", "N", "requested load on the journal, Y", requested_journal<By::load, 1>, csv | requested | demand, "load, Y",
     shown::newtons},
    {"x", "m", "journal centre, X", position<0>, csv | sampled, "journal, X", shown::micrometres},
    {"y", "m", "journal centre, Y", position<1>, csv | sampled, "journal, Y", shown::micrometres},
    {"force_x", "N", "applied force on the journal, X", force<0>, csv | sampled, "force, X", shown::newtons},
    {"force_y", "N", "applied force on the journal, Y", force<1>, csv | sampled, "force, Y", shown::newtons},
    {"tilt_x", "rad", "slope of the axis of the journal towards X", tilt<0>, csv | of_tilt, "tilt, X",
     shown::milliradians},
    {"tilt_y", "rad", "slope of the axis of the journal towards Y", tilt<1>, csv | of_tilt, "tilt, Y",
     shown::milliradians},
    {"moment_x", "N m", "moment of the applied forces along X about the mid-plane", moment<0>, csv | of_tilt,
     "moment, X", shown::newton_millimetres},
    {"moment_y", "N m", "moment of the applied forces along Y about the mid-plane", moment<1>, csv | of_tilt,
     "moment, Y", shown::newton_millimetres},
    {"eccentricity_ratio", "1", "distance of the journal from the centre over the radial clearance",
     of<&FilmBearingOutcome::eccentricity>, csv | headline | sampled, "eccentricity", shown::unitless},
    {"attitude_angle", "degree",
     "angle from the force to the displacement of the journal, positive in the sense of rotation",
     [](const B&, const S& state) { return to_degrees(state.outcome->attitude_angle); }, csv | headline | sampled,
     "attitude angle", shown::degrees},
    {"h_min", "m", "minimum film thickness of all nodes",
     [](const B& bearing, const S& state) { return state.outcome->thinnest.thickness * bearing.film->scales.thickness; },
     csv | headline | leading | sampled, "minimum film thickness", shown::micrometres},
    {"h_min_theta", "degree", "angle of the minimum film thickness from the weld along the foil",
     [](const B&, const S& state) { return to_degrees(state.outcome->thinnest.theta); },
     csv | sampled, "minimum film thickness: at, from the weld", shown::degrees},
    {"h_min_z", "m", "distance of the minimum film thickness from the mid-plane",
     [](const B& bearing, const S& state) {
       const FilmBearingOutcome& outcome = *state.outcome;
       return bearing.film->half_width() *
              bearing.film->pads[static_cast<std::size_t>(outcome.thinnest_pad)].zeta(outcome.thinnest.row);
     },
     csv | of_width, "minimum film thickness: at, from mid-plane", ShownUnit{"mm", 1e-3}},
    {"h_min_pad", "1", "pad with the minimum film thickness",
     [](const B&, const S& state) { return state.outcome->thinnest_pad + 1.0; }, csv | of_pads | sampled, "minimum film thickness: of pad",
     shown::unitless, whole_number},
    {"h_min_mesh_error", "m",
     "estimated discretisation error of the minimum film thickness, from a mesh of another size",
     [](const B&, const S& state) { return state.mesh_error ? state.mesh_error->minimum_film_thickness : absent; },
     none, "film, mesh error", shown::micrometres},
    {"force_mesh_error", "N",
     "estimated discretisation error of the force at the position, or under a load the effect of the position error",
     [](const B&, const S& state) { return state.mesh_error ? state.mesh_error->force : absent; }, none,
     "force, mesh error", shown::newtons},
    {"h_min_vertex", "m", "minimum film thickness by a parabola through its node and both neighbours",
     [](const B& bearing, const S& state) {
       return state.outcome->thinnest.vertex_thickness * bearing.film->scales.thickness;
     },
     sampled, "minimum film thickness, by a parabola"},
    {"h_min_vertex_theta", "degree", "angle of the minimum film thickness from the weld along the foil",
     [](const B&, const S& state) { return to_degrees(state.outcome->thinnest.vertex_theta); }, none,
     "minimum film thickness, by a parabola: at, from the weld"},
    {"h_min_crest", "m", "minimum film thickness over a crest", length<&FilmBearingOutcome::thinnest_crest>,
     of_foils | sampled, "minimum film thickness over a crest"},
    {"p_max", "Pa", "maximum pressure", pressure<&FilmBearingOutcome::max_pressure>, csv | shown_first | sampled,
     "maximum pressure", shown::bars},
    {"p_min", "Pa", "minimum pressure", pressure<&FilmBearingOutcome::min_pressure>, csv | sampled, "minimum pressure",
     shown::bars},
    {"torque", "N m", "torque of the film on the journal against a positive speed", of<&FilmBearingOutcome::torque>,
     csv | shown_first | sampled, "torque", shown::newton_millimetres},
    {"couette_torque", "N m", "Couette part of the torque", of<&FilmBearingOutcome::couette_torque>, none, "Couette torque"},
    {"poiseuille_torque", "N m", "Poiseuille part of the torque",
     [](const B&, const S& state) {
       return state.outcome->torque - state.outcome->couette_torque - state.outcome->asperity_torque;
     },
     none, "Poiseuille torque"},
    {"asperity_torque", "N m", "part of the torque of asperities that rub", of<&FilmBearingOutcome::asperity_torque>,
     csv | of_asperities | sampled, "torque: of asperities", shown::newton_millimetres},
    {"asperity_share", "1", "part of the force on the journal that asperities carry, along it",
     [](const B&, const S& state) {
       const Eigen::Vector2d& whole = state.outcome->force;
       return whole.isZero(0.0) ? 0.0 : state.outcome->asperity_force.dot(whole) / whole.squaredNorm();
     },
     csv | of_asperities | shown_first | sampled, "load on asperities", shown::unitless},
    {"max_asperity_pressure", "Pa", "maximum pressure of asperities, mean over those around",
     pressure<&FilmBearingOutcome::max_asperity_pressure>, of_asperities | sampled, "asperities, max. pressure",
     shown::bars},
    {"least_torque_speed", "rad/s", "speed of minimum torque under the load: lift-off from rough surfaces",
     [](const B&, const S& state) { return state.least_torque_speed.value_or(absent); },
     csv | of_asperities | shown_first, "speed of minimum torque", shown::revolutions},
    {"power", "W", "power loss", of<&FilmBearingOutcome::power>, csv | headline | key_figure | sampled, "power loss", shown::watts},
    {"couette_dissipation", "W", "Couette dissipation", of<&FilmBearingOutcome::couette_dissipation>, none, "Couette dissipation"},
    {"poiseuille_dissipation", "W", "Poiseuille dissipation",
     [](const B&, const S& state) {
       return state.outcome->dissipation - state.outcome->couette_dissipation -
              state.outcome->asperity_torque * state.last->speed;
     },
     none, "Poiseuille dissipation"},
    {"flow_weld", "m3/s", "flow past the weld along the foil, at ambient pressure", flow<&FilmFlows::start>, none, "flow past the weld"},
    {"flow_free_end", "m3/s", "flow past the free end along the foil, at ambient pressure", flow<&FilmFlows::end>, none, "flow past the free end"},
    {"flow_sides", "m3/s", "flow out at both sides together, at ambient pressure", flow<&FilmFlows::sides>, sampled, "flow out at the sides"},
    {"flow_side_left", "m3/s", "flow out at the side z < 0, at ambient pressure",
     [](const B&, const S& state) {
       return state.outcome->flows.sides - state.outcome->slit_flow - state.outcome->flows.right_side;
     },
     of_tilt, "flow out at the side z < 0"},
    {"flow_side_right", "m3/s", "flow out at the side z > 0, at ambient pressure", flow<&FilmFlows::right_side>,
     of_tilt, "flow out at the side z > 0"},
    {"flow_slits", "m3/s", "part of flow_sides out at the slits of the top foil, at ambient pressure",
     of<&FilmBearingOutcome::slit_flow>, of_slits},
    {"energy_imbalance", "1", "relative imbalance of dissipated and supplied power",
     [](const B&,
        const S& state) { return relative(state.outcome->dissipation - state.outcome->power, state.outcome->power); }},
    {"torque_imbalance", "1", "relative difference between the torque by the balance of moments and that by shear",
     [](const B&, const S& state) {
       return relative(state.outcome->torque_of_moments - state.outcome->torque, state.outcome->torque);
     }},
    {"mass_imbalance", "1", "relative imbalance of the mass flow, over the larger flow past an end: round-off",
     [](const B&, const S& state) {
       const FilmFlows& flows = state.outcome->flows;
       return relative(flows.start - flows.end - flows.sides, std::max(std::abs(flows.start), std::abs(flows.end)));
     }},
    {"loaded_bumps", "1", "bumps loaded by the top foil",
     [](const B&, const S& state) { return static_cast<double>(state.outcome->loaded_bumps); },
     csv | of_foils | shown_first | sampled, "loaded bumps", shown::unitless, whole_number},
    {"first_loaded_bump", "1", "first loaded bump, counted from the weld, pad after pad",
     bump_number<&FilmBearingOutcome::first_loaded>, of_foils | is_bump, "", shown::in_files, whole_number},
    {"last_loaded_bump", "1", "last loaded bump, counted from the weld, pad after pad",
     bump_number<&FilmBearingOutcome::last_loaded>, of_foils | is_bump, "", shown::in_files, whole_number},
    {"lifted_bumps_at_entry", "1", "detached bumps at the inlet; with several pads, the maximum",
     [](const B& bearing, const S& state) { return static_cast<double>(lifted_bumps_at_entry(bearing, state)); },
     of_foils | sampled, "detached bumps at the inlet", shown::in_files, whole_number},
    {"highest_bump_load", "N", "maximum compression between top foil and crest",
     [](const B& bearing, const S& state) { return bump_loads(bearing, *state.last).maxCoeff(); }, of_foils | sampled,
     "maximum bump load", shown::newtons},
    {"highest_loaded_bump", "1", "bump with the maximum load, counted from the weld, pad after pad",
     [](const B& bearing, const S& state) {
       Eigen::Index place = 0;
       return bump_loads(bearing, *state.last).maxCoeff(&place) > 0.0 ? static_cast<double>(place + 1) : absent;
     },
     of_foils | is_bump, "maximum bump load: on bump", shown::unitless, whole_number},
    {"max_stress_top_foil", "Pa", "maximum bending stress of the top foil",
     [](const B&, const S& state) { return state.top_foil_stress.value_or(absent); }, of_foils | sampled,
     "maximum stress, top foil", shown::megapascals},
    {"max_stress_bump_foil", "Pa", "maximum bending stress of the bump foil; frame only",
     [](const B&, const S& state) { return state.bump_foil_stress.value_or(absent); }, of_foils | sampled,
     "maximum stress, bump foil", shown::megapascals},
    {"status", "", "how the search for the state ended",
     [](const B&, const S& state) {
       const auto *const place = std::find(running_statuses.begin(), running_statuses.end(), state.report.status);
       return static_cast<double>(place - running_statuses.begin());
     },
     of_solver | csv | requested | shown_first | sampled, "status", shown::unitless, running_status},
    {"path", "", "path that leads to the state",
     [](const B&, const S& state) { return static_cast<double>(state.path); }, of_solver | csv | requested, "path",
     shown::unitless, flags<FilmPath>},
    {"kxx", "N/m", "dF_x/dx, sliding contacts keep sliding", entry<&S::stiffness, 0, 0>,
     csv | shown_first | sampled, "stiffness, xx", shown::stiffness},
    {"kxy", "N/m", "dF_x/dy, sliding contacts keep sliding", entry<&S::stiffness, 0, 1>, csv | sampled,
     "stiffness, xy", shown::stiffness},
    {"kyx", "N/m", "dF_y/dx, sliding contacts keep sliding", entry<&S::stiffness, 1, 0>, csv | sampled,
     "stiffness, yx", shown::stiffness},
    {"kyy", "N/m", "dF_y/dy, sliding contacts keep sliding", entry<&S::stiffness, 1, 1>,
     csv | shown_first | sampled, "stiffness, yy", shown::stiffness},
    {"kaa", "N m/rad", "dM_x/da, sliding contacts keep sliding; a, b: slopes of the axis towards X and Y",
     entry<&S::stiffness, 2, 2>, csv | of_tilt, "tilting stiffness, aa", shown::tilting_stiffness},
    {"kab", "N m/rad", "dM_x/db, sliding contacts keep sliding", entry<&S::stiffness, 2, 3>, csv | of_tilt,
     "tilting stiffness, ab", shown::tilting_stiffness},
    {"kba", "N m/rad", "dM_y/da, sliding contacts keep sliding", entry<&S::stiffness, 3, 2>, csv | of_tilt,
     "tilting stiffness, ba", shown::tilting_stiffness},
    {"kbb", "N m/rad", "dM_y/db, sliding contacts keep sliding", entry<&S::stiffness, 3, 3>, csv | of_tilt,
     "tilting stiffness, bb", shown::tilting_stiffness},
    {"kxx_stuck", "N/m", "dF_x/dx, full stick", entry<&S::stuck_stiffness, 0, 0>, csv | of_foils},
    {"kxy_stuck", "N/m", "dF_x/dy, full stick", entry<&S::stuck_stiffness, 0, 1>, csv | of_foils},
    {"kyx_stuck", "N/m", "dF_y/dx, full stick", entry<&S::stuck_stiffness, 1, 0>, csv | of_foils},
    {"kyy_stuck", "N/m", "dF_y/dy, full stick", entry<&S::stuck_stiffness, 1, 1>, csv | of_foils},
    {"foil_response", "1",
     "largest slow displacement of the top foil per displacement of the journal: large where the state is nearly "
     "singular",
     [](const B&, const S& state) { return state.foil_response.value_or(absent); }, of_foils,
     "foil displacement per journal displacement"},
    {"stable", "",
     "whether film and foils stay at the state with the journal held: no motion grows, sliding or full stick",
     [](const B&, const S& state) {
       const std::optional<bool> stable = state.held.is_stable();
       return stable ? static_cast<double>(*stable) : absent;
     },
     csv | of_foils | shown_first | sampled, "stable, journal held", shown::unitless, yes_or_no},
    {"growth_held", "1",
     "growth rate over the speed of rotation, film and foils with the journal held: largest real part, unstable if "
     "positive; sliding contacts keep sliding",
     held_growth<&HeldMotions::sliding>, csv | of_foils | shown_first | sampled, "growth, journal held",
     shown::unitless},
    {"whirl_ratio_held", "1",
     "angular frequency of the growing motion with the journal held over the speed of rotation",
     held_whirl_ratio<&HeldMotions::sliding>, csv | of_foils | sampled, "growth, journal held: whirl ratio", shown::unitless},
    {"growth_held_theta", "degree",
     "angle from the weld along the foil where the top foil moves most in the growing motion with the journal held",
     [](const B& bearing, const S& state) {
       return state.held.sliding ? to_degrees(held_place(bearing, *state.held.sliding).theta) : absent;
     },
     of_foils, "growth, journal held: at, from the weld", shown::degrees},
    {"growth_held_stuck", "1", "growth rate over the speed of rotation, journal held, full stick",
     held_growth<&HeldMotions::stuck>, csv | of_foils | sampled, "growth, journal held, full stick"},
    {"whirl_ratio_held_stuck", "1",
     "angular frequency of the growing motion with the journal held over the speed of rotation, full stick",
     held_whirl_ratio<&HeldMotions::stuck>, csv | of_foils, "whirl ratio, journal held, full stick"},
    {"hold_down", "N", "load of the top foil on the last bump before its free end; with several pads, the smallest",
     [](const B& bearing, const S& state) {
       const Vector loads = bump_loads(bearing, *state.last);
       double least = std::numeric_limits<double>::infinity();
       Eigen::Index bumps = 0;
       for (const FilmPad& pad : bearing.film->pads) least = std::min(least, loads[(bumps += pad.bumps()) - 1]);
       return least;
     },
     csv | of_foils | sampled, "hold-down of the free end", shown::newtons},
    {"light_contacts", "1", "closed contacts that carry less than 1 mN",
     [](const B&, const S& state) { return static_cast<double>(state.light_contacts); }, of_foils, "", shown::in_files,
     whole_number},
    {"critical_mass", "kg",
     "smallest mass per bearing at which a rigid rotor on two such bearings begins to whirl; none where it never does, or "
     "where the state is unstable with the journal held; sliding contacts keep sliding",
     critical_mass_of<&S::critical_mass>, csv | shown_first | key_figure | sampled, "critical rotor mass",
     shown::kilograms},
    {"critical_whirl_ratio", "1", "frequency of the whirl at the critical mass over the speed of rotation",
     critical_whirl_ratio<&S::critical_mass>, csv | sampled, "critical rotor mass: whirl ratio", shown::unitless},
    {"critical_mass_stuck", "kg", "critical rotor mass, full stick", critical_mass_of<&S::stuck_critical_mass>,
     csv | of_foils | sampled, "critical rotor mass, full stick"},
    {"critical_whirl_ratio_stuck", "1", "critical whirl ratio, full stick",
     critical_whirl_ratio<&S::stuck_critical_mass>, csv | of_foils, "critical whirl ratio, full stick"},
    {"whirl_frequency", "rad/s", "first frequency of small motions; default: that of the rotation (synchronous)",
     [](const B&, const S& state) { return state.whirls.empty() ? absent : state.whirls.front().frequency; }, none,
     "whirl frequency", shown::revolutions},
    {"kxx_whirl", "N/m", "dF_x/dx at whirl_frequency, sliding contacts keep sliding",
     whirl_stiffness<&FilmWhirl::impedance, 0, 0>, sampled, "dynamic stiffness, xx", shown::stiffness},
    {"kxy_whirl", "N/m", "dF_x/dy at whirl_frequency, sliding contacts keep sliding",
     whirl_stiffness<&FilmWhirl::impedance, 0, 1>, sampled, "dynamic stiffness, xy", shown::stiffness},
    {"kyx_whirl", "N/m", "dF_y/dx at whirl_frequency, sliding contacts keep sliding",
     whirl_stiffness<&FilmWhirl::impedance, 1, 0>, sampled, "dynamic stiffness, yx", shown::stiffness},
    {"kyy_whirl", "N/m", "dF_y/dy at whirl_frequency, sliding contacts keep sliding",
     whirl_stiffness<&FilmWhirl::impedance, 1, 1>, sampled, "dynamic stiffness, yy", shown::stiffness},
    {"cxx_whirl", "N s/m", "dF_x/d(dx/dt) at whirl_frequency, sliding contacts keep sliding",
     whirl_damping<&FilmWhirl::impedance, 0, 0>, sampled, "dynamic damping, xx", shown::damping},
    {"cxy_whirl", "N s/m", "dF_x/d(dy/dt) at whirl_frequency, sliding contacts keep sliding",
     whirl_damping<&FilmWhirl::impedance, 0, 1>, sampled, "dynamic damping, xy", shown::damping},
    {"cyx_whirl", "N s/m", "dF_y/d(dx/dt) at whirl_frequency, sliding contacts keep sliding",
     whirl_damping<&FilmWhirl::impedance, 1, 0>, sampled, "dynamic damping, yx", shown::damping},
    {"cyy_whirl", "N s/m", "dF_y/d(dy/dt) at whirl_frequency, sliding contacts keep sliding",
     whirl_damping<&FilmWhirl::impedance, 1, 1>, sampled, "dynamic damping, yy", shown::damping},
    {"kxx_whirl_stuck", "N/m", "dF_x/dx at whirl_frequency, full stick",
     whirl_stiffness<&FilmWhirl::stuck_impedance, 0, 0>, of_foils},
    {"kxy_whirl_stuck", "N/m", "dF_x/dy at whirl_frequency, full stick",
     whirl_stiffness<&FilmWhirl::stuck_impedance, 0, 1>, of_foils},
    {"kyx_whirl_stuck", "N/m", "dF_y/dx at whirl_frequency, full stick",
     whirl_stiffness<&FilmWhirl::stuck_impedance, 1, 0>, of_foils},
    {"kyy_whirl_stuck", "N/m", "dF_y/dy at whirl_frequency, full stick",
     whirl_stiffness<&FilmWhirl::stuck_impedance, 1, 1>, of_foils},
    {"cxx_whirl_stuck", "N s/m", "dF_x/d(dx/dt) at whirl_frequency, full stick",
     whirl_damping<&FilmWhirl::stuck_impedance, 0, 0>, of_foils},
    {"cxy_whirl_stuck", "N s/m", "dF_x/d(dy/dt) at whirl_frequency, full stick",
     whirl_damping<&FilmWhirl::stuck_impedance, 0, 1>, of_foils},
    {"cyx_whirl_stuck", "N s/m", "dF_y/d(dx/dt) at whirl_frequency, full stick",
     whirl_damping<&FilmWhirl::stuck_impedance, 1, 0>, of_foils},
    {"cyy_whirl_stuck", "N s/m", "dF_y/d(dy/dt) at whirl_frequency, full stick",
     whirl_damping<&FilmWhirl::stuck_impedance, 1, 1>, of_foils},
    {"jumps", "1", "jumps on the path to the state: from a branch of states that ends to another one",
     cost<&FilmReport::jumps>, of_solver | requested | of_foils | sampled, "jumps to other branches", shown::in_files, whole_number},
    {"iterations", "1", "Newton steps on the path to the state", cost<&FilmReport::iterations>, of_solver | requested, "",
     shown::in_files, whole_number},
    {"factorisations", "1", "factorisations of contact systems on the path to the state",
     cost<&FilmReport::factorisations>, of_solver | requested | of_foils, "", shown::in_files, whole_number},
    {"residual", "1", "norm of all scaled residuals before the last Newton step",
     [](const B&, const S& state) { return state.report.residual; }, of_solver | sampled},
    {"wall_time", "s", "time that the state took", [](const B&, const S& state) { return state.wall_time; },
     of_solver | requested},
    {"lift_off_speed", "rad/s",
     "lowest speed of the path coasting down under the load whose state is stable and whose minimum film thickness is "
     "film.h_lift_off or more",
     limit_value<&S::lift_off_speed>, csv | requested | of_foils | of_limits | headline | sampled, "lift-off speed",
     shown::revolutions},
    {"load_capacity", "N",
     "largest load of the path, along the first load, whose state at the speed is stable and whose minimum film "
     "thickness is film.h_lift_off or more",
     limit_value<&S::load_capacity>, csv | requested | of_foils | of_limits | headline | sampled, "load capacity",
     shown::newtons},
    {"lift_off_bounded_by", "", "why states below lift_off_speed do not count", limit_bound<&S::lift_off_speed>,
     csv | requested | of_foils | of_limits, "", shown::in_files, flags<LimitBound>},
    {"lift_off_unstable_from", "rad/s",
     "lowest speed of that path whose state is unstable with the journal held; none where all are stable",
     unstable_from<&S::lift_off_speed>, csv | requested | of_foils | of_limits},
    {"lift_off_unstable_to", "rad/s", "highest speed of that path whose state is unstable",
     unstable_to<&S::lift_off_speed>, csv | requested | of_foils | of_limits},
    {"capacity_bounded_by", "", "why states above load_capacity do not count", limit_bound<&S::load_capacity>,
     csv | requested | of_foils | of_limits, "", shown::in_files, flags<LimitBound>},
    {"capacity_unstable_from", "N",
     "smallest load of that path whose state is unstable with the journal held; none where all are stable",
     unstable_from<&S::load_capacity>, csv | requested | of_foils | of_limits},
    {"capacity_unstable_to", "N", "largest load of that path whose state is unstable", unstable_to<&S::load_capacity>,
     csv | requested | of_foils | of_limits},
});

/// Displacement by P_k over the width, at zeta = 1: 0 for foils without this mode.
template <int k>
Vector mode_of_top_foil(const BearingModel& bearing, const BearingState& state) {
  const WidthLines& lines = bearing.film->pads.front().foil.lines;
  const auto place = std::find(lines.orders.begin(), lines.orders.end(), k) - lines.orders.begin();
  if (place == std::ssize(lines.orders)) return Vector::Zero(bearing.film->columns());
  return bearing.film->scales.thickness * (lines.to_modes.row(place) * state.film.deflection).transpose();
}

constexpr auto column_table = std::to_array<ColumnQuantity>({
    {"film_thickness", "m", "film thickness, the same over the width",
     [](const BearingModel& bearing, const BearingState& state) -> Vector {
       return bearing.film->scales.thickness * state.film.thickness.row(0).transpose();
     },
     of_uniform_film},
    {"line_load", "N/m", "gauge pressure, integrated over the width",
     [](const BearingModel& bearing, const BearingState& state) -> Vector {
       const FilmMesh& mesh = bearing.film->pads.front().foil.mesh;  // all meshes have the same rows
       Vector load = Vector::Zero(bearing.film->columns());
       for (int j = 0; j <= mesh.rows; ++j) {
         load.array() += mesh.row_weight(j) * (state.film.pressure.row(j).transpose().array() - 1.0);
       }
       return mesh.copies() * bearing.film->scales.gas.ambient_pressure * bearing.film->scales.radius * mesh.dzeta *
              load;
     }},
    {"asperity_pressure", "Pa", "pressure of asperities, mean over those around, the same over the width",
     [](const BearingModel& bearing, const BearingState& state) -> Vector {
       return bearing.film->scales.gas.ambient_pressure *
              asperity_pressures(*bearing.film, state.film.thickness).row(0).transpose();
     },
     of_asperities | of_uniform_film},
    {"film_top_displacement", "m", "deflection of the top foil in the mean over the width, positive outward",
     [](const BearingModel& bearing, const BearingState& state) -> Vector {
       return bearing.film->scales.thickness *
              (state.film.deflection.transpose() * bearing.film->pads.front().foil.lines.weight);
     }},
    {"film_top_slope", "m", "deflection of the top foil at its side z > 0 beyond the mean, linear over the width",
     mode_of_top_foil<1>, of_slope},
    {"film_top_parabola", "m", "deflection of the top foil at its sides beyond the mean, as a parabola over the width",
     mode_of_top_foil<2>, of_parabola},
    {"film_top_moment", "N m", "bending moment of the top foil",
     [](const BearingModel& bearing, const BearingState& state) -> Vector {
       Vector moment = bearing.film->scales.thickness * state.film.moment.colwise().sum().transpose();
       for (const FilmPad& pad : bearing.film->pads) moment(pad.columns()) *= pad.foil.stiffness * pad.foil.pitch;
       return moment;
     }},
});

}  // namespace

std::string name_of_limit(const FilmLimit& limit) {
  return limit.kind == FilmLimitKind::lift_off_speed
             ? fmt::format("lift-off speed under the load ({:.6g}, {:.6g}) N", limit.thick.journal.x(),
                           limit.thick.journal.y())
             : fmt::format("load capacity at {:.6g} rpm", limit.thick.speed / shown::revolutions.size);
}

std::string shown_limit_value(const FilmLimit& limit, double value) {
  return limit.kind == FilmLimitKind::lift_off_speed ? fmt::format("{:.5g} rpm", value / shown::revolutions.size)
                                                     : fmt::format("{:.5g} N", value);
}

std::string unstable_ranges_text(const FilmLimit& limit) {
  std::string text;
  for (const auto& [from, to] : limit.unstable) {
    text += fmt::format("{}{}", text.empty() ? "" : " and ", shown_limit_value(limit, from));
    if (to > from) text += fmt::format(" to {}", shown_limit_value(limit, to));
  }
  return text;
}

std::vector<RunningQuantity> running_quantities(const BearingModel& bearing, bool limits) {
  std::vector<RunningQuantity> quantities(running_quantity_table.begin(), running_quantity_table.end());
  std::erase_if(quantities, [&](const RunningQuantity& quantity) {
    return (quantity.is(of_limits) && !limits) ||
           (quantity.is(of_asperities) && !bearing.film->surroundings.asperities) ||
           (quantity.is(of_foils) && bearing.bumps() == 0) ||
           (quantity.is(of_pads) && bearing.film->pads.size() == 1) ||
           (quantity.is(of_width) && !bearing.film->varies_over_the_width() && !bearing.film->has_slits()) ||
           (quantity.is(of_tilt) && !bearing.film->tilts()) || (quantity.is(of_slits) && !bearing.film->has_slits());
  });
  return quantities;
}

std::span<const RunningQuantity> all_running_quantities() {
  return running_quantity_table;
}

bool has_mode(const BearingModel& bearing, int k) {
  const std::vector<int>& orders = bearing.film->pads.front().foil.lines.orders;
  return std::find(orders.begin(), orders.end(), k) != orders.end();
}

std::span<const ColumnQuantity> column_quantities() {
  return column_table;
}

double value_of(const RunningQuantity& quantity, const BearingModel& bearing, const RunningState& state) {
  return quantity.is(requested) || state.found() ? quantity.value(bearing, state) : absent;
}

Matrix film_pressure(const BearingModel& bearing, const BearingState& state) {
  return bearing.film->scales.gas.ambient_pressure * state.film.pressure;
}

std::string running_bump_text(const BearingModel& bearing, int bump) {
  for (std::size_t k = 0; k < bearing.film->pads.size(); ++k) {
    const int bumps = bearing.film->pads[k].bumps();
    if (bump < bumps)
      return bearing.film->pads.size() == 1 ? fmt::format("{}", bump + 1) : fmt::format("{}.{}", k + 1, bump + 1);
    bump -= bumps;
  }
  return {};
}

namespace {

std::string speed_text(const OperatingPoint& point) {
  return fmt::format("{:.6g} rpm", point.speed / shown::revolutions.size);
}

std::string journal_text(const OperatingPoint& point) {
  const bool by_load = point.by_load();
  const double unit = by_load ? 1.0 : 1e-6;
  return fmt::format("{} ({:.6g}, {:.6g}) {}", by_load ? "load" : "position", point.journal.x() / unit,
                     point.journal.y() / unit, by_load ? "N" : "um");
}

/// The previous value of the quantity that changes between points.
std::string where_from(const OperatingPoint& before, const OperatingPoint& now) {
  return before.journal == now.journal ? speed_text(before) : journal_text(before);
}

}  // namespace

std::string name_of_point(const OperatingPoint& point) {
  return (std::isnan(point.speed) ? "" : speed_text(point) + ", ") + journal_text(point);
}

std::string name_of_state(const RunningState& state) {
  return fmt::format("{} from {}, {}", name_of(state.path),
                     state.before ? where_from(*state.before, state.requested) : "rest",
                     name_of_point(state.requested));
}

std::string running_failure(const BearingModel& bearing, const RunningState& state) {
  if (state.found()) return {};
  std::string text = fmt::format("{}: {}", name_of_state(state), explanation(state.report.status));
  if (state.outcome) {
    text += fmt::format(
        "; last state found: {:.6g} rpm, journal ({:.5g}, {:.5g}) um, force ({:.5g}, "
        "{:.5g}) N, minimum film thickness {:.4g} um",
        state.last->speed / shown::revolutions.size, 1e6 * state.last->position.x(), 1e6 * state.last->position.y(),
        state.outcome->force.x(), state.outcome->force.y(),
        1e6 * state.outcome->thinnest.thickness * bearing.film->scales.thickness);
    if (state.last->clearance_offset > 0.0) {
      text += fmt::format(", with the clearance at {:.5g} um, closing to {:.5g} um",
                          1e6 * (bearing.clearance + state.last->clearance_offset), 1e6 * bearing.clearance);
    }
  }
  return text;
}

HeldPlace held_place(const BearingModel& bearing, const HeldMotion& motion) {
  const auto behind = std::find_if(bearing.film->pads.begin(), bearing.film->pads.end(),
                                   [&](const FilmPad& pad) { return pad.first_column > motion.column; });
  const FilmPad& pad = *std::prev(behind);
  return {.pad = static_cast<std::size_t>(std::distance(bearing.film->pads.begin(), behind)) - 1,
          .theta = pad.foil.mesh.angles()[motion.column - pad.first_column]};
}

int lifted_bumps_at_entry(const BearingModel& bearing, const RunningState& state) {
  if (!state.found()) return 0;
  const Vector loads = bump_loads(bearing, *state.last);
  if (!(loads.array() > 0.0).any()) return 0;
  Eigen::Index most = 0;
  Eigen::Index bump = 0;
  for (const FilmPad& pad : bearing.film->pads) {
    Vector own = loads.segment(bump, pad.bumps());
    if (bearing.film->surface_speed(pad, state.requested.speed) < 0.0) own.reverseInPlace();
    most = std::max(most, std::find_if(own.begin(), own.end(), [](double load) { return load > 0.0; }) - own.begin());
    bump += pad.bumps();
  }
  return static_cast<int>(most);
}

}  // namespace bumpfoil
