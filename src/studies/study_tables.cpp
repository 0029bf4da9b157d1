#include "bumpfoil/studies/study_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "bumpfoil/model/geometry.hpp"
#include "io/result_columns.hpp"

namespace bumpfoil {
namespace {

/// What `quantities` has of a cycle: the time that it took says nothing about the bearing.
std::vector<CycleColumn> quantities_of_cycle() {
  std::vector<CycleColumn> columns;
  std::copy_if(cycle_columns().begin(), cycle_columns().end(), std::back_inserter(columns),
               [](const CycleColumn& column) { return column.name != "wall_time"; });
  return columns;
}

using Row = std::vector<TableCell>;

/// Appends rows that begin with the name of a run and a direction.
using RowWriter = void (*)(const Study&, const StudyRun&, const StudyRunResult&, StudyTable&);

Row row_of(const StudyRun& run, const Cycle& cycle) {
  return {run.name, to_degrees(cycle.direction)};
}

void append(Row& row, std::initializer_list<TableCell> cells) {
  row.insert(row.end(), cells);
}

void append(Row& row, const std::optional<double>& number) {
  TableCell& cell = row.emplace_back();
  if (number) cell = *number;
}

std::string_view branch_name(const Increment& increment) {
  return increment.branch == Branch::loading ? "loading" : "unloading";
}

std::string mode_name(ContactMode mode) {
  switch (mode) {
    case ContactMode::open:
      return "open";
    case ContactMode::stick:
      return "stick";
    case ContactMode::slip_forward:
      return "slip_forward";
    case ContactMode::slip_backward:
      return "slip_backward";
  }
  return "";
}

bool is_closed(ContactMode mode) {
  return mode != ContactMode::open;
}

void write_loops(const Study& /*study*/, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  for (const Cycle& cycle : result.result.cycles) {
    for (const Increment& increment : cycle.increments) {
      Row& row = table.rows.emplace_back(row_of(run, cycle));
      append(row, {increment.index, std::string(branch_name(increment)), increment.displacement, increment.force_direct,
                   increment.force_cross});
    }
  }
}

void write_quantities(const Study& study, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  for (const Cycle& cycle : result.result.cycles) {
    Row& row = table.rows.emplace_back(row_of(run, cycle));
    if (!study.parameter.empty()) append(row, run.parameter);
    for (const CycleColumn& column : quantities_of_cycle()) {
      append(row, column.value(cycle));
    }
  }
}

void write_loads(const Study& /*study*/, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  for (const Cycle& cycle : result.result.cycles) {
    if (!cycle.turning_point) continue;
    const Increment& increment = cycle.at_turning_point();
    for (int bump = 0; bump < result.input.bump_foil.bumps; ++bump) {
      Row& row = table.rows.emplace_back(row_of(run, cycle));
      append(row, {bump + 1, increment.journal_top.normal_force[bump], increment.top_bump.normal_force[bump]});
    }
  }
}

double height_error(const Case& input, int bump) {
  const std::vector<double>& errors = input.bump_foil.height_errors;
  return errors.empty() ? 0.0 : errors[static_cast<std::size_t>(bump)];
}

/// Height of the crests over the sleeve where they touch the undeformed top foil.
double nominal_height(const Case& input) {
  return nominal_bump(input.bump_foil).rise + input.bump_foil.thickness;
}

void write_heights(const Study& /*study*/, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  const Case& input = result.input;
  const Vector theta = crest_angles(input);
  const Eigen::Matrix2Xd normals = outward_normals(polar_angles(input.bearing, theta));
  for (const Cycle& cycle : result.result.cycles) {
    const Vector pushed =
        journal_gaps(input.bearing.radial_clearance, normals, cycle.amplitude * unit_vector(cycle.direction));
    for (int bump = 0; bump < input.bump_foil.bumps; ++bump) {
      const double nominal = nominal_height(input);
      Row& row = table.rows.emplace_back(row_of(run, cycle));
      append(row, {bump + 1, to_degrees(theta[bump]), height_error(input, bump), nominal + height_error(input, bump),
                   nominal + input.bearing.radial_clearance, nominal + pushed[bump]});
    }
  }
}

void write_foils(const Study& study, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  const Case& input = result.input;
  const Vector theta = crest_angles(input);
  const Vector phi = polar_angles(input.bearing, theta);
  const Eigen::Matrix2Xd normals = outward_normals(phi);
  const double nominal = nominal_height(input);
  for (const Cycle& cycle : result.result.cycles) {
    for (const int index : study.increments) {
      if (index >= static_cast<int>(cycle.increments.size())) continue;
      const Increment& at = cycle.increments[static_cast<std::size_t>(index)];
      const Vector journal = journal_gaps(input.bearing.radial_clearance, normals, {at.x, at.y});
      const Eigen::Index feet = at.foot_v.size() / theta.size();
      for (int bump = 0; bump < input.bump_foil.bumps; ++bump) {
        const Eigen::Index foot = feet * (bump + 1) - 1;
        const auto place = static_cast<std::size_t>(bump);
        Row& row = table.rows.emplace_back(row_of(run, cycle));
        append(row, {index, at.displacement, bump + 1, to_degrees(theta[bump]), to_degrees(phi[bump])});
        append(row, {nominal + journal[bump], nominal - at.top_displacement[bump],
                     nominal + height_error(input, bump) - at.crest_v[bump], at.bump_sleeve.gap[foot]});
        append(row, {at.journal_top.gap[bump], at.top_bump.gap[bump], at.bump_sleeve.gap[foot]});
        append(row,
               {at.journal_top.normal_force[bump], at.top_bump.normal_force[bump], at.bump_sleeve.normal_force[foot]});
        append(row, {mode_name(at.journal_top.mode[place]), mode_name(at.top_bump.mode[place]),
                     mode_name(at.bump_sleeve.mode[static_cast<std::size_t>(foot)])});
      }
    }
  }
}

/// Closed and slipping contacts of an interface, and those that opened and closed since the increment before.
void append_counts(const InterfaceFields& now, const InterfaceFields* before, Row& row) {
  int closed = 0;
  int slipping = 0;
  int newly_open = 0;
  int newly_closed = 0;
  for (std::size_t i = 0; i < now.mode.size(); ++i) {
    const ContactMode mode = now.mode[i];
    closed += is_closed(mode) ? 1 : 0;
    slipping += mode == ContactMode::slip_forward || mode == ContactMode::slip_backward ? 1 : 0;
    if (before == nullptr) continue;
    newly_open += !is_closed(mode) && is_closed(before->mode[i]) ? 1 : 0;
    newly_closed += is_closed(mode) && !is_closed(before->mode[i]) ? 1 : 0;
  }
  append(row, {closed, slipping, newly_open, newly_closed});
}

void write_contacts(const Study& /*study*/, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  for (const Cycle& cycle : result.result.cycles) {
    const Increment* before = nullptr;
    for (const Increment& now : cycle.increments) {
      Row& row = table.rows.emplace_back(row_of(run, cycle));
      append(row, {now.index, std::string(branch_name(now)), now.displacement});
      for (const auto interface : {&Increment::journal_top, &Increment::top_bump, &Increment::bump_sleeve}) {
        append_counts(now.*interface, before == nullptr ? nullptr : &(before->*interface), row);
      }
      before = &now;
    }
  }
}

std::vector<std::string> quantity_columns(const Study& study) {
  std::vector<std::string> columns;
  if (!study.parameter.empty()) {
    columns.push_back(study.parameter_unit.empty() ? study.parameter : study.parameter + '_' + study.parameter_unit);
  }
  for (const CycleColumn& column : quantities_of_cycle()) columns.push_back(name_with_unit(column.name, column.unit));
  return columns;
}

/// Columns after run and direction, and who fills them.
std::pair<std::vector<std::string>, RowWriter> layout(StudyTableKind kind, const Study& study) {
  switch (kind) {
    case StudyTableKind::loops:
      return {{"increment", "branch", "displacement_m", "force_direct_N", "force_cross_N"}, write_loops};
    case StudyTableKind::quantities:
      return {quantity_columns(study), write_quantities};
    case StudyTableKind::loads:
      return {{"bump", "journal_load_N", "bump_load_N"}, write_loads};
    case StudyTableKind::heights:
      return {{"bump", "theta_deg", "height_error_m", "height_m", "journal_centred_m", "journal_pushed_m"},
              write_heights};
    case StudyTableKind::foils:
      return {{"increment", "displacement_m", "bump", "theta_deg", "phi_deg", "journal_height_m", "top_foil_height_m",
               "crest_height_m", "foot_height_m", "gap_journal_top_m", "gap_top_bump_m", "gap_bump_sleeve_m",
               "normal_force_journal_top_N", "normal_force_top_bump_N", "normal_force_bump_sleeve_N",
               "state_journal_top", "state_top_bump", "state_bump_sleeve"},
              write_foils};
    case StudyTableKind::contacts: {
      std::vector<std::string> columns{"increment", "branch", "displacement_m"};
      for (const std::string interface : {"journal_top", "top_bump", "bump_sleeve"}) {
        for (const std::string count : {"closed_", "slipping_", "newly_open_", "newly_closed_"}) {
          columns.push_back(count + interface);
        }
      }
      return {std::move(columns), write_contacts};
    }
  }
  return {};
}

}  // namespace

std::string_view name_of(StudyTableKind kind) {
  switch (kind) {
    case StudyTableKind::loops:
      return "loops";
    case StudyTableKind::quantities:
      return "quantities";
    case StudyTableKind::loads:
      return "loads";
    case StudyTableKind::heights:
      return "heights";
    case StudyTableKind::foils:
      return "foils";
    case StudyTableKind::contacts:
      return "contacts";
  }
  return "";
}

StudyTable make_study_table(StudyTableKind kind, const Study& study, const std::vector<StudyRunResult>& results) {
  const auto [columns, write] = layout(kind, study);
  StudyTable table{.name = std::string(name_of(kind)), .columns = {"run", "direction_deg"}, .rows = {}};
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  for (std::size_t i = 0; i < results.size(); ++i) write(study, study.runs[i], results[i], table);
  return table;
}

std::string table_csv(const StudyTable& table) {
  std::string out = fmt::format("{}\n", fmt::join(table.columns, ","));
  const auto append_cell = [&out](const TableCell& cell) {
    if (const auto* whole = std::get_if<int>(&cell)) fmt::format_to(std::back_inserter(out), "{}", *whole);
    if (const auto* word = std::get_if<std::string>(&cell)) out += *word;
    if (const auto* number = std::get_if<double>(&cell); number != nullptr && std::isfinite(*number)) {
      fmt::format_to(std::back_inserter(out), "{:.17g}", *number);
    }
  };
  for (const std::vector<TableCell>& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out += ',';
      append_cell(row[i]);
    }
    out += '\n';
  }
  return out;
}

}  // namespace bumpfoil
