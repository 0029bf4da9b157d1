#include "ensemble/ensemble_netcdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/cycle/result_layout.hpp"
#include "results/netcdf_provenance.hpp"
#include "results/netcdf_writer.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;
using netCDF::NcDim;
using netCDF::NcVar;

/// Samples that are in memory at a time.
constexpr std::size_t piece = 10'000;

class EnsembleWriter {
 public:
  EnsembleWriter(NewNetcdf& file, const Case& input, const EnsembleLayout& layout, const EnsembleLog& log)
      : file_(file),
        input_(input),
        layout_(layout),
        log_(log),
        sample_(file.add_dim("sample", log.samples())),
        place_(file.add_dim(std::string(layout.dimension()), layout.places.size())),
        bump_(file.add_dim("bump", layout.bumps)) {}

  void write_coordinates() {
    std::vector<double> samples(log_.samples());
    std::iota(samples.begin(), samples.end(), 0.0);
    file_.put_all({"sample", "1", "number of the sample; its bearing depends on seed and number only", {Form::whole}},
                  {sample_}, samples);
    write_places();
    std::vector<double> bumps(layout_.bumps);
    std::iota(bumps.begin(), bumps.end(), 1.0);
    file_.put_all({"bump",
                   "1",
                   count_pads(input_) > 1 ? "number of the bump from the weld, pad after pad"
                                          : "number of the bump from the weld",
                   {Form::whole}},
                  {bump_}, bumps);
    for (const NamedNumbers& geometry : make_result_layout(input_, Experiment::cycle).at_bumps) {
      file_.put_all({geometry.name, geometry.unit, geometry.long_name}, {bump_}, geometry.values);
    }
  }

  void write_places() {
    if (layout_.command == EnsembleCommand::cycle) {
      file_.put_all({"direction", "degree", "direction of the push, from X towards Y"}, {place_},
                    of_places([](const EnsemblePlace& place) { return to_degrees(std::get<double>(place.at)); }));
      return;
    }
    const auto put = [this](const char* name, const char* unit, const char* long_name, const auto& value) {
      file_.put_all({name, unit, long_name}, {place_},
                    of_places([&](const EnsemblePlace& place) { return value(std::get<OperatingPoint>(place.at)); }));
    };
    std::vector<double> numbers(layout_.places.size());
    std::iota(numbers.begin(), numbers.end(), 1.0);
    file_.put_all({"state", "1", "state of the running bearing, in the order of its path", {Form::whole}}, {place_},
                  numbers);
    put("speed", "rad/s", "speed of the journal, positive from X to Y",
        [](const OperatingPoint& point) { return point.speed; });
    const bool by_load = std::get<OperatingPoint>(layout_.places.front().at).by_load();
    const char* const unit = by_load ? "N" : "m";
    put(by_load ? "load_x" : "position_x", unit, by_load ? "load on the journal, X" : "position of the journal, X",
        [](const OperatingPoint& point) { return point.journal.x(); });
    put(by_load ? "load_y" : "position_y", unit, by_load ? "load on the journal, Y" : "position of the journal, Y",
        [](const OperatingPoint& point) { return point.journal.y(); });
  }

  /// What was drawn is drawn again.
  void write_deviations() {
    const MonteCarloSettings& ensemble = *input_.montecarlo;
    if (ensemble.bump_height) {
      in_pieces(file_.add({"bump_height_deviation", "m", "deviation of the height of the bump"}, {sample_, bump_}),
                {layout_.bumps}, of_each([](const Sample& sample) { return sample.height_deviations; }));
    }
    for (std::size_t i = 0; i < scattered_numbers().size(); ++i) {
      const ScatteredNumber& number = scattered_numbers()[i];
      if (!(ensemble.*number.distribution)) continue;
      in_pieces(
          file_.add({std::string(number.name) + "_deviation", std::string(number.unit), std::string(number.long_name)},
                    {sample_}),
          {}, of_each([i](const Sample& sample) { return std::vector{sample.deviations[i]}; }));
    }
    if (ensemble.sleeve_waviness) {
      in_pieces(file_.add({"sleeve_waviness_phase", "rad", "phase of the waves of the sleeve"}, {sample_}), {},
                of_each([](const Sample& sample) { return std::vector{sample.waviness_phase}; }));
    }
  }

