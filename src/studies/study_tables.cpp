#include "bumpfoil/studies/study_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

/// Columns of `quantities` for a cycle: physical results, not solver statistics.
std::vector<CycleQuantity> quantities_of_cycle() {
  std::vector<CycleQuantity> quantities = cycle_quantities(Experiment::cycle);
  std::erase_if(quantities, [](const CycleQuantity& quantity) {
    return quantity.form.kind != Form::real || quantity.name == "amplitude" || quantity.name == "wall_time";
  });
  return quantities;
}

/// Common to all studies: those of the reference bearing.
const std::vector<double>& clearance_forces() {
  static const std::vector<double> forces = reference_case().settings.get<CycleSettings>().clearance_forces;
  return forces;
}

using Row = std::vector<TableCell>;

/// Appends rows that start with the name of a run and a direction.
using RowWriter = void (*)(const Study&, const StudyRun&, const StudyRunResult&, StudyTable&);

Row row_of(const StudyRun& run, const Cycle& cycle) {
  return {run.name, to_degrees(cycle.direction)};
}

void append(Row& row, std::initializer_list<TableCell> cells) {
  row.insert(row.end(), cells);
}

std::string word_of(ContactMode mode) {
  return std::string(name_of(mode));
}

bool is_closed(ContactMode mode) {
  return mode != ContactMode::open;
}

void write_loops(const Study& /*study*/, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  for (const Cycle& cycle : result.result.cycles) {
    for (const Increment& increment : cycle.increments) {
      Row& row = table.rows.emplace_back(row_of(run, cycle));
      append(row, {increment.index, std::string(name_of(increment.branch)), increment.displacement,
                   increment.force_direct, increment.force_cross});
    }
  }
}

void write_quantities(const Study& study, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  for (const Cycle& cycle : result.result.cycles) {
    Row& row = table.rows.emplace_back(row_of(run, cycle));
    if (!study.parameter.empty()) append(row, {run.parameter ? TableCell(*run.parameter) : TableCell()});
    for (const CycleQuantity& quantity : quantities_of_cycle()) append(row, {quantity.value(cycle, result.input)});
    for (std::size_t i = 0; i < clearance_forces().size(); ++i) append(row, {clearance_of(cycle, i)});
  }
}

void write_loads(const Study& /*study*/, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  for (const Cycle& cycle : result.result.cycles) {
    if (!cycle.turning_point) continue;
    const TurningPoint& turn = *cycle.turning_point;
    for (int bump = 0; bump < result.input.bump_foil.bumps; ++bump) {
      Row& row = table.rows.emplace_back(row_of(run, cycle));
      append(row, {bump + 1, turn.journal_loads[bump], turn.bump_loads[bump]});
    }
  }
}

double height_error(const Case& input, int bump) {
  const std::vector<double>& errors = input.bump_foil.height_errors;
  return errors.empty() ? 0.0 : errors[static_cast<std::size_t>(bump)];
}

/// Height of the crests above the sleeve where they touch the undeformed top foil.
double foil_height(const Case& input) {
  const BumpShape bump = nominal_bump(input.bump_foil);
  return bump.rise + bump.thickness;
}

