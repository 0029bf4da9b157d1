#include "bumpfoil/experiments/cycle/result_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

using namespace tag;  // NOLINT(google-build-using-namespace): for the tables below

template <auto Increment::*member>
double of(const Increment& increment) {
  return static_cast<double>(increment.*member);
}

template <int SolveCost::*member>
double cost(const Increment& increment) {
  return increment.cost.*member;
}

template <auto CycleEvent::*member>
double of_event(const CycleEvent& event) {
  return static_cast<double>(event.*member);
}

template <auto Cycle::*member>
double of_cycle(const Cycle& cycle, const Case& /*input*/) {
  return static_cast<double>(cycle.*member);
}

template <std::optional<double> Cycle::*member>
double derived(const Cycle& cycle, const Case& /*input*/) {
  return (cycle.*member).value_or(absent);
}

template <int SolveCost::*member>
double total(const Cycle& cycle, const Case& /*input*/) {
  return cycle.cost.*member;
}

template <double Increment::*member>
double at_start(const Cycle& cycle, const Case& /*input*/) {
  return cycle.start ? (*cycle.start).*member : absent;
}

/// Quantities of a cycle that are undefined before its start.
template <double Cycle::*member>
double once_begun(const Cycle& cycle, const Case& /*input*/) {
  return cycle.start ? cycle.*member : absent;
}

template <double TurningPoint::*member>
double at_turn(const Cycle& cycle, const Case& /*input*/) {
  return cycle.turning_point ? (*cycle.turning_point).*member : absent;
}

template <double Increment::*member>
double first_turn(const Cycle& cycle, const Case& /*input*/) {
  return cycle.turning_point ? cycle.turns.front().*member : absent;
}

template <std::optional<double> TangentStiffnesses::*member>
double tangent(const Cycle& cycle, const Case& /*input*/) {
  return cycle.turning_point ? (cycle.turning_point->tangent.*member).value_or(absent) : absent;
}

template <std::optional<StressPeak> Cycle::*member>
double peak(const Cycle& cycle, const Case& /*input*/) {
  return cycle.*member ? (*(cycle.*member)).stress : absent;
}

template <std::size_t foil>
double yields(const Cycle& cycle, const Case& input) {
  return above_yield(stressed_foils()[foil], cycle, input);
}

/// Only under load control is it a result.
template <Control (*control)(const Case&)>
double amplitude(const Cycle& cycle, const Case& input) {
  return cycle.turning_point || control(input) == Control::displacement ? cycle.amplitude : absent;
}
Control control_of_cycle(const Case& input) {
  return input.settings.get<CycleSettings>().amplitude.control;
}
Control control_of_strip(const Case& input) {
  return input.settings.get<StripSettings>().amplitude.control;
}

template <auto FoilFields::*member>
FieldMatrix field(const FoilFields& fields) {
  return fields.*member;
}

template <FieldMatrix StressFields::*member>
FieldMatrix stress(const FoilFields& fields) {
  return fields.stress.*member;
}

template <InterfaceFields FoilFields::*interface, FieldMatrix InterfaceFields::*member>
FieldMatrix contact(const FoilFields& fields) {
  return fields.*interface.*member;
}

template <InterfaceFields FoilFields::*interface>
FieldMatrix state(const FoilFields& fields) {
  return (fields.*interface).mode.unaryExpr([](ContactMode mode) { return static_cast<double>(mode); });
}

/// An entry of the tangents of a path.
template <std::optional<Eigen::Matrix2d> TangentMatrices::*tangent, int i, int j>
double entry(const Increment& increment) {
  const std::optional<Eigen::Matrix2d>& K = increment.tangents.*tangent;
  return K ? (*K)(i, j) : absent;
}

template <double OrbitLoop::*member>
double last_orbit(const Cycle& cycle, const Case& /*input*/) {
  return cycle.orbits.empty() ? absent : cycle.orbits.back().*member;
}

