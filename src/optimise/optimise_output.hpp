#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bumpfoil/optimise/optimise.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// A line on what kept the optimisation from converging; none where nothing did.
std::vector<std::string> optimise_failures(const OptimiseResult& result);

/// Warnings of the best point, and points that have no result.
std::vector<std::string> optimise_warnings(const OptimiseResult& result);

/// For the terminal.
std::string optimise_table(const OptimiseResult& result);

/// Contents of result.nc. @param result  lives as long as it
Dataset optimise_dataset(const OptimiseResult& result);

/// Contents of points.csv: a line for each point.
std::string points_csv(const OptimiseResult& result);

/// Entries of summary.json.
nlohmann::ordered_json optimise_lists(const OptimiseResult& result);

/// Contents of case.toml: the case with the best values, and where they come from. @pre  there is a best point
std::string optimised_case_text(const OptimiseResult& result);

}  // namespace bumpfoil
