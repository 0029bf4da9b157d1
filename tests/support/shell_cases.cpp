#include "support/shell_cases.hpp"

#include <cmath>
#include <numbers>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "support/bonded_foils.hpp"
#include "support/json_data.hpp"

namespace bumpfoil {
namespace {

constexpr int columns_per_pitch = 6;

const nlohmann::json& shell_file() {
  static const nlohmann::json parsed = json_data("fe/shells.json");
  return parsed;
}

/// An array of arrays; none if there is no such key.
Matrix read_lines(const nlohmann::json& row, const std::string& key) {
  if (!row.contains(key)) return {};
  const nlohmann::json& lines = row.at(key);
  Matrix matrix(static_cast<Eigen::Index>(lines.size()), static_cast<Eigen::Index>(lines.at(0).size()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    matrix.row(i) = to_vector(lines.at(static_cast<std::size_t>(i))).transpose();
  }
  return matrix;
}

BearingModel bearing_of(int bumps, int modes, WidthPart width, SheetModel sheet = {}) {
  Case input = reference_case();
  input.bump_foil.bumps = bumps;
  input.bump_foil.model = BumpFoilModel::frame;
  return make_film_bearing(
      make_foils(input), gas_of(input.gas),
      {.columns_per_pitch = columns_per_pitch, .rows = 32, .width_modes = modes, .sheet = sheet, .width = width});
}

/// P under a lobe of 1 bar. @param middle, extent  rad
Matrix lobe(const BearingModel& bearing, double middle, double extent) {
  const FilmMesh& mesh = bearing.film->pads.front().foil.mesh;
  const double peak = 1e5 / bearing.film->scales.gas.ambient_pressure;
  const Vector theta = mesh.angles();
  Matrix pressure = mesh.field(1.0);
  for (int k = 0; k < mesh.nodes(); ++k) {
    const double part = (theta[k] - middle) / extent;
    if (std::abs(part) > 0.5) continue;
    for (int j = 0; j <= mesh.rows; ++j) {
      pressure(j, k) += peak * std::cos(std::numbers::pi * part) * (1.0 - mesh.zeta(j) * mesh.zeta(j));
    }
  }
  return pressure;
}

/// Displacements at shell_zeta(), a row for each of these columns.
Matrix displacements(const BearingModel& bearing, const BondedAnswer& answer, const std::vector<int>& columns) {
  const std::vector<double>& zeta = shell_zeta();
  Matrix w(static_cast<Eigen::Index>(columns.size()), static_cast<Eigen::Index>(zeta.size()));
  for (Eigen::Index j = 0; j < w.cols(); ++j) {
    const Vector shapes = bearing.film->pads.front().foil.lines.shapes(zeta[static_cast<std::size_t>(j)]);
    for (Eigen::Index i = 0; i < w.rows(); ++i) {
      w(i, j) = shapes.dot(answer.deflection.col(columns[static_cast<std::size_t>(i)]));
    }
  }
  return w;
}

/// Columns in the middle of the spans behind bumps, counted from 1.
std::vector<int> spans_behind(int first, int last) {
  std::vector<int> columns;
  for (int bump = first; bump <= last; ++bump) columns.push_back(columns_per_pitch * bump);
  return columns;
}

double extent_in_file() {
  return shell_file().at("extent_rad");
}

ShellNumbers held_crests(int modes) {
  const BearingModel bearing = bearing_of(26, modes, WidthPart::half);
  const BondedAnswer answer = bonded_answer(
      bearing, {.pressure = lobe(bearing, std::numbers::pi, extent_in_file()),
                .crest_lift = Matrix::Zero(bearing.film->pads.front().foil.lines.count(), bearing.bumps())});
  return {.crest_w = {}, .span_w = displacements(bearing, answer, spans_behind(11, 15)), .moments = {}};
}

ShellNumbers nine_bumps(bool feet_slide, int modes, SheetModel sheet) {
  const BearingModel bearing = bearing_of(9, 1, WidthPart::half);
  const FoilFilm& foil = bearing.film->pads.front().foil;
  const double fifth_crest = foil.mesh.angles()[foil.supports[4]];
  return press_bumps(
      {.bumps = 9, .middle = fifth_crest, .extent = extent_in_file(), .feet_slide = feet_slide, .sheet = sheet}, modes);
}

ShellNumbers tilted(bool feet_slide, int modes) {
  const BearingModel bearing = bearing_of(9, modes, WidthPart::whole);
  const FoilFilm& foil = bearing.film->pads.front().foil;
  const Vector at_crests = foil.mesh.angles()(foil.supports);
  const Vector outward = 0.5 * shell_file().at("tilt_m").get<double>() * (at_crests.array() - at_crests[4]).cos();
  const BondedAnswer answer = bonded_answer(bearing, {.feet_slide = feet_slide,
                                                      .pressure = foil.mesh.field(1.0),
                                                      .crest_lift = foil.lines.zeta * outward.transpose()});
  return {.crest_w = {},
          .span_w = {},
          .moments = bearing.film->half_width() * answer.crest_force.transpose() * foil.lines.zeta};
}

std::vector<FeShells> read_shells() {
  std::vector<FeShells> shells;
  for (const nlohmann::json& row : shell_file().at("rows")) {
    shells.push_back({.name = row.at("case"),
                      .feet = row.at("feet"),
                      .refined = row.at("refined"),
                      .found = {.crest_w = read_lines(row, "crest_w_m"),
                                .span_w = read_lines(row, "span_w_m"),
                                .moments = row.contains("moments_N_m") ? to_vector(row.at("moments_N_m")) : Vector()}});
  }
  return shells;
}

}  // namespace

const std::vector<FeShells>& fe_shells() {
  static const std::vector<FeShells> shells = read_shells();
  return shells;
}

const std::vector<double>& shell_zeta() {
  static const auto zeta = shell_file().at("zeta").get<std::vector<double>>();
  return zeta;
}

ShellNumbers press_bumps(const PressedBumps& pressed, int modes) {
  const BearingModel bearing = bearing_of(pressed.bumps, modes, WidthPart::half, pressed.sheet);
  const BondedAnswer answer = bonded_answer(
      bearing, {.feet_slide = pressed.feet_slide, .pressure = lobe(bearing, pressed.middle, pressed.extent)});
  return {.crest_w = displacements(bearing, answer, bearing.film->pads.front().foil.supports),
          .span_w = displacements(bearing, answer, spans_behind(1, pressed.bumps - 1)),
          .moments = {}};
}

ShellNumbers shells_by_program(const std::string& name, const std::string& feet, int modes, SheetModel sheet) {
  if (name == "held crests") return held_crests(modes);
  const bool feet_slide = feet == "sliding";
  return name == "tilt" ? tilted(feet_slide, modes) : nine_bumps(feet_slide, modes, sheet);
}

}  // namespace bumpfoil
