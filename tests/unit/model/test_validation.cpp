#include "bumpfoil/model/validation.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "bumpfoil/experiments/path/path.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::nan;
using test_support::wrong_keys;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(FindErrors, FindsNoneInTheReferenceCase) {
  EXPECT_TRUE(find_errors(reference_case()).empty());
}

TEST(FindErrors, ChecksEnsembles) {
  const auto ensemble = [](const std::function<void(MonteCarloSettings&)>& change) {
    return wrong_keys([&](Case& input) {
      input.montecarlo = MonteCarloSettings{.bump_height = HeightScatter{Distribution{.sigma = 10e-6}}};
      change(*input.montecarlo);
    });
  };
  const auto heights = [&](const Distribution& distribution) {
    return ensemble([&](MonteCarloSettings& e) { e.bump_height->distribution = distribution; });
  };
  using enum DistributionKind;
  EXPECT_EQ(ensemble([](MonteCarloSettings&) {}), Keys{});
  EXPECT_EQ(ensemble([](MonteCarloSettings& e) { e.samples = 0; }), Keys{"montecarlo.samples"});
  for (const char* command :
       {"strip", "", "equilibrium", "stability", "unbalance", "transient"}) {  // none, or no table
    EXPECT_EQ(ensemble([command](MonteCarloSettings& e) { e.command = command; }), Keys{"montecarlo.command"})
        << command;
  }
  EXPECT_EQ(ensemble([](MonteCarloSettings& e) { e.seed = -1; }), Keys{"montecarlo.seed"});
  EXPECT_EQ(ensemble([](MonteCarloSettings& e) { e.bump_height.reset(); }), Keys{"montecarlo"});
  EXPECT_EQ(ensemble([](MonteCarloSettings& e) { e.bump_height->correlation_length = -1e-3; }),
            Keys{"montecarlo.bump_height.correlation_length"});
  EXPECT_EQ(heights({}), Keys{"montecarlo.bump_height.std"});
  EXPECT_EQ(heights({.sigma = 0.0}), Keys{"montecarlo.bump_height.std"});
  EXPECT_EQ(heights({.sigma = nan}), Keys{"montecarlo.bump_height.std"});
  EXPECT_EQ(heights({.sigma = 1e-6, .lower = -1e-6}), Keys{"montecarlo.bump_height.lower"});
  EXPECT_EQ(heights({.kind = uniform, .lower = -1e-6, .upper = 1e-6}), Keys{});
  EXPECT_EQ(heights({.kind = uniform, .lower = 1e-6, .upper = 1e-6}), Keys{"montecarlo.bump_height.upper"});
  EXPECT_EQ(heights({.kind = uniform, .sigma = 1e-6, .upper = 1e-6}),
            (Keys{"montecarlo.bump_height.std", "montecarlo.bump_height.lower"}));
  EXPECT_EQ(heights({.kind = truncated_normal, .sigma = 1e-6, .lower = -1e-6, .upper = 1e-6}), Keys{});
  EXPECT_EQ(heights({.kind = truncated_normal, .sigma = 1e-6, .lower = 9e-6, .upper = 10e-6}),
            Keys{"montecarlo.bump_height.lower"});
  EXPECT_EQ(heights({.kind = table}), Keys{"montecarlo.bump_height.values"});
  EXPECT_EQ(heights({.kind = table, .values = {0.0, infinity}}), Keys{"montecarlo.bump_height.values[2]"});
  EXPECT_EQ(ensemble([](MonteCarloSettings& e) { e.friction_top_bump = Distribution{.sigma = -0.1}; }),
            Keys{"montecarlo.friction_top_bump.std"});
  EXPECT_EQ(ensemble([](MonteCarloSettings& e) {
              e.sleeve_waviness = WavinessScatter{0, 5e-6};
            }),
            Keys{"montecarlo.sleeve_waviness.harmonic"});
  EXPECT_EQ(ensemble([](MonteCarloSettings& e) {
              e.sleeve_waviness = WavinessScatter{3, 5e-3};
            }),
            Keys{"montecarlo.sleeve_waviness.amplitude"});
}

