#include "case/deviations_csv.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/csv_lines.hpp"
#include "case/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view deviation_header = "deviation";

}  // namespace

std::vector<double> read_deviations(const std::string& path) {
  const std::string text = read_text_file(path);
  std::vector<double> deviations;
  std::vector<InputError> errors;
  for_each_line(text, [&](std::size_t line, std::string_view content) {
    const auto error = [&](std::string what, std::string advice) {
      errors.push_back({path, line, "line", std::string(content), std::move(what), std::move(advice)});
    };
    if (line == 1) {
      if (content != deviation_header)
        error("is not a header of deviations", fmt::format("write {}", deviation_header));
    } else if (!content.empty()) {
      const auto number = parse<double>(content);
      if (!number || !std::isfinite(*number)) return error("is not a finite number", "give it in SI, without a unit");
      deviations.push_back(*number);
    }
  });
  if (errors.empty() && deviations.empty()) {
    errors.push_back(
        {path, 0, "", "", "contains no deviations", fmt::format("write {}, and one in each line", deviation_header)});
  }
  if (errors.empty() && std::ssize(deviations) > most_points) {
    errors.push_back({path, 0, "", "", fmt::format("holds {} deviations", deviations.size()),
                      fmt::format("give at most {}", most_points)});
  }
  if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
  return deviations;
}

}  // namespace bumpfoil
