#include <cstdint>
#include <string>

#include "bumpfoil/experiments/path/path.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "case/case_keys.hpp"
#include "case/path_csv.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

/// Maximum number of increments, counted by an `int`.
constexpr std::int64_t most_path_increments = 1'000'000'000;

void describe(CaseVisitor& keys, PathSettings& path) {
  using enum Presence;
  using enum Dimension;
  const bool has_file = keys.file(
      {"file", optional, "File of the path",
       "a file beside this one with the columns x_m,y_m (positions) or force_x_N,force_y_N (loads)", "\"path.csv\""},
      "points", [&path](const std::string& name) { path.points = read_path(name); });
  const bool has_points = keys.places({"points", optional, "Points", "the same as a list; or an orbit, without points",
                                       "[[\"0 um\", \"-40 um\"], [\"10 um\", \"-40 um\"]]"},
                                      path.points);
  // Unreadable points must not count as an orbit with missing keys.
  if ((has_file || has_points) && path.is_orbit()) path.points.values.emplace_back(0.0, 0.0);
  const Presence of_orbit = path.is_orbit() ? required : optional;
  const auto in_plane = [&keys](const Key& key, Control plain, PlaneTarget& target) {
    std::optional<PlaneTarget> given = target;
    keys.either(key, plain, given);
    target = *given;
  };
  in_plane({"centre", of_orbit, "Centre", "of the orbit, an ellipse: a position, or a load", "[\"0 um\", \"-40 um\"]"},
           Control::displacement, path.centre);
  in_plane({"semi_axes", of_orbit, "Semi-axes", "of the same kind", "[\"10 um\", \"5 um\"]"}, path.centre.control,
           path.semi_axes);
  keys.value({"tilt", defaulted, "Tilt", "of the first axis, from X towards Y", "0 deg", angle}, &path.tilt);
  keys.choice({"sense", defaulted, "Sense", "or \"clockwise\""}, path.sense);
  keys.value({"orbits", defaulted, "Orbits", "one after the other, with friction carried over"}, &path.orbits);
  keys.value({"steps", defaulted, "Increments per orbit", "also on the straight approach to its first point"},
             &path.steps);
}

void describe_path(CaseVisitor& keys, Case& input) {
  using enum Presence;
  settings_table<PathSettings>(
      keys, {"path", optional, "Path", "a prescribed path of the journal from the centre, for the command path"},
      input.settings, describe);
}

void check_path(Checks& checks, const Case& input, const CheckedBumpFoil& foil) {
  const PathSettings* const settings = input.settings.find<PathSettings>();
  if (settings == nullptr) return;
  const PathSettings& path = *settings;
  checks.require_history("path", input.bump_foil.model != BumpFoilModel::former,
                         "has no history: it can only be pushed from the centre");
  const double limit = flattening(input.bearing, foil.rise);
  const bool by_load = path.control() == Control::load;
  const bool presses = !by_load && limit > 0.0;
  const double most = by_load ? load_range.most : presses ? limit : length_range.most;
  const std::string_view unit = by_load ? "N" : "m";
  const auto within_reach = [&](const std::string& key, double distance) {
    return checks.require_for(presses ? "path" : "", distance < most, key, quantity(distance, unit),
                              presses ? "would press the bumps flat" : "is unphysical",
                              fmt::format("stay below {} from the centre", quantity(most, unit)));
  };
  for (std::size_t i = 0; i < path.points.values.size(); ++i) {
    if (!within_reach(fmt::format("path.points[{}]", i + 1), path.points.values[i].norm())) return;
  }
  std::int64_t increments = std::ssize(path.points.values);
  if (!path.is_orbit()) {
    checks.require(path.centre.value.isZero(0.0) && path.semi_axes.value.isZero(0.0),
                   path.centre.value.isZero(0.0) ? "path.semi_axes" : "path.centre", "",
                   "belongs to an orbit, but the path goes through points", "remove it, or the points");
  } else {
    const Eigen::Vector2d& axes = path.semi_axes.value;
    checks.require(path.semi_axes.control == path.centre.control, "path.semi_axes", "",
                   by_load ? "are lengths where the centre is a load" : "are forces where the centre is a position",
                   "give both as lengths, or both as forces");
    checks.require(axes.minCoeff() >= 0.0 && axes.maxCoeff() > 0.0, "path.semi_axes",
                   fmt::format("({}, {})", quantity(axes.x(), unit), quantity(axes.y(), unit)),
                   "must not be negative, nor both zero", "give two lengths of an ellipse; one may be zero");
    within_reach("path.centre", path.centre.value.norm() + axes.maxCoeff());
    checks.angle("path.tilt", path.tilt);
    const bool counts = checks.count("path.orbits", path.orbits, "orbits") &&
                        checks.count("path.steps", path.steps, "increments", {3, most_steps});
    if (!counts) return;
    increments = std::int64_t{path.steps} * (path.orbits + 1);
  }
  if (!foil.bumps) return;
  checks.require_for("path", increments <= most_path_increments, path.is_orbit() ? "path.orbits" : "path.points",
                     std::to_string(path.is_orbit() ? path.orbits : increments),
                     fmt::format("{} increments are too many", increments),
                     fmt::format("give a path of at most {}", most_path_increments));
}

}  // namespace

CaseTable path_settings() {
  return {.experiment = "path",
          .needs = "path",
          .foils = true,
          .describe = describe_path,
          .check = check_path,
          .given = gives<PathSettings>};
}

}  // namespace bumpfoil
