#include "results/csv_value.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace bumpfoil {

void append_csv(std::string& out, double value, const Form& form) {
  if (!std::isfinite(value)) return;
  if (form.kind == Form::truth) {
    out += value != 0.0 ? "true" : "false";
  } else if (form.kind == Form::flag) {
    out += form.words[static_cast<std::size_t>(value)];
  } else {
    fmt::format_to(std::back_inserter(out), "{:.17g}", value);
  }
}

}  // namespace bumpfoil
