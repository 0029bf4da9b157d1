#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/table.hpp"

namespace bumpfoil {

/// Sentences on parameters that the data do not determine, and on a model that they contradict.
std::vector<std::string> fit_warnings(const FitResult& result);

/// The result as text for the terminal.
std::string fit_table(const FitResult& result);

/// Contents of fit.nc. @param result  must outlive it
Dataset fit_dataset(const FitResult& result);

/// Rows of fit.csv: one per data point.
Table fitted_points(const FitResult& result);

/// Entries of summary.json.
nlohmann::ordered_json fit_lists(const FitResult& result);

/// Contents of case.toml: the fitted case, with the sources of its values.
std::string fitted_case_text(const FitResult& result);

}  // namespace bumpfoil
