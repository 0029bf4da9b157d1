#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// Sentences on what the data do not tell, and on a model that they contradict.
std::vector<std::string> fit_warnings(const FitResult& result);

/// For the terminal.
std::string fit_table(const FitResult& result);

/// Contents of fit.nc. @param result  lives as long as it
Dataset fit_dataset(const FitResult& result);

/// Contents of fit.csv: a line for each point of the data.
std::string fit_csv(const FitResult& result);

/// Entries of summary.json.
nlohmann::ordered_json fit_lists(const FitResult& result);

/// Contents of case.toml: the fitted case, and where its values come from.
std::string fitted_case_text(const FitResult& result);

}  // namespace bumpfoil
