#pragma once

#include <any>
#include <map>
#include <typeindex>
#include <utility>

namespace bumpfoil {

/// Settings of some type, which can be copied and compared.
struct AnySettings {
  std::any value;
  bool (*equal)(const std::any&, const std::any&);

  bool operator==(const AnySettings& other) const { return equal(value, other.value); }
};

/// Settings of experiments, at most one of each type. A case holds them without knowing their types, which stay in the
/// folders of their experiments.
class SettingsByType {
 public:
  /// Those of a type; null where there are none.
  template <typename Settings>
  [[nodiscard]] const Settings* find() const {
    const auto found = held_.find(typeid(Settings));
    return found == held_.end() ? nullptr : std::any_cast<Settings>(&found->second.value);
  }

  template <typename Settings>
  [[nodiscard]] Settings* find() {
    return const_cast<Settings*>(std::as_const(*this).find<Settings>());
  }

  /// Keeps these in place of any others of their type.
  /// @return what is kept, to be changed there
  template <typename Settings>
  Settings& set(Settings settings) {
    const auto equal = [](const std::any& a, const std::any& b) {
      return *std::any_cast<Settings>(&a) == *std::any_cast<Settings>(&b);
    };
    const auto place = held_.insert_or_assign(typeid(Settings), AnySettings{std::move(settings), equal}).first;
    return *std::any_cast<Settings>(&place->second.value);
  }

  bool operator==(const SettingsByType&) const = default;

 private:
  std::map<std::type_index, AnySettings> held_;
};

}  // namespace bumpfoil
