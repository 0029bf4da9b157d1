#include "bumpfoil/model/per_bump.hpp"

#include <cmath>

namespace bumpfoil {

double PerBump::at(std::size_t bump, std::size_t bumps) const {
  if (!law) return values.size() == 1 ? values.front() : values[bump];
  const double first = values.front();
  const double last = values.back();
  if (bump == 0 || bumps < 2) return first;
  if (bump + 1 == bumps) return last;
  const double part = static_cast<double>(bump) / static_cast<double>(bumps - 1);
  return *law == Grading::linear ? first + (last - first) * part : first * std::pow(last / first, part);
}

PerBump listed(const PerBump& dimension, std::size_t bumps) {
  std::vector<double> each;
  each.reserve(bumps);
  for (std::size_t n = 0; n < bumps; ++n) each.push_back(dimension.at(n, bumps));
  return PerBump(std::move(each));
}

PerBump shifted(const PerBump& dimension, std::size_t bumps, double deviation) {
  // A shift of both ends would change the ratios of a geometric law.
  PerBump result = dimension.law == Grading::geometric ? listed(dimension, bumps) : dimension;
  for (double& value : result.values) value += deviation;
  return result;
}

}  // namespace bumpfoil
