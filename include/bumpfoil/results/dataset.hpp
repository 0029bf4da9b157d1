#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

struct DataDimension {
  std::string name;
  std::size_t size{};  ///< of one that grows: what it is to become; 0 where that is not known
  /// Its entries come one after the other: unlimited in netCDF files. Values of variables over it, which is their first
  /// dimension, are those of the entries in memory; see ResultStream.
  bool grows{};
};

/// Numbers over some dimensions of a dataset.
struct Variable {
  VariableMeaning meaning;
  std::vector<std::string> dims{};
  /// The last dimension runs fastest; not a number where absent; none where all are. Read when they are needed: what
  /// they are read from must live so long.
  std::function<std::vector<double>()> values{};
  /// Instead of these, where they are more than the memory takes: those of `count` entries of the first dimension.
  std::function<std::vector<double>(std::size_t first, std::size_t count)> rows{};
  std::map<std::string, std::string> attributes{};  ///< in netCDF files, such as `coordinates`
  std::vector<std::string> names{};                 ///< of the entries, which tables show instead of numbers
  bool known{};                                     ///< none is ever absent
  bool compressed{};                                ///< in its own netCDF file
};

/// Content of a result, described once: its own netCDF file has it over its dimensions, that of a sweep also over the
/// swept keys.
struct Dataset {
  std::vector<DataDimension> dims{};
  std::vector<Variable> coordinates{};  ///< known, and the same at all points of a sweep
  std::vector<Variable> variables{};
  std::map<std::string, std::string> attributes{};

  /// Adds a dimension and the coordinate of its name.
  void add_dimension(VariableMeaning meaning, std::vector<double> values);
  Variable& add_coordinate(VariableMeaning meaning, std::vector<std::string> over, std::vector<double> values);
  Variable& add(VariableMeaning meaning, std::vector<std::string> over,
                std::function<std::vector<double>()> values = {});
  Variable& add(VariableMeaning meaning, std::vector<std::string> over, std::vector<double> values);

  /// Numbers of a variable over its dimensions.
  [[nodiscard]] std::size_t size_of(const Variable& variable) const;
  [[nodiscard]] std::size_t size_of(const std::string& name) const;
  [[nodiscard]] const DataDimension& dimension(const std::string& name) const;
  /// Whether its values are those of entries that come one after the other.
  [[nodiscard]] bool grows(const Variable& variable) const;
};

/// Numbers from `first` on.
std::vector<double> numbers_from(double first, std::size_t count);

/// `value` of each entry of a list.
template <typename List, typename Value>
auto each(const List& list, const Value& value) {
  std::vector<std::decay_t<decltype(value(*std::begin(list)))>> values;
  values.reserve(list.size());
  for (const auto& one : list) values.push_back(value(one));
  return values;
}

/// What each quantity of some lists means, one list after the other.
template <typename... Lists>
std::vector<VariableMeaning> meanings_of(const Lists&... lists) {
  std::vector<VariableMeaning> meanings;
  const auto add = [&meanings](const auto& list) {
    for (const auto& quantity : list) meanings.push_back(quantity.meaning());
  };
  (add(lists), ...);
  return meanings;
}

/// Names of a list of quantities, after others.
template <typename Quantities>
std::vector<std::string> names_of(const Quantities& quantities, std::vector<std::string> first = {}) {
  for (const auto& quantity : quantities) first.emplace_back(quantity.name);
  return first;
}

/// Rows of all numbers, one after the other, each filled up with absent ones to its width.
/// @param row_of  number of the row -> its first numbers, at most `width`
template <typename RowOf>
std::vector<double> padded_rows(std::size_t rows, std::size_t width, const RowOf& row_of) {
  std::vector<double> all;
  all.reserve(rows * width);
  for (std::size_t row = 0; row < rows; ++row) {
    const auto& numbers = row_of(row);
    all.insert(all.end(), numbers.begin(), numbers.end());
    all.resize((row + 1) * width, absent);
  }
  return all;
}

}  // namespace bumpfoil
