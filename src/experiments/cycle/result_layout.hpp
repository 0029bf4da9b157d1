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

/// Numbers with what readers are told about them.
struct NamedNumbers {
  std::string name;
  std::string unit;
  std::string long_name;
  std::vector<double> values;
};

/// Names and places that differ between result.nc of a bearing and of a strip.
struct ResultLayout {
  NamedNumbers cycles;  ///< their coordinate: directions, or numbers of a strip's cycles, begun or not; a path: none
  std::vector<std::size_t> places;  ///< of the cycles of the case among these, which are sorted; a path: one
  std::size_t increments{};         ///< of a cycle
  std::size_t bumps{};
  std::size_t feet{};
  std::size_t pads{1};
  std::size_t strips{1};
  std::vector<NamedNumbers> scalars;   ///< geometry
  std::vector<NamedNumbers> at_bumps;  ///< the same, one per bump
  std::vector<NamedNumbers> at_feet;   ///< one per foot
  std::vector<NamedNumbers> at_pads;   ///< one per pad of several
  std::string bump_coordinates;        ///< those of them that say where a bump is
  std::string foot_coordinates;

  /// Whether there are such nodes.
  [[nodiscard]] bool has(Node at) const { return (at != Node::pad || pads > 1) && (at != Node::strip || strips > 1); }
  /// Their dimension; none of what is one.
  [[nodiscard]] std::vector<std::string> dims_of(Node at) const;
  /// Variables that say where they are.
  [[nodiscard]] std::string coordinates_of(Node at) const;
};

ResultLayout make_result_layout(const Case& input, Experiment experiment);

/// That of states of the running bearing, of place_film_pads(): there are no cycles.
ResultLayout make_film_layout(const Case& input);

/// Adds the dimensions of bumps, feet, several pads and strips, and the geometry that it takes to draw them.
/// @param carrying  sleeve or base
void add_foils(const ResultLayout& layout, std::string_view carrying, Dataset& data);

}  // namespace bumpfoil
