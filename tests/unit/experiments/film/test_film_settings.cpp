// Validation of running bearings.

#include "bumpfoil/model/validation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::nan;
using test_support::wrong_keys;

TEST(FindErrors, ChecksTheFeed) {
  const auto feed = [](double pressure) {
    return wrong_keys([&](Case& input) { input.film.inlet_pressure = pressure; });
  };
  EXPECT_EQ(feed(1.02e5), Keys{});
  EXPECT_EQ(feed(-1.0), Keys{"film.inlet_pressure"});
}

TEST(FindErrors, ChecksRoughSurfaces) {
  const auto rough = [](const AsperitySettings& settings) {
    return wrong_keys([&](Case& input) { input.asperity = settings; });
  };
  const AsperitySettings by_factor{.sigma = 0.3e-6, .pressure_factor = 2.4e8, .friction = 0.2};
  const AsperitySettings by_peaks{.sigma = 0.3e-6, .density = 1.7e10, .radius = 10e-6, .friction = 0.2};
  EXPECT_EQ(rough(by_factor), Keys{});
  EXPECT_EQ(rough(by_peaks), Keys{});
  AsperitySettings wrong = by_factor;
  wrong.density = 1.7e10;
  EXPECT_EQ(rough(wrong), Keys{"asperity.pressure_factor"});
  wrong = by_peaks;
  wrong.radius.reset();
  wrong.sigma = 0.0;
  wrong.friction = nan;
  EXPECT_EQ(rough(wrong), (Keys{"asperity.sigma", "asperity.friction", "asperity.radius"}));
  // At zero speed the journal is carried by asperities only.
  const auto resting = [&](const std::optional<AsperitySettings>& settings) {
    return wrong_keys([&](Case& input) {
      input.asperity = settings;
      input.settings.set(EquilibriumSettings{.speeds = {0.0}, .loads = {{50.0, 0.0}}});
    });
  };
  EXPECT_EQ(resting(std::nullopt), Keys{"equilibrium.speeds[1]"});
  EXPECT_EQ(resting(by_factor), Keys{});
}

/// Foils that vary over the width are available under films.
TEST(FindErrors, ChecksTheModesOverTheWidth) {
  const auto with_modes = [](
                              int modes, const std::function<void(Case&)>& change = [](Case&) {}) {
    return wrong_keys([&](Case& input) {
      input.width.modes = modes;
      input.settings.set(EquilibriumSettings{.speeds = {1000.0}, .loads = {{50.0, 0.0}}});
      change(input);
    });
  };
  EXPECT_EQ(with_modes(1), Keys{});
  EXPECT_EQ(with_modes(2), Keys{});
  EXPECT_EQ(with_modes(3), Keys{});
  EXPECT_EQ(with_modes(0), Keys{"width.modes"});
  EXPECT_EQ(with_modes(5), Keys{});
  EXPECT_EQ(with_modes(6), Keys{"width.modes"});
  const auto on_sheet = [](Case& input) { input.width.sheet = true; };
  EXPECT_EQ(with_modes(3, on_sheet), Keys{});
  EXPECT_EQ(with_modes(2, on_sheet), Keys{"width.sheet"});
  const auto on_split_sheet = [](Case& input) {
    input.width.sheet = true;
    input.bump_foil.strips = 3;
  };
  EXPECT_EQ(with_modes(3, on_split_sheet), Keys{"width.sheet"});
  const auto on_peaks = [](Case& input) {
    input.asperity = AsperitySettings{.sigma = 0.3e-6, .pressure_factor = 2.4e8, .friction = 0.2};
  };
  EXPECT_EQ(with_modes(1, on_peaks), Keys{});
  EXPECT_EQ(with_modes(3, on_peaks), Keys{});
  const auto pads = [](Case& input) {
    input.bump_foil.bumps = 8;
    input.pads.resize(3);
  };
  EXPECT_EQ(with_modes(1, pads), Keys{});
  EXPECT_EQ(with_modes(3, pads), Keys{});
  // Other commands with films.
  Case input = reference_case();
  input.width.modes = 2;
  const auto blames_modes = [&](const char* command) {
    const std::vector<InputError> errors = find_errors(input, {command});
    return std::any_of(errors.begin(), errors.end(), [](const InputError& one) { return one.key == "width.modes"; });
  };
  EXPECT_TRUE(blames_modes("film"));
  for (const char* const command : {"stability", "unbalance", "transient"}) EXPECT_FALSE(blames_modes(command));
  EXPECT_TRUE(find_errors(input, {"cycle"}).empty());
}

