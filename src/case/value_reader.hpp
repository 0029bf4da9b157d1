#pragma once

#include <toml++/toml.h>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/control.hpp"
#include "case/reading_log.hpp"
#include "case/units.hpp"

namespace bumpfoil {

/// A word for a number.
using NamedNumber = std::pair<std::string_view, double>;

/// Maximum number of texts in a list.
inline constexpr int most_texts = 1000;

/// Error of a node whose type differs from the expected one, "a list".
std::string is_where(const toml::node& node, std::string_view due);

/// Reads the content of a key into its value; errors go into the log.
struct ValueReader {
  ReadingLog& log;
  const std::string& path;
  const toml::node& node;
  std::optional<Dimension> dimension{};
  std::string alternatives{};  ///< alternatives to mention in messages

  void operator()(std::string* value) const;
  void operator()(bool* value) const;
  void operator()(int* value) const;
  void operator()(double* value) const;
  void operator()(std::optional<double>* value) const;
  void operator()(PerBump* value) const;
  void operator()(FormedRadius* value) const;

  /// Wrong entries become zero.
  void operator()(std::vector<double>* value) const;

  /// Texts in a list, or a single one.
  void operator()(std::vector<std::string>* value) const;

  /// A list of angles; "+X", "+Y", "-X" and "-Y" are accepted.
  void directions(std::vector<double>& angles) const;

 private:
  void refuse(std::string_view due, std::string advice) const;
  void read_list(std::vector<double>& values, std::span<const NamedNumber> names) const;
};

/// The kind implied by the unit of a text; absent for a plain number, or a text that is neither.
std::optional<Control> control_of(const toml::node& node);

/// A length or a force.
void read_target(ReadingLog& log, const std::string& path, const toml::node& node, Control control, double& value);

/// The two entries of a vector in the X-Y plane; null if invalid, with an error in the log.
const toml::array* plane_vector(ReadingLog& log, const std::string& path, const toml::node& node,
                                std::string_view example);

/// A list of two entries, along X and Y; absent if invalid.
std::optional<PlaneTarget> read_place(ReadingLog& log, const std::string& path, const toml::node& node, Control plain,
                                      std::string_view example);

/// A list of such targets, all positions or all loads.
void read_places(ReadingLog& log, const std::string& path, const toml::node& node, std::string_view example,
                 PathPoints& points);

}  // namespace bumpfoil
