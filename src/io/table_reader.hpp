#pragma once

#include <toml++/toml.h>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/io/units.hpp"

namespace bumpfoil {

/// Where a key was met, and what it was given, for messages.
struct Origin {
  std::string file;
  std::size_t line{};
  std::string written;
  bool degrees{};  ///< an angle without a unit, of so many radians that degrees may be meant
};

/// What is known while a case file is read: its faults, and where its keys stand.
class ReadingLog {
 public:
  explicit ReadingLog(std::string file) : file_(std::move(file)) {}

  /// Remembers where a key stands and what it was given.
  void met(const std::string& key, const toml::node& node);

  /// Remembers of a key that was met that its number may be meant in degrees.
  void met_degrees(const std::string& key) { origins_[key].degrees = true; }

  /// A fault of a key, placed where the key, or the table that lacks it, stands.
  void fault(const std::string& key, std::string what, std::string advice);

  /// The value of `key` was taken from `other`, where its faults are to be reported, once.
  void taken_from(const std::string& key, const std::string& other) { taken_from_[key] = other; }

  /// A fault found after reading, dropped if its key, or what holds it, was at fault before.
  void later_fault(const Fault& fault);

  /// A fault with its own place.
  void add(Fault fault, ErrorKind kind = ErrorKind::input);

  /// Whether further faults are only counted.
  [[nodiscard]] bool full() const;

  [[nodiscard]] const std::string& file() const { return file_; }

  /// @throws Error listing all faults in the order of the lines, if there are any; of the kind `file` if each of them
  /// was.
  void throw_if_faulty();

 private:
  [[nodiscard]] const Origin* place_of(const std::string& key) const;

  std::string file_;
  std::vector<Fault> faults_;
  std::size_t unlisted_{};
  bool input_fault_{};
  std::map<std::string, Origin> origins_;
  std::set<std::string> faulty_;                   ///< keys that had a fault while they were read
  std::set<std::string> judged_;                   ///< keys that had one later
  std::map<std::string, std::string> taken_from_;  ///< keys whose value stands under another one
};

enum class Presence { required, optional };

/// Takes the values of one table out of a case file. Whatever is wrong goes into the log; what was asked for is then
/// left as it was.
class TableReader {
 public:
  /// `node` may be null: the table is missing. The root has an empty path.
  TableReader(ReadingLog& log, const toml::node* node, std::string path);

  [[nodiscard]] bool missing() const { return missing_; }
  [[nodiscard]] bool present() const { return table_ != nullptr; }
  [[nodiscard]] bool has(std::string_view key) const { return table_ != nullptr && table_->contains(key); }
  [[nodiscard]] std::string path_of(std::string_view key) const;

  /// Dimensioned value: a string with a unit, or a number in SI.
  void quantity(std::string_view key, double& value, Dimension dimension, Presence presence);
  void quantity(std::string_view key, std::optional<double>& value, Dimension dimension);
  /// Optional dimensioned value that may measure one of two things; a plain number means what `dimension` says. On
  /// return `dimension` is that of the value.
  void quantity(std::string_view key, double& value, Dimension& dimension, Dimension one, Dimension other);
  void number(std::string_view key, double& value, Presence presence);
  void integer(std::string_view key, int& value, Presence presence);
  void flag(std::string_view key, bool& value);
  /// @return whether there is a text
  bool text(std::string_view key, std::string& value);
  /// List of dimensioned values. Entries found in `names` stand for theirs. Entries that are faulty are zero.
  void quantities(std::string_view key, std::vector<double>& values, Dimension dimension, Presence presence,
                  const std::map<std::string, double, std::less<>>& names = {});

  /// One of a few words.
  template <typename Enum, std::size_t N>
  void choice(std::string_view key, Enum& value, const std::array<std::pair<std::string_view, Enum>, N>& names) {
    std::vector<std::string> words;
    for (const auto& [word, meaning] : names) words.emplace_back(word);
    if (const int index = index_of_word(key, words); index >= 0) value = names[static_cast<std::size_t>(index)].second;
  }

  /// A table inside this one.
  TableReader table(std::string_view key);

  /// Reports every key that nobody asked for. To be called last.
  void finish();

 private:
  const toml::node* find(std::string_view key, Presence presence);
  int index_of_word(std::string_view key, const std::vector<std::string>& words);
  bool read_quantity(const std::string& path, const toml::node& node, double& value, Dimension dimension,
                     const std::string& alternatives = {});

  ReadingLog& log_;
  bool missing_;
  const toml::table* table_{};
  std::string path_;
  std::vector<std::string> known_;
};

}  // namespace bumpfoil
