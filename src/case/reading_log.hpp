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

/// Where a key was found, and its value, for messages.
struct Origin {
  std::string file;
  std::size_t line{};
  std::string written;
  std::string_view unit_hint{};  ///< of a plain number that may be meant in another unit than that of SI
  bool implied{};                ///< a table that an override made for its key
};

/// State while a case file is read: its errors, and the positions of its keys.
class ReadingLog {
 public:
  explicit ReadingLog(std::string file) : file_(std::move(file)) {}

  /// Records where a key is and its value.
  void met(const std::string& key, const toml::node& node);

  /// Remembers of a key that was met that its number may be meant in another unit: what its faults are to say of that,
  /// where {} stands for the number. The text must stay.
  void met_unlikely(const std::string& key, std::string_view hint) { origins_[key].unit_hint = hint; }

  /// An error of a key, at the place of the key or of the table that lacks it. Only the first one of a key counts.
  void fault(const std::string& key, std::string what, std::string advice);

  /// An error of this key was reported under another one.
  void told(const std::string& key) { faulty_.insert(key); }

  /// The value of `key` was taken from `other`, where its faults are to be reported, once.
  void taken_from(const std::string& key, const std::string& other) { taken_from_[key] = other; }

  /// A fault found after reading, dropped if its key, or what holds it, was at fault before.
  void later_fault(const Fault& fault);

  /// Whether nothing is wrong so far.
  [[nodiscard]] bool is_sound() const { return faults_.empty(); }

  /// Whether all that is wrong so far lies in this table.
  [[nodiscard]] bool is_sound_but_for(const std::string& table) const;

  /// Whether something is wrong with this key, or in it.
  [[nodiscard]] bool blames(const std::string& key) const;

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

}  // namespace bumpfoil