TEST(FindErrors, ChecksTheWavesOfASleeve) {
  const auto waves = [](
                         Waviness given, const std::function<void(Case&)>& change = [](Case&) {}) {
    return wrong_keys([&](Case& input) {
      input.bearing.sleeve.waves = {given};
      change(input);
    });
  };
  EXPECT_EQ(waves({3, 5e-6, 1.0}), Keys{});
  EXPECT_EQ(waves({0, 0.0, nan}), (Keys{"bearing.sleeve_waviness[1].harmonic", "bearing.sleeve_waviness[1].amplitude",
                                        "bearing.sleeve_waviness[1].phase"}));
  EXPECT_EQ(waves({3, 5e-6, 1.0}, [](Case& input) { input.bump_foil.model = BumpFoilModel::former; }),
            Keys{"bump_foil.model"});
}

TEST(FindErrors, ChecksProfilesAndTapers) {
  const auto wrong = [](const std::function<void(Bearing&)>& change) {
    return wrong_keys([&](Case& input) { change(input.bearing); });
  };
  EXPECT_EQ(wrong([](Bearing& bearing) { bearing.journal.deviations = {1e-6, -2e-6}; }), Keys{});
  EXPECT_EQ(wrong([](Bearing& bearing) {
              bearing.journal.deviations = {1e-6, nan, -2e-3};
            }),
            (Keys{"bearing.journal_profile[2]", "bearing.journal_profile[3]"}));
  EXPECT_EQ(wrong([](Bearing& bearing) {
              bearing.journal.waves = {{2, 1e-6, 0.0}, {2, -1e-6, 0.0}};
            }),
            Keys{"bearing.journal_waviness[2].amplitude"});
  EXPECT_EQ(wrong([](Bearing& bearing) { bearing.taper = -3e-6; }), Keys{});
  EXPECT_EQ(wrong([](Bearing& bearing) { bearing.taper = 3e-3; }), Keys{"bearing.taper"});
}

TEST(FindErrors, ChecksPads) {
  const auto pads = [](const std::function<void(Case&)>& change) {
    return wrong_keys([&](Case& input) {
      input.bump_foil.bumps = 7;
      input.pads.resize(3);
      change(input);
    });
  };
  EXPECT_EQ(pads([](Case&) {}), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bearing.pad_gap = 0.1; }), Keys{"bearing.pad_gap"});
  EXPECT_EQ(pads([](Case& input) { input.bearing.pad_gap = 2.1; }), Keys{"bearing.pad_gap"});
  EXPECT_EQ(pads([](Case& input) { input.bearing.pad_gap = -0.1; }), Keys{"bearing.pad_gap"});
  EXPECT_EQ(pads([](Case& input) { input.bearing.pad_gap = 0.1; }), Keys{});
  EXPECT_EQ(pads([](Case& input) { input.pads[1].weld_angle = nan; }), Keys{"pad[2].weld_angle"});
  EXPECT_EQ(pads([](Case& input) { input.pads[1].arc = 0.0; }), Keys{"pad[2].arc"});
  EXPECT_EQ(pads([](Case& input) { input.pads[0].lobe = 5e-3; }), Keys{"pad[1].lobe"});
  // Foils per pad, unstretched and stretched to their arcs.
  EXPECT_EQ(pads([](Case& input) {
              input.pads[2].bump_foil = input.bump_foil;
              input.pads[2].bump_foil->thickness = -1.0;
            }),
            Keys{"pad[3].bump_foil.thickness"});
  EXPECT_EQ(pads([](Case& input) { input.pads[0].arc = 0.5; }), Keys{"pad[1].bump_foil.length"});
  for (const auto& change :
       std::vector<std::function<void(BumpFoil&)>>{[](BumpFoil& foil) { foil.model = BumpFoilModel::frame; },
                                                   [](BumpFoil& foil) { foil.yield_stress = 1e9; }}) {
    EXPECT_EQ(pads([&](Case& input) {
                input.pads[0].bump_foil = input.bump_foil;
                change(*input.pads[0].bump_foil);
              }).size(),
              1U);
  }
  // Pads start a third of the circumference, 2.09 rad, apart: these overlap.
  EXPECT_EQ(pads([](Case& input) { input.pads[2].weld_angle = input.bearing.weld_angle - 2.2; }), Keys{"pad[3]"});
  EXPECT_EQ(pads([](Case& input) { input.pads[1].arc = 2.2; }), Keys{"pad[3]"});
  // The limit, clearance plus rise, is lower towards a pad that is closer.
  EXPECT_EQ(pads([](Case& input) { input.settings.get<CycleSettings>().amplitude.value = 435e-6; }), Keys{});
  EXPECT_EQ(pads([](Case& input) {
              input.settings.get<CycleSettings>().amplitude.value = 435e-6;
              input.pads[0].lobe = 10e-6;
            }),
            Keys{"cycle.amplitude"});
}

