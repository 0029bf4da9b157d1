#include "experiments/cycle/measured_loops_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/csv_dialect.hpp"
#include "case/csv_lines.hpp"
#include "case/csv_rows.hpp"
#include "case/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::array named_axes{std::pair{"+X", 0.0}, std::pair{"+Y", 90.0}, std::pair{"-X", 180.0},
                                std::pair{"-Y", 270.0}};

/// Columns named in messages.
constexpr std::size_t most_named = 12;

/// A column that every file has.
struct Wanted {
  std::string_view key;  ///< in --columns
  Dimension dimension{};
  std::string_view unit;                ///< in advice
  std::vector<std::string_view> names;  ///< that rigs and testing machines give it, the first preferred
};

const Wanted wanted_displacement{
    "displacement",
    Dimension::length,
    "um",
    {"displacement", "disp", "deflection", "travel", "stroke", "position", "Weg", "Auslenkung", "Verschiebung"}};
const Wanted wanted_force{"force", Dimension::force, "N", {"force", "load", "load cell", "F", "Kraft", "Last"}};

struct MeasuredColumn {
  std::size_t index{};
  ColumnUnit unit{};
};

/// The columns that may be the one that is wanted: of the first name that any has.
std::vector<MeasuredColumn> by_known_names(const std::vector<std::string>& columns, const Wanted& wanted) {
  std::vector<MeasuredColumn> found;
  for (const std::string_view name : wanted.names) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (auto unit = unit_of_column(columns[i], name, wanted.dimension)) found.push_back({i, std::move(*unit)});
    }
    if (!found.empty()) break;
  }
  return found;
}

/// Those of a name that is given, with the unit of the file or with one that is given behind the name.
std::vector<MeasuredColumn> by_given_name(const std::vector<std::string>& columns, const std::string& given,
                                          Dimension dimension) {
  const std::string name = given.substr(0, given.find_last_of("([_ \t"));
  const std::optional<ColumnUnit> unit = unit_of_column(given, name, dimension);
  std::vector<MeasuredColumn> found;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool same = is_column(columns[i], given) || is_column(columns[i], name);
    if (auto of_file = unit_of_column(columns[i], given, dimension)) {
      found.push_back({i, std::move(*of_file)});
    } else if (unit && same) {
      found.push_back({i, *unit});
    }
  }
  return found;
}

/// Takes the lines one by one.
class LoopsReader {
 public:
  LoopsReader(const std::string& path, std::string at_column, MeasuredColumns columns, const std::string& at)
      : rows_(path), at_column_(std::move(at_column)), given_(std::move(columns)) {
    if (at.empty()) return;
    given_at_ = place(at);
    numbers_ = {};  // the decimal sign of the file may be another
    if (!given_at_)
      rows_.fault(fmt::format("is assigned to the {} {}, which does not exist", at_column_, at), at_advice());
  }

  void read_line(std::size_t line, std::string_view text) {
    if (is_csv_remark(text)) return;
    if (!rows_.has_header()) return read_header(line, text);
    if (!displacement_ || !force_) return;  // without them nothing is known of the rest
    const std::vector<std::string> cells = rows_.read(line, text);
    if (cells.empty()) return;
    const auto no_number = [&](const char* quantity) {
      rows_.fault(line, text, numbers_.what(quantity, rows_.dialect()),
                  "give all without a unit, with one decimal sign");
    };
    const std::optional<double> displacement = numbers_.read(cells[displacement_->index]);
    if (!displacement) return no_number("displacement");
    const std::optional<double> force = numbers_.read(cells[force_->index]);
    if (!force) return no_number("force");
    std::optional<double> at = given_at_;
    if (at_) {
      at = place(cells[*at_]);
      if (!at) return rows_.fault(line, text, fmt::format("has no {}", at_column_), at_advice());
    }
    points_at(at).push_back({*displacement * displacement_->unit.size, *force * force_->unit.size});
  }

  /// @throws Error (input) if there was a fault
  std::vector<MeasuredLoop> finish() {
    if (points_.empty() && !rows_.faulty()) {
      rows_.fault("contains no loop", "write displacement_um,force_N and a line for each point of the loop");
    }
    std::vector<MeasuredLoop> loops;
    const bool faulty = rows_.faulty();
    for (const auto& [at, points] : points_) {
      if (faulty) break;
      if (auto cycle = last_cycle(points)) {
        loops.push_back({at, std::move(*cycle)});
      } else {
        rows_.fault(fmt::format("{} {} does not go to a displacement and back", at ? at_column_ : "the loop",
                                at ? fmt::format("{}", *at) : "in it"),
                    "give its points in the order of measurement, displacements positive towards the foils");
      }
    }
    rows_.throw_if_faulty();
    return loops;
  }

