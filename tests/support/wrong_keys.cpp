#include "support/wrong_keys.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/experiments/unbalance/unbalance.hpp"
#include "bumpfoil/model/validation.hpp"

namespace bumpfoil::test_support {

Keys wrong_keys(const std::function<void(Case&)>& change) {
  Case input = reference_case();
  change(input);
  Keys keys;
  for (const auto& [command, error] : check_case(input)) {
    // Skips commands without a table.
    if (command == "film" || command == "limits" ||
        (command == "equilibrium" && input.settings.find<EquilibriumSettings>() == nullptr) ||
        (command == "stability" && input.settings.find<StabilitySettings>() == nullptr) ||
        (command == "unbalance" && input.settings.find<UnbalanceSettings>() == nullptr) ||
        (command == "transient" && input.settings.find<TransientSettings>() == nullptr) ||
        (command == "montecarlo" && !input.montecarlo)) {
      continue;
    }
    EXPECT_TRUE(error.file.empty());
    EXPECT_FALSE(error.what.empty());
    EXPECT_FALSE(error.advice.empty());
    keys.push_back(error.key);
  }
  return keys;
}

}  // namespace bumpfoil::test_support