constexpr auto increment_table = std::to_array<IncrementQuantity>({
    {"branch", "", "branch of the cycle", of<&Increment::branch>, loops | csv, "", shown::in_files, flags<Branch>},
    {"displacement", "m", "displacement of the {pressing} {along}", of<&Increment::displacement>, of_all | csv},
    {"x", "m", "journal centre, X", of<&Increment::x>, bearings | csv | headline, "journal, X", shown::micrometres},
    {"y", "m", "journal centre, Y", of<&Increment::y>, bearings | csv | headline, "journal, Y", shown::micrometres},
    {"force_x", "N", "applied force on the journal, X", of<&Increment::force_x>, bearings | csv | headline, "force, X",
     shown::newtons},
    {"force_y", "N", "applied force on the journal, Y", of<&Increment::force_y>, bearings | csv | headline, "force, Y",
     shown::newtons},
    {"force_direct", "N", "applied force on the {pressing}, {along}", of<&Increment::force_direct>, of_all | csv},
    {"force_cross", "N", "applied force on the journal, 90 degrees ahead of the direction", of<&Increment::force_cross>,
     bearings | csv},
    {"moment_x", "N m", "moment of the applied forces along X about the mid-plane", of<&Increment::moment_x>,
     bearings | of_width_alone | csv, "moment, X", shown::newton_millimetres},
    {"moment_y", "N m", "moment of the applied forces along Y about the mid-plane", of<&Increment::moment_y>,
     bearings | of_width_alone | csv, "moment, Y", shown::newton_millimetres},
    {"tilt_x", "rad", "slope of the axis of the journal towards X", of<&Increment::tilt_x>,
     bearings | of_width_alone | csv, "tilt, X", shown::milliradians},
    {"tilt_y", "rad", "slope of the axis of the journal towards Y", of<&Increment::tilt_y>,
     bearings | of_width_alone | csv, "tilt, Y", shown::milliradians},
    {"elastic_energy", "J", "elastic energy of the foils", of<&Increment::elastic_energy>, of_all | csv},
    {"dissipated_energy", "J",
     "energy dissipated since increment 0: by friction and, with `events`, where the foils snap",
     of<&Increment::dissipated_energy>, of_all | csv | headline, "dissipated energy", shown::millijoules},
    {"work", "J", "work of the {pressing} since increment 0", of<&Increment::work>, of_all | csv},
    {"residual", "1", "largest unbalanced force over the largest contact force",
     [](const Increment& increment) { return increment.residuals.equilibrium; }, of_all | csv},
    {"iterations", "1", "linear solves", cost<&SolveCost::iterations>, of_all | csv, "", shown::in_files, whole_number},
    {"factorisations", "1", "factorisations of the system of equations", cost<&SolveCost::factorisations>, of_all, "",
     shown::in_files, whole_number},
    {"substeps", "1", "extra solves because the increment had to be halved", of<&Increment::substeps>, of_all | csv, "",
     shown::in_files, whole_number},
    {"increment_converged", "", "whether the increment meets the bounds of the solver",
     [](const Increment& increment) { return increment.converged() ? 1.0 : 0.0; }, of_all, "", shown::in_files,
     yes_or_no},
    {"increment_status", "", "how the increment ended", of<&Increment::status>, of_all | csv, "", shown::in_files,
     flags<Status>},
    {"orbit", "1", "orbit that the increment belongs to; 0 before the first", of<&Increment::orbit>, of_paths | csv, "",
     shown::in_files, whole_number},
    {"kxx", "N/m", "tangent stiffness dFx/dx, sliding contacts keep sliding", entry<&TangentMatrices::loading, 0, 0>,
     of_paths | csv},
    {"kxy", "N/m", "tangent stiffness dFx/dy, sliding contacts keep sliding", entry<&TangentMatrices::loading, 0, 1>,
     of_paths | csv},
    {"kyx", "N/m", "tangent stiffness dFy/dx, sliding contacts keep sliding", entry<&TangentMatrices::loading, 1, 0>,
     of_paths | csv},
    {"kyy", "N/m", "tangent stiffness dFy/dy, sliding contacts keep sliding", entry<&TangentMatrices::loading, 1, 1>,
     of_paths | csv},
    {"kxx_stuck", "N/m", "tangent stiffness dFx/dx, full stick", entry<&TangentMatrices::unloading, 0, 0>,
     of_paths | csv},
    {"kxy_stuck", "N/m", "tangent stiffness dFx/dy, full stick", entry<&TangentMatrices::unloading, 0, 1>,
     of_paths | csv},
    {"kyx_stuck", "N/m", "tangent stiffness dFy/dx, full stick", entry<&TangentMatrices::unloading, 1, 0>,
     of_paths | csv},
    {"kyy_stuck", "N/m", "tangent stiffness dFy/dy, full stick", entry<&TangentMatrices::unloading, 1, 1>,
     of_paths | csv},
});

