#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bumpfoil/optimise/optimise.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/table.hpp"

namespace bumpfoil {

/// The reason why the optimisation did not converge, in one line; none if it did.
std::vector<std::string> optimise_failures(const OptimiseResult& result);

/// Warnings of the best point, and of points without a result.
std::vector<std::string> optimise_warnings(const OptimiseResult& result);

/// The result as text for the terminal.
std::string optimise_table(const OptimiseResult& result);

/// Contents of result.nc. @param result  must outlive it
Dataset optimise_dataset(const OptimiseResult& result);

/// Rows of points.csv: one per point.
Table point_table(const OptimiseResult& result);

/// Entries of summary.json.
nlohmann::ordered_json optimise_lists(const OptimiseResult& result);

/// Contents of case.toml: the case with the best values, and their source. @pre  there is a best point
std::string optimised_case_text(const OptimiseResult& result);

}  // namespace bumpfoil
