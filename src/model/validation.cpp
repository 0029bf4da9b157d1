#include "bumpfoil/model/validation.hpp"

namespace bumpfoil {

std::vector<Fault> find_faults(const Case& /*input*/) {
  return {};
}

void require_valid(const Case& input) {
  std::vector<Fault> faults = find_faults(input);
  if (!faults.empty()) throw Error(ErrorKind::input, std::move(faults));
}

}  // namespace bumpfoil