  void write_quantities() {
    for (std::size_t k = 0; k < layout_.columns.size(); ++k) {
      const EnsembleColumn& column = layout_.columns[k];
      in_pieces(file_.add(column.meaning, {sample_, place_}), {layout_.places.size()}, of_each_place(k, 1));
    }
    in_pieces(
        file_.add({"bump_load", "N",
                   layout_.command == EnsembleCommand::cycle ? "load on the crest of the bump at full displacement"
                                                             : "load on the crest of the bump"},
                  {sample_, place_, bump_}),
        {layout_.places.size(), layout_.bumps}, of_each_place(layout_.columns.size(), layout_.bumps));
  }

 private:
  /// (first sample, samples) -> their numbers
  using Numbers = std::function<std::vector<double>(std::size_t, std::size_t)>;

  /// @param extents  of a sample
  void in_pieces(const NcVar& variable, const std::vector<std::size_t>& extents, const Numbers& numbers) const {
    for (std::size_t first = 0; first < log_.samples(); first += piece) {
      const std::size_t count = std::min(piece, log_.samples() - first);
      std::vector<std::size_t> start(extents.size() + 1, 0);
      std::vector<std::size_t> extent{count};
      start.front() = first;
      extent.insert(extent.end(), extents.begin(), extents.end());
      NewNetcdf::put(variable, start, extent, numbers(first, count));
    }
  }

  template <typename Of>
  [[nodiscard]] Numbers of_each(const Of& of) const {
    return [this, of](std::size_t first, std::size_t count) {
      std::vector<double> all;
      for (std::size_t i = first; i < first + count; ++i) {
        const std::vector<double> numbers = of(draw_sample(input_, i));
        all.insert(all.end(), numbers.begin(), numbers.end());
      }
      return all;
    };
  }

  template <typename Value>
  [[nodiscard]] std::vector<double> of_places(const Value& value) const {
    std::vector<double> all;
    for (const EnsemblePlace& place : layout_.places) all.push_back(value(place));
    return all;
  }

  /// So many columns of the log of each place, from one on.
  [[nodiscard]] Numbers of_each_place(std::size_t column, std::size_t columns) const {
    return [this, column, columns](std::size_t first, std::size_t count) {
      const std::size_t stride = layout_.places.size() * columns;
      std::vector<double> all(count * stride);
      for (std::size_t place = 0; place < layout_.places.size(); ++place) {
        for (std::size_t k = 0; k < columns; ++k) {
          const std::vector<double> values = log_.column(layout_.entry(place, column + k), first, count);
          for (std::size_t i = 0; i < count; ++i) all[i * stride + place * columns + k] = values[i];
        }
      }
      return all;
    };
  }

  NewNetcdf& file_;
  const Case& input_;
  const EnsembleLayout& layout_;
  const EnsembleLog& log_;
  NcDim sample_, place_, bump_;
};

/// netCDF does not survive a full disk.
void require_room(const fs::path& path, const EnsembleLayout& layout, std::size_t samples) {
  const std::size_t numbers = layout.width() + layout.bumps + scattered_numbers().size() + 2;
  constexpr std::size_t declarations = 20'000'000;  // with the text of the case
  const std::size_t needed = samples * numbers * sizeof(double) + declarations;
  std::error_code code;
  const fs::space_info space = fs::space(path.parent_path(), code);
  if (code || space.available >= needed) return;
  throw Error(
      ErrorKind::file,
      {{path.filename().string(), 0, "", "",
        fmt::format("takes up to {} MB, but the disk has {} MB free", needed / 1'000'000, space.available / 1'000'000),
        "free some space, or use another folder"}});
}

}  // namespace

void write_ensemble_netcdf(const fs::path& path, const Case& input, const EnsembleLayout& layout,
                           const EnsembleLog& log, RunStatus status, std::string_view message,
                           const Provenance& provenance, std::string_view run_id) {
  require_room(path, layout, log.samples());
  try {
    NewNetcdf file(path);
    add_provenance(file,
                   {.input = input,
                    .command = "montecarlo",
                    .status = status,
                    .message = std::string(message),
                    .warnings = input.remarks,
                    .provenance = provenance},
                   run_id);
    EnsembleWriter writer(file, input, layout, log);
    writer.write_coordinates();
    writer.write_deviations();
    writer.write_quantities();
    file.close_file();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt("ensemble.nc", error, "use fewer samples");
  }
}

}  // namespace bumpfoil
