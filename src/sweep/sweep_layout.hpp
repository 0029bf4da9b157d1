#pragma once

#include <vector>

#include "bumpfoil/sweep/sweep.hpp"

namespace bumpfoil {

/// What the values of points are over: the dataset of the point with the most of it, of which nothing was begun, with
/// room for the longest of each dimension, and its parts. Other points may have less.
struct SweepLayout {
  Dataset dataset;
  std::vector<SweptPart> parts;
};
SweepLayout layout_of(const Sweep& sweep, const std::vector<SweepPoint>& points);

/// All points over the swept keys and those dimensions: what sweep.nc holds. What a point has not is absent.
/// @param points  live as long as it
Dataset sweep_dataset(const Sweep& sweep, const std::vector<SweepPoint>& points);

}  // namespace bumpfoil
