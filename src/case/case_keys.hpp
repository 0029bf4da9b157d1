#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/control.hpp"
#include "case/units.hpp"

namespace bumpfoil {

enum class Presence {
  required,
  optional,   ///< absent if not given
  defaulted,  ///< has a default
  inherited,  ///< a table of differences from another with the same keys
};

/// Description of a key of the case file, or of a table.
struct Key {
  std::string_view name;  ///< within its table
  Presence presence{Presence::required};
  std::string_view title;                ///< label in reports
  std::string_view text{};               ///< meaning, for comments
  std::string_view example{};            ///< value shown by `init`; empty: that of the reference case
  std::optional<Dimension> dimension{};  ///< of a text with a unit, or of a number in SI
  std::string_view otherwise{};          ///< "table.key" that provides the value if this one is not given
  bool instead{};                        ///< alternative to the previous key: only one may be given
  bool left_open{};              ///< the reader may choose a better value than the default, so templates leave it out
  std::string_view spared_by{};  ///< table that makes a required key optional
  std::string_view stand_in{};   ///< key of its table that may replace it
  bool any_dimension{};          ///< unknown: that of another key, which the table names wrongly or not at all
};

/// Storage of the value of a key. An absent number or an empty list means no value.
using Value = std::variant<std::string*, bool*, int*, double*, std::optional<double>*, std::vector<double>*,
                           std::vector<std::string>*, PerBump*, FormedRadius*>;

/// Visits every key of the case file, in its order, to read or to write.
class CaseVisitor {
 public:
  CaseVisitor() = default;
  CaseVisitor(const CaseVisitor&) = delete;
  CaseVisitor& operator=(const CaseVisitor&) = delete;
  virtual ~CaseVisitor() = default;

  virtual void value(const Key& key, Value value) = 0;

  /// A list of angles; "+X", "+Y", "-X" and "-Y" are accepted.
  virtual void directions(const Key& key, std::vector<double>& angles) = 0;

  /// A list of vectors in the X-Y plane, each by its components along X and Y.
  virtual void vectors(const Key& key, std::vector<Eigen::Vector2d>& vectors) = 0;

  /// One of a few words, by its index, or none.
  virtual void word(const Key& key, std::span<const std::string_view> words, std::optional<std::size_t>& index) = 0;

  template <typename Enum>
  void choice(const Key& key, std::optional<Enum>& value) {
    std::optional<std::size_t> index;
    if (value) index = static_cast<std::size_t>(*value);
    word(key, enum_names<Enum>, index);
    if (index) value = static_cast<Enum>(*index);
  }

  template <typename Enum>
  void choice(const Key& key, Enum& value) {
    std::optional<Enum> chosen = value;
    choice(key, chosen);
    value = *chosen;
  }

  /// One of a few names that are not those of an enumeration.
  void choice(const Key& key, std::span<const std::string_view> names, std::string& value) {
    const auto chosen = std::find(names.begin(), names.end(), value);
    std::optional<std::size_t> index;
    if (chosen != names.end()) index = static_cast<std::size_t>(chosen - names.begin());
    word(key, names, index);
    if (index) value = names[*index];
  }

  /// A number given once for several keys, or individually for each.
  virtual void once_or_each(const Key& once, std::initializer_list<std::pair<Key, double*>> each) = 0;

  /// A length or its double, such as a radius or a diameter.
  virtual void once_or_twice(const Key& once, const Key& twice, std::optional<double>& number) = 0;

  /// A displacement or a load, each with its own key.
  virtual void one_of(const Key& displacement, const Key& load, Target& target) = 0;

  /// A displacement or a load under one key, distinguished by unit; a number without a unit is of kind `plain`.
  virtual void either(const Key& key, Control plain, std::optional<Target>& target) = 0;

  /// The same with a component along X and one along Y.
  virtual void either(const Key& key, Control plain, std::optional<PlaneTarget>& target) = 0;

  /// Any number of such targets, all displacements or all loads: a list of lists. @return whether it is given
  virtual bool places(const Key& key, PathPoints& points) = 0;

  /// A file, named relative to the case file, instead of the list or table `other`. `read` may throw Error.
  /// @return whether it is given
  virtual bool file(const Key& key, std::string_view other,
                    const std::function<void(const std::string& path)>& read) = 0;

  /// Any number of tables of one kind, each under its own [[name]]. `describe` visits the keys of the i-th, from 0;
  /// `count` is the present number in the case.
  virtual void tables(const Key& key, std::size_t count,
                      const std::function<void(CaseVisitor&, std::size_t i)>& describe) = 0;

  /// Whether the visitor supplies tables of this key that replace the present ones.
  [[nodiscard]] virtual bool replaces(const Key& key) const = 0;

  /// A table whose keys `describe` visits; `given`: whether it has any content yet.
  virtual void table(const Key& key, bool given, const std::function<void(CaseVisitor&)>& describe) = 0;
};

/// A table that is given if any of its members differs from the default. @param describe_members  (visitor, members) ->
/// void
template <typename Table, typename Describe>
void defaulted_table(CaseVisitor& keys, const Key& key, Table& members, const Describe& describe_members) {
  keys.table(key, members != Table{}, [&](CaseVisitor& visitor) { describe_members(visitor, members); });
}

/// An optional table of the case.
template <typename Table, typename Describe>
void optional_table(CaseVisitor& keys, const Key& key, std::optional<Table>& members,
                    const Describe& describe_members) {
  Table inner = members.value_or(Table{});
  keys.table(key, members.has_value(), [&](CaseVisitor& visitor) {
    describe_members(visitor, inner);
    members = inner;
  });
}

/// The same for the settings of an experiment. @param describe_members  (visitor, Settings&) -> void
template <typename Settings>
void settings_table(CaseVisitor& keys, const Key& key, SettingsByType& all,
                    void (*describe_members)(CaseVisitor&, Settings&)) {
  const Settings* const held = all.find<Settings>();
  Settings inner = held == nullptr ? Settings{} : *held;
  keys.table(key, held != nullptr, [&](CaseVisitor& visitor) {
    describe_members(visitor, inner);
    all.set(inner);
  });
}

/// Tables under [[name]], one for each member. @param describe_member  (visitor, member) -> void
template <typename Member, typename Describe>
void list_of_tables(CaseVisitor& keys, const Key& key, std::vector<Member>& members, const Describe& describe_member) {
  if (keys.replaces(key)) members.clear();
  keys.tables(key, members.size(), [&](CaseVisitor& inner, std::size_t i) {
    if (i == members.size()) members.emplace_back();
    describe_member(inner, members[i]);
  });
}

/// A table of differences from the general values. @param describe_members  (visitor, members) -> void
template <typename Table, typename Describe>
void own_table(CaseVisitor& keys, const Key& key, const Table& common, std::optional<Table>& own,
               const Describe& describe_members) {
  Table members = own.value_or(common);
  keys.table(key, own.has_value(), [&](CaseVisitor& inner) {
    describe_members(inner, members);
    own = members;
  });
}

/// Tables of the bearing, its foils and their friction in which a bearing of a rotor differs from the case.
void describe_own_design(CaseVisitor& keys, const BearingDesign& common, RotorBearing& own);

/// All keys of the case file: those of the bearing and of ensembles, and those that experiments describe.
void describe(CaseVisitor& keys, Case& input);

}  // namespace bumpfoil