void write_heights(const Study& /*study*/, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  const Case& input = result.input;
  const Vector theta = crest_angles(input);
  const Eigen::Matrix2Xd normals = outward_normals(polar_angles(input.bearing, theta));
  for (const Cycle& cycle : result.result.cycles) {
    const Vector pushed =
        journal_gaps(input.bearing.radial_clearance, normals, cycle.amplitude * unit_vector(cycle.direction));
    for (int bump = 0; bump < input.bump_foil.bumps; ++bump) {
      const double nominal = foil_height(input);
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
  const double nominal = foil_height(input);
  for (const Cycle& cycle : result.result.cycles) {
    const FoilFields& fields = cycle.fields;
    for (const int i : study.increments) {
      if (i >= fields.increments()) continue;
      const Increment& at = cycle.increments[static_cast<std::size_t>(i)];
      const Vector journal = journal_gaps(input.bearing.radial_clearance, normals, {at.x, at.y});
      const Eigen::Index feet = fields.foot_v.cols() / theta.size();
      for (int bump = 0; bump < input.bump_foil.bumps; ++bump) {
        const Eigen::Index foot = feet * (bump + 1) - 1;
        Row& row = table.rows.emplace_back(row_of(run, cycle));
        append(row, {i, at.displacement, bump + 1, to_degrees(theta[bump]), to_degrees(phi[bump])});
        append(row, {nominal + journal[bump], nominal - fields.top_displacement(i, bump),
                     nominal + height_error(input, bump) - fields.crest_v(i, bump), fields.bump_sleeve.gap(i, foot)});
        append(row, {fields.journal_top.gap(i, bump), fields.top_bump.gap(i, bump), fields.bump_sleeve.gap(i, foot),
                     fields.journal_top.normal_force(i, bump), fields.top_bump.normal_force(i, bump),
                     fields.bump_sleeve.normal_force(i, foot)});
        append(row, {word_of(fields.journal_top.mode(i, bump)), word_of(fields.top_bump.mode(i, bump)),
                     word_of(fields.bump_sleeve.mode(i, foot))});
      }
    }
  }
}

/// Numbers of closed and slipping contacts of an interface, and of those that opened and closed since the previous
/// increment.
void append_counts(const ModeMatrix& modes, Eigen::Index increment, Row& row) {
  int closed = 0;
  int slipping = 0;
  int newly_open = 0;
  int newly_closed = 0;
  for (Eigen::Index i = 0; i < modes.cols(); ++i) {
    const ContactMode mode = modes(increment, i);
    closed += is_closed(mode) ? 1 : 0;
    slipping += mode == ContactMode::slip_forward || mode == ContactMode::slip_backward ? 1 : 0;
    if (increment == 0) continue;
    const bool was_closed = is_closed(modes(increment - 1, i));
    newly_open += !is_closed(mode) && was_closed ? 1 : 0;
    newly_closed += is_closed(mode) && !was_closed ? 1 : 0;
  }
  append(row, {closed, slipping, newly_open, newly_closed});
}

void write_contacts(const Study& /*study*/, const StudyRun& run, const StudyRunResult& result, StudyTable& table) {
  for (const Cycle& cycle : result.result.cycles) {
    for (Eigen::Index i = 0; i < cycle.fields.increments(); ++i) {
      const Increment& now = cycle.increments[static_cast<std::size_t>(i)];
      Row& row = table.rows.emplace_back(row_of(run, cycle));
      append(row, {now.index, std::string(name_of(now.branch)), now.displacement});
      for (const auto interface : {&FoilFields::journal_top, &FoilFields::top_bump, &FoilFields::bump_sleeve}) {
        append_counts((cycle.fields.*interface).mode, i, row);
      }
    }
  }
}

std::vector<std::string> quantity_columns(const Study& study) {
  std::vector<std::string> columns;
  if (!study.parameter.empty()) {
    columns.push_back(study.parameter_unit.empty() ? study.parameter : study.parameter + '_' + study.parameter_unit);
  }
  for (const CycleQuantity& quantity : quantities_of_cycle()) columns.push_back(quantity.key());
  for (const VariableMeaning& clearance : clearance_quantities(clearance_forces())) columns.push_back(clearance.key());
  return columns;
}

/// Columns after run and direction, and the functions that write them.
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
      for (const std::string_view interface : enum_names<Interface>) {
        for (const std::string count : {"closed_", "slipping_", "newly_open_", "newly_closed_"}) {
          columns.push_back(count + std::string(interface));
        }
      }
      return {std::move(columns), write_contacts};
    }
  }
  return {};
}

}  // namespace

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