 private:
  void read_header(std::size_t line, std::string_view text) {
    const std::vector<std::string> names = rows_.read_header(text);
    displacement_ = find_column(line, text, names, wanted_displacement, given_.displacement);
    force_ = find_column(line, text, names, wanted_force, given_.force);
    const std::string& at_name = given_.at.empty() ? at_column_ : given_.at;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_column(names[i], at_name) || is_column(names[i], at_name + "_deg")) at_ = i;
    }
    if (!at_ && !given_.at.empty())
      rows_.fault(line, text, missing(given_.at, names), "name one of these in --columns");
    if (at_ && given_at_) {
      rows_.fault(line, text, fmt::format("has a column {}", names[*at_]),
                  fmt::format("leave out the {} after the file name", at_column_));
    }
  }

  [[nodiscard]] std::string missing(std::string_view what, const std::vector<std::string>& columns) const {
    const std::size_t named = std::min(columns.size(), most_named);
    return fmt::format("has no {} among its {} columns, separated by {}: \"{}\"{}", what, columns.size(),
                       rows_.dialect().name,
                       fmt::join(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(named), "\", \""),
                       named < columns.size() ? ", ..." : "");
  }

  std::optional<MeasuredColumn> find_column(std::size_t line, std::string_view text,
                                            const std::vector<std::string>& columns, const Wanted& wanted,
                                            const std::string& given) {
    std::vector<MeasuredColumn> found =
        given.empty() ? by_known_names(columns, wanted) : by_given_name(columns, given, wanted.dimension);
    if (found.size() == 1) return std::move(found.front());
    const std::string choice = fmt::format("--columns '{}=NAME [{}]'", wanted.key, wanted.unit);
    if (!found.empty()) {
      rows_.fault(line, text, fmt::format("has {} columns of the {}", found.size(), wanted.key),
                  fmt::format("specify which one: {}", choice));
    } else if (!given.empty()) {
      rows_.fault(line, text, missing(given, columns),
                  fmt::format("give one of these names, followed by its unit if the file has none: {}", choice));
    } else {
      std::vector<std::string> understood;
      for (const std::string_view name : wanted.names) understood.push_back(fmt::format("{}_{}", name, wanted.unit));
      rows_.fault(line, text, missing(understood.front(), columns),
                  fmt::format("{}; recognised names, followed by any unit: {}; for another name use {}",
                              column_advice(columns, understood, wanted.dimension,
                                            fmt::format("name a column {}", understood.front())),
                              fmt::join(wanted.names, ", "), choice));
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string at_advice() const {
    return at_column_ == "cycle" ? "write 1, 2, ..." : "write +X, -X, +Y, -Y or an angle in degrees";
  }

  std::optional<double> place(std::string_view cell) {
    const auto axis =
        std::find_if(named_axes.begin(), named_axes.end(), [cell](const auto& one) { return one.first == cell; });
    if (at_column_ != "cycle" && axis != named_axes.end()) return axis->second;
    return numbers_.read(cell);
  }

  std::vector<LoadingCurve::Point>& points_at(const std::optional<double>& at) {
    const auto found =
        std::find_if(points_.begin(), points_.end(), [&at](const auto& some) { return some.first == at; });
    if (found != points_.end()) return found->second;
    return points_.emplace_back(at, std::vector<LoadingCurve::Point>{}).second;
  }

  CsvRows rows_;
  std::string at_column_;
  MeasuredColumns given_;
  std::vector<std::pair<std::optional<double>, std::vector<LoadingCurve::Point>>> points_;
  CsvNumbers numbers_;
  std::optional<double> given_at_;
  std::optional<std::size_t> at_;
  std::optional<MeasuredColumn> displacement_;
  std::optional<MeasuredColumn> force_;
};

}  // namespace

MeasuredColumns parse_measured_columns(std::string_view text) {
  MeasuredColumns columns;
  const std::array keys{std::pair{"displacement=", &columns.displacement}, std::pair{"force=", &columns.force},
                        std::pair{"direction=", &columns.at}, std::pair{"cycle=", &columns.at}};
  std::string* value = nullptr;
  while (!text.empty()) {
    const std::string_view part = trimmed(text.substr(0, text.find(',')));
    const auto key =
        std::find_if(keys.begin(), keys.end(), [part](const auto& one) { return part.starts_with(one.first); });
    if (key != keys.end()) {
      value = key->second;
      *value = part.substr(std::string_view(key->first).size());
    } else if (value) {
      *value += fmt::format(",{}", part);  // the name of a column has a comma
    } else {
      throw Error(ErrorKind::input, {{"", 0, "--columns", std::string(text), "does not start with the kind of column",
                                      "write displacement=NAME,force=NAME,direction=NAME, or some of these"}});
    }
    text.remove_prefix(std::min(text.size(), text.find(',')));
    if (!text.empty()) text.remove_prefix(1);
  }
  for (const auto& [key, name] : keys) std::erase(*name, '"');
  return columns;
}

std::vector<MeasuredLoop> read_measured_loops(const std::string& path, const std::string& at_column,
                                              const MeasuredColumns& columns, const std::string& at) {
  const std::string text = read_text_file(path);
  LoopsReader reader(path, at_column, columns, at);
  for_each_line(text, [&reader](std::size_t line, std::string_view content) { reader.read_line(line, content); });
  return reader.finish();
}

}  // namespace bumpfoil
