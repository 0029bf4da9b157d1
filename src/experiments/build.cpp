#include "bumpfoil/experiments/build.hpp"

#include <memory>
#include <utility>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/origin/uzawa.hpp"
#include "experiments/cycle/cycle_run.hpp"
#include "origin/former_cycle.hpp"

namespace bumpfoil {

namespace {

JournalOverWidth journal_of(const WidthSettings& width) {
  JournalOverWidth journal{.slope = {width.tilt[0], width.tilt[1]}, .profile = width.profile()};
  if (!width.moment.empty()) journal.moment = Eigen::Vector2d(width.moment[0], width.moment[1]);
  return journal;
}

SheetModel sheet_of(const Case& input) {
  return input.width.sheet ? SheetModel::elastic : SheetModel::held;
}

}  // namespace

SharedBearing make_bearing_foils(const Case& input, const std::vector<std::string>& commands) {
  require_bearing(input, commands);
  if (!input.varies_over_the_width()) return std::make_shared<const BearingModel>(make_foils(input));
  const JournalOverWidth journal = journal_of(input.width);
  if (input.bump_foil.is_split())
    return std::make_shared<const BearingModel>(on_strips(make_foils(input), input.width.modes, journal));
  return std::make_shared<const BearingModel>(on_lines(make_foils(input), input.width.modes, journal, sheet_of(input)));
}

SharedBearing make_strip_foils(const Case& input) {
  require_valid(input, {"strip"});
  const StripSettings& strip = input.settings.get<StripSettings>();
  return std::make_shared<const BearingModel>(make_foils(input, strip.bumps, strip.weld, strip.top_foil));
}

std::unique_ptr<PathFollower> make_path_follower(const SharedProblem& problem, const SolverSettings& settings,
                                                 const std::shared_ptr<ModeSystem>& modes, Rates rates) {
  switch (settings.chosen()) {
    case SolverName::newton:
      return make_increment_follower(std::make_unique<NewtonSolver>(problem, modes));
    case SolverName::events:
      return make_event_stepper(problem, modes, rates);
    case SolverName::uzawa:
      break;
  }
  const UzawaParameters& given = settings.uzawa;
  UzawaOptions options = uzawa_options_for(*problem);
  options.eps_alm = given.eps_alm.value_or(options.eps_alm);
  options.eps_f = given.eps_f.value_or(options.eps_f);
  options.eps_r = given.eps_r.value_or(options.eps_r);
  options.tau_f = given.tau_f.value_or(options.tau_f);
  return make_increment_follower(std::make_unique<UzawaSolver>(*problem, options));
}

FoilStepper make_stepper(SharedBearing foils, const SolverSettings& settings, Rates rates) {
  return {std::move(foils), [&](const SharedProblem& problem, const std::shared_ptr<ModeSystem>& modes) {
            return make_path_follower(problem, settings, modes, rates);
          }};
}

CycleRun make_cycle_run(const Case& input) {
  return input.bump_foil.model == BumpFoilModel::former ? former_cycle_run(input) : present_cycle_run(input);
}

namespace {

JournalTilt tilt_of(const Case& input) {
  const double half_width = 0.5 * input.bearing.axial_length;
  const auto both = [](const std::vector<double>& along) { return Eigen::Vector2d(along[0], along[1]); };
  if (!input.width.moment.empty()) return {Control::load, both(input.width.moment) / half_width};
  return {Control::displacement, half_width * both(input.width.tilt)};
}

}  // namespace

FilmSurroundings surroundings_of(const Case& input, double ambient) {
  FilmSurroundings surroundings{.inlet_pressure = input.film.inlet_pressure.value_or(ambient) / ambient,
                                .tilt = tilt_of(input),
                                .profile = input.width.profile()};
  if (const std::vector<double>& sides = input.film.side_pressure; !sides.empty()) {
    surroundings.side_pressure = Eigen::Vector2d(sides[0], sides[1]) / ambient;
  }
  if (input.asperity) surroundings.asperities = asperities_of(*input.asperity, input.top_foil);
  return surroundings;
}

BearingModel make_film_bearing(const Case& input, const Gas& gas, const FilmResolution& resolution) {
  require_bearing(input, {"equilibrium"});
  return make_film_bearing(make_film_foils(input), gas, resolution, surroundings_of(input, gas.ambient_pressure));
}

double thickness_floor(const Case& input) {
  return input.asperity ? 0.0 : input.film.h_floor;
}

FilmResolution resolution_of(const Case& input) {
  return {.columns_per_pitch = input.film.columns_per_pitch,
          .rows = input.film.rows,
          .width_modes = input.width.modes,
          .sheet = sheet_of(input),
          .width = input.has_equal_halves() ? WidthPart::half : WidthPart::whole};
}

BearingModel make_film_bearing(const Case& input) {
  return make_film_bearing(input, gas_of(input.gas), resolution_of(input));
}

}  // namespace bumpfoil
