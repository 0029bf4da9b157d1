#include "bumpfoil/experiments/sampling.hpp"

#include <algorithm>

#include "bumpfoil/core/status.hpp"

namespace bumpfoil {

std::size_t EnsembleLayout::column(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [name](const EnsembleColumn& one) { return one.meaning.name == name; });
  return static_cast<std::size_t>(found - columns.begin());
}

std::string_view EnsembleLayout::status_name(int status) const {
  return (*statuses)[static_cast<std::size_t>(status)];
}

std::string_view EnsembleLayout::status_reason(int status) const {
  if (status == no_bearing()) return "invalid sample";
  const auto& names = enum_names<Status>;
  const auto found = std::find(names.begin(), names.end(), status_name(status));
  return found == names.end() ? status_name(status) : explanation(static_cast<Status>(found - names.begin()));
}

}  // namespace bumpfoil
