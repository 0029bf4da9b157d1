#include "bumpfoil/readers/sampled_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/model/scatter.hpp"
#include "case/case_difference.hpp"
#include "readers/stored_result.hpp"
#include "results/netcdf_image.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

/// Reads the random numbers of a sample.
Sample read_sample(const NetcdfImage& image, std::size_t number, const Case& stored) {
  const auto numbers = [&](const std::string& name) {
    return image.numbers(image.variable(name, {"sample"}), {number}, {1}).front();
  };
  const MonteCarloSettings& ensemble = *stored.montecarlo;
  Sample sample;
  if (ensemble.bump_height) {
    const auto bumps = static_cast<std::size_t>(total_bumps(stored));
    if (image.size_of("bump") != bumps) image.refuse("bump", "does not have the size of the foil");
    const std::string name = "bump_height_deviation";
    if (const std::size_t strips = strips_drawn_apart(stored); strips == 1) {
      sample.height_deviations = image.numbers(image.variable(name, {"sample", "bump"}), {number, 0}, {1, bumps});
    } else {
      if (image.size_of("strip") != strips) image.refuse("strip", "does not have the size of the foil");
      sample.height_deviations =
          image.numbers(image.variable(name, {"sample", "strip", "bump"}), {number, 0, 0}, {1, strips, bumps});
    }
  }
  for (const ScatteredNumber& scattered : scattered_numbers()) {
    const bool scatters = (ensemble.*scattered.distribution).has_value();
    sample.deviations.push_back(scatters ? numbers(std::string(scattered.name) + "_deviation") : 0.0);
  }
  if (ensemble.sleeve_waviness) sample.waviness_phase = numbers("sleeve_waviness_phase");
  return sample;
}

constexpr std::array<std::string_view, 5> bearing_tables{"bearing", "bump_foil", "top_foil", "pad", "friction"};

/// Requires the same bearing, foils and friction: the reference of the deviations.
void require_same_bearing(const Case& stored, const Case& input, const std::string& file) {
  std::vector<InputError> errors;
  for (const CaseDifference& difference : case_differences(stored, input)) {
    // Tables of a list are numbered: pad[2].
    const std::string table = difference.key.substr(0, difference.key.find_first_of(".["));
    const bool is_of_bearing = std::find(bearing_tables.begin(), bearing_tables.end(), table) != bearing_tables.end();
    if (!is_of_bearing && !difference.key.starts_with("rotor.bearing[")) continue;
    errors.push_back({file, 0, difference.key, difference.theirs, fmt::format("is {} in this case", difference.ours),
                      "give the case of the ensemble"});
  }
  if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
}

}  // namespace

Case read_sampled_case(const fs::path& file, std::size_t number, const Case& input, std::string_view command) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const NetcdfImage image(
      read_stored_result(folder, file.filename().string(), {.advice = "take it from a backup or run again"}).bytes,
      file.string());
  const auto understood = image.texts().find("case_understood");
  if (understood == image.texts().end()) image.refuse("case_understood", "is missing: this is not an ensemble");
  Case stored = parse_case(understood->second, file.string());
  if (!stored.montecarlo) image.refuse("", "is not an ensemble");
  require_same_bearing(stored, input, file.string());
  const std::size_t samples = image.size_of("sample");
  if (number >= samples) {
    throw Error(ErrorKind::input, {{file.string(), 0, "sample", std::to_string(number), "is not there",
                                    fmt::format("give a number below {}", samples)}});
  }
  const Sample sample = read_sample(image, number, stored);
  Case drawn = input;
  if (!drawn.solver.name && stored.montecarlo->command == command) drawn.solver.name = stored.solver.name;
  drawn.montecarlo = std::move(stored.montecarlo);
  return sampled_case(drawn, sample);
}

}  // namespace bumpfoil
