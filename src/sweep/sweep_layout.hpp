#pragma once

#include <string>
#include <vector>

#include "bumpfoil/sweep/sweep.hpp"

namespace bumpfoil {

/// What the values of points are over: the dataset of the point with the most of it, of which nothing was begun, what
/// others have besides, with room for the longest of each dimension, and its parts. No point need have all of it.
struct SweepLayout {
  Dataset dataset;
  std::vector<SweptPart> parts;
};
SweepLayout layout_of(const Sweep& sweep, const std::vector<SweepPoint>& points);

/// Values of a variable at a point; none where the point has no such variable.
/// @param hint  where it is among the variables of most points
const std::vector<double>& values_of(const SweepPoint& point, const std::string& name, std::size_t hint);

/// Adds names to those there are, each behind the one that it follows.
void merge_names(const std::vector<std::string>& more, std::vector<std::string>& all);

/// All points over the swept keys and those dimensions: what sweep.nc holds. What a point has not is absent.
/// @param points  live as long as it
Dataset sweep_dataset(const Sweep& sweep, const std::vector<SweepPoint>& points);

}  // namespace bumpfoil
