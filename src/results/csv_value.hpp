#pragma once

#include <string>

#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

/// Appends a value of a CSV file: all digits of a number, true or false, or a word; nothing if it is unknown.
void append_csv(std::string& out, double value, const Form& form = {});

}  // namespace bumpfoil
