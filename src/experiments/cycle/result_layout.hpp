#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// Numbers with their name and description for readers.
struct NamedNumbers {
  std::string name;
  std::string unit;
  std::string long_name;
  std::vector<double> values;
};

/// Names and positions that differ between result.nc of a bearing and of a strip.
struct ResultLayout {
  NamedNumbers cycles;  ///< their coordinate: directions, or cycle numbers of a strip, started or not; none for a path
  std::vector<std::size_t> places;  ///< of the cycles of the case among these sorted values; one for a path
  std::size_t increments{};         ///< of a cycle
  std::size_t bumps{};
  std::size_t feet{};
  std::size_t pads{1};
  std::size_t strips{1};
  std::vector<NamedNumbers> scalars;   ///< geometry
  std::vector<NamedNumbers> at_bumps;  ///< the same, one per bump
  std::vector<NamedNumbers> at_feet;   ///< one per foot
  std::vector<NamedNumbers> at_pads;   ///< one per pad of several
  std::string bump_coordinates;        ///< those that give the position of a bump
  std::string foot_coordinates;

  /// Whether the result has nodes of this kind.
  [[nodiscard]] bool has(Node at) const { return (at != Node::pad || pads > 1) && (at != Node::strip || strips > 1); }
  /// Their dimensions; none for a scalar.
  [[nodiscard]] std::vector<std::string> dims_of(Node at) const;
  /// Variables that give their positions.
  [[nodiscard]] std::string coordinates_of(Node at) const;
};

ResultLayout make_result_layout(const Case& input, Experiment experiment);

/// Layout of a bearing without a film: without cycles.
ResultLayout make_bearing_layout(const Case& input);

/// Layout of running states, of place_film_pads(): without cycles.
ResultLayout make_film_layout(const Case& input);

/// Adds the dimensions of bumps, feet, several pads and strips, and the geometry needed to draw them.
/// @param carrying  sleeve or base
void add_foils(const ResultLayout& layout, std::string_view carrying, Dataset& data);

}  // namespace bumpfoil
