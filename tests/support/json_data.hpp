#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Files have angles in degrees.
inline constexpr double degree = std::numbers::pi / 180.0;

/// A file of tests/data.
inline nlohmann::json json_data(const std::string& file) {
  return nlohmann::json::parse(std::ifstream(BUMPFOIL_TEST_DATA "/" + file));
}

inline Vector to_vector(const nlohmann::json& list) {
  const auto values = list.get<std::vector<double>>();
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace bumpfoil
