#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// A variable as a file declares it.
struct StoredVariable {
  std::string name;
  int id{};
  int type{};                        ///< of netCDF: NC_DOUBLE, ...
  std::vector<std::string> dims;     ///< their names
  std::vector<std::size_t> extents;  ///< their sizes
  std::optional<double> fill;        ///< what stands for a value that is absent
  std::string units;                 ///< empty where it says none
  std::string long_name;             ///< what it is, in words; empty where it says nothing
  std::string flag_meanings;         ///< words for 0, 1, ..., with spaces between; empty where it holds no flags

  [[nodiscard]] bool has_dims(const std::vector<std::string_view>& names) const;
};

/// A netCDF-4 file in memory whose declarations are not believed. A few bytes can declare any rank, size and attribute:
/// nothing is allocated or read before it was compared with what a file of this size can hold.
///
/// That holds for what netCDF tells of a file. What it is made of is read by libhdf5, which a damaged file can crash:
/// files with a checksum are to be verified before they come here.
///
/// netCDF is not thread-safe: to be used by one thread at a time.
class NetcdfImage {
 public:
  /// @param bytes  of the file   @param name  of the file in messages
  /// @throws Error (file), as do all functions, naming file and variable
  NetcdfImage(std::string bytes, std::string name);
  ~NetcdfImage();
  NetcdfImage(const NetcdfImage&) = delete;
  NetcdfImage& operator=(const NetcdfImage&) = delete;

  /// Global attributes that are texts.
  [[nodiscard]] const std::map<std::string, std::string>& texts() const { return texts_; }

  /// All that hold numbers; others are faults.
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

  /// Stops reading: what is wrong with the file, and with which of its variables.
  [[noreturn]] void refuse(std::string_view variable, std::string what) const;

 private:
  void check(int status, std::string_view variable = {}) const;
  void read_dimensions();
  void read_texts();
  /// A text of a variable, or of the file (NC_GLOBAL); nothing where there is none or it is no text.
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
