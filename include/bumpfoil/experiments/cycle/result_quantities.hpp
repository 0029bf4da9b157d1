#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/result_names.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"

/// Every quantity of a result, described once: what it means, and where it comes from. All files, the table on the
/// terminal and the report take it from here; what is added here is in all of them.
namespace bumpfoil {

/// Words in which results of a bearing and of a strip differ.
struct Wording {
  std::string_view pressing;    ///< journal or plate
  std::string_view over_crest;  ///< what touches the crests
  std::string_view carrying;    ///< sleeve or base
  std::string_view along;       ///< which way displacements and forces count
  std::string_view start;       ///< where increment 0 is
};
Wording wording_of(const Case& input, Experiment experiment);

/// A long name with {pressing}, {over_crest}, {carrying}, {along} and {start} in these words.
std::string spelled(std::string_view long_name, const Wording& wording);

/// What CSV files and summaries call the coordinate of the cycles of an experiment; a path has none.
constexpr std::string_view cycle_key(Experiment experiment) {
  if (experiment == Experiment::path) return {};
  return experiment == Experiment::strip ? "cycle" : "direction_deg";
}

namespace tag {

// Results that have a quantity.
inline constexpr Tags of_cycles = first_of_experiment;
inline constexpr Tags of_strips = 2 * of_cycles;
inline constexpr Tags of_paths = 2 * of_strips;
inline constexpr Tags bearings = of_cycles | of_paths;
inline constexpr Tags loops = of_cycles | of_strips;
inline constexpr Tags of_all = of_cycles | of_strips | of_paths;

inline constexpr Tags of_width_alone = 2 * of_paths;  ///< of results that vary over the width alone

}  // namespace tag

/// Of one increment.
using IncrementQuantity = Quantity<double (*)(const Increment&)>;

/// Of one cycle; a key of summary.json, too.
using CycleQuantity = Quantity<double (*)(const Cycle&, const Case&)>;

/// What the columns of a field stand for.
enum class Node {
  foil,  ///< all of them
  bump,
  foot,
  weld,   ///< of each pad; the one of a foil that goes all around is no list
  pad,    ///< of several; a foil that goes all around has none
  strip,  ///< of several that do not move alike
};

/// Strips with results of their own: those of the bump foil, or one where they move alike.
std::size_t strips_apart(const Case& input);

/// Of the foils at one increment: a matrix of increments and nodes, see FoilFields. No columns where it is not known.
struct FieldQuantity : Quantity<FieldMatrix (*)(const FoilFields&)> {
  Node node{};
};

/// Loads of a cycle, one per node: at full displacement, or the largest of a path; nothing where they are not known. A
/// key of summary.json, too.
struct LoadQuantity : Quantity<Vector (*)(const Cycle&)> {
  Node node{};
};

/// Of one change of state of a contact.
using EventQuantity = Quantity<double (*)(const CycleEvent&)>;

/// In the order of files and tables. @param over_width  CycleResult::over_width
std::vector<IncrementQuantity> increment_quantities(Experiment experiment, bool over_width = false);
std::vector<CycleQuantity> cycle_quantities(Experiment experiment, bool over_width = false);
std::span<const FieldQuantity> field_quantities();
std::vector<LoadQuantity> load_quantities(Experiment experiment);
std::span<const EventQuantity> event_quantities();

/// Displacements of a cycle at which its direct force first reaches each of `cycle.clearance_forces`, by the names that
/// tables, summaries and ensembles have them by: "clearance_5N". In netCDF files they are a list.
std::vector<VariableMeaning> clearance_quantities(const std::vector<double>& forces);
/// Not a number where the force is not reached. @param force  number of it
double clearance_of(const Cycle& cycle, std::size_t force);

/// A foil whose stress is compared with its yield stress.
struct StressedFoil {
  std::string_view name;
  std::string_view long_name;
  std::optional<StressPeak> Cycle::*peak;
  std::optional<double> (*yield_stress)(const Case&);
};
std::span<const StressedFoil> stressed_foils();

/// A bump (from 0) as people count: "3", or of several pads "3 of pad 2".
std::string bump_text(const Case& input, int bump);

/// "crest 3", "weld".
std::string place_text(const Case& input, const StressPeak& peak);

/// The pad of the place, from 0; none where the bearing is not made of several.
std::optional<std::size_t> pad_of(const Case& input, const StressPeak& peak);

/// Whether the stress of a foil exceeds its yield stress in a cycle: 0 or 1, not a number where one of them is not
/// known.
double above_yield(const StressedFoil& foil, const Cycle& cycle, const Case& input);

}  // namespace bumpfoil