TEST(FindErrors, KnowsPadsInFewCommands) {
  const auto pads = [](const std::function<void(Case&)>& change) {
    return wrong_keys([&](Case& input) {
      input.bump_foil.bumps = 7;
      input.pads.resize(2);
      change(input);
    });
  };
  EXPECT_EQ(pads([](Case& input) { input.bump_foil.model = BumpFoilModel::former; }), Keys{"bump_foil.model"});
  EXPECT_EQ(pads([](Case& input) { input.settings.set(StripSettings{.bumps = 7, .amplitude = {.value = 1e-6}}); }),
            Keys{"strip"});
  EXPECT_EQ(pads([](Case& input) {
              input.montecarlo = MonteCarloSettings{.bump_height = HeightScatter{Distribution{.sigma = 10e-6}}};
            }),
            Keys{});
}

TEST(FindErrors, ChecksTheFormingOfTopFoils) {
  const auto top = [](const std::function<void(TopFoil&)>& change) {
    return wrong_keys([&](Case& input) { change(input.top_foil); });
  };
  EXPECT_EQ(top([](TopFoil& foil) { foil.formed_radius = {FormedTo::radius, 19.2e-3}; }), Keys{});
  EXPECT_EQ(top([](TopFoil& foil) { foil.formed_radius = {FormedTo::radius, 18.9e-3}; }), Keys{});  // a warning only
  EXPECT_EQ(top([](TopFoil& foil) { foil.formed_radius = {FormedTo::radius, 9e-3}; }), Keys{"top_foil.formed_radius"});
  EXPECT_EQ(top([](TopFoil& foil) { foil.formed_radius = {FormedTo::radius, NAN}; }), Keys{"top_foil.formed_radius"});
  EXPECT_EQ(top([](TopFoil& foil) { foil.seat_pressure = -1.0; }), Keys{"top_foil.seat_pressure"});
  EXPECT_EQ(top([](TopFoil& foil) { foil.overhang = 0.0; }), Keys{"top_foil.overhang"});
  EXPECT_EQ(top([](TopFoil& foil) { foil.overhang = 9e-3; }), Keys{"top_foil.overhang"});  // overlaps the weld
  EXPECT_EQ(top([](TopFoil& foil) { foil.overhang = 2.5e-3; }), Keys{});
  const auto seated = [](double clearance) {
    return wrong_keys([&](Case& input) {
      input.top_foil.formed_radius = {FormedTo::seated};
      input.bearing.radial_clearance = clearance;
    });
  };
  EXPECT_EQ(seated(31.8e-6), Keys{});
  EXPECT_EQ(seated(0.0), Keys{"top_foil.formed_radius"});
}

/// A pad that is preloaded by more than the clearance is seated by the clearance of the bearing.
TEST(FindErrors, SeatsPreloadedPads) {
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.bumps = 7;
              input.top_foil.formed_radius = {FormedTo::seated};
              input.pads = {Pad{.lobe = 40e-6}, Pad{.lobe = 40e-6}, Pad{.lobe = 40e-6}};
            }),
            Keys{});
}

