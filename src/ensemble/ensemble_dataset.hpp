#pragma once

#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/row_log.hpp"

namespace bumpfoil {

/// Random numbers and results of each sample of an ensemble, read in pieces: except for the sample numbers, memory does
/// not grow with the number of samples.
/// @param input, layout, log  outlive it
Dataset ensemble_dataset(const Case& input, const EnsembleLayout& layout, const RowLog& log);

}  // namespace bumpfoil
