#include "bumpfoil/experiments/cycle/result_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

constexpr Form real{};
constexpr Form whole{Form::whole};
constexpr std::array<std::string_view, 2> truth_words{"no", "yes"};
constexpr Form truth{Form::truth, truth_words};

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

/// Quantities of a cycle that mean nothing before it was begun.
template <double Cycle::*member>
double once_begun(const Cycle& cycle, const Case& /*input*/) {
  return cycle.start ? cycle.*member : absent;
}

template <double TurningPoint::*member>
double at_turn(const Cycle& cycle, const Case& /*input*/) {
  return cycle.turning_point ? (*cycle.turning_point).*member : absent;
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

/// Under load control it is what the cycle finds out.
template <Control (*control)(const Case&)>
double amplitude(const Cycle& cycle, const Case& input) {
  return cycle.turning_point || control(input) == Control::displacement ? cycle.amplitude : absent;
}
Control control_of_cycle(const Case& input) {
  return input.cycle.amplitude.control;
}
Control control_of_strip(const Case& input) {
  return input.strip->amplitude.control;
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

// What tells some quantities from others: results that have them, and that they say how it was computed.
template <unsigned within>
struct Only {
  constexpr IncrementQuantity operator()(IncrementQuantity quantity) const {
    quantity.within = within;
    return quantity;
  }
  constexpr CycleQuantity operator()(CycleQuantity quantity) const {
    quantity.within = within;
    return quantity;
  }
  constexpr LoadQuantity operator()(LoadQuantity quantity) const {
    quantity.within = within;
    return quantity;
  }
};
constexpr Only<Within::bearing> bearing_only;
constexpr Only<Within::cycle> cycle_only;
constexpr Only<Within::strip> strip_only;
constexpr Only<Within::path> path_only;
constexpr Only<Within::loops> loops_only;
constexpr CycleQuantity solver(CycleQuantity quantity) {
  quantity.of_solver = true;
  return quantity;
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
    loops_only({"branch", "", "branch of the cycle", of<&Increment::branch>, flags<Branch>}),
    {"displacement", "m", "displacement of the {pressing} {along}", of<&Increment::displacement>},
    bearing_only({"x", "m", "journal centre, X", of<&Increment::x>}),
    bearing_only({"y", "m", "journal centre, Y", of<&Increment::y>}),
    bearing_only({"force_x", "N", "force that holds the journal, X", of<&Increment::force_x>}),
    bearing_only({"force_y", "N", "force that holds the journal, Y", of<&Increment::force_y>}),
    {"force_direct", "N", "force that holds the {pressing}, {along}", of<&Increment::force_direct>},
    bearing_only({"force_cross", "N", "force that holds the journal, 90 degrees ahead of the direction",
                  of<&Increment::force_cross>}),
    {"elastic_energy", "J", "elastic energy of the foils", of<&Increment::elastic_energy>},
    {"dissipated_energy", "J",
     "energy dissipated since increment 0: by friction and, with `events`, where the foils snap",
     of<&Increment::dissipated_energy>},
    {"work", "J", "work of the {pressing} since increment 0", of<&Increment::work>},
    {"residual", "1", "largest unbalanced force over the largest contact force",
     [](const Increment& increment) { return increment.residuals.equilibrium; }},
    {"iterations", "1", "linear solves", cost<&SolveCost::iterations>, whole},
    {"factorisations", "1", "factorisations of the system of equations", cost<&SolveCost::factorisations>, whole,
     false},
    {"substeps", "1", "extra solves because the increment had to be halved", of<&Increment::substeps>, whole},
    {"increment_converged", "", "whether the increment meets the bounds of the solver",
     [](const Increment& increment) { return increment.converged() ? 1.0 : 0.0; }, truth, false},
    {"increment_status", "", "how the increment ended", of<&Increment::status>, flags<Status>},
    path_only({"orbit", "1", "orbit that the increment belongs to; 0 before the first", of<&Increment::orbit>, whole}),
    path_only({"kxx", "N/m", "tangent stiffness dFx/dx, further motion", entry<&TangentMatrices::loading, 0, 0>}),
    path_only({"kxy", "N/m", "tangent stiffness dFx/dy, further motion", entry<&TangentMatrices::loading, 0, 1>}),
    path_only({"kyx", "N/m", "tangent stiffness dFy/dx, further motion", entry<&TangentMatrices::loading, 1, 0>}),
    path_only({"kyy", "N/m", "tangent stiffness dFy/dy, further motion", entry<&TangentMatrices::loading, 1, 1>}),
    path_only({"kxx_stuck", "N/m", "tangent stiffness dFx/dx, all closed contacts sticking",
               entry<&TangentMatrices::unloading, 0, 0>}),
    path_only({"kxy_stuck", "N/m", "tangent stiffness dFx/dy, all closed contacts sticking",
               entry<&TangentMatrices::unloading, 0, 1>}),
    path_only({"kyx_stuck", "N/m", "tangent stiffness dFy/dx, all closed contacts sticking",
               entry<&TangentMatrices::unloading, 1, 0>}),
    path_only({"kyy_stuck", "N/m", "tangent stiffness dFy/dy, all closed contacts sticking",
               entry<&TangentMatrices::unloading, 1, 1>}),
});

constexpr std::string_view loaded_stiffness_text =
    "range of the force over that of the displacement: of a push from the take-up point to full displacement, about a "
    "preload from turning point to turning point";

constexpr auto cycle_table = std::to_array<CycleQuantity>({
    cycle_only(
        {"amplitude", "m", "displacement from the start to full displacement or load", amplitude<control_of_cycle>}),
    strip_only({"amplitude", "m", "displacement from the start to full displacement or load",
                amplitude<control_of_strip>, real, "amplitude", shown::micrometres}),
    loops_only(
        solver({"steps", "1", "increments per branch", of_cycle<&Cycle::steps>, whole, "increments per branch"})),
    solver({"converged", "", "whether every increment of the cycle is there and converged",
            [](const Cycle& cycle, const Case&) { return cycle.converged() ? 1.0 : 0.0; }, truth, "converged",
            shown::unitless}),
    solver({"status", "", "how the cycle ended", of_cycle<&Cycle::status>, flags<Status>, "status"}),
    loops_only({"max_force", "N", "force {along} at full displacement", at_turn<&TurningPoint::max_force>, real,
                "maximum force", shown::newtons}),
    cycle_only({"cross_force_at_max", "N", "cross force at full displacement", at_turn<&TurningPoint::cross_force>,
                real, "cross force there", shown::newtons}),
    cycle_only({"initial_x", "m", "journal centre {start}, X", at_start<&Increment::x>}),
    cycle_only({"initial_y", "m", "journal centre {start}, Y", at_start<&Increment::y>}),
    strip_only({"initial_displacement", "m", "displacement {start}", at_start<&Increment::displacement>, real,
                "displacement at the start", shown::micrometres}),
    loops_only({"initial_force", "N", "force {along} {start}", at_start<&Increment::force_direct>, real,
                "force at the start", shown::newtons}),
    bearing_only({"initial_force_x", "N", "force {start}, X", at_start<&Increment::force_x>}),
    bearing_only({"initial_force_y", "N", "force {start}, Y", at_start<&Increment::force_y>}),
    bearing_only({"initial_journal_load", "N", "sum of the loads of the journal on the top foil {start}",
                  once_begun<&Cycle::initial_journal_load>, real, "sum of journal loads at the start"}),
    {"initial_elastic_energy", "J", "elastic energy {start}", at_start<&Increment::elastic_energy>, real,
     "elastic energy at the start"},
    {"assembly_dissipation", "J", "energy dissipated by the assembly", once_begun<&Cycle::assembly_dissipation>, real,
     "dissipated by the assembly"},
    loops_only({"loaded_stiffness", "N/m", loaded_stiffness_text, derived<&Cycle::loaded_stiffness>, real,
                "loaded stiffness", shown::stiffness}),
    loops_only({"secant_stiffness", "N/m", "maximum force over displacement, free travel included",
                derived<&Cycle::secant_stiffness>, real, "secant with free travel", shown::stiffness}),
    loops_only({"tangent_stiffness_loading", "N/m",
                "tangent stiffness at full displacement, slipping contacts going on to slip",
                tangent<&TangentStiffnesses::loading>, real, "tangent stiffness, loading", shown::stiffness}),
    loops_only({"tangent_stiffness_unloading", "N/m",
                "tangent stiffness at full displacement, all closed contacts sticking",
                tangent<&TangentStiffnesses::unloading>, real, "tangent stiffness, unloading", shown::stiffness}),
    loops_only({"loop_energy", "J", "closed integral of force over displacement, trapezoidal rule",
                derived<&Cycle::loop_energy>, real, "loop energy", shown::millijoules}),
    loops_only({"elastic_energy_at_max", "J", "elastic energy at full displacement",
                at_turn<&TurningPoint::elastic_energy>, real, "elastic energy at full displacement"}),
    loops_only({"loss_factor", "1",
                "loop energy over (pi K X^2): K loaded stiffness, X half the displacement that it is taken over",
                derived<&Cycle::loss_factor>, real, "loss factor", shown::unitless}),
    loops_only({"specific_damping_capacity", "1",
                "loop energy over the elastic energy stored between start and full displacement",
                derived<&Cycle::specific_damping_capacity>, real, "specific damping capacity"}),
    cycle_only({"first_contact", "m", "displacement at which the journal first touches the top foil",
                derived<&Cycle::first_contact>, real, "first contact", shown::micrometres}),
    loops_only({"take_up", "m", "displacement at which the force last rises through 1 % of its maximum",
                derived<&Cycle::take_up>, real, "take-up point", shown::micrometres}),
    cycle_only({"clearance_5N", "m", "displacement at which the direct force first reaches 5 N",
                derived<&Cycle::clearance_5N>}),
    cycle_only({"clearance_10N", "m", "displacement at which the direct force first reaches 10 N",
                derived<&Cycle::clearance_10N>}),
    path_only({"orbit_energy", "J", "closed integral of force over displacement of the last orbit, trapezoidal rule",
               last_orbit<&OrbitLoop::energy>, real, "energy of the last orbit", shown::millijoules}),
    path_only({"orbit_force_defect", "N", "difference of the forces at both ends of the last orbit",
               last_orbit<&OrbitLoop::force_defect>, real, "its forces differ by", shown::newtons}),
    path_only({"orbit_position_defect", "m", "distance of the positions at both ends of the last orbit",
               last_orbit<&OrbitLoop::position_defect>, real, "its positions differ by", shown::micrometres}),
    {"max_compression", "m", "largest compression of a bump over all increments",
     [](const Cycle& cycle, const Case&) { return cycle.compression ? cycle.compression->compression : absent; }, real,
     "highest compression", shown::micrometres},
    {"max_stress_top_foil", "Pa", "largest bending stress of the top foil over all increments",
     peak<&Cycle::top_foil_stress>, real, "highest stress, top foil", shown::megapascals},
    {"max_stress_bump_foil", "Pa", "largest bending stress of the bump foil over all increments",
     peak<&Cycle::bump_foil_stress>, real, "highest stress, bump foil", shown::megapascals},
    {"above_yield_top_foil", "", "whether the stress of the top foil exceeds its yield stress", yields<0>, truth},
    {"above_yield_bump_foil", "", "whether the stress of the bump foil exceeds its yield stress", yields<1>, truth},
    bearing_only({"settled", "", "whether the loop is that of the cycle before, of cycles that are repeated",
                  [](const Cycle& cycle, const Case&) {
                    return cycle.loop_energies.size() < 2 ? absent : cycle.settled ? 1.0 : 0.0;
                  },
                  truth}),
    solver({"total_iterations", "1", "linear solves (back-substitutions) of all increments",
            total<&SolveCost::iterations>, whole, "linear solves", shown::unitless}),
    solver({"total_factorisations", "1", "factorisations of all increments; kept ones serve many",
            total<&SolveCost::factorisations>, whole, "factorisations", shown::unitless}),
    solver({"total_substeps", "1", "extra solves of all increments because they had to be halved",
            of_cycle<&Cycle::substeps>, whole, "halved increments", shown::unitless}),
    solver({"max_residual", "1", "largest residual at the start and where legs end", once_begun<&Cycle::max_residual>,
            real, "largest residual", shown::unitless}),
    solver({"wall_time", "s", "time that the cycle took", of_cycle<&Cycle::wall_time>, real, "time", {"ms", 1e-3}}),
});

constexpr auto field_table = std::to_array<FieldQuantity>({
    {"top_displacement", "m", "radial displacement of the top foil over the bump, positive outward", Node::bump,
     field<&FoilFields::top_displacement>},
    {"crest_u", "m", "tangential displacement of the crest, positive away from the weld", Node::bump,
     field<&FoilFields::crest_u>},
    {"crest_v", "m", "radial displacement of the crest, positive outward", Node::bump, field<&FoilFields::crest_v>},
    {"foot_u", "m", "tangential displacement of the foot, positive away from the weld", Node::foot,
     field<&FoilFields::foot_u>},
    {"foot_v", "m", "radial displacement of the foot, positive outward", Node::foot, field<&FoilFields::foot_v>},
    {"compression", "m", "radial approach of the crest of the bump and its feet", Node::bump,
     field<&FoilFields::compression>},
    {"gap_journal_top", "m", "gap between {pressing} and top foil, 0 where closed", Node::bump,
     contact<&FoilFields::journal_top, &InterfaceFields::gap>},
    {"gap_top_bump", "m", "gap between {over_crest} and crest, 0 where closed", Node::bump,
     contact<&FoilFields::top_bump, &InterfaceFields::gap>},
    {"gap_bump_sleeve", "m", "gap between foot and {carrying}, 0 where closed", Node::foot,
     contact<&FoilFields::bump_sleeve, &InterfaceFields::gap>},
    {"normal_force_journal_top", "N", "compression between {pressing} and top foil", Node::bump,
     contact<&FoilFields::journal_top, &InterfaceFields::normal_force>},
    {"normal_force_top_bump", "N", "compression between {over_crest} and crest", Node::bump,
     contact<&FoilFields::top_bump, &InterfaceFields::normal_force>},
    {"normal_force_bump_sleeve", "N", "compression between foot and {carrying}", Node::foot,
     contact<&FoilFields::bump_sleeve, &InterfaceFields::normal_force>},
    {"friction_force_journal_top", "N", "friction of the {pressing} on the top foil, which is zero", Node::bump,
     contact<&FoilFields::journal_top, &InterfaceFields::friction_force>},
    {"friction_force_top_bump", "N", "friction of the {over_crest} on the crest, positive away from the weld",
     Node::bump, contact<&FoilFields::top_bump, &InterfaceFields::friction_force>},
    {"friction_force_bump_sleeve", "N", "friction of the {carrying} on the foot, positive away from the weld",
     Node::foot, contact<&FoilFields::bump_sleeve, &InterfaceFields::friction_force>},
    {"state_journal_top", "", "contact of {pressing} and top foil", Node::bump, state<&FoilFields::journal_top>,
     flags<ContactMode>},
    {"state_top_bump", "", "contact of {over_crest} and crest", Node::bump, state<&FoilFields::top_bump>,
     flags<ContactMode>},
    {"state_bump_sleeve", "", "contact of foot and {carrying}", Node::foot, state<&FoilFields::bump_sleeve>,
     flags<ContactMode>},
    {"stress_top_foil", "Pa", "bending stress of the top foil over the crest", Node::bump,
     stress<&StressFields::top_crest>},
    {"stress_bump_foil_crest", "Pa", "bending stress of the bump foil at the crest; frame only", Node::bump,
     stress<&StressFields::bump_crest>},
    {"stress_bump_foil_foot", "Pa", "bending stress of the bump foil at the end of the arc; frame only", Node::foot,
     stress<&StressFields::bump_foot>},
    {"stress_bump_foil", "Pa", "largest bending stress along the arc of the bump; frame only", Node::bump,
     stress<&StressFields::bump_largest>},
    {"stress_top_foil_weld", "Pa", "bending stress of the top foil where it is clamped", Node::weld,
     stress<&StressFields::top_weld>},
    {"stress_bump_foil_weld", "Pa", "bending stress of the bump foil where it is clamped; frame only", Node::weld,
     stress<&StressFields::bump_weld>},
    {"pad_force_x", "N", "part of force_x that the pad takes", Node::pad, field<&FoilFields::pad_force_x>},
    {"pad_force_y", "N", "part of force_y that the pad takes", Node::pad, field<&FoilFields::pad_force_y>},
});

template <Vector TurningPoint::*member>
Vector loads(const Cycle& cycle) {
  return cycle.turning_point ? (*cycle.turning_point).*member : Vector();
}

constexpr auto load_table = std::to_array<LoadQuantity>({
    loops_only({"bump_loads", "N", "compression between {over_crest} and crest at full displacement", Node::bump,
                loads<&TurningPoint::bump_loads>}),
    loops_only({"foot_loads", "N", "compression between foot and {carrying} at full displacement", Node::foot,
                loads<&TurningPoint::foot_loads>}),
    loops_only({"journal_loads", "N", "compression between {pressing} and top foil at full displacement", Node::bump,
                loads<&TurningPoint::journal_loads>}),
    loops_only({"pad_forces_x", "N", "part of the force along X that the pad takes at full displacement", Node::pad,
                loads<&TurningPoint::pad_forces_x>}),
    loops_only({"pad_forces_y", "N", "part of the force along Y that the pad takes at full displacement", Node::pad,
                loads<&TurningPoint::pad_forces_y>}),
    path_only({"max_pad_forces", "N", "largest size of the force that the pad takes over all increments", Node::pad,
               [](const Cycle& cycle) { return largest_pad_forces(cycle.fields); }}),
});

constexpr auto event_table = std::to_array<EventQuantity>({
    {"event_displacement", "m", "displacement of the {pressing} {along}", of_event<&CycleEvent::displacement>},
    {"event_index", "1", "bump or, at the {carrying}, foot, counted from the weld",
     [](const CycleEvent& event) { return event.index + 1.0; }, whole},
    {"event_branch", "", "branch of the cycle", of_event<&CycleEvent::branch>, flags<Branch>},
    {"event_interface", "", "interface of the contact", of_event<&CycleEvent::interface>, flags<Interface>},
    {"event_from", "", "state of the contact before", of_event<&CycleEvent::from>, flags<ContactMode>},
    {"event_to", "", "state of the contact after", of_event<&CycleEvent::to>, flags<ContactMode>},
});

constexpr std::array<StressedFoil, 2> foil_table{{
    {"top_foil", "top foil", &Cycle::top_foil_stress, [](const Case& input) { return input.top_foil.yield_stress; }},
    {"bump_foil", "bump foil", &Cycle::bump_foil_stress,
     [](const Case& input) { return input.bump_foil.yield_stress; }},
}};

constexpr unsigned bit_of(Experiment experiment) {
  switch (experiment) {
    case Experiment::cycle:
      return Within::cycle;
    case Experiment::strip:
      return Within::strip;
    case Experiment::path:
      return Within::path;
  }
  return Within::all;
}

template <typename Table>
auto those_of(const Table& table, Experiment experiment) {
  const unsigned bit = bit_of(experiment);
  std::vector<typename Table::value_type> quantities;
  std::copy_if(table.begin(), table.end(), std::back_inserter(quantities),
               [bit](const auto& quantity) { return (quantity.within & bit) != 0; });
  return quantities;
}

}  // namespace