constexpr std::string_view loaded_stiffness_text =
    "structural stiffness over the loaded range: from the take-up point to full displacement, about a preload between "
    "the turning points";

constexpr auto cycle_list = std::to_array<CycleQuantity>({
    {"amplitude", "m", "displacement from the start to full displacement or load", amplitude<control_of_cycle>,
     of_cycles},
    {"amplitude", "m", "displacement from the start to full displacement or load", amplitude<control_of_strip>,
     of_strips, "amplitude", shown::micrometres},
    {"steps", "1", "increments per branch", of_cycle<&Cycle::steps>, loops | of_solver, "increments per branch",
     shown::in_files, whole_number},
    {"converged", "", "whether every increment of the cycle is present and converged",
     [](const Cycle& cycle, const Case&) { return cycle.converged() ? 1.0 : 0.0; }, of_all | of_solver, "converged",
     shown::unitless, yes_or_no},
    {"status", "", "how the cycle ended", of_cycle<&Cycle::status>, of_all | of_solver | shown_first | sampled,
     "status", shown::in_files, flags<Status>},
    {"max_force", "N", "force {along} at full displacement", at_turn<&TurningPoint::max_force>,
     loops | headline | key_figure | sampled | measured, "maximum force", shown::newtons},
    {"cross_force_at_max", "N", "cross force at full displacement", at_turn<&TurningPoint::cross_force>,
     of_cycles | sampled, "cross force", shown::newtons},
    {"moment_x_at_max", "N m", "moment of the forces along X about the mid-plane at full displacement",
     first_turn<&Increment::moment_x>, of_cycles | of_width_alone | sampled, "moment, X", shown::newton_millimetres},
    {"moment_y_at_max", "N m", "moment of the forces along Y about the mid-plane at full displacement",
     first_turn<&Increment::moment_y>, of_cycles | of_width_alone | sampled, "moment, Y", shown::newton_millimetres},
    {"tilt_x_at_max", "rad", "slope of the axis of the journal towards X at full displacement",
     first_turn<&Increment::tilt_x>, of_cycles | of_width_alone | sampled, "tilt, X", shown::milliradians},
    {"tilt_y_at_max", "rad", "slope of the axis of the journal towards Y at full displacement",
     first_turn<&Increment::tilt_y>, of_cycles | of_width_alone | sampled, "tilt, Y", shown::milliradians},
    {"initial_x", "m", "journal centre {start}, X", at_start<&Increment::x>, of_cycles},
    {"initial_y", "m", "journal centre {start}, Y", at_start<&Increment::y>, of_cycles},
    {"initial_displacement", "m", "displacement {start}", at_start<&Increment::displacement>, of_strips,
     "displacement at the start", shown::micrometres},
    {"initial_force", "N", "force {along} {start}", at_start<&Increment::force_direct>, loops | sampled | measured,
     "force at the start", shown::newtons},
    {"initial_force_x", "N", "force {start}, X", at_start<&Increment::force_x>, bearings},
    {"initial_force_y", "N", "force {start}, Y", at_start<&Increment::force_y>, bearings},
    {"initial_journal_load", "N", "sum of the loads of the journal on the top foil {start}",
     once_begun<&Cycle::initial_journal_load>, bearings | sampled, "sum of journal loads at the start",
     shown::in_files},
    {"initial_elastic_energy", "J", "elastic energy {start}", at_start<&Increment::elastic_energy>, of_all | sampled,
     "elastic energy at the start", shown::in_files},
    {"assembly_dissipation", "J", "energy dissipated by the assembly", once_begun<&Cycle::assembly_dissipation>, of_all,
     "dissipated by the assembly", shown::in_files},
    {"loaded_stiffness", "N/m", loaded_stiffness_text, derived<&Cycle::loaded_stiffness>,
     loops | headline | leading | sampled | measured, "structural stiffness", shown::stiffness},
    {"secant_stiffness", "N/m", "maximum force over displacement, including free travel",
     derived<&Cycle::secant_stiffness>, loops | shown_first | sampled | measured, "secant with free travel",
     shown::stiffness},
    {"tangent_stiffness_loading", "N/m", "tangent stiffness at full displacement, sliding contacts keep sliding",
     tangent<&TangentStiffnesses::loading>, loops | sampled, "tangent stiffness, loading", shown::stiffness},
    {"tangent_stiffness_unloading", "N/m", "tangent stiffness at full displacement, full stick",
     tangent<&TangentStiffnesses::unloading>, loops | sampled, "tangent stiffness, unloading", shown::stiffness},
    {"loop_energy", "J", "closed integral of force over displacement, trapezoidal rule", derived<&Cycle::loop_energy>,
     loops | headline | sampled | measured, "loop energy", shown::millijoules},
    {"elastic_energy_at_max", "J", "elastic energy at full displacement", at_turn<&TurningPoint::elastic_energy>,
     loops | sampled, "elastic energy at full displacement", shown::in_files},
    {"loss_factor", "1", "loop energy over (pi K X^2): K structural stiffness, X half its displacement range",
     derived<&Cycle::loss_factor>, loops | headline | key_figure | sampled | measured, "loss factor", shown::unitless},
    {"specific_damping_capacity", "1", "loop energy over the elastic energy stored between start and full displacement",
     derived<&Cycle::specific_damping_capacity>, loops | sampled, "specific damping capacity", shown::in_files},
    {"first_contact", "m", "displacement at which the journal first touches the top foil",
     derived<&Cycle::first_contact>, of_cycles | sampled, "first contact", shown::micrometres},
    {"take_up", "m", "displacement at which the force last rises through 1 % of its maximum", derived<&Cycle::take_up>,
     loops | shown_first | sampled | measured, "take-up point", shown::micrometres},
    {"orbit_energy", "J", "closed integral of force over displacement of the last orbit, trapezoidal rule",
     last_orbit<&OrbitLoop::energy>, of_paths, "energy of the last orbit", shown::millijoules},
    {"orbit_force_defect", "N", "difference of the forces at both ends of the last orbit",
     last_orbit<&OrbitLoop::force_defect>, of_paths, "closure error of the force", shown::newtons},
    {"orbit_position_defect", "m", "distance of the positions at both ends of the last orbit",
     last_orbit<&OrbitLoop::position_defect>, of_paths, "closure error of the position", shown::micrometres},
    {"max_compression", "m", "maximum compression of a bump over all increments",
     [](const Cycle& cycle, const Case&) { return cycle.compression ? cycle.compression->compression : absent; },
     of_all, "maximum compression", shown::micrometres},
    {"max_stress_top_foil", "Pa", "maximum bending stress of the top foil over all increments",
     peak<&Cycle::top_foil_stress>, of_all | shown_first, "maximum stress, top foil", shown::megapascals},
    {"max_stress_bump_foil", "Pa", "maximum bending stress of the bump foil over all increments",
     peak<&Cycle::bump_foil_stress>, of_all, "maximum stress, bump foil", shown::megapascals},
    {"above_yield_top_foil", "", "whether the stress of the top foil exceeds its yield stress", yields<0>, of_all, "",
     shown::in_files, yes_or_no},
    {"above_yield_bump_foil", "", "whether the stress of the bump foil exceeds its yield stress", yields<1>, of_all, "",
     shown::in_files, yes_or_no},
    {"settled", "", "whether the loop repeats that of the previous cycle, if cycles are repeated",
     [](const Cycle& cycle, const Case&) {
       return cycle.loop_energies.size() < 2 ? absent : cycle.settled ? 1.0 : 0.0;
     },
     bearings, "", shown::in_files, yes_or_no},
    {"total_iterations", "1", "linear solves (back-substitutions) of all increments", total<&SolveCost::iterations>,
     of_all | of_solver, "linear solves", shown::unitless, whole_number},
    {"total_factorisations", "1", "factorisations of all increments; stored ones are reused",
     total<&SolveCost::factorisations>, of_all | of_solver, "factorisations", shown::unitless, whole_number},
    {"total_substeps", "1", "extra solves of all increments because they had to be halved", of_cycle<&Cycle::substeps>,
     of_all | of_solver, "halved increments", shown::unitless, whole_number},
    {"max_residual", "1", "largest residual at the start and where legs end", once_begun<&Cycle::max_residual>,
     of_all | of_solver | sampled, "largest residual", shown::unitless},
    {"wall_time",
     "s",
     "time that the cycle took",
     of_cycle<&Cycle::wall_time>,
     of_all | of_solver,
     "time",
     {"ms", 1e-3}},
});

