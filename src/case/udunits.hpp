#pragma once

#include <udunits2.h>

#include <memory>
#include <optional>
#include <string_view>

#include "case/unit_system.hpp"

namespace bumpfoil {

/// The units of UDUNITS-2, and "deg". Not thread-safe.
class Udunits {
 public:
  /// @throws Error (file) if its database cannot be read.
  Udunits();

  [[nodiscard]] std::optional<UnitMeaning> read(std::string_view text) const;

  /// What is known under a name or under a symbol, without a prefix.
  [[nodiscard]] std::optional<UnitMeaning> named(const char* name) const;
  [[nodiscard]] std::optional<UnitMeaning> with_symbol(const char* symbol) const;

 private:
  struct FreeSystem {
    void operator()(ut_system* system) const { ut_free_system(system); }
  };
  std::unique_ptr<ut_system, FreeSystem> system_;
};

}  // namespace bumpfoil
