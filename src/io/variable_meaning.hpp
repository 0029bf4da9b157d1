#pragma once

#include <string>

#include "bumpfoil/io/result_quantities.hpp"

namespace bumpfoil {

/// What readers are told about a variable.
struct VariableMeaning {
  std::string name;
  std::string unit;
  std::string long_name;
  Form form{};
};

}  // namespace bumpfoil