constexpr auto field_table = std::to_array<FieldQuantity>({
    {{"top_displacement", "m", "radial displacement of the top foil over the bump, positive outward",
      field<&FoilFields::top_displacement>},
     Node::bump},
    {{"crest_u", "m", "tangential displacement of the crest, positive away from the weld", field<&FoilFields::crest_u>},
     Node::bump},
    {{"crest_v", "m", "radial displacement of the crest, positive outward", field<&FoilFields::crest_v>}, Node::bump},
    {{"foot_u", "m", "tangential displacement of the foot, positive away from the weld", field<&FoilFields::foot_u>},
     Node::foot},
    {{"foot_v", "m", "radial displacement of the foot, positive outward", field<&FoilFields::foot_v>}, Node::foot},
    {{"compression", "m", "radial approach of the crest of the bump and its feet", field<&FoilFields::compression>},
     Node::bump},
    {{"gap_journal_top", "m", "gap between {pressing} and top foil, 0 where closed",
      contact<&FoilFields::journal_top, &InterfaceFields::gap>},
     Node::bump},
    {{"gap_top_bump", "m", "gap between {over_crest} and crest, 0 where closed",
      contact<&FoilFields::top_bump, &InterfaceFields::gap>},
     Node::bump},
    {{"gap_bump_sleeve", "m", "gap between foot and {carrying}, 0 where closed",
      contact<&FoilFields::bump_sleeve, &InterfaceFields::gap>},
     Node::foot},
    {{"normal_force_journal_top", "N", "compression between {pressing} and top foil",
      contact<&FoilFields::journal_top, &InterfaceFields::normal_force>},
     Node::bump},
    {{"normal_force_top_bump", "N", "compression between {over_crest} and crest",
      contact<&FoilFields::top_bump, &InterfaceFields::normal_force>},
     Node::bump},
    {{"normal_force_bump_sleeve", "N", "compression between foot and {carrying}",
      contact<&FoilFields::bump_sleeve, &InterfaceFields::normal_force>},
     Node::foot},
    {{"friction_force_journal_top", "N", "friction of the {pressing} on the top foil, which is zero",
      contact<&FoilFields::journal_top, &InterfaceFields::friction_force>},
     Node::bump},
    {{"friction_force_top_bump", "N", "friction of the {over_crest} on the crest, positive away from the weld",
      contact<&FoilFields::top_bump, &InterfaceFields::friction_force>},
     Node::bump},
    {{"friction_force_bump_sleeve", "N", "friction of the {carrying} on the foot, positive away from the weld",
      contact<&FoilFields::bump_sleeve, &InterfaceFields::friction_force>},
     Node::foot},
    {{"state_journal_top", "", "contact of {pressing} and top foil", state<&FoilFields::journal_top>, none, "",
      shown::in_files, flags<ContactMode>},
     Node::bump},
    {{"state_top_bump", "", "contact of {over_crest} and crest", state<&FoilFields::top_bump>, none, "",
      shown::in_files, flags<ContactMode>},
     Node::bump},
    {{"state_bump_sleeve", "", "contact of foot and {carrying}", state<&FoilFields::bump_sleeve>, none, "",
      shown::in_files, flags<ContactMode>},
     Node::foot},
    {{"stress_top_foil", "Pa", "bending stress of the top foil over the crest", stress<&StressFields::top_crest>},
     Node::bump},
    {{"stress_bump_foil_crest", "Pa", "bending stress of the bump foil at the crest; frame only",
      stress<&StressFields::bump_crest>},
     Node::bump},
    {{"stress_bump_foil_foot", "Pa", "bending stress of the bump foil at the end of the arc; frame only",
      stress<&StressFields::bump_foot>},
     Node::foot},
    {{"stress_bump_foil", "Pa", "maximum bending stress along the arc of the bump; frame only",
      stress<&StressFields::bump_largest>},
     Node::bump},
    {{"stress_top_foil_weld", "Pa", "bending stress of the top foil where it is clamped",
      stress<&StressFields::top_weld>},
     Node::weld},
    {{"stress_bump_foil_weld", "Pa", "bending stress of the bump foil where it is clamped; frame only",
      stress<&StressFields::bump_weld>},
     Node::weld},
    {{"top_slope", "m",
      "radial displacement of the top foil over the bump at its side z > 0 beyond the mean, linear over the width",
      field<&FoilFields::top_slope>, of_width_alone},
     Node::bump},
    {{"top_parabola", "m",
      "radial displacement of the top foil over the bump at its sides beyond the mean, as a parabola over the width",
      field<&FoilFields::top_parabola>, of_width_alone},
     Node::bump},
    {{"crest_u_slope", "m",
      "tangential displacement of the crest at its side z > 0 beyond the mean, linear over the width",
      field<&FoilFields::crest_u_slope>, of_width_alone},
     Node::bump},
    {{"crest_v_slope", "m", "radial displacement of the crest at its side z > 0 beyond the mean, linear over the width",
      field<&FoilFields::crest_v_slope>, of_width_alone},
     Node::bump},
    {{"foot_u_slope", "m",
      "tangential displacement of the foot at its side z > 0 beyond the mean, linear over the width",
      field<&FoilFields::foot_u_slope>, of_width_alone},
     Node::foot},
    {{"foot_v_slope", "m", "radial displacement of the foot at its side z > 0 beyond the mean, linear over the width",
      field<&FoilFields::foot_v_slope>, of_width_alone},
     Node::foot},
    {{"crest_v_parabola", "m",
      "radial displacement of the crest at its sides beyond the mean, as a parabola over the width",
      field<&FoilFields::crest_v_parabola>, of_width_alone},
     Node::bump},
    {{"crest_u_parabola", "m",
      "tangential displacement of the crest at its sides beyond the mean, as a parabola over the width; elastic sheet "
      "only",
      field<&FoilFields::crest_u_parabola>, of_width_alone},
     Node::bump},
    {{"foot_u_parabola", "m",
      "tangential displacement of the foot at its sides beyond the mean, as a parabola over the width; elastic sheet "
      "only",
      field<&FoilFields::foot_u_parabola>, of_width_alone},
     Node::foot},
    {{"foot_v_parabola", "m",
      "radial displacement of the foot at its sides beyond the mean, as a parabola over the width; elastic sheet only",
      field<&FoilFields::foot_v_parabola>, of_width_alone},
     Node::foot},
    {{"pad_force_x", "N", "part of force_x carried by the pad", field<&FoilFields::pad_force_x>}, Node::pad},
    {{"pad_force_y", "N", "part of force_y carried by the pad", field<&FoilFields::pad_force_y>}, Node::pad},
    {{"strip_load", "N", "compression between {over_crest} and all crests of the strip",
      field<&FoilFields::strip_load>},
     Node::strip},
});

