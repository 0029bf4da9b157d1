/// Prints the results of the program for the cases of tests/data/fe/shells.json, as rows of the same form, for
/// docs/verification/fe_shells.md.
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "support/shell_cases.hpp"

namespace bumpfoil {
namespace {

nlohmann::json rows_of_matrix(const Matrix& matrix) {
  nlohmann::json lines = nlohmann::json::array();
  for (const auto& row : matrix.rowwise()) lines.push_back(std::vector<double>(row.begin(), row.end()));
  return lines;
}

nlohmann::json answers() {
  nlohmann::json rows = nlohmann::json::array();
  for (const FeShells& shells : fe_shells()) {
    if (shells.refined > 1) continue;
    for (const int modes : {1, 3}) {
      if (modes == 1 && shells.name == "tilt") continue;  // uniform foils cannot follow a tilt
      const ShellNumbers own = shells_by_program(shells.name, shells.feet, modes);
      nlohmann::json row{{"case", shells.name}, {"feet", shells.feet}, {"modes", modes}};
      if (own.crest_w.size() > 0) row["crest_w_m"] = rows_of_matrix(own.crest_w);
      if (own.span_w.size() > 0) row["span_w_m"] = rows_of_matrix(own.span_w);
      if (own.moments.size() > 0) row["moments_N_m"] = std::vector<double>(own.moments.begin(), own.moments.end());
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace
}  // namespace bumpfoil

int main() {
  std::cout << bumpfoil::answers() << '\n';
}
