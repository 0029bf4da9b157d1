#include "bumpfoil/case/case_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/experiments/vibration/vibration_settings.hpp"
#include "support/case_texts.hpp"
#include "support/temporary_folder.hpp"
#include "support/wrong_cases.hpp"

namespace bumpfoil {
namespace {

using test_support::cut;
using test_support::expect_in;
using test_support::refusal;
using test_support::TemporaryFolder;
using test_support::whole_case;
using test_support::with;

using std::numbers::pi;

TEST(ParseCase, ReadsEnsembles) {
  EXPECT_FALSE(with({}).montecarlo);
  const TemporaryFolder folder;
  folder.write("lengths.csv", "deviation\n1e-6\n\n -2e-6\n");
  const std::string text = whole_case() + R"(
[montecarlo]
samples = 50
bump_height = { distribution = "normal", std = "10 um", correlation_length = "9 mm" }
radial_clearance = { distribution = "truncated_normal", std = "2 um", lower = "-4 um", upper = 5e-6 }
friction_bump_sleeve = { distribution = "uniform", lower = -0.05, upper = 0.05 }
bump_length = { distribution = "table", file = "lengths.csv" }
sleeve_waviness = { harmonic = 3, amplitude = "5 um" }
)";
  const Case input = parse_case(text, (folder.path() / "case.toml").string());
  using enum DistributionKind;
  const MonteCarloSettings expected{
      .samples = 50,
      .seed = 1,
      .bump_height = HeightScatter{{.kind = normal, .sigma = 10e-6}, 9e-3},
      .bump_length = Distribution{.kind = table, .values = {1e-6, -2e-6}},
      .friction_bump_sleeve = Distribution{.kind = uniform, .lower = -0.05, .upper = 0.05},
      .radial_clearance = Distribution{.kind = truncated_normal, .sigma = 2e-6, .lower = -4e-6, .upper = 5e-6},
      .sleeve_waviness = WavinessScatter{3, 5e-6}};
  EXPECT_EQ(input.montecarlo.value(), expected);
  EXPECT_EQ(parse_case(case_to_toml(input), "again.toml"), input);
  EXPECT_NE(refusal({"montecarlo.bump_height.std=10 N"}).find("montecarlo.bump_height.std = 10 N"), std::string::npos);
  EXPECT_NE(refusal({"montecarlo.bump_hight.std=10 um"}).find("did you mean \"bump_height\"?"), std::string::npos);
}

TEST(ParseCase, EnsemblesOfCyclesFollowEventsUnlessASolverIsNamed) {
  const auto solver = [](const std::string& command, std::vector<std::string> overrides) {
    const std::string text = cut(whole_case(), "name = \"newton\"\n");
    overrides.emplace_back("montecarlo.bump_height.std=10 um");
    return parse_case(text, "case.toml", {.overrides = overrides, .commands = {command}}).solver.chosen();
  };
  EXPECT_EQ(solver("montecarlo", {}), SolverName::events);
  EXPECT_EQ(solver("montecarlo", {"bump_foil.model=frame"}), SolverName::events);
  EXPECT_EQ(solver("montecarlo", {"solver.name=newton"}), SolverName::newton);
  EXPECT_EQ(solver("montecarlo", {"solver.name=uzawa"}), SolverName::uzawa);
  // The event-following solver requires piecewise linear problems, without films.
  EXPECT_EQ(solver("montecarlo", {"bump_foil.model=frame", "bump_foil.geometry=nonlinear"}), SolverName::newton);
  EXPECT_EQ(solver("montecarlo", {"montecarlo.command=equilibrium", "equilibrium.speeds=[\"45000 rpm\"]",
                                  "equilibrium.loads=[[\"50 N\", \"0 N\"]]"}),
            SolverName::newton);
  EXPECT_EQ(solver("cycle", {}), SolverName::newton);
  EXPECT_EQ(case_to_toml(with({})).find("events"), std::string::npos);
}

TEST(CheckCase, SaysWhatEachCommandWouldSay) {
  const std::string text = whole_case() +
                           "[equilibrium]\nspeeds = [\"45000 rpm\"]\nloads = [[\"50 N\", \"0 N\"]]\n"
                           "[strip]\ndisplacement = \"20 um\"\n[montecarlo]\nbump_height = { std = \"10 um\" }\n";
  const auto verdicts = [&text](const std::vector<std::string>& overrides) {
    std::string out;
    for (const auto& [name, errors] : check_case(text, "case.toml", overrides).commands) {
      out += name;
      for (const InputError& error : errors) out += fmt::format(" {}:{}", error.line, error.key);
      out += ' ';
    }
    return out;
  };
  EXPECT_EQ(verdicts({}), "cycle strip equilibrium montecarlo ");
  EXPECT_EQ(verdicts({"cycle.amplitude=0.6 mm"}),
            "cycle 0:cycle.amplitude strip equilibrium montecarlo 0:cycle.amplitude ");
  EXPECT_EQ(verdicts({"strip.displacement=0.6 mm", "solver.name=events"}),
            "cycle strip 0:strip.displacement equilibrium 0:solver.name montecarlo ");
}

TEST(ParseCase, ReadsRangesWhereListsAreDue) {
  const auto forces = [](const std::string& range) {
    return with({"cycle.clearance_forces=" + range}).settings.get<CycleSettings>().clearance_forces;
  };
  EXPECT_EQ(forces("{from=\"5 N\", to=\"20 N\", points=4}"), (std::vector{5.0, 10.0, 15.0, 20.0}));
  EXPECT_EQ(forces("{from=\"0.02 kN\", to=5, step=\"-5 N\"}"), (std::vector{20.0, 15.0, 10.0, 5.0}));
  EXPECT_EQ(forces("{from=1, to=2, step=0.333333333333}"), (std::vector{1.0, 1.0 + 1.0 / 3.0, 1.0 + 2.0 / 3.0, 2.0}));
  EXPECT_EQ(forces("{from=5, to=5, points=1}"), std::vector{5.0});
  EXPECT_EQ(
      with({"cycle.directions={from=0.0, to=\"270 deg\", points=4}"}).settings.get<CycleSettings>().directions.back(),
      1.5 * pi);
  const Case running = with({"equilibrium.loads=[[\"50 N\", 0]]",
                             "equilibrium.speeds={from=\"10000 rpm\", to=\"60000 rpm\", step=\"5000 rpm\"}"});
  ASSERT_EQ(running.settings.get<EquilibriumSettings>().speeds.size(), 11U);
  EXPECT_NEAR(running.settings.get<EquilibriumSettings>().speeds[1], 15000.0 * pi / 30.0, 1e-9);
  EXPECT_EQ(with({"equilibrium.loads=[[1, 0]]", "equilibrium.speeds.from=1", "equilibrium.speeds.to=3",
                  "equilibrium.speeds.points=3"})
                .settings.get<EquilibriumSettings>()
                .speeds,
            (std::vector{1.0, 2.0, 3.0}));
  EXPECT_EQ(parse_case(case_to_toml(running), "again.toml"), running);

  const auto refused = [](const std::string& range) { return refusal({"cycle.clearance_forces=" + range}); };
  const auto expect_refused = [&](const std::string& range, const std::string& part) {
    EXPECT_NE(refused(range).find("cycle.clearance_forces" + part), std::string::npos) << refused(range);
  };
  expect_refused("{from=5, to=20}", ": has neither points nor step");
  expect_refused("{from=5, to=20, points=4, step=5}", ": has both points and step");
  expect_refused("{from=5, points=4}", ".to: is missing");
  expect_refused("{from=5, to=5, points=2}", ".points = 2: repeats the same value");
  expect_refused("{from=5, to=20, points=1}", ".points = 1: is 1, but the ends differ");
  expect_refused("{from=5, to=20, points=0}", ".points = 0: is not a valid number");
  expect_refused("{from=5, to=20, points=100001}", ".points = 100001: makes 100001 values; give at most 100000");
  // Whatever is wrong with it, it is not missing.
  for (const char* wrong : {"{from=5, to=20, points=100001}", "{from=5, to=\"1 N\", points=2}", "{from=5, to=20}"}) {
    const std::string said = refusal({"equilibrium.loads=[[50, 0]]", std::string("equilibrium.speeds=") + wrong});
    EXPECT_NE(said.find("equilibrium.speeds"), std::string::npos) << said;
    EXPECT_EQ(said.find("no speed"), std::string::npos) << said;
  }
  expect_refused("{from=5, to=20, step=1e-9}", ".step = 1e-09: makes 1.5e+10 values");
  expect_refused("{from=5, to=20, step=0}", ".step = 0: does not lead");
  expect_refused("{from=5, to=20, step=-5}", ".step = -5: does not lead to the last value");
  expect_refused("{from=5, to=20, step=4}", ".step = 4: does not lead to the last value");
  expect_refused("{from=5, to=\"20 mm\", points=4}", ".to = 20 mm: ");
  expect_refused("{from=5, to=20, point=4}", ".point = 4: unknown key");
  expect_refused("{from=-5, to=20, points=6}", "[1] = -5 N: must be positive");
}

TEST(ParseCase, ReadsTheWavesOfASleeve) {
  // One alone is a table, several are a list of tables.
  EXPECT_EQ(with({"bearing.sleeve_waviness={harmonic=3, amplitude=\"5 um\"}"}).bearing.sleeve.waves,
            (std::vector<Waviness>{{3, 5e-6, 0.0}}));
  EXPECT_EQ(
      with({"bearing.journal_waviness=[{harmonic=3, amplitude=\"5 um\"}, {harmonic=2, amplitude=1e-6, phase=1.0}]"})
          .bearing.journal.waves,
      (std::vector<Waviness>{{3, 5e-6, 0.0}, {2, 1e-6, 1.0}}));
  EXPECT_EQ(with({"bearing.sleeve_profile=[\"3 um\", 1e-6]"}).bearing.sleeve.deviations, (std::vector{3e-6, 1e-6}));
  EXPECT_NE(refusal({"bearing.sleeve_waviness.amplitude=5 um"}).find("bearing.sleeve_waviness[1].harmonic: is missing"),
            std::string::npos);
}

TEST(ParseCase, ReadsEveryKey) {
  const Case input = parse_case(whole_case(), "case.toml");
  EXPECT_EQ(input.title, "Whole");
  EXPECT_EQ(input.bearing.radius, 19.05e-3);
  EXPECT_EQ(input.bearing.axial_length, 38.1e-3);
  EXPECT_EQ(input.bearing.radial_clearance, 31.8e-6);
  EXPECT_EQ(input.bearing.weld_angle, pi);
  EXPECT_EQ(input.bearing.wrap, Wrap::clockwise);
  EXPECT_EQ(input.bump_foil.bumps, 26);
  EXPECT_EQ(input.bump_foil.pitch.values, std::vector{4.572e-3});
  EXPECT_EQ(input.bump_foil.length.values, std::vector{3.556e-3});
  EXPECT_EQ(input.bump_foil.height.values, std::vector{0.508e-3});
  EXPECT_EQ(input.bump_foil.thickness.values, std::vector{0.102e-3});
  EXPECT_EQ(input.bump_foil.youngs_modulus, 214e9);
  EXPECT_EQ(input.bump_foil.poisson_ratio, 0.29);
  EXPECT_EQ(input.bump_foil.truss.k1, 150e6);
  EXPECT_FALSE(input.bump_foil.truss.k2);
  EXPECT_DOUBLE_EQ(input.bump_foil.truss.theta_d.value(), 15.83 * pi / 180.0);
  EXPECT_EQ(input.friction, (Friction{.top_bump = 0.1, .bump_sleeve = 0.1}));
  EXPECT_EQ(input.solver.uzawa.eps_alm, 100e6);
  ASSERT_EQ(input.settings.get<CycleSettings>().directions.size(), 2U);
  EXPECT_EQ(input.settings.get<CycleSettings>().directions[0], 0.0);
  EXPECT_DOUBLE_EQ(input.settings.get<CycleSettings>().directions[1], 37.5 * pi / 180.0);
  EXPECT_EQ(input.settings.get<CycleSettings>().amplitude.value, 79.5e-6);
  EXPECT_EQ(input.settings.get<CycleSettings>().steps, 100);
}

TEST(ParseCase, TopFoilTakesTheMaterialOfTheBumpFoil) {
  EXPECT_EQ(parse_case(whole_case(), "case.toml").top_foil,
            (TopFoil{.thickness = 0.102e-3, .youngs_modulus = 214e9, .poisson_ratio = 0.29}));
  EXPECT_EQ(with({"top_foil.poisson_ratio=0.3"}).top_foil.poisson_ratio, 0.3);
}

TEST(ParseCase, DisplacementsAreSmallUnlessSaidOtherwise) {
  EXPECT_EQ(parse_case(cut(whole_case(), "geometry = \"linear\"\n"), "case.toml").bump_foil.geometry, Geometry::linear);
  EXPECT_EQ(with({"bump_foil.model=\"frame\"", "bump_foil.geometry=\"nonlinear\""}).bump_foil.geometry,
            Geometry::nonlinear);
}

TEST(ParseCase, TopFoilTakesTheYieldStressOfTheBumpFoil) {
  const Case input = with({"bump_foil.yield_stress=900 MPa"});
  EXPECT_EQ(input.bump_foil.yield_stress, 900e6);
  EXPECT_EQ(input.top_foil.yield_stress, 900e6);
  EXPECT_EQ(with({"bump_foil.yield_stress=900 MPa", "top_foil.yield_stress=1 GPa"}).top_foil.yield_stress, 1e9);
  EXPECT_EQ(with({}).top_foil.yield_stress, std::nullopt);
  EXPECT_NE(refusal({"bump_foil.yield_stress=1 Pa"}).find("bump_foil.yield_stress = 1 Pa: is unphysical"),
            std::string::npos);
  EXPECT_EQ(refusal({"bump_foil.yield_stress=1 Pa"}).find("top_foil"), std::string::npos);  // said once
}

TEST(ParseCase, ReadsStrips) {
  EXPECT_EQ(with({}).settings.find<StripSettings>(), nullptr);
  const StripSettings by_displacement = with({"strip.displacement=20 um"}).settings.get<StripSettings>();
  EXPECT_EQ(by_displacement, (StripSettings{.bumps = 26, .amplitude = {Control::displacement, 20e-6}}));
  const StripSettings by_load = with({"strip.load=100 N", "strip.bumps=10", "strip.weld=none", "strip.top_foil=false",
                                      "strip.preload=120", "strip.cycles=3", "strip.steps=20"})
                                    .settings.get<StripSettings>();
  EXPECT_EQ(by_load, (StripSettings{.bumps = 10,
                                    .weld = StripWeld::none,
                                    .top_foil = false,
                                    .amplitude = {Control::load, 100.0},
                                    .preload = Target{Control::load, 120.0},  // a plain number is of its kind
                                    .cycles = 3,
                                    .steps = 20}));
  const auto preload = [](const std::string& text) {
    return with({"strip.displacement=20 um", "strip.preload=" + text}).settings.get<StripSettings>().preload.value();
  };
  EXPECT_EQ(preload("50 N"), (Target{Control::load, 50.0}));
  EXPECT_EQ(preload("30 um"), (Target{Control::displacement, 30e-6}));
  EXPECT_EQ(preload("3e-5"), (Target{Control::displacement, 3e-5}));
  EXPECT_NE(refusal({"strip.displacement=20 um", "strip.preload=5 MPa"}).find("strip.preload = 5 MPa"),
            std::string::npos);
  EXPECT_NE(refusal({"strip.bumps=10"}).find("strip.displacement: is missing"), std::string::npos);
  EXPECT_EQ(refusal({"strip.displacement=20 um", "strip.load=10 N"}),
            "--set: strip.displacement = 20 um: conflicts with load, which is also given; give one of the two");
  EXPECT_NE(refusal({"strip.displacement=20 um", "strip.welt=none"}).find("did you mean \"weld\"?"), std::string::npos);
}

TEST(ParseCase, TakesADiameterForTheRadius) {
  const auto written = [](const std::string& diameter) {
    std::string text = whole_case();
    const std::string radius = "radius = \"19.05 mm\"";
    return text.replace(text.find(radius), radius.size(), "diameter = " + diameter);
  };
  const std::string text = written("\"38.1 mm\"");
  EXPECT_EQ(parse_case(text, "case.toml"), parse_case(whole_case(), "case.toml"));
  // Errors refer to the key as written.
  const auto refused = [&written](const std::string& diameter) {
    try {
      static_cast<void>(parse_case(written(diameter), "case.toml"));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused("\"-2 mm\""),
            "case.toml:3: bearing.diameter = -2 mm: must be positive; give a value from 1e-09 m to 1000 m");
  EXPECT_EQ(refused("\"2 N\"").find("case.toml:3: bearing.diameter = 2 N: is a force, expected a length"), 0);
  EXPECT_EQ(refused("\"2 N\"").find('\n'), std::string::npos);
  // On the command line it replaces the radius of the file, and the radius replaces a diameter there.
  EXPECT_EQ(with({"bearing.diameter=40 mm"}).bearing.radius, 20e-3);
  const CaseRequest request{.overrides = {"bearing.radius=20 mm"}, .commands = {}};
  EXPECT_EQ(parse_case(text, "case.toml", request).bearing.radius, 20e-3);
  EXPECT_EQ(refusal({"bearing.diameter=40 mm", "bearing.radius=20 mm"}),
            "--set: bearing.radius = 20 mm: conflicts with diameter, which is also given; give one of the two");
}

TEST(ParseCase, ReadsVibrations) {
  EXPECT_EQ(with({}).settings.find<VibrationSettings>(), nullptr);
  const std::vector<std::string> given{
      "vibration.loads=[[\"0 N\", \"-50 N\"], [10, 0]]", "vibration.directions=[\"+X\", \"90 deg\"]",
      "vibration.amplitudes=[\"1 um\", 2e-6]", "vibration.frequencies=[\"6000 rpm\", 500]"};
  const VibrationSettings vibration = with(given).settings.get<VibrationSettings>();
  EXPECT_EQ(vibration, (VibrationSettings{.loads = {{0.0, -50.0}, {10.0, 0.0}},
                                          .directions = {0.0, 0.5 * pi},
                                          .amplitudes = {1e-6, 2e-6},
                                          .frequencies = {200.0 * pi, 500.0}}));
  const auto changed = [&](const std::string& key) {
    std::vector<std::string> all = given;
    all.push_back(key);
    return refusal(all);
  };
  EXPECT_NE(changed("vibration.loads=[0, -50]").find("vibration.loads[1]"), std::string::npos);
  EXPECT_NE(changed("vibration.loads=[[0, -50, 1]]").find("vibration.loads[1]"), std::string::npos);
  EXPECT_NE(changed("vibration.loads=[[0, -50, 1]]").find("has 3 entries; give two, along X and Y"), std::string::npos);
  EXPECT_NE(
      changed("vibration.loads=[[5, \"5 um\"]]").find("vibration.loads[1][2] = 5 um: is a length, expected a force"),
      std::string::npos);
  EXPECT_NE(changed("vibration.loads=5 N").find("write a list of vectors"), std::string::npos);
  EXPECT_NE(changed("vibration.frequencies=[\"0 Hz\"]").find("vibration.frequencies[1] = 0 Hz: must be positive"),
            std::string::npos);
  EXPECT_NE(refusal({"vibration.loads=[[0, 5]]"}).find("vibration.amplitudes: is missing"), std::string::npos);
}

TEST(ParseCase, ReadsWhatCyclesGoAbout) {
  const auto preload = [](const std::string& text) {
    return with({"cycle.preload=" + text}).settings.get<CycleSettings>().preload.value();
  };
  EXPECT_EQ(with({}).settings.get<CycleSettings>().preload, std::nullopt);
  EXPECT_EQ(preload("[\"0 N\", \"-50 N\"]"), (PlaneTarget{Control::load, {0.0, -50.0}}));
  EXPECT_EQ(preload("[\"5 um\", 0]"), (PlaneTarget{Control::displacement, {5e-6, 0.0}}));
  EXPECT_EQ(preload("[0, 5e-6]"), (PlaneTarget{Control::displacement, {0.0, 5e-6}}));
  const CycleSettings by_load =
      with({"cycle.load=80 N", "cycle.preload=[0, -50]", "cycle.swing=true", "cycle.cycles=7"})
          .settings.get<CycleSettings>();
  EXPECT_EQ(by_load.amplitude, (Target{Control::load, 80.0}));  // in place of the amplitude of the file
  EXPECT_EQ(by_load.preload, (PlaneTarget{Control::load, {0.0, -50.0}}));
  EXPECT_TRUE(by_load.swing);
  EXPECT_EQ(by_load.cycles, 7);
  EXPECT_NE(refusal({"cycle.preload=[\"5 um\", \"5 N\"]"}).find("cycle.preload"), std::string::npos);
  EXPECT_NE(refusal({"cycle.preload=[\"5 um\", \"5 N\"]"}).find("mixes a displacement and a load"), std::string::npos);
  EXPECT_NE(refusal({"cycle.preload=[\"5 um\"]"}).find("has 1 entries; give two, along X and Y"), std::string::npos);
  EXPECT_NE(refusal({"cycle.preload=[\"5 um\", \"5 MPa\"]"}).find("cycle.preload[2] = 5 MPa"), std::string::npos);
  EXPECT_NE(refusal({"cycle.preload=50 N"}).find("is not a list"), std::string::npos);
}

TEST(ReadCase, KnowsTheRunningBearing) {
  EXPECT_EQ(with({}).settings.find<EquilibriumSettings>(), nullptr);
  EXPECT_EQ(with({}).gas.preset, GasPreset::air);
  const Case input =
      with({"gas.preset=helium", "gas.temperature=350 K", "gas.ambient_pressure=2 bar", "gas.mean_free_path=120 nm",
            "film.rows=8", "film.h_lift_off=2 um", "equilibrium.speeds=[\"30000 rpm\", 1000]",
            "equilibrium.loads=[[\"50 N\", \"-5 N\"], [1, 2]]", "equilibrium.steps=5"});
  EXPECT_EQ(input.gas.preset, GasPreset::helium);
  EXPECT_EQ(input.gas.temperature, 350.0);
  EXPECT_EQ(input.gas.ambient_pressure, 2e5);
  EXPECT_EQ(input.gas.mean_free_path, 120e-9);
  EXPECT_EQ(input.film.rows, 8);
  EXPECT_EQ(input.film.h_lift_off, 2e-6);
  const EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  ASSERT_EQ(equilibrium.speeds.size(), 2U);
  EXPECT_DOUBLE_EQ(equilibrium.speeds[0], 1000.0 * pi);
  EXPECT_EQ(equilibrium.loads, (std::vector<Eigen::Vector2d>{{50.0, -5.0}, {1.0, 2.0}}));
  EXPECT_EQ(equilibrium.path, FilmPath::load_ramp);
  EXPECT_EQ(equilibrium.steps, 5);
  // What is written of it means the same.
  EXPECT_EQ(parse_case(case_to_toml(input), "again.toml"), input);
}

TEST(ReadCase, TakesARayToPositions) {
  const auto to = [](const std::string& path) {
    std::vector<std::string> overrides{"equilibrium.speeds=[1000]", "equilibrium.positions=[[\"25 um\", 0]]"};
    if (!path.empty()) overrides.push_back("equilibrium.path=" + path);
    return with(overrides).settings.get<EquilibriumSettings>();
  };
  EXPECT_EQ(to("").path, FilmPath::position_ray);
  EXPECT_EQ(to("cold_start").path, FilmPath::cold_start);
  EXPECT_EQ(to("").positions, (std::vector<Eigen::Vector2d>{{25e-6, 0.0}}));
}

TEST(ReadCase, SaysWhatIsWrongWithARunningBearing) {
  const auto error = [](const std::string& loads) {
    return refusal({"equilibrium.speeds=[\"300 Hz\"]", "equilibrium.loads=" + loads});
  };
  try {
    parse_case(whole_case(), "case.toml",
               {.overrides = {"equilibrium.speeds=[\"300 Hz\"]", "equilibrium.loads=[]"}, .commands = {"equilibrium"}});
    ADD_FAILURE();
  } catch (const Error& error) {
    expect_in(error.what(), "equilibrium.loads: no load specified");
  }
  EXPECT_NE(error("50 N").find("write a list of vectors: [[\"50 N\", \"0 N\"]]"), std::string::npos);
  EXPECT_NE(error("[\"50 N\", \"0 N\"]").find("equilibrium.loads[1]"), std::string::npos);
  EXPECT_NE(error("[[\"50 N\"]]").find("give two, along X and Y"), std::string::npos);
  EXPECT_NE(error("[[\"50 N\", \"3 um\"]]").find("equilibrium.loads[1][2] = 3 um: is a length, expected a force"),
            std::string::npos);
  EXPECT_NE(refusal({"equilibrium.speeds=[\"50 1/s\"]", "equilibrium.loads=[[5, 0]]"})
                .find("may count revolutions or radians"),
            std::string::npos);
  EXPECT_NE(refusal({"equilibrium.loads=[[5, 0]]"}).find("equilibrium.speeds: is missing"), std::string::npos);
  EXPECT_NE(refusal({"gas.preset=steam"}).find("gas.temperature"), std::string::npos);
}

TEST(ParseCase, ReadsFlags) {
  EXPECT_TRUE(
      with({"bump_foil.model=frame", "bump_foil.stiffness_follows_height=true"}).bump_foil.stiffness_follows_height);
  EXPECT_NE(refusal({"bump_foil.stiffness_follows_height=1"}).find("is a whole number, expected true or false"),
            std::string::npos);
  EXPECT_NE(refusal({"bump_foil.stiffness_follows_height=true"}).find("only the frame model"), std::string::npos);
}

std::string refusal_of(const std::string& command, const std::vector<std::string>& overrides) {
  try {
    parse_case(whole_case(), "case.toml", {.overrides = overrides, .commands = {command}});
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(ParseCase, TakesAFrameForATrussThatNobodyAskedFor) {
  const std::string text =
      cut(cut(whole_case(), "model = \"truss\"\n"), "[bump_foil.truss]\nk1 = \"150 MN/m\"\ntheta_d = \"15.83 deg\"\n");
  const auto parse = [&text](std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(),
                     {"bump_foil.pitch=4.6 mm", "bump_foil.length=3.2 mm", "bump_foil.height=0.55 mm"});
    return parse_case(text, "case.toml", {.overrides = overrides, .commands = {"cycle"}});
  };
  const Case framed = parse({});
  EXPECT_EQ(framed.bump_foil.model, BumpFoilModel::frame);
  ASSERT_EQ(framed.remarks.size(), 1U);
  for (const char* const part : {"modelled as a frame", "k2 is identified as -", "bump_foil.model = \"frame\""}) {
    expect_in(framed.remarks.front(), part);
  }
  EXPECT_NE(case_to_toml(framed).find("model = \"frame\""), std::string::npos);
  EXPECT_TRUE(parse({"bump_foil.model=frame"}).remarks.empty());
  EXPECT_EQ(parse({"bump_foil.length=3.556 mm"}).bump_foil.model, BumpFoilModel::truss);
  EXPECT_THROW(parse({"bump_foil.model=truss"}), Error);
  EXPECT_THROW(parse({"bump_foil.truss.k1=150 MN/m"}), Error);
  EXPECT_EQ(parse({"bump_foil.truss.k2=1 MN/m", "bump_foil.truss.k3=1 MN/m"}).bump_foil.model, BumpFoilModel::truss);
  const Case padded = parse({"bump_foil.bumps=8", "pad=[{bump_foil={bumps=7}}, {}]"});
  EXPECT_EQ(padded.pads.front().bump_foil->model, BumpFoilModel::frame);
  EXPECT_THROW(parse({"bump_foil.bumps=8", "pad=[{bump_foil={model=\"truss\"}}, {}]"}), Error);
}

TEST(ParseCase, ReportsATrussThatCannotBeIdentified) {
  // Flats longer than the bumps; refused where the case is read.
  const std::vector<std::string> odd{"bump_foil.pitch=7.6 mm", "bump_foil.bumps=10"};
  EXPECT_NE(refusal_of("cycle", odd).find("bump_foil.truss.k2: is identified as -"), std::string::npos);
  EXPECT_NO_THROW(with(odd));  // properties can still be computed
  EXPECT_NO_THROW(with({odd[0], odd[1], "bump_foil.truss.k2=1 MN/m"}));
  EXPECT_NO_THROW(with({odd[0], odd[1], "bump_foil.model=frame"}));
}

TEST(ParseCase, TablesThatMayBeMissingAre) {
  const std::string text =
      cut(whole_case(), "[cycle]\ndirections = [\"+X\", \"37.5 deg\"]\namplitude = \"79.5 um\"\nsteps = 100\n");
  const Case input = parse_case(cut(text, "[solver]\nname = \"newton\"\neps_alm = \"100 MN/m\"\n"), "case.toml");
  EXPECT_EQ(input.settings.find<CycleSettings>(), nullptr);
  EXPECT_EQ(input.solver, SolverSettings{});
  try {
    parse_case(text, "case.toml", {.overrides = {}, .commands = {"cycle"}});
    ADD_FAILURE() << "the missing table went unnoticed";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "case.toml: cycle: this table is missing; add [cycle], which this command needs; `bumpfoil init` shows "
              "its keys");
  }
}

TEST(ParseCase, TablesThatPadsCannotHaveAreNotAskedFor) {
  const auto refusal_of = [](const std::string& table) {
    const CaseRequest request{.overrides = {"pad=[{}, {}]", "bump_foil.bumps=7"}, .commands = {table}};
    try {
      parse_case(whole_case(), "case.toml", request);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal_of("strip").find("pad: is not supported by this command"), std::string::npos);
  EXPECT_EQ(refusal_of("strip").find("is missing"), std::string::npos);
  EXPECT_NE(refusal_of("equilibrium").find("equilibrium: this table is missing"), std::string::npos);
}

TEST(ParseCase, CyclesGoInFourDirectionsUnlessToldOtherwise) {
  const std::string line = "directions = [\"+X\", \"37.5 deg\"]\n";
  EXPECT_EQ(parse_case(cut(whole_case(), line), "case.toml").settings.get<CycleSettings>().directions,
            (std::vector<double>{0.0, pi, 0.5 * pi, 1.5 * pi}));
  EXPECT_NE(refusal({"cycle.directions=[]"}).find("no direction specified"), std::string::npos);
  // Without an amplitude, too, it would pass for a case without the table.
  EXPECT_NE(refusal({"cycle.directions=[]", "cycle.amplitude=0"}).find("cycle.directions: no direction"),
            std::string::npos);
}

TEST(ParseCase, AxesAreExact) {
  const Case input = with({"cycle.directions=[\"+X\", \"+Y\", \"-X\", \"-Y\", \"45 deg\", 1.5]"});
  EXPECT_EQ(input.settings.get<CycleSettings>().directions,
            (std::vector<double>{0.0, 0.5 * pi, pi, 1.5 * pi, 0.25 * pi, 1.5}));
}

TEST(ParseCase, FrictionMayDifferPerInterface) {
  const std::string text = cut(whole_case(), "coefficient = 0.1\n");
  const CaseRequest both{.overrides = {"friction.top_bump=0.1", "friction.bump_sleeve=0"}, .commands = {}};
  EXPECT_EQ(parse_case(text, "case.toml", both).friction, (Friction{.top_bump = 0.1, .bump_sleeve = 0.0}));
  EXPECT_EQ(refusal({"friction.coefficient=none"}),  // said once
            "--set: friction.coefficient = none: is not a number; write a number, such as 0.1");
}

TEST(ParseCase, ReadsWindowsLineEndsAndByteOrderMark) {
  std::string text;
  for (const char c : whole_case()) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const TemporaryFolder folder;
  EXPECT_EQ(read_case(folder.write("case.toml", "\xef\xbb\xbf" + text)), parse_case(whole_case(), "case.toml"));
}

TEST(ParseCase, ReadsWhatDiffersAlongTheFoil) {
  std::string each = "[";
  for (int n = 0; n < 26; ++n) each += n < 25 ? "\"4.5 mm\", " : "4.4e-3]";
  const Case input = with({"bump_foil.pitch=" + each, "bump_foil.thickness={start = \"0.1 mm\", end = 0.11e-3}",
                           "bump_foil.height={start = \"0.5 mm\", end = \"0.4 mm\", law = \"geometric\"}"});
  ASSERT_TRUE(input.bump_foil.pitch.is_list());
  EXPECT_EQ(input.bump_foil.pitch.at(24, 26), 4.5e-3);
  EXPECT_EQ(input.bump_foil.pitch.at(25, 26), 4.4e-3);
  EXPECT_EQ(input.bump_foil.thickness, PerBump(0.1e-3, 0.11e-3, Grading::linear));
  EXPECT_EQ(input.bump_foil.height, PerBump(0.5e-3, 0.4e-3, Grading::geometric));

  const Case parts = parse_case(whole_case() + R"(
[[bump_foil.section]]
from = 1
to = 5
height = "0.5 mm"
[[bump_foil.section]]
from = 6
to = 6
pitch = "4.5 mm"
length = 3.5e-3
thickness = "0.1 mm"
[[bump_foil.shim]]
from = 20
to = 22
thickness = "25 um"
)",
                                "case.toml");
  EXPECT_EQ(parts.bump_foil.sections,
            (std::vector<BumpSection>{{.from = 1, .to = 5, .height = 0.5e-3},
                                      {.from = 6, .to = 6, .pitch = 4.5e-3, .length = 3.5e-3, .thickness = 0.1e-3}}));
  EXPECT_EQ(parts.bump_foil.shims, (std::vector<Shim>{{20, 22, 25e-6}}));
}

TEST(ParseCase, ReadsPads) {
  const Case input = with({"pad=[{lobe=\"5 um\"}, {weld_edge=\"trailing\", arc=\"100 deg\"}, {weld_angle=\"-50 deg\"}]",
                           "pad[3].bump_foil.height=\"0.5 mm\"", "pad[3].top_foil.thickness=\"0.15 mm\"",
                           "bump_foil.bumps=7", "bearing.pad_gap=\"20 deg\""});
  ASSERT_EQ(input.pads.size(), 3U);
  EXPECT_EQ(input.pads[0], (Pad{.lobe = 5e-6}));
  EXPECT_EQ(input.pads[1].weld_edge, WeldEdge::trailing);
  EXPECT_DOUBLE_EQ(input.pads[1].arc.value(), 100.0 / 180.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(input.pads[2].weld_angle.value(), -50.0 / 180.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(input.bearing.pad_gap.value(), std::numbers::pi / 9.0);
  // The rest of their foils is that of all.
  BumpFoil expected = input.bump_foil;
  expected.height = 0.5e-3;
  EXPECT_EQ(input.pads[2].bump_foil, expected);
  TopFoil top = input.top_foil;
  top.thickness = 0.15e-3;
  EXPECT_EQ(input.pads[2].top_foil, top);
  EXPECT_EQ(parse_case(case_to_toml(input), "written"), input);
}

TEST(ParseCase, ReadsBearingsOfARotor) {
  const std::vector<std::string> rotor{
      "rotor.mass=2 kg", "rotor.transverse_inertia=9e-3 kg m2", "rotor.bearings=[-0.07, 0.09]",
      "bump_foil.shim=[{from=1, to=2, thickness=1e-6}, {from=5, to=6, thickness=1e-6}]"};
  const auto on = [&rotor](const std::string& bearings) {
    std::vector<std::string> overrides = rotor;
    overrides.push_back("rotor.bearing=" + bearings);
    return overrides;
  };
  EXPECT_TRUE(with(rotor).rotor_bearings.empty());
  const Case input = with(on(R"([{}, {bearing={diameter="40 mm"}, friction={top_bump=0.3}, film={rows=9}, )"
                             R"(bump_foil={shim={from=3, to=4, thickness="2 um"}}, width={modes=3}, )"
                             R"(asperity={sigma="0.2 um", friction=0.1, pressure_factor=1e8}}])"));
  ASSERT_EQ(input.rotor_bearings.size(), 2U);
  EXPECT_EQ(input.rotor_bearings[0], RotorBearing{});
  const Case first = bearing_at(input, 0);
  EXPECT_EQ(static_cast<const BearingDesign&>(first), static_cast<const BearingDesign&>(input));
  EXPECT_FALSE(first.settings.find<RotorSettings>() != nullptr || first.asperity.has_value());
  // What is not said is that of the case; lists are replaced as a whole.
  const Case second = bearing_at(input, 1);
  Bearing bearing = input.bearing;
  bearing.radius = 20e-3;
  EXPECT_EQ(second.bearing, bearing);
  EXPECT_EQ(second.friction, (Friction{.top_bump = 0.3, .bump_sleeve = input.friction.bump_sleeve}));
  BumpFoil foil = input.bump_foil;
  foil.shims = {{3, 4, 2e-6}};
  EXPECT_EQ(second.bump_foil, foil);
  EXPECT_EQ(second.top_foil, input.top_foil);
  EXPECT_EQ(second.film.rows, 9);
  EXPECT_EQ(second.film.columns_per_pitch, input.film.columns_per_pitch);
  EXPECT_EQ(second.width, WidthSettings{.modes = 3});
  EXPECT_EQ(first.width, WidthSettings{});
  EXPECT_DOUBLE_EQ(second.asperity->sigma, 0.2e-6);
  EXPECT_EQ(parse_case(case_to_toml(input), "written"), input);
  expect_in(case_to_json(input), "\"bearing\": [\n      {},\n");
  // Pads replace those of the case, and have the foils of their bearing.
  const Case padded = with(on("[{pad=[{bump_foil={height=0.5e-3}}], bump_foil={bumps=7, shim=[]}}, {}]"));
  EXPECT_EQ(bearing_at(padded, 0).pads.at(0).bump_foil->bumps, 7);
  EXPECT_TRUE(bearing_at(padded, 1).pads.empty());
  EXPECT_EQ(parse_case(case_to_toml(padded), "written"), padded);

  const auto refused = [&](const std::string& bearings) { return refusal(on(bearings)); };
  expect_in(refused("[{}]"), "rotor.bearing: is given 1 times, for 2 bearing positions");
  expect_in(refused("[{}, {rotor={mass=1}}]"), "rotor.bearing[2].rotor: unknown table");
  expect_in(refused("[{}, {montecarlo={samples=1}}]"), "rotor.bearing[2].montecarlo: unknown table");
  expect_in(refused("[{}, {bearing={clearance=1e-6}}]"), "did you mean \"bearing.radial_clearance\"?");
  expect_in(refused("[{}, {friction={coefficient=2}}]"), "rotor.bearing[2].friction.coefficient = 2: is unphysical");
  // Dimensions that only together are wrong.
  expect_in(refused("[{bearing={radius=\"10 mm\"}}, {}]"),
            "rotor.bearing[1].bump_foil.bumps = 26: the foil would overlap itself");
  expect_in(refusal({"rotor.mass=2 kg", "rotor.bearing=[{}, {}]"}),
            "rotor.bearing: is given for a rotor that does not tilt");
}

TEST(ParseCase, SaysWhereABearingOfARotorIsWrong) {
  const std::string before = whole_case();
  const std::string text = before + R"(
[rotor]
mass = "2 kg"
transverse_inertia = "9e-3 kg m2"
bearings = ["-70 mm", "90 mm"]

[[rotor.bearing]]
[[rotor.bearing]]
bearing = { radial_clearance = "28 um" }
top_foil = { thickness = "9 mm" }
)";
  try {
    static_cast<void>(parse_case(text, "two.toml"));
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.errors().size(), 1U) << error.what();
    EXPECT_EQ(error.errors()[0].key, "rotor.bearing[2].top_foil.thickness");
    EXPECT_EQ(error.errors()[0].line, 10U + std::count(before.begin(), before.end(), '\n'));
    EXPECT_EQ(error.errors()[0].file, "two.toml");
  }
}

/// Bumps that make no truss are frames in all bearings of a rotor.
TEST(ParseCase, TakesAFrameForABearingOfARotor) {
  const std::string text =
      cut(cut(whole_case(), "model = \"truss\"\n"), "[bump_foil.truss]\nk1 = \"150 MN/m\"\ntheta_d = \"15.83 deg\"\n");
  const auto parse = [&text](const std::string& model) {
    return parse_case(
        text, "case.toml",
        {.overrides = {"rotor.mass=2 kg", "rotor.transverse_inertia=9e-3 kg m2", "rotor.bearings=[-0.07, 0.09]",
                       "rotor.bearing=[{}, {bump_foil={pitch=4.6e-3, length=3.2e-3, height=0.55e-3" + model + "}}]"},
         .commands = {"cycle"}});
  };
  const Case framed = parse("");
  EXPECT_EQ(framed.bump_foil.model, BumpFoilModel::frame);
  EXPECT_EQ(framed.rotor_bearings[1].bump_foil->model, BumpFoilModel::frame);
  ASSERT_EQ(framed.remarks.size(), 1U);
  expect_in(framed.remarks.front(), "rotor.bearing[2].bump_foil");
  EXPECT_THROW(parse(", model=\"truss\""), Error);
}

TEST(ParseCase, ReadsHowTopFoilsAreFormed) {
  EXPECT_EQ(with({}).top_foil.formed_radius, FormedRadius{});
  EXPECT_EQ(with({"top_foil.formed_radius=\"seated\""}).top_foil.formed_radius, FormedRadius{FormedTo::seated});
  const Case formed =
      with({"top_foil.formed_radius=19.3 mm", "top_foil.seat_pressure=0.2 kPa", "top_foil.overhang=2 mm",
            "montecarlo.formed_radius.std=50 um", "film.inlet_pressure=1.1 bar"});
  EXPECT_EQ(formed.top_foil.formed_radius.to, FormedTo::radius);
  EXPECT_DOUBLE_EQ(formed.top_foil.formed_radius.radius, 19.3e-3);
  EXPECT_DOUBLE_EQ(formed.top_foil.seat_pressure.value(), 200.0);
  EXPECT_DOUBLE_EQ(formed.top_foil.overhang.value(), 2e-3);
  EXPECT_DOUBLE_EQ(formed.montecarlo->formed_radius->sigma.value(), 50e-6);
  EXPECT_DOUBLE_EQ(formed.film.inlet_pressure.value(), 1.1e5);
  expect_in(refusal({"top_foil.formed_radius=\"sitting\""}), "or \"seated\"");
  expect_in(refusal({"top_foil.formed_radius=19.3 N"}), "top_foil.formed_radius");
}

TEST(ParseCase, ReadsRoughSurfaces) {
  EXPECT_FALSE(with({}).asperity.has_value());
  const Case rough = with({"asperity.sigma=0.3 um", "asperity.friction=0.2", "asperity.density=17000 1/mm2",
                           "asperity.radius=10 um", "asperity.modulus=117 GPa"});
  ASSERT_TRUE(rough.asperity.has_value());
  EXPECT_DOUBLE_EQ(rough.asperity->sigma, 0.3e-6);
  EXPECT_DOUBLE_EQ(rough.asperity->friction, 0.2);
  EXPECT_DOUBLE_EQ(rough.asperity->density.value(), 1.7e10);
  EXPECT_DOUBLE_EQ(rough.asperity->radius.value(), 10e-6);
  EXPECT_DOUBLE_EQ(rough.asperity->modulus.value(), 117e9);
  EXPECT_EQ(parse_case(case_to_toml(rough), "written"), rough);
  expect_in(refusal({"asperity.sigma=0.3 um"}), "asperity.friction: is missing");
  expect_in(refusal({"asperity.sigma=0.3 um", "asperity.friction=0.2", "asperity.density=17000 1/mm"}),
            "expected a number per area");
}

TEST(ParseCase, SaysWhatIsWrongWithPads) {
  expect_in(refusal({"pad=[{lob=1e-6}]"}), "did you mean \"lobe\"?");
  expect_in(refusal({"pad=[{}, {}]"}), "pad[2]: overlaps pad 1 by 177.5");
  expect_in(refusal({"bump_foil.bumps=7", "pad=[{}, {bump_foil={height=\"0.1 mm\"}}]"}), "pad[2].bump_foil.height");
}

TEST(ParseCase, SaysWhatIsWrongAlongTheFoil) {
  expect_in(refusal({"bump_foil.pitch={start = \"4 mm\"}"}), "bump_foil.pitch.end: is missing");
  expect_in(refusal({"bump_foil.pitch={start = 4e-3, end = 4e-3, low = 1}"}), "did you mean \"law\"?");
  expect_in(refusal({"bump_foil.pitch={start = 4e-3, end = 4e-3, law = \"sine\"}"}),
            "write one of \"linear\", \"geometric\"");
  expect_in(refusal({"bump_foil.pitch=[4e-3, \"1 N\"]"}), "bump_foil.pitch[2] = 1 N");
  expect_in(refusal({"bump_foil.pitch=[4e-3, 4e-3]"}), "there must be one value per bump, 26 in all");
  const auto refused = [](const std::string& tables) -> std::string {
    try {
      parse_case(whole_case() + tables, "case.toml");
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  expect_in(refused("[[bump_foil.shim]]\nfrom = 2\nto = 30\nthickness = \"2 um\"\n"),
            "bump_foil.shim[1].to = 30: is not a bump of the foil");
  expect_in(refused("[[bump_foil.shim]]\nfrom = 2\nthickness = \"2 um\"\n"), "bump_foil.shim[1].to: is missing");
  expect_in(refused("[[bump_foil.shim]]\nfrom = 2\nto = 3\nthick = \"2 um\"\n"),
            "bump_foil.shim[1].thick = 2 um: unknown key");
  expect_in(refusal({"bump_foil.shim=3"}), "write [[bump_foil.shim]]");
}

TEST(ReadCaseText, IsWhatItsAuthorWrote) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_case_text(folder.write("case.toml", "# mine\r\nx = 1\n")), "# mine\r\nx = 1\n");
}

TEST(ReadCase, FilesThatCannotBeReadAreNoWrongInput) {
  const TemporaryFolder folder;
  const auto kind = [](const std::string& path, const CaseRequest& request = {}) {
    try {
      read_case(path, request);
    } catch (const Error& error) {
      return error.kind();
    }
    ADD_FAILURE();
    return ErrorKind::input;
  };
  EXPECT_EQ(kind((folder.path() / "missing.toml").string()), ErrorKind::file);
  EXPECT_EQ(kind(folder.path().string()), ErrorKind::file);
  EXPECT_EQ(kind(folder.write("case.toml", whole_case()),
                 {.overrides = {"bump_foil.height_errors_file=missing.csv"}, .commands = {}}),
            ErrorKind::file);
  EXPECT_EQ(kind((folder.path() / "case.toml").string(),
                 {.overrides = {"bump_foil.height_errors_file=missing.csv", "bearing.radius=0"}, .commands = {}}),
            ErrorKind::input);
}

}  // namespace
}  // namespace bumpfoil
