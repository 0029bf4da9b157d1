#include "bumpfoil/model/settings_by_type.hpp"

#include <fmt/format.h>

#include <string>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

void throw_missing_table(std::string_view table) {
  throw Error(ErrorKind::input,
              {{"", 0, std::string(table), "", "this table is missing", fmt::format("add [{}]", table)}});
}

}  // namespace bumpfoil
