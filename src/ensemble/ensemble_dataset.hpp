#pragma once

#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/row_log.hpp"

namespace bumpfoil {

/// What was drawn of each sample of an ensemble and what came of it, read in pieces: what it holds in memory does not
/// grow with the number of samples but for their numbers.
/// @param input, layout, log  outlive it
Dataset ensemble_dataset(const Case& input, const EnsembleLayout& layout, const RowLog& log);

}  // namespace bumpfoil
