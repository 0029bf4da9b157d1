#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

std::string key_of(std::string_view name, std::string_view unit) {
  for (const std::string_view prefix : {"total_", "increment_"}) {
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  }
  for (const std::string_view status : {"load_status", "point_status", "response_status", "speed_status"}) {
    if (name == status) name = "status";
  }
  std::string key(name);
  if (unit.empty() || unit == "1") return key;
  if (unit == "degree") return key + "_deg";
  key += '_';
  for (const char letter : unit) {
    if (letter == '/') {
      key += "_per_";
    } else {
      key += letter == ' ' ? '_' : letter;
    }
  }
  return key;
}

}  // namespace bumpfoil