/// A tilted journal is computed by `equilibrium` and `film`, one that is free to tilt only by `equilibrium`.
TEST(FindErrors, ChecksTheTilt) {
  const auto width = [](const std::function<void(WidthSettings&)>& change, const std::string& command) {
    Case input = reference_case();
    input.settings.set(
        EquilibriumSettings{.speeds = {1000.0}, .positions = {{10e-6, 0.0}}, .path = FilmPath::position_ray});
    change(input.width);
    Keys keys;
    for (const InputError& error : find_errors(input, {command})) keys.push_back(error.key);
    return keys;
  };
  const auto tilt = [](WidthSettings& settings) { settings.tilt = {1e-4, 0.0}; };
  const auto moment = [](WidthSettings& settings) { settings.moment = {0.0, 0.0}; };
  EXPECT_EQ(width(tilt, "equilibrium"), Keys{});
  EXPECT_EQ(width([](WidthSettings& settings) { settings.tilt = {0.0, -1e-4}; }, "equilibrium"), Keys{});
  EXPECT_EQ(width(moment, "equilibrium"), Keys{});
  EXPECT_EQ(width(tilt, "film"), Keys{});
  EXPECT_EQ(width(moment, "film"), Keys{"width.moment"});
  for (const char* const command : {"stability", "unbalance", "transient"}) {
    const auto blames = [&](const Keys& keys, const char* key) {
      return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    EXPECT_FALSE(blames(width(tilt, command), "width.tilt")) << command;
    EXPECT_TRUE(blames(width(moment, command), "width.moment")) << command;  // the rotor determines the moments
  }
  EXPECT_EQ(width(tilt, "montecarlo"), Keys{});             // the command of each bearing is checked separately
  EXPECT_EQ(width(moment, "cycle"), Keys{"width.moment"});  // these foils do not respond to a moment
  EXPECT_EQ(width(tilt, "cycle"), Keys{"width.tilt"});      // these foils do not respond to a tilt
  for (const char* const command : {"cycle", "path", "vibration"}) {
    const auto dry = [&](const std::function<void(Case&)>& change) {
      Case input = reference_case();
      input.width = {.modes = 2, .tilt = {1e-4, 0.0}};
      change(input);
      Keys keys;
      for (const InputError& error : find_errors(input, {command})) keys.push_back(error.key);
      return keys;
    };
    EXPECT_EQ(dry([](Case&) {}), Keys{}) << command;
    const auto at_large = [](Case& input) {
      input.bump_foil.model = BumpFoilModel::frame;
      input.bump_foil.geometry = Geometry::nonlinear;
    };
    EXPECT_EQ(dry(at_large), Keys{"width.tilt"}) << command;
    EXPECT_EQ(dry([](Case& input) { input.width = {.modes = 2, .conicity = 1e-6}; }), Keys{}) << command;
    EXPECT_EQ(dry([](Case& input) { input.width = {.modes = 1, .crowning = 1e-6}; }), Keys{"width.crowning"})
        << command;
  }
  const auto between = [](const std::vector<double>& pressures, const std::string& command) {
    Case input = reference_case();
    input.settings.set(
        EquilibriumSettings{.speeds = {1000.0}, .positions = {{10e-6, 0.0}}, .path = FilmPath::position_ray});
    input.film.side_pressure = pressures;
    Keys keys;
    for (const InputError& error : find_errors(input, {command})) keys.push_back(error.key);
    return keys;
  };
  EXPECT_EQ(between({1.1e5, 1.1e5}, "stability"), Keys{});
  EXPECT_EQ(between({1.1e5, 1.0e5}, "equilibrium"), Keys{});
  EXPECT_EQ(between({1.1e5, 1.0e5}, "stability"), Keys{});
  EXPECT_EQ(between({1.1e5, 1.0e5}, "cycle"), Keys{});  // it has no film
  EXPECT_EQ(between({1.1e5}, "film"), Keys{"film.side_pressure"});
  EXPECT_EQ(between({1.1e5, -1.0}, "film"), Keys{"film.side_pressure[2]"});
  const auto cone = [](WidthSettings& settings) { settings.conicity = 1e-6; };
  const auto barrel = [](WidthSettings& settings) { settings.crowning = 1e-6; };
  EXPECT_EQ(width(cone, "equilibrium"), Keys{});
  EXPECT_EQ(width(cone, "cycle"), Keys{"width.conicity"});
  EXPECT_EQ(width(cone, "transient"), Keys{});
  EXPECT_EQ(width([](WidthSettings& settings) { settings.conicity = 1.0; }, "film"), Keys{"width.conicity"});
  EXPECT_EQ(width(barrel, "equilibrium"), Keys{});
  EXPECT_EQ(width(barrel, "cycle"), Keys{"width.crowning"});
  EXPECT_EQ(width([](WidthSettings& settings) { settings.crowning = nan; }, "film"), Keys{"width.crowning"});
  EXPECT_EQ(width([](WidthSettings& settings) { settings.tilt = {1e-4}; }, "equilibrium"), Keys{"width.tilt"});
  EXPECT_EQ(width([](WidthSettings& settings) { settings.tilt = {1e-4, 1.0}; }, "equilibrium"), Keys{"width.tilt[2]"});
  EXPECT_EQ(width(
                [](WidthSettings& settings) {
                  settings.moment = {nan, 0.0};
                },
                "equilibrium"),
            Keys{"width.moment[1]"});
}

TEST(FindErrors, ChecksTheGas) {
  const auto gas = [](const std::function<void(GasSettings&)>& change) {
    return wrong_keys([&](Case& input) { change(input.gas); });
  };
  EXPECT_EQ(gas([](GasSettings& g) { g.temperature = 20.0; }), Keys{"gas.temperature"});
  EXPECT_EQ(gas([](GasSettings& g) { g.temperature = nan; }), Keys{"gas.temperature"});
  EXPECT_EQ(gas([](GasSettings& g) { g.preset = GasPreset::steam; }), Keys{"gas.temperature"});  // water at 293 K
  EXPECT_EQ(gas([](GasSettings& g) { g = {.preset = GasPreset::steam, .viscosity = 12e-6}; }), Keys{});
  EXPECT_EQ(gas([](GasSettings& g) { g.viscosity = 18.5; }), Keys{"gas.viscosity"});
  EXPECT_EQ(gas([](GasSettings& g) { g.ambient_pressure = 0.0; }), Keys{"gas.ambient_pressure"});
  EXPECT_EQ(gas([](GasSettings& g) { g.mean_free_path = -1e-9; }), Keys{"gas.mean_free_path"});
}

TEST(FindErrors, ChecksTheMeshOfTheFilm) {
  const auto film = [](const std::function<void(FilmSettings&)>& change) {
    return wrong_keys([&](Case& input) { change(input.film); });
  };
  for (const int columns : {2, 5, 102}) {
    EXPECT_EQ(film([&](FilmSettings& f) { f.columns_per_pitch = columns; }), Keys{"film.columns_per_pitch"});
  }
  EXPECT_EQ(film([](FilmSettings& f) { f.rows = 1; }), Keys{"film.rows"});
  const auto finest = [](Case& input) { input.film = {.columns_per_pitch = 100, .rows = 200}; };
  EXPECT_EQ(wrong_keys(finest), Keys{});  // no command to run
  EXPECT_EQ(wrong_keys([&](Case& input) {
              finest(input);
              input.settings.set(EquilibriumSettings{.speeds = {1000.0}, .loads = {{50.0, 0.0}}});
            }),
            Keys{"film.columns_per_pitch"});
  // Near the memory limit: 26 bumps on 46 x 200 need 2 GB.
  for (const int columns : {42, 46}) {
    const Keys keys = wrong_keys([&](Case& input) {
      input.film = {.columns_per_pitch = columns, .rows = 200};
      input.settings.set(EquilibriumSettings{.speeds = {1000.0}, .loads = {{50.0, 0.0}}});
    });
    EXPECT_EQ(keys.empty(), columns == 42) << columns;
  }
  EXPECT_EQ(film([](FilmSettings& f) { f.wall = FilmWall::springs; }), Keys{"film.wall_stiffness"});
  EXPECT_EQ(film([](FilmSettings& f) { f.wall_stiffness = 0.0; }), Keys{"film.wall_stiffness"});
  EXPECT_EQ(film([](FilmSettings& f) { f.h_floor = 1.0; }), Keys{"film.h_floor"});
  EXPECT_EQ(film([](FilmSettings& f) { f.h_lift_off = 0.05e-6; }), Keys{"film.h_lift_off"});  // below h_floor
}

TEST(FindErrors, ChecksTheBearingForEveryCommandWithAFilm) {
  const auto blames = [](const std::function<void(Case&)>& change, const std::string& key, const std::string& command) {
    Case input = reference_case();
    change(input);
    const std::vector<InputError> errors = find_errors(input, {command});
    return std::any_of(errors.begin(), errors.end(), [&](const InputError& one) { return one.key == key; });
  };
  const auto fine = [](Case& input) { input.film = {.columns_per_pitch = 100, .rows = 200}; };
  const auto uneven = [](Case& input) { input.bearing.journal.waves = {{.harmonic = 2, .amplitude = 1e-6}}; };
  const auto former = [](Case& input) { input.bump_foil.model = BumpFoilModel::former; };
  const auto at_large = [](Case& input) {
    input.bump_foil.model = BumpFoilModel::frame;
    input.bump_foil.geometry = Geometry::nonlinear;
  };
  const auto by_events = [](Case& input) { input.solver.name = SolverName::events; };
  for (const char* const command : {"film", "equilibrium", "stability", "unbalance", "transient"}) {
    const bool foils = std::string_view(command) != "film";
    EXPECT_TRUE(blames(fine, "film.columns_per_pitch", command)) << command;
    EXPECT_TRUE(blames(uneven, "bearing", command)) << command;
    EXPECT_EQ(blames(former, "bump_foil.model", command), foils) << command;
    EXPECT_EQ(blames(at_large, "bump_foil.geometry", command), foils) << command;
    EXPECT_EQ(blames(by_events, "solver.name", command), foils) << command;
  }
  for (const char* const command : {"cycle", "path", "vibration", "strip"}) {
    EXPECT_FALSE(blames(fine, "film.columns_per_pitch", command)) << command;
    EXPECT_FALSE(blames(uneven, "bearing", command)) << command;
    EXPECT_FALSE(blames(by_events, "solver.name", command)) << command;
  }
}

TEST(FindErrors, ChecksStatesOfARunningBearing) {
  const auto equilibrium = [](const std::function<void(Case&, EquilibriumSettings&)>& change) {
    return wrong_keys([&](Case& input) {
      input.settings.set(EquilibriumSettings{.speeds = {1000.0}, .loads = {{50.0, 0.0}}});
      change(input, input.settings.get<EquilibriumSettings>());
    });
  };
  using E = EquilibriumSettings;
  EXPECT_EQ(equilibrium([](Case&, E&) {}), Keys{});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.speeds.clear(); }), Keys{"equilibrium.speeds"});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.speeds.push_back(0.0); }), Keys{"equilibrium.speeds[2]"});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.speeds.push_back(-1e9); }), Keys{"equilibrium.speeds[2]"});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.loads.clear(); }), Keys{"equilibrium.loads"});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.loads[0].setZero(); }), Keys{"equilibrium.loads[1]"});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.loads[0] = {0.0, nan}; }), Keys{"equilibrium.loads[1][2]"});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.positions = {{1e-5, 0.0}}; }), Keys{"equilibrium.positions"});
  const auto by_position = [](E& e, double x, FilmPath path) {
    e.loads.clear();
    e.positions = {{x, 0.0}};
    e.path = path;
  };
  EXPECT_EQ(equilibrium([&](Case&, E& e) { by_position(e, 1e-5, FilmPath::position_ray); }), Keys{});
  EXPECT_EQ(equilibrium([&](Case&, E& e) { by_position(e, 1e-5, FilmPath::load_ramp); }), Keys{"equilibrium.path"});
  EXPECT_EQ(equilibrium([&](Case&, E& e) { by_position(e, 25.0, FilmPath::cold_start); }),
            Keys{"equilibrium.positions[1][1]"});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.steps = 0; }), Keys{"equilibrium.steps"});
  EXPECT_EQ(equilibrium([](Case&, E& e) { e.frequencies = {1000.0, 2000.0}; }), Keys{});
  for (const double frequency : {0.0, -1000.0, 1e9, nan}) {
    EXPECT_EQ(equilibrium([&](Case&, E& e) {
                e.frequencies = {1000.0, frequency};
              }),
              Keys{"equilibrium.frequencies[2]"});
  }
  EXPECT_EQ(equilibrium([](Case& input, E&) { input.bump_foil.model = BumpFoilModel::former; }),
            Keys{"bump_foil.model"});
  const auto large = [](Case& input, E&) {
    input.bump_foil.model = BumpFoilModel::frame;
    input.bump_foil.geometry = Geometry::nonlinear;
  };
  EXPECT_EQ(equilibrium(large), Keys{"bump_foil.geometry"});
}

}  // namespace
}  // namespace bumpfoil
