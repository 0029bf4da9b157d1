#pragma once

#include <toml++/toml.h>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Position of a key, and its value, for messages.
struct Origin {
  std::string file;
  std::size_t line{};
  std::string written;
  std::string_view unit_hint{};  ///< of a plain number that may be meant in another unit than SI
  bool implied{};                ///< a table created by an override of its key
};

/// State of reading a case file: its errors, and the positions of its keys.
class ReadingLog {
 public:
  explicit ReadingLog(std::string file) : file_(std::move(file)) {}

  /// Records position and value of a key.
  void met(const std::string& key, const toml::node& node);

  /// Records for a known key that its number may be meant in another unit: the hint for its errors, with {} for the
  /// number. The text must outlive the log.
  void met_unlikely(const std::string& key, std::string_view hint) { origins_[key].unit_hint = hint; }

  /// Adds an error of a key, at the position of the key or of the table that lacks it. Only the first per key is kept.
  void error(const std::string& key, std::string what, std::string advice);

  /// Marks an error of this key as already reported under another one.
  void mark_reported(const std::string& key) { wrong_.insert(key); }

  /// Records that `key` took its value from `other`: its errors are reported there, once.
  void taken_from(const std::string& key, const std::string& other) { taken_from_[key] = other; }

  /// Adds an error found after reading, unless its key, or a parent, already had one.
  void later_error(const InputError& error);

  /// Whether there are no errors so far.
  [[nodiscard]] bool is_sound() const { return errors_.empty(); }

  /// Whether all errors so far are in this table.
  [[nodiscard]] bool is_sound_but_for(const std::string& table) const;

  /// Whether there is an error in this key, or below it.
  [[nodiscard]] bool blames(const std::string& key) const;

  /// Adds an error with its own position.
  void add(InputError error, ErrorKind kind = ErrorKind::input);

  /// Whether further errors are only counted.
  [[nodiscard]] bool full() const;

  [[nodiscard]] const std::string& file() const { return file_; }

  /// @throws Error listing all errors by line, if there are any; of kind `file` if all of them are.
  void throw_if_wrong();

 private:
  [[nodiscard]] const Origin* place_of(const std::string& key) const;

  std::string file_;
  std::vector<InputError> errors_;
  std::size_t unlisted_{};
  bool input_error_{};
  std::map<std::string, Origin> origins_;
  std::set<std::string> wrong_;                    ///< keys with an error during reading
  std::set<std::string> checked_;                  ///< keys with a later error
  std::map<std::string, std::string> taken_from_;  ///< keys whose value was taken from another
};

}  // namespace bumpfoil