template <Vector TurningPoint::*member>
Vector loads(const Cycle& cycle) {
  return cycle.turning_point ? (*cycle.turning_point).*member : Vector();
}

constexpr auto load_table = std::to_array<LoadQuantity>({
    {{"bump_loads", "N", "compression between {over_crest} and crest at full displacement",
      loads<&TurningPoint::bump_loads>, loops},
     Node::bump},
    {{"foot_loads", "N", "compression between foot and {carrying} at full displacement",
      loads<&TurningPoint::foot_loads>, loops},
     Node::foot},
    {{"journal_loads", "N", "compression between {pressing} and top foil at full displacement",
      loads<&TurningPoint::journal_loads>, loops},
     Node::bump},
    {{"pad_forces_x", "N", "part of the force along X carried by the pad at full displacement",
      loads<&TurningPoint::pad_forces_x>, loops},
     Node::pad},
    {{"pad_forces_y", "N", "part of the force along Y carried by the pad at full displacement",
      loads<&TurningPoint::pad_forces_y>, loops},
     Node::pad},
    {{"strip_loads", "N", "compression between {over_crest} and all crests of the strip at full displacement",
      loads<&TurningPoint::strip_loads>, of_cycles},
     Node::strip},
    {{"max_pad_forces", "N", "maximum magnitude of the pad force over all increments",
      [](const Cycle& cycle) { return cycle.largest_pad_forces; }, of_paths},
     Node::pad},
});

