#pragma once

#include <optional>
#include <string>

namespace bumpfoil {

/// `number` in the unit that is `unit` in SI, for tables: five significant digits, without exponent for what is usual;
/// a dash if it is not known.
std::string number_text(const std::optional<double>& number, double unit);

}  // namespace bumpfoil