TEST(FindErrors, ChecksStrips) {
  const auto strip = [](const std::function<void(StripSettings&)>& change) {
    return wrong_keys([&](Case& input) {
      input.settings.set(StripSettings{.bumps = 10, .amplitude = {Control::displacement, 20e-6}});
      input.bump_foil.height_errors.assign(26, 0.0);
      change(input.settings.get<StripSettings>());
    });
  };
  const Target load{Control::load, 60.0};
  const Target light{Control::load, 50.0};
  EXPECT_EQ(strip([](StripSettings&) {}), Keys{});
  EXPECT_EQ(strip([](StripSettings& s) { s.bumps = 0; }), Keys{"strip.bumps"});
  EXPECT_EQ(strip([](StripSettings& s) { s.bumps = 27; }), Keys{"strip.bumps"});  // beyond the height errors
  EXPECT_EQ(strip([](StripSettings& s) { s.amplitude.value = 0.0; }), Keys{"strip.displacement"});
  EXPECT_EQ(strip([](StripSettings& s) { s.amplitude.value = 0.41e-3; }), Keys{"strip.displacement"});  // the rise
  EXPECT_EQ(strip([](StripSettings& s) { s.amplitude = {Control::load, -1.0}; }), Keys{"strip.load"});
  EXPECT_EQ(strip([](StripSettings& s) { s.preload = {Control::load, nan}; }), Keys{"strip.preload"});
  EXPECT_EQ(strip([&](StripSettings& s) { s.preload = light; }), Keys{});
  EXPECT_EQ(strip([&](StripSettings& s) { s.amplitude = s.preload.emplace(load); }), Keys{});
  const auto too_light = [&](StripSettings& s) {
    s.amplitude = load;
    s.preload = light;  // a plate cannot pull
  };
  EXPECT_EQ(strip(too_light), Keys{"strip.preload"});
  const auto mixed = [&](StripSettings& s) {
    s.amplitude = load;
    s.preload = {Control::displacement, 1e-6};
  };
  EXPECT_EQ(strip(mixed), Keys{"strip.preload"});
  const auto flat = [](StripSettings& s) {
    s.amplitude = {Control::displacement, 0.21e-3};  // each less than the rise of 0.406 mm, not both together
    s.preload = s.amplitude;
  };
  EXPECT_EQ(strip(flat), Keys{"strip.displacement"});
  EXPECT_EQ(strip([](StripSettings& s) { s.cycles = 0; }), Keys{"strip.cycles"});
  EXPECT_EQ(strip([](StripSettings& s) { s.steps = 0; }), Keys{"strip.steps"});
  EXPECT_EQ(strip([](StripSettings& s) { s.steps = s.cycles = 2000; }), Keys{"strip.steps"});  // memory
}

TEST(FindErrors, WantsFinitePositiveSizes) {
  const std::vector<std::pair<std::string, double& (*)(Case&)>> sizes{
      {"bearing.radius", [](Case& c) -> double& { return c.bearing.radius; }},
      {"bearing.axial_length", [](Case& c) -> double& { return c.bearing.axial_length; }},
      {"bump_foil.pitch", [](Case& c) -> double& { return c.bump_foil.pitch.values.front(); }},
      {"bump_foil.length", [](Case& c) -> double& { return c.bump_foil.length.values.front(); }},
      {"bump_foil.height", [](Case& c) -> double& { return c.bump_foil.height.values.front(); }},
      {"bump_foil.thickness", [](Case& c) -> double& { return c.bump_foil.thickness.values.front(); }},
      {"bump_foil.youngs_modulus", [](Case& c) -> double& { return c.bump_foil.youngs_modulus; }},
      {"top_foil.thickness", [](Case& c) -> double& { return c.top_foil.thickness; }},
      {"top_foil.youngs_modulus", [](Case& c) -> double& { return c.top_foil.youngs_modulus; }},
      {"solver.eps_alm", [](Case& c) -> double& { return c.solver.uzawa.eps_alm.emplace(); }},
      {"solver.eps_f", [](Case& c) -> double& { return c.solver.uzawa.eps_f.emplace(); }},
      {"solver.eps_r", [](Case& c) -> double& { return c.solver.uzawa.eps_r.emplace(); }},
      {"solver.tau_f", [](Case& c) -> double& { return c.solver.uzawa.tau_f.emplace(); }},
      {"cycle.amplitude", [](Case& c) -> double& { return c.settings.get<CycleSettings>().amplitude.value; }},
  };
  for (const auto& [key, size] : sizes) {
    for (const double value : {0.0, -1e-3, nan, infinity, -infinity, 1e300, 1e-300}) {
      // Reported once, without consequential errors.
      EXPECT_EQ(wrong_keys([&, member = size](Case& input) { member(input) = value; }), Keys{key}) << value;
    }
  }
}