constexpr auto event_table = std::to_array<EventQuantity>({
    {"event_displacement", "m", "displacement of the {pressing} {along}", of_event<&CycleEvent::displacement>},
    {"event_index", "1", "bump or, at the {carrying}, foot, counted from the weld",
     [](const CycleEvent& event) { return event.index + 1.0; }, none, "", shown::in_files, whole_number},
    {"event_branch", "", "branch of the cycle", of_event<&CycleEvent::branch>, none, "", shown::in_files,
     flags<Branch>},
    {"event_interface", "", "interface of the contact", of_event<&CycleEvent::interface>, none, "", shown::in_files,
     flags<Interface>},
    {"event_from", "", "state of the contact before", of_event<&CycleEvent::from>, none, "", shown::in_files,
     flags<ContactMode>},
    {"event_to", "", "state of the contact after", of_event<&CycleEvent::to>, none, "", shown::in_files,
     flags<ContactMode>},
});

constexpr std::array<StressedFoil, 2> foil_table{{
    {"top_foil", "top foil", &Cycle::top_foil_stress, [](const Case& input) { return input.top_foil.yield_stress; }},
    {"bump_foil", "bump foil", &Cycle::bump_foil_stress,
     [](const Case& input) { return input.bump_foil.yield_stress; }},
}};

