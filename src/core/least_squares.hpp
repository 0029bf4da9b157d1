#pragma once

#include <Eigen/Core>
#include <optional>

namespace bumpfoil {

/// The X that minimises |A X - B|, column by column; of several, the shortest. Compiled once, because the decomposition
/// takes seconds to compile.
/// @param A          any shape and rank
/// @param B          as many rows as A
/// @param threshold  pivots below this fraction of the largest count as zero; by default round-off
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, std::optional<double> threshold = {});

}  // namespace bumpfoil
