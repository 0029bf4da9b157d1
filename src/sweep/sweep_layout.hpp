#pragma once

#include <string>
#include <vector>

#include "bumpfoil/sweep/sweep.hpp"

namespace bumpfoil {

/// Common layout of all points: the unstarted dataset of the point with most entries, plus additional entries of
/// others, with the maximum length of each dimension, and its parts. A point may lack any of them.
struct SweepLayout {
  Dataset dataset;
  std::vector<SweptPart> parts;
};
SweepLayout layout_of(const Sweep& sweep, const std::vector<SweepPoint>& points);

/// Values of a variable at a point; none if the point has no such variable.
/// @param hint  its index among the variables of most points
const std::vector<double>& values_of(const SweepPoint& point, const std::string& name, std::size_t hint);

/// Merges names into a list, each after its predecessor.
void merge_names(const std::vector<std::string>& more, std::vector<std::string>& all);

/// All points over the swept keys and those dimensions: the content of sweep.nc. Missing values are absent.
/// @param points  must outlive it
Dataset sweep_dataset(const Sweep& sweep, const std::vector<SweepPoint>& points);

}  // namespace bumpfoil