Wording wording_of(const Case& input, Experiment experiment) {
  if (experiment == Experiment::path) {
    return {"journal", "top foil", "sleeve", "away from the centre", "at the centred journal"};
  }
  if (experiment == Experiment::cycle) {
    return {"journal", "top foil", "sleeve", "along the direction",
            input.cycle.preload ? "at the preload" : "at the centred journal"};
  }
  return {"plate", input.strip->top_foil ? "top foil" : "plate", "base", "towards the base", "at the start"};
}

std::string spelled(std::string_view long_name, const Wording& wording) {
  return fmt::format(fmt::runtime(long_name), fmt::arg("pressing", wording.pressing),
                     fmt::arg("over_crest", wording.over_crest), fmt::arg("carrying", wording.carrying),
                     fmt::arg("along", wording.along), fmt::arg("start", wording.start));
}

std::vector<IncrementQuantity> increment_quantities(Experiment experiment) {
  return those_of(increment_table, experiment);
}

std::vector<CycleQuantity> cycle_quantities(Experiment experiment) {
  return those_of(cycle_table, experiment);
}

std::span<const FieldQuantity> field_quantities() {
  return field_table;
}

std::vector<LoadQuantity> load_quantities(Experiment experiment) {
  return those_of(load_table, experiment);
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
