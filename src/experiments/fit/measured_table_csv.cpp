#include "experiments/fit/measured_table_csv.hpp"

#include <fmt/format.h>

#include <utility>

#include "case/csv_lines.hpp"
#include "case/csv_rows.hpp"
#include "case/named_columns.hpp"
#include "case/text_file.hpp"
#include "experiments/fit/fit_columns.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view table_option = "columns";

/// Whether files must have the column.
bool is_demanded(const FitColumnInfo& info, const FitData& data) {
  return info.measured ? data.column(info.column).std.has_value()
                       : info.column == FitColumn::amplitude || info.column == FitColumn::speed;
}

class TableOfReadings {
 public:
  TableOfReadings(const std::string& path, FitData& data) : rows_(path), data_(data) {
    std::vector<std::pair<std::string_view, std::string*>> keys;
    for (const FitColumnInfo& info : fit_columns()) {
      if (!info.is_of(data.experiment)) continue;
      infos_.push_back(&info);
      keys.emplace_back(info.name(), &given_.at(static_cast<std::size_t>(info.column)));
    }
    parse_column_names(
        data.columns, keys, table_option,
        data.experiment == FittedExperiment::vibration ? "amplitude=NAME,stiffness=NAME" : "speed=NAME,torque=NAME");
  }

  void read_line(std::size_t line, std::string_view text) {
    if (is_csv_remark(text)) return;
    if (!rows_.has_header()) return read_header(line, text);
    if (rows_.has_errors() && columns_.empty()) return;
    const std::vector<std::string> cells = rows_.read(line, text);
    if (cells.empty()) return;
    ++count_;
    for (const auto& [info, column] : columns_) {
      const std::optional<double> number = numbers_.read(cells[column.index]);
      if (!number) {
        return rows_.error(line, text, numbers_.what(info->name(), rows_.dialect()),
                           "give all without a unit, with one decimal sign; rows that lack a number go into data of "
                           "their own");
      }
      data_.column(info->column).values.push_back(*number * column.unit.size);
    }
  }

  void finish() {
    if (count_ == 0 && !rows_.has_errors())
      rows_.error("contains no row", "write a line for each place of measurement");
    rows_.throw_if_wrong();
  }

 private:
  void read_header(std::size_t line, std::string_view text) {
    const std::vector<std::string> names = rows_.read_header(text);
    for (const FitColumnInfo* const info : infos_) {
      const bool demanded = is_demanded(*info, data_);
      if (info->measured && !demanded) continue;  // not fitted
      WantedColumn wanted{
          .key = info->name(), .dimension = info->dimension, .unit = info->csv_unit, .optional = !demanded};
      wanted.names.push_back(info->name());
      for (const std::string_view name : info->other_names) {
        if (!name.empty()) wanted.names.push_back(name);
      }
      const std::string& given = given_.at(static_cast<std::size_t>(info->column));
      if (auto found = find_named_column(rows_, line, text, names, wanted, given, table_option)) {
        columns_.emplace_back(info, std::move(*found));
      }
    }
    if (rows_.has_errors()) columns_.clear();
  }

  CsvRows rows_;
  FitData& data_;
  CsvNumbers numbers_;
  std::vector<const FitColumnInfo*> infos_;
  std::array<std::string, enum_names<FitColumn>.size()> given_;
  std::vector<std::pair<const FitColumnInfo*, NamedColumn>> columns_;
  std::size_t count_{};
};

}  // namespace

void read_measured_table(const std::string& path, FitData& data) {
  const std::string text = read_text_file(path);
  TableOfReadings table(path, data);
  for_each_line(text, [&table](std::size_t line, std::string_view content) { table.read_line(line, content); });
  table.finish();
}

}  // namespace bumpfoil