constexpr Tags tag_of(Experiment experiment) {
  switch (experiment) {
    case Experiment::cycle:
      return tag::of_cycles;
    case Experiment::strip:
      return tag::of_strips;
    case Experiment::path:
      return tag::of_paths;
  }
  return tag::of_all;
}

template <typename Table>
auto those_of(const Table& table, Experiment experiment, bool over_width = false) {
  std::vector<typename Table::value_type> quantities;
  std::copy_if(table.begin(), table.end(), std::back_inserter(quantities), [=](const auto& quantity) {
    return quantity.is(tag_of(experiment)) && (over_width || !quantity.is(of_width_alone));
  });
  return quantities;
}

}  // namespace

Wording wording_of(const Case& input, Experiment experiment) {
  if (experiment == Experiment::path) {
    return {"journal", "top foil", "sleeve", "away from the centre", "at the centred journal"};
  }
  if (experiment == Experiment::cycle) {
    // Running bearings without cycles are described as cycles are.
    const CycleSettings* const cycle = input.settings.find<CycleSettings>();
    return {"journal", "top foil", "sleeve", "along the direction",
            cycle != nullptr && cycle->preload ? "at the preload" : "at the centred journal"};
  }
  return {"plate", input.settings.get<StripSettings>().top_foil ? "top foil" : "plate", "base", "towards the base",
          "at the start"};
}