TEST(FindErrors, TakesClearanceOfAnySign) {
  for (const double clearance : {-50e-6, 0.0, 50e-6}) {
    EXPECT_EQ(wrong_keys([&](Case& input) { input.bearing.radial_clearance = clearance; }), Keys{}) << clearance;
  }
  for (const double clearance : {-3e-3, 3e-3, nan}) {
    EXPECT_EQ(wrong_keys([&](Case& input) { input.bearing.radial_clearance = clearance; }),
              Keys{"bearing.radial_clearance"})
        << clearance;
  }
}

TEST(FindErrors, TakesDegreesForDegrees) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.bearing.weld_angle = 180.0; }), Keys{"bearing.weld_angle"});
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.settings.get<CycleSettings>().directions = {0.0, 90.0, nan};
            }),
            (Keys{"cycle.directions[2]", "cycle.directions[3]"}));
}

TEST(FindErrors, WantsFrictionBetweenNoneAndOne) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.friction = {.top_bump = 0.0, .bump_sleeve = 1.0}; }), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.friction = {.top_bump = -0.1, .bump_sleeve = 1.1}; }),
            (Keys{"friction.top_bump", "friction.bump_sleeve"}));
  EXPECT_EQ(wrong_keys([](Case& input) { input.friction.top_bump = nan; }), Keys{"friction.top_bump"});
}

TEST(FindErrors, FollowsLargeDisplacementsOfTheFrameWithNewtonAlone) {
  const auto nonlinear = [](BumpFoilModel model, SolverName solver) {
    return wrong_keys([=](Case& input) {
      input.bump_foil.model = model;
      input.bump_foil.geometry = Geometry::nonlinear;
      input.solver.name = solver;
    });
  };
  EXPECT_EQ(nonlinear(BumpFoilModel::frame, SolverName::newton), Keys{});
  EXPECT_EQ(nonlinear(BumpFoilModel::frame, SolverName::events), Keys{"solver.name"});
  EXPECT_EQ(nonlinear(BumpFoilModel::frame, SolverName::uzawa), Keys{"solver.name"});
  EXPECT_EQ(nonlinear(BumpFoilModel::truss, SolverName::newton), Keys{"bump_foil.geometry"});
  EXPECT_EQ(nonlinear(BumpFoilModel::truss, SolverName::events), (Keys{"bump_foil.geometry", "solver.name"}));
}

TEST(FindErrors, ListsEverything) {
  EXPECT_EQ(
      wrong_keys([](Case& input) {
        input.bearing.radius = -1.0;
        input.bump_foil.poisson_ratio = 0.7;
        input.top_foil.thickness = nan;
        input.friction.bump_sleeve = -1.0;
        input.settings.get<CycleSettings>().steps = 0;
      }),
      (Keys{"bearing.radius", "bump_foil.poisson_ratio", "top_foil.thickness", "friction.bump_sleeve", "cycle.steps"}));
}

TEST(RequireValid, ThrowsWhatWasFound) {
  Case input = reference_case();
  EXPECT_NO_THROW(require_valid(input));
  input.bearing.radius = 0.0;
  input.friction.top_bump = 2.0;
  try {
    require_valid(input);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.errors().size(), 2U);
  }
}

}  // namespace
}  // namespace bumpfoil
