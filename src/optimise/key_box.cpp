#include "optimise/key_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

double short_value(double value, const OptimisedKey& key) {
  double rounded = value;
  read_number(fmt::format("{:.12g}", value), rounded);
  return std::clamp(rounded, key.lower, key.upper);
}

}  // namespace

Eigen::VectorXd KeyBox::place_of(const KeyValues& values) const {
  Eigen::VectorXd place(dimensions());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const OptimisedKey& key = keys_[i];
    place[static_cast<Eigen::Index>(i)] = key.log ? std::log(values[i] / key.lower) / std::log(key.upper / key.lower)
                                                  : (values[i] - key.lower) / (key.upper - key.lower);
  }
  return place;
}

KeyValues KeyBox::values_at(const Eigen::VectorXd& place) const {
  KeyValues values;
  values.reserve(keys_.size());
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const OptimisedKey& key = keys_[i];
    const double part = place[static_cast<Eigen::Index>(i)];
    const double value =
        key.log ? key.lower * std::pow(key.upper / key.lower, part) : key.lower + part * (key.upper - key.lower);
    values.push_back(part >= 1.0 ? key.upper : value);
  }
  return short_values(values);
}

KeyValues KeyBox::short_values(const KeyValues& values) const {
  KeyValues all;
  all.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) all.push_back(short_value(values[i], keys_[i]));
  return all;
}

}  // namespace bumpfoil
