#pragma once

#include <string>

#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

/// Adds a value of a CSV file: all digits of a number, true or false, a word; nothing where it is not known.
void append_csv(std::string& out, double value, const Form& form = {});

}  // namespace bumpfoil
