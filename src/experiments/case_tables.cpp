#include <array>

#include "experiments/registry.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {

#define BUMPFOIL_DECLARE(name) CaseTable name##_settings();
BUMPFOIL_EXPERIMENTS(BUMPFOIL_DECLARE)
#undef BUMPFOIL_DECLARE

std::span<const CaseTable> case_tables() {
#define BUMPFOIL_CALL(name) name##_settings(),
  static const std::array all{BUMPFOIL_EXPERIMENTS(BUMPFOIL_CALL)};
#undef BUMPFOIL_CALL
  return all;
}

}  // namespace bumpfoil
