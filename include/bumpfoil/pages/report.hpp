#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// What the page of a report has in the place of its data.
inline constexpr std::string_view report_placeholder = "@bumpfoil-report-data@";

/// Numbers per increment and node that a report holds at most; runs with more of them are thinned. Of a sweep it is all
/// numbers.
inline constexpr std::size_t most_report_values = 2'000'000;

/// A CSV file of measured loops.
struct MeasuredFile {
  std::filesystem::path path;
  std::string at{};  ///< direction ("+X" or degrees) or strip cycle of its loop, where no column of it says so
};

struct ReadingOptions {
  std::size_t most_values = most_report_values;  ///< over all folders
  /// Whether result.nc must have the checksum that summary.json lists. Without, a damaged file may still be found out
  /// by its shape, show wrong numbers, or crash libhdf5.
  bool checked = true;
  std::function<void(const std::string&)> warn{};  ///< called, where given, with remarks on measured loops
  /// Each is shown as one more run: columns displacement_um (or _nm, _mm, _m) and force_N (or _mN, _kN), or by other
  /// names of rigs, and where the results have several cycles `direction` (+X, degrees) or, of a strip, `cycle`. Of
  /// several cycles one after the other the last is shown.
  std::vector<MeasuredFile> measured{};
  /// Names of these columns where they are others: displacement=NAME,force=NAME,direction=NAME.
  std::string columns{};
};

/// Everything that a report shows of the results in some folders, as JSON.
///
/// `{"schema": "bumpfoil-report/1", "version", "commit", "keys", "runs": [...]}`: titles and units of the keys of the
/// case file by their paths (`{"bearing.radius": {"title": "Radius", "unit": "m"}, ...}`), and one object per folder:
/// `name` (the last parts of its path, as many as it takes to tell the folders apart), `kind` (the command that wrote
/// it), `attributes` (global texts of result.nc, without paths of the machine), `summary`, and `quantities` (`name`,
/// `key` in the summary, `label`, `unit`, `whole`, `of_solver`, `meaning` of each that tables show). Values are base64
/// of little-endian binary32, flags of signed bytes; NaN and -127 stand for what is absent. Where sleeve or journal of
/// a bearing are no circles, `deviations` has what their radii are more than nominal, m, at equal angles from X on
/// towards Y to X again: `sleeve` (with the taper, under the foils), `journal`, and `taper` alone where the sleeve has
/// more than it; without those that are circles. The rest is one of three:
///
/// Cycles (`cycle`, `strip`): `summary` is summary.json as it is; `meanings` (`unit` and `text` of the variables of
/// cycles and increments, as result.nc says them), `geometry` (variables without increments: a number, or one per bump,
/// foot or pad), `nodes` (sizes of the dimensions of nodes), `last_increment` (that was requested), and `cycles`, one
/// for each direction of a bearing. A cycle has `at` (the direction in degrees, or the number of the cycle),
/// `increments` (numbers of those that are kept: all, or every n-th one of each branch, always with its ends), `series`
/// (variables per increment) and `fields` (per increment and node: `{"at": "bump" | "foot" | "pad", "values"}`). Left
/// out are gaps, which the displacements give, and the friction at the journal, which is zero. Of stresses per node
/// `series` has the largest at every increment. Measured loops have `measured`: true, series of displacement, force and
/// work, and no fields.
///
/// Grids (`sweep` and all other experiments): `summary` is what summary.json begins with, up to the status, and its
/// `axes`, `limits`, `onsets`, or `stations` and `peaks`, or of `fit` and `optimise` summary.json as it is;
/// `dimensions` (sizes by name), `variables` (by name: `key` in tables, `dims`, the last running fastest, `unit`,
/// `text`, `words` of flags, `values`, all binary32) and `left_out` (names of those that were too large).
///
/// Runs in time (`transient`) are grids as well: the summary has `stations`, `revolutions`, `energy`, the first `rubs`
/// and `rub_count` of all. Of many revolutions and spectra every n-th is there, and of the steps those of some
/// revolutions: `stored` has the sizes of these dimensions in the file, and `orbits` tells which steps lead through
/// which of them (`revolution`, from 1; `first`, `steps` among those that are there). The last revolution is there, be
/// it whole or not.
///
/// Ensembles (`montecarlo`): `summary` has the statistics of summary.json as well; `directions` in degrees,
/// `sample_count`, and `distributions` by the names of quantities: `unit`, `text`, `from` and `to` (the least and the
/// largest number of all directions), for each direction `counts` (samples in intervals of equal width between these)
/// and `first` (numbers of the first samples, null where they are not known). `samples` are these first bearings as
/// cycles, run again. Of running bearings `states` has names in place of directions, and there are no samples.
///
/// Variables go by their dimensions, so that new ones need no code here.
///
/// netCDF is not thread-safe: to be called by one thread at a time.
///
/// Files are not trusted: their shapes, and that they belong to one run, are verified before use.
///
/// @param folders  of results, at least one
/// @throws Error (file) that lists every folder that does not exist, holds no result, cannot be read, or is damaged;
///         Error (input) for measured loops that cannot be understood, or that no result is to be compared with
std::string report_json(const std::vector<std::filesystem::path>& folders, const ReadingOptions& options = {});

/// The page with the data in place of `report_placeholder`, written so that no text in it can end the script element
/// that holds it. @param page  has the placeholder once
std::string fill_report(std::string_view page, std::string_view json);

}  // namespace bumpfoil
