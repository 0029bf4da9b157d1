#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/result_names.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"

/// Every quantity of a result, described once: what readers are told about it, and where it comes from. All files, the
/// table on the terminal and the report take it from here; what is added here is in all of them.
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

/// Results that have a quantity: sums of these.
struct Within {
  static constexpr unsigned cycle = 1;
  static constexpr unsigned strip = 2;
  static constexpr unsigned path = 4;
  static constexpr unsigned bearing = cycle | path;
  static constexpr unsigned loops = cycle | strip;
  static constexpr unsigned all = cycle | strip | path;
};

/// Of one increment. Values that are not known are not numbers.
struct IncrementQuantity {
  std::string_view name, unit, long_name;
  double (*value)(const Increment&);
  Form form{};
  bool in_csv{true};  ///< beside result.nc
  unsigned within{Within::all};
};

/// Of one cycle; a key of summary.json, too.
struct CycleQuantity {
  std::string_view name, unit, long_name;
  double (*value)(const Cycle&, const Case&);
  Form form{};
  std::string_view label{};  ///< in tables for people; empty where it is in the files only
  ShownUnit shown{};         ///< on the terminal; a size of 0 where it is not
  bool of_solver{};          ///< says how it was computed
  unsigned within{Within::all};
};

/// What the columns of a field stand for.
enum class Node {
  foil,  ///< all of them
  bump,
  foot,
  weld,  ///< of each pad; the one of a foil that goes all around is no list
  pad,   ///< of several; a foil that goes all around has none
};

/// Of the foils at one increment: a matrix of increments and nodes, see FoilFields. No columns where it is not known.
struct FieldQuantity {
  std::string_view name, unit, long_name;
  Node node;
  FieldMatrix (*values)(const FoilFields&);
  Form form{};
};

/// Loads of a cycle, one per node: at full displacement, or the largest of a path. A key of summary.json, too.
struct LoadQuantity {
  std::string_view name, unit, long_name;
  Node node;
  Vector (*values)(const Cycle&);  ///< nothing where they are not known
  unsigned within{Within::all};
};

/// Of one change of state of a contact.
struct EventQuantity {
  std::string_view name, unit, long_name;
  double (*value)(const CycleEvent&);
  Form form{};
};

/// In the order of files and tables.
std::vector<IncrementQuantity> increment_quantities(Experiment experiment);
std::vector<CycleQuantity> cycle_quantities(Experiment experiment);
std::span<const FieldQuantity> field_quantities();
std::vector<LoadQuantity> load_quantities(Experiment experiment);
std::span<const EventQuantity> event_quantities();

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
