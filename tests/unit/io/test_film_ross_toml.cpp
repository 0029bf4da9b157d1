#include "io/film_ross_toml.hpp"

#include <gtest/gtest.h>

#include <toml++/toml.h>

namespace bumpfoil {
namespace {

FilmWhirl whirl_of(double frequency, double stiffness) {
  Eigen::Matrix2cd impedance;
  impedance << std::complex<double>(stiffness, 2.0 * frequency), 1.0, 2.0, 3.0;
  return {.frequency = frequency, .impedance = impedance, .stuck_impedance = 10.0 * impedance};
}

RunningState state_of(double speed, const Eigen::Vector2d& load, std::vector<FilmWhirl> whirls) {
  RunningState state;
  state.asked.speed = speed;
  state.asked.control = OperatingPoint::Control::load;
  state.asked.journal = load;
  state.report.status = FilmStatus::converged;
  state.whirls = std::move(whirls);
  return state;
}

Case case_with(std::vector<double> frequencies) {
  Case input = reference_case();
  input.equilibrium = EquilibriumSettings{.speeds = {1.0}, .loads = {{1.0, 0.0}}};
  input.equilibrium->frequencies = std::move(frequencies);
  return input;
}

toml::table parsed(const Case& input, std::vector<RunningState> states) {
  EquilibriumResult result;
  result.states = std::move(states);
  return toml::parse(film_ross_toml(input, result, "run"));
}

TEST(FilmRossToml, TabulatesSynchronousWhirlOverTheSpeed) {
  // As a ramp down leaves them, with a state that was not found and one whose coefficients are not known.
  std::vector<RunningState> states{
      state_of(30.0, {5.0, -7.0}, {whirl_of(30.0, 300.0)}), state_of(20.0, {5.0, -7.0}, {whirl_of(20.0, 200.0)}),
      state_of(15.0, {5.0, -7.0}, {whirl_of(15.0, 150.0)}), state_of(10.0, {5.0, -7.0}, {whirl_of(10.0, 100.0)})};
  states[1].report.status = FilmStatus::fold;
  states[2].whirls[0].impedance.reset();
  const toml::table document = parsed(case_with({}), states);
  const toml::array& bearings = *document["bearing"].as_array();
  ASSERT_EQ(bearings.size(), 2U);
  const toml::table& stuck = *bearings[0].as_table();
  const toml::table& slipping = *bearings[1].as_table();
  EXPECT_EQ(stuck["contacts"].value<std::string>(), "stuck");
  EXPECT_EQ(slipping["contacts"].value<std::string>(), "slipping");
  EXPECT_EQ(stuck["load_N"][1].value<double>(), -7.0);
  EXPECT_EQ(stuck["turns"].value<std::string>(), "from X to Y");
  EXPECT_EQ(stuck["element"]["frequency"], (toml::array{10.0, 15.0, 30.0}));
  EXPECT_EQ(stuck["element"]["kxx"], (toml::array{1000.0, 1500.0, 3000.0}));
  EXPECT_EQ(stuck["element"]["cxx"], (toml::array{20.0, 20.0, 20.0}));
  EXPECT_EQ(slipping["element"]["frequency"], (toml::array{10.0, 30.0}));
  EXPECT_EQ(slipping["element"]["kxx"], (toml::array{100.0, 300.0}));
  EXPECT_EQ(slipping["element"]["kyx"], (toml::array{2.0, 2.0}));
  EXPECT_EQ(slipping["element"].as_table()->size(), 9U);  // nothing that a constructor would not take
}

TEST(FilmRossToml, HasARowForEachSpeedWhereFrequenciesAreGiven) {
  const std::vector<double> frequencies{50.0, 40.0};
  const toml::table document =
      parsed(case_with(frequencies), {state_of(-20.0, {1.0, 0.0}, {whirl_of(50.0, 4.0), whirl_of(40.0, 3.0)}),
                                      state_of(-10.0, {1.0, 0.0}, {whirl_of(50.0, 2.0), whirl_of(40.0, 1.0)})});
  const toml::node_view element = document["bearing"][1]["element"];
  EXPECT_EQ(document["bearing"][1]["turns"].value<std::string>(), "from Y to X");
  EXPECT_EQ(element["speed"], (toml::array{10.0, 20.0}));
  EXPECT_EQ(element["frequency"], (toml::array{40.0, 50.0}));
  EXPECT_EQ(element["kxx"], (toml::array{toml::array{1.0, 2.0}, toml::array{3.0, 4.0}}));
  EXPECT_EQ(element["cxx"][1], (toml::array{2.0, 2.0}));
}

TEST(FilmRossToml, OfOneSpeedIsAListOverFrequenciesOrANumber) {
  const std::vector<RunningState> states{state_of(20.0, {1.0, 0.0}, {whirl_of(40.0, 3.0), whirl_of(50.0, 4.0)}),
                                         state_of(20.0, {2.0, 0.0}, {whirl_of(40.0, 5.0)})};
  const toml::table document = parsed(case_with({40.0, 50.0}), states);
  ASSERT_EQ(document["bearing"].as_array()->size(), 4U);  // two loads, stuck and slipping
  EXPECT_EQ(document["bearing"][1]["speed_rad_per_s"].value<double>(), 20.0);
  EXPECT_EQ(document["bearing"][1]["element"]["kxx"], (toml::array{3.0, 4.0}));
  EXPECT_FALSE(document["bearing"][1]["element"].as_table()->contains("speed"));
  EXPECT_EQ(document["bearing"][3]["element"]["kxx"].value<double>(), 5.0);
  EXPECT_FALSE(document["bearing"][3]["element"].as_table()->contains("frequency"));
}

}  // namespace
}  // namespace bumpfoil
