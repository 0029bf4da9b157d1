#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// A variable as declared by a file.
struct StoredVariable {
  std::string name;
  int id{};
  int type{};                        ///< netCDF type: NC_DOUBLE, ...
  std::vector<std::string> dims;     ///< names of its dimensions
  std::vector<std::size_t> extents;  ///< sizes of its dimensions
  std::optional<double> fill;        ///< value that marks absent entries
  std::string units;                 ///< empty if not given
  std::string long_name;             ///< description; empty if not given
  std::string flag_meanings;         ///< space-separated words for 0, 1, ...; empty if it holds no flags

  [[nodiscard]] bool has_dims(const std::vector<std::string_view>& names) const;
};

/// A netCDF-4 file in memory whose declarations are not trusted. A few bytes can declare any rank, size and attribute:
/// before each allocation or read, sizes are compared with what a file of this size can hold.
/// | This covers what netCDF reports about a file. libhdf5 parses its structure and may crash on a damaged file: verify
/// checksums first where available.
/// | netCDF is not thread-safe: use from one thread at a time.
class NetcdfImage {
 public:
  /// @param bytes  of the file   @param name  of the file in messages
  /// @throws Error (file), as do all functions, naming file and variable
  NetcdfImage(std::string bytes, std::string name);
  ~NetcdfImage();
  NetcdfImage(const NetcdfImage&) = delete;
  NetcdfImage& operator=(const NetcdfImage&) = delete;

  /// Global text attributes.
  [[nodiscard]] const std::map<std::string, std::string>& texts() const { return texts_; }

  /// All numeric variables; others are errors.
  [[nodiscard]] const std::map<std::string, StoredVariable>& variables() const { return variables_; }

  /// A variable with these dimensions.
  [[nodiscard]] const StoredVariable& variable(const std::string& name,
                                               const std::vector<std::string_view>& dims) const;

  /// Size of a dimension.
  [[nodiscard]] std::size_t size_of(const std::string& dimension) const;

  /// Part of a variable; NaN for what is absent or not finite.
  [[nodiscard]] std::vector<double> numbers(const StoredVariable& variable, const std::vector<std::size_t>& start,
                                            const std::vector<std::size_t>& count) const;

  /// All of a variable.
  [[nodiscard]] std::vector<double> numbers(const StoredVariable& variable) const;

  /// Stops reading with an error of the file and of a variable.
  [[noreturn]] void refuse(std::string_view variable, std::string what) const;

 private:
  void check(int status, std::string_view variable = {}) const;
  void read_dimensions();
  void read_texts();
  /// A text attribute of a variable, or of the file (NC_GLOBAL); nothing if it is missing or not a text.
  [[nodiscard]] std::optional<std::string> read_text(int variable, const char* name) const;
  void read_variables();
  [[nodiscard]] StoredVariable read_variable(int id) const;
  void check_chunks(const StoredVariable& variable) const;
  [[nodiscard]] std::optional<double> read_fill(const StoredVariable& variable) const;

  std::string bytes_;
  std::string name_;
  int id_{};
  std::map<int, std::string> dimension_names_;
  std::map<std::string, std::size_t> dimensions_;
  std::map<std::string, std::string> texts_;
  std::map<std::string, StoredVariable> variables_;
};

}  // namespace bumpfoil
