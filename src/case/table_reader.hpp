#pragma once

#include <toml++/toml.h>
#include <string>
#include <utility>
#include <vector>

#include "case/case_keys.hpp"
#include "case/reading_log.hpp"

namespace bumpfoil {

/// Reads the values of a table, and of those inside it, from a case file. Errors go to the log and leave the value
/// unchanged.
class TableReader final : public CaseVisitor {
 public:
  /// Reader of the root table. Log and document must outlive it.
  TableReader(ReadingLog& log, const toml::table& root) : log_(log), root_(root), table_(root) {}

  void value(const Key& key, Value value) override;
  void directions(const Key& key, std::vector<double>& angles) override;
  void vectors(const Key& key, std::vector<Eigen::Vector2d>& vectors) override;
  void word(const Key& key, std::span<const std::string_view> words, std::optional<std::size_t>& index) override;
  void once_or_each(const Key& once, std::initializer_list<std::pair<Key, double*>> each) override;
  void once_or_twice(const Key& once, const Key& twice, std::optional<double>& number) override;
  void one_of(const Key& displacement, const Key& load, Target& target) override;
  void either(const Key& key, Control plain, std::optional<Target>& target) override;
  void either(const Key& key, Control plain, std::optional<PlaneTarget>& target) override;
  bool places(const Key& key, PathPoints& points) override;
  bool file(const Key& key, std::string_view other, const std::function<void(const std::string&)>& read) override;
  void tables(const Key& key, std::size_t count,
              const std::function<void(CaseVisitor&, std::size_t)>& describe) override;
  [[nodiscard]] bool replaces(const Key& key) const override { return has(key); }
  void table(const Key& key, bool given, const std::function<void(CaseVisitor&)>& describe) override;

  /// Reports every unknown key. Call this last.
  void finish();

 private:
  TableReader(const TableReader& outer, const toml::table& table, std::string path, bool inherits = false)
      : log_(outer.log_), root_(outer.root_), table_(table), path_(std::move(path)), inherits_(inherits) {}

  bool second_counts(const Key& first, const Key& second);
  void range(const Key& key, const toml::table& ends, const std::string& path, std::vector<double>& values);
  void graded(const Key& key, const toml::table& ends, const std::string& path, PerBump& dimension);
  [[nodiscard]] bool has(const Key& key) const { return table_.contains(key.name); }
  [[nodiscard]] std::string advice_on_unknown(const std::string& name, const toml::node& node) const;
  [[nodiscard]] std::string path_of(std::string_view name) const;
  std::pair<const toml::node*, std::string> find(const Key& key);

  ReadingLog& log_;
  const toml::table& root_;
  const toml::table& table_;
  std::string path_{};
  bool inherits_{};  ///< missing values are already set by inheritance
  std::vector<std::string> known_{};
};

}  // namespace bumpfoil