std::string spelled(std::string_view long_name, const Wording& wording) {
  return fmt::format(fmt::runtime(long_name), fmt::arg("pressing", wording.pressing),
                     fmt::arg("over_crest", wording.over_crest), fmt::arg("carrying", wording.carrying),
                     fmt::arg("along", wording.along), fmt::arg("start", wording.start));
}

std::size_t strips_apart(const Case& input) {
  return input.varies_over_the_width() && input.lets_strips_move_apart()
             ? static_cast<std::size_t>(input.bump_foil.strips)
             : 1;
}

std::vector<IncrementQuantity> increment_quantities(Experiment experiment, bool over_width) {
  return those_of(increment_table, experiment, over_width);
}

std::vector<CycleQuantity> cycle_quantities(Experiment experiment, bool over_width) {
  return those_of(cycle_list, experiment, over_width);
}

std::span<const FieldQuantity> field_quantities() {
  return field_table;
}

std::vector<LoadQuantity> load_quantities(Experiment experiment) {
  return those_of(load_table, experiment);
}

std::vector<VariableMeaning> clearance_quantities(const std::vector<double>& forces) {
  std::vector<VariableMeaning> quantities;
  quantities.reserve(forces.size());
  for (const double force : forces) {
    quantities.push_back(
        {.name = fmt::format("clearance_{:.6g}N", force),
         .unit = "m",
         .long_name = fmt::format("displacement at which the direct force first reaches {:.6g} N", force),
         .label = fmt::format("clearance at {:.6g} N", force),
         .shown = shown::micrometres});
  }
  return quantities;
}

double clearance_of(const Cycle& cycle, std::size_t force) {
  return force < cycle.clearances.size() ? cycle.clearances[force].displacement.value_or(absent) : absent;
}

std::span<const EventQuantity> event_quantities() {
  return event_table;
}

std::span<const StressedFoil> stressed_foils() {
  return foil_table;
}

std::string bump_text(const Case& input, int bump) {
  const PadBump found = find_bump(input, bump);
  const std::string number = std::to_string(found.bump + 1);
  return count_pads(input) == 1 ? number : fmt::format("{} of pad {}", number, found.pad + 1);
}

std::string place_text(const Case& input, const StressPeak& peak) {
  const std::string_view place = name_of(peak.place);
  if (peak.bump >= 0) return fmt::format("{} {}", place, bump_text(input, peak.bump));
  const std::optional<std::size_t> pad = pad_of(input, peak);
  return pad ? fmt::format("{} of pad {}", place, *pad + 1) : std::string(place);
}

std::optional<std::size_t> pad_of(const Case& input, const StressPeak& peak) {
  if (count_pads(input) == 1) return std::nullopt;
  return peak.bump >= 0 ? find_bump(input, peak.bump).pad : static_cast<std::size_t>(peak.pad);
}

double above_yield(const StressedFoil& foil, const Cycle& cycle, const Case& input) {
  const std::optional<StressPeak>& peak = cycle.*foil.peak;
  const std::optional<double> yield_stress = foil.yield_stress(input);
  if (!peak || !yield_stress) return absent;
  return peak->stress > *yield_stress ? 1.0 : 0.0;
}

}  // namespace bumpfoil
