#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/io/case_writer.hpp"

namespace bumpfoil {

/// The text of examples/gen1.toml.
std::string_view example_gen1();

std::vector<std::string> preset_names() {
  return {"gen1"};
}

std::string case_template(std::string_view preset) {
  if (preset == "gen1") return std::string(example_gen1());
  throw Error(ErrorKind::input, {{"", 0, "preset", std::string(preset), "is not known",
                                  fmt::format("use one of {}", fmt::join(preset_names(), ", "))}});
}

}  // namespace bumpfoil
