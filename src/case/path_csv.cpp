#include "case/path_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/csv_lines.hpp"
#include "case/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view headers = "write x_m,y_m for positions or force_x_N,force_y_N for loads";

std::optional<Control> control_of(std::string_view header) {
  const auto columns = two_columns(header);
  if (columns == std::pair<std::string_view, std::string_view>("x_m", "y_m")) return Control::displacement;
  if (columns == std::pair<std::string_view, std::string_view>("force_x_N", "force_y_N")) return Control::load;
  return std::nullopt;
}

}  // namespace

PathPoints read_path(const std::string& path) {
  const std::string text = read_text_file(path);
  PathPoints points;
  std::vector<InputError> errors;
  for_each_line(text, [&](std::size_t line, std::string_view content) {
    const auto error = [&](std::string what, std::string_view advice) {
      errors.push_back({path, line, "line", std::string(content), std::move(what), std::string(advice)});
    };
    if (line == 1) {
      const std::optional<Control> control = control_of(content);
      if (!control) return error("is not a header of a path", headers);
      points.control = *control;
      return;
    }
    if (content.empty()) return;
    const auto columns = two_columns(content);
    if (!columns) return error("does not have two columns", "write two numbers, such as 0,-4e-5");
    const auto x = parse<double>(columns->first);
    const auto y = parse<double>(columns->second);
    if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y)) {
      return error("is not two finite numbers", "give them in SI, without units");
    }
    points.values.emplace_back(*x, *y);
  });
  if (errors.empty() && points.values.empty()) {
    errors.push_back({path, 0, "", "", "contains no points", fmt::format("{}, and a line for each place", headers)});
  }
  if (errors.empty() && std::ssize(points.values) > most_points) {
    errors.push_back({path, 0, "", "", fmt::format("holds {} places", points.values.size()),
                      fmt::format("give at most {}", most_points)});
  }
  if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
  return points;
}

}  // namespace bumpfoil
