#include "io/ross_element.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bumpfoil/core/assert.hpp"
#include "io/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

/// One entry of the matrices as the lists that ROSS wants.
std::string coefficient(const RossElement& element, const std::vector<Eigen::Matrix2d>& matrices, int row, int column) {
  if (matrices.size() == 1) return toml_number(matrices.front()(row, column));
  std::vector<std::string> rows;
  std::vector<double> values;
  for (const Eigen::Matrix2d& matrix : matrices) {
    values.push_back(matrix(row, column));
    if (values.size() < element.frequencies.size()) continue;
    rows.push_back(toml_list(values));
    values.clear();
  }
  return element.speeds.empty() ? rows.front() : fmt::format("[{}]", fmt::join(rows, ", "));
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

std::string toml_of(const RossElement& element) {
  [[maybe_unused]] const std::size_t rows = std::max<std::size_t>(1, element.speeds.size());
  BUMPFOIL_ASSERT(element.stiffness.size() == rows * element.frequencies.size());
  BUMPFOIL_ASSERT(element.damping.size() == element.stiffness.size());
  std::string out = "\n[bearing.element]\n";
  if (!element.speeds.empty()) out += fmt::format("speed = {}\n", toml_list(element.speeds));
  if (element.stiffness.size() > 1) out += fmt::format("frequency = {}\n", toml_list(element.frequencies));
  for (const auto& [axes, row, column] : matrix_entries) {
    out += fmt::format("k{} = {}\n", axes, coefficient(element, element.stiffness, row, column));
  }
  for (const auto& [axes, row, column] : matrix_entries) {
    out += fmt::format("c{} = {}\n", axes, coefficient(element, element.damping, row, column));
  }
  return out;
}

}  // namespace bumpfoil
