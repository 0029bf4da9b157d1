#include "experiments/vibration/ross_element.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "experiments/vibration/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

/// One matrix entry as nested lists for ROSS, in rows of a given length.
std::string coefficient(const std::vector<Eigen::Matrix2d>& matrices, std::size_t row_size, int row, int column) {
  if (matrices.size() == 1) return toml_number(matrices.front()(row, column));
  std::vector<std::string> rows;
  std::vector<double> values;
  for (const Eigen::Matrix2d& matrix : matrices) {
    values.push_back(matrix(row, column));
    if (values.size() < row_size) continue;
    rows.push_back(toml_list(values));
    values.clear();
  }
  return rows.size() == 1 ? rows.front() : fmt::format("[{}]", fmt::join(rows, ", "));
}

}  // namespace

std::string toml_number(double value) {
  std::string text = fmt::format("{:.17g}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string toml_list(const std::vector<double>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) texts.push_back(toml_number(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string toml_of(const RossElement& element, std::string_view name) {
  const std::size_t speeds = std::max<std::size_t>(1, element.speeds.size());
  const std::size_t frequencies = std::max<std::size_t>(1, element.frequencies.size());
  BUMPFOIL_ASSERT(element.stiffness.size() == speeds * frequencies);
  BUMPFOIL_ASSERT(element.damping.size() == element.stiffness.size());
  std::string out = fmt::format("\n[bearing.{}]\n", name);
  if (speeds > 1) out += fmt::format("speed = {}\n", toml_list(element.speeds));
  if (frequencies > 1) out += fmt::format("frequency = {}\n", toml_list(element.frequencies));
  const std::size_t row_size = frequencies > 1 ? frequencies : speeds;
  for (const auto& [letter, matrices] : {std::pair{'k', &element.stiffness}, std::pair{'c', &element.damping}}) {
    for (const auto& [axes, row, column] : matrix_entries) {
      out += fmt::format("{}{} = {}\n", letter, axes, coefficient(*matrices, row_size, row, column));
    }
  }
  return out;
}

}  // namespace bumpfoil
