#include "experiments/equilibrium/film_ross_toml.hpp"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <cmath>
#include <set>

#include "bumpfoil/experiments/reference_case.hpp"
#include "core/linear_algebra.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

FilmWhirl whirl_of(double frequency, double stiffness) {
  Eigen::Matrix2cd impedance;
  impedance << std::complex<double>(stiffness, 2.0 * frequency), 1.0, 2.0, 3.0;
  return {.frequency = frequency, .impedance = impedance, .stuck_impedance = 10.0 * impedance};
}

/// @param whirls  at the tabulated frequencies; synchronous whirl has a stiffness of a tenth of the speed
RunningState state_of(double speed, const Eigen::Vector2d& load, std::vector<FilmWhirl> whirls) {
  RunningState state;
  state.requested = OperatingPoint::loaded_by(load, speed);
  state.report.status = Status::converged;
  state.synchronous = whirl_of(std::abs(speed), 0.1 * std::abs(speed));
  state.tabulated = std::move(whirls);
  return state;
}

Case case_with(std::vector<double> frequencies) {
  Case input = reference_case();
  input.settings.set(EquilibriumSettings{.speeds = {1.0}, .loads = {{1.0, 0.0}}});
  input.settings.get<EquilibriumSettings>().frequencies = std::move(frequencies);
  return input;
}

std::string written(Case input, std::vector<RunningState> states, int ross_version) {
  input.settings.get<EquilibriumSettings>().ross_version = ross_version;
  EquilibriumResult result;
  result.states = std::move(states);
  return film_ross_toml(input, result, "run");
}

toml::table parsed(const Case& input, std::vector<RunningState> states, int ross_version = 3) {
  return toml::parse(written(input, std::move(states), ross_version));
}

/// Whether the constructor of BearingElement of ROSS 3 takes a table: its names; axes that rise, of two values or more;
/// coefficients over both axes in a row for each speed, over one in a list, over none as numbers.
testing::AssertionResult is_taken(const toml::table& element) {
  const std::set<std::string_view> coefficients{"kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"};
  const auto size_of = [&element](std::string_view axis) -> std::size_t {
    if (!element.contains(axis)) return 0;
    const toml::array& values = *element[axis].as_array();
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
      if (!(values[i].value<double>() < values[i + 1].value<double>())) return 1;
    }
    return values.size();
  };
  const std::size_t speeds = size_of("speed");
  const std::size_t frequencies = size_of("frequency");
  if (speeds == 1 || frequencies == 1) return testing::AssertionFailure() << "an axis that does not rise";
  std::size_t found = 0;
  for (const auto& [key, value] : element) {
    if (key == "speed" || key == "frequency") continue;
    if (!coefficients.contains(key.str())) return testing::AssertionFailure() << key.str() << " is no argument";
    ++found;
    if (speeds == 0 && frequencies == 0) {
      if (!value.is_floating_point()) return testing::AssertionFailure() << key.str() << " is no number";
      continue;
    }
    const toml::array* list = value.as_array();
    if (list == nullptr || list->size() != (speeds > 0 ? speeds : frequencies)) {
      return testing::AssertionFailure() << key.str() << " is as long as no axis";
    }
    for (const toml::node& row : *list) {
      const bool both = speeds > 0 && frequencies > 0;
      if (both ? !row.is_array() || row.as_array()->size() != frequencies : !row.is_floating_point()) {
        return testing::AssertionFailure() << key.str() << " has a row that is as long as no axis";
      }
    }
  }
  if (found != coefficients.size()) return testing::AssertionFailure() << found << " coefficients";
  return testing::AssertionSuccess();
}

void expect_all_taken(const toml::table& document) {
  for (const toml::node& bearing : *document["bearing"].as_array()) {
    for (const char* name : {"element", "synchronous"}) {
      EXPECT_TRUE(is_taken(*(*bearing.as_table())[name].as_table())) << name;
    }
  }
}

TEST(FilmRossToml, TabulatesOverSpeedAndFrequencyAndSynchronousWhirlOverTheSpeed) {
  const auto at = [](double stiffness) {
    return std::vector{whirl_of(4.0, stiffness), whirl_of(36.0, stiffness + 1.0)};
  };
  // As a ramp down leaves them, with a state that was not found and one whose coefficients are not known.
  std::vector<RunningState> states{state_of(30.0, {5.0, -7.0}, at(300.0)), state_of(20.0, {5.0, -7.0}, at(200.0)),
                                   state_of(15.0, {5.0, -7.0}, at(150.0)), state_of(10.0, {5.0, -7.0}, at(100.0))};
  states[1].report.status = Status::fold;
  states[2].tabulated[1].impedance.reset();
  const toml::table document = parsed(case_with({}), states);
  expect_all_taken(document);
  const toml::array& bearings = *document["bearing"].as_array();
  ASSERT_EQ(bearings.size(), 2U);
  const toml::table& stuck = *bearings[0].as_table();
  const toml::table& slipping = *bearings[1].as_table();
  EXPECT_EQ(stuck["contacts"].value<std::string>(), "stuck");
  EXPECT_EQ(slipping["contacts"].value<std::string>(), "slipping");
  EXPECT_EQ(stuck["load_N"][1].value<double>(), -7.0);
  EXPECT_EQ(stuck["turns"].value<std::string>(), "from X to Y");
  EXPECT_EQ(stuck["element"]["speed"], (toml::array{10.0, 15.0, 30.0}));
  EXPECT_EQ(stuck["element"]["frequency"], (toml::array{4.0, 36.0}));
  EXPECT_EQ(stuck["element"]["kxx"],
            (toml::array{toml::array{1000.0, 1010.0}, toml::array{1500.0, 1510.0}, toml::array{3000.0, 3010.0}}));
  EXPECT_EQ(stuck["element"]["cxx"][1], (toml::array{20.0, 20.0}));
  EXPECT_EQ(stuck["synchronous"]["speed"], (toml::array{10.0, 15.0, 30.0}));
  EXPECT_EQ(stuck["synchronous"]["kxx"], (toml::array{10.0, 15.0, 30.0}));
  EXPECT_FALSE(stuck["synchronous"].as_table()->contains("frequency"));
  EXPECT_EQ(slipping["element"]["speed"], (toml::array{10.0, 30.0}));
  EXPECT_EQ(slipping["element"]["kyx"][1], (toml::array{2.0, 2.0}));
  EXPECT_EQ(slipping["synchronous"]["kyx"], (toml::array{2.0, 2.0}));
}

TEST(FilmRossToml, SaysWhatSynchronousCoefficientsAreFor) {
  const std::vector<RunningState> states{state_of(10.0, {1.0, 0.0}, {whirl_of(2.0, 3.0)})};
  const std::string words = "# synchronous: for unbalance response, not for stability\n[bearing.";
  EXPECT_NE(written(case_with({}), states, 3).find(words + "synchronous]"), std::string::npos);
  EXPECT_NE(written(case_with({}), states, 2).find(words + "element]"), std::string::npos);
  EXPECT_NE(written(case_with({}), states, 3).find("The case names no frequencies"), std::string::npos);
  EXPECT_EQ(written(case_with({2.0}), states, 3).find("The case names no frequencies"), std::string::npos);
}

/// Version 2 supports one axis, and evaluates it at the rotor speed.
TEST(FilmRossToml, OfVersion2IsSynchronous) {
  const toml::table document = parsed(case_with({40.0, 50.0}),
                                      {state_of(-20.0, {1.0, 0.0}, {whirl_of(40.0, 3.0), whirl_of(50.0, 4.0)}),
                                       state_of(-10.0, {1.0, 0.0}, {whirl_of(40.0, 1.0), whirl_of(50.0, 2.0)})},
                                      2);
  const toml::node_view slipping = document["bearing"][1];
  EXPECT_EQ(slipping["turns"].value<std::string>(), "from Y to X");
  EXPECT_EQ(slipping["element"]["frequency"], (toml::array{10.0, 20.0}));
  EXPECT_EQ(slipping["element"]["kxx"], (toml::array{1.0, 2.0}));
  EXPECT_FALSE(slipping["element"].as_table()->contains("speed"));
  EXPECT_FALSE(slipping.as_table()->contains("synchronous"));
}

TEST(FilmRossToml, LeavesOutAnAxisOfOneValue) {
  const std::vector<RunningState> one{state_of(20.0, {1.0, 0.0}, {whirl_of(40.0, 3.0), whirl_of(50.0, 4.0)})};
  const toml::table over_frequency = parsed(case_with({40.0, 50.0}), one);
  expect_all_taken(over_frequency);
  EXPECT_EQ(over_frequency["bearing"][1]["speed_rad_per_s"].value<double>(), 20.0);
  EXPECT_EQ(over_frequency["bearing"][1]["element"]["frequency"], (toml::array{40.0, 50.0}));
  EXPECT_EQ(over_frequency["bearing"][1]["element"]["kxx"], (toml::array{3.0, 4.0}));
  EXPECT_EQ(over_frequency["bearing"][1]["synchronous"]["kxx"].value<double>(), 2.0);

  const toml::table over_speed = parsed(case_with({40.0}), {state_of(20.0, {1.0, 0.0}, {whirl_of(40.0, 5.0)}),
                                                            state_of(30.0, {1.0, 0.0}, {whirl_of(40.0, 6.0)}),
                                                            state_of(30.0, {2.0, 0.0}, {whirl_of(40.0, 7.0)})});
  expect_all_taken(over_speed);
  ASSERT_EQ(over_speed["bearing"].as_array()->size(), 4U);  // two loads, stuck and slipping
  EXPECT_EQ(over_speed["bearing"][1]["element"]["speed"], (toml::array{20.0, 30.0}));
  EXPECT_EQ(over_speed["bearing"][1]["element"]["kxx"], (toml::array{5.0, 6.0}));
  EXPECT_EQ(over_speed["bearing"][3]["element"]["kxx"].value<double>(), 7.0);
}

/// Coefficients of one kind, as the file has them.
Eigen::Matrix2d matrix_of(const toml::table& element, char kind, const auto& look_up) {
  Eigen::Matrix2d matrix;
  const auto entry = [&](const char* axes) { return look_up(element[std::string(1, kind) + axes]); };
  matrix << entry("xx"), entry("xy"), entry("yx"), entry("yy");
  return matrix;
}

/// Eigenvalue of a mass on a bearing with the largest real part.
std::complex<double> least_damped(double mass, const Eigen::Matrix2d& K, const Eigen::Matrix2d& C) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A.topRightCorner<2, 2>().setIdentity();
  A.bottomLeftCorner<2, 2>() = -K / mass;
  A.bottomRightCorner<2, 2>() = -C / mass;
  const Eigen::VectorXcd values = eigenvalues(A).value();
  return *std::max_element(values.begin(), values.end(),
                           [](const auto& a, const auto& b) { return a.real() < b.real(); });
}

/// A rotor of 1 kg per bearing under its weight whirls unstably above 13,100 rpm (gas inlet at the weld). The
/// coefficients at the whirl frequency show this, those of synchronous whirl do not.
TEST(FilmRossToml, TellsAnUnstableRotorByItsTableAloneNotBySynchronousWhirl) {
  const double mass = 1.0;
  const double speed = speed_of_rpm(15000.0);
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4}, 0.0);
  input.settings.set(EquilibriumSettings{
      .speeds = {-speed, -0.9 * speed}, .loads = {{9.81 * mass, 0.0}}, .path = FilmPath::cold_start, .steps = 3});
  StateCheckers checkers;
  const EquilibriumResult result = run_equilibrium(input, {}, {}, &checkers);
  const toml::table document = toml::parse(film_ross_toml(input, result, "run"));
  expect_all_taken(document);
  const toml::table& table = *document["bearing"][0]["element"].as_table();
  const toml::array& axis = *table["frequency"].as_array();
  ASSERT_NEAR(*table["speed"][1].value<double>(), speed, 1e-9 * speed);

  // Linear between the frequencies, at the one that the rotor whirls with there.
  double whirl = 0.5 * speed;
  std::complex<double> root;
  for (int i = 0; i < 20; ++i) {
    std::size_t above = 1;
    while (above + 1 < axis.size() && *axis[above].value<double>() < whirl) ++above;
    const double low = *axis[above - 1].value<double>();
    const double part = (whirl - low) / (*axis[above].value<double>() - low);
    const auto at_whirl = [&](const auto& rows) {
      return (1.0 - part) * *rows[1][above - 1].template value<double>() +
             part * *rows[1][above].template value<double>();
    };
    root = least_damped(mass, matrix_of(table, 'k', at_whirl), matrix_of(table, 'c', at_whirl));
    whirl = std::abs(root.imag());
  }
  EXPECT_GT(root.real(), 0.0);
  EXPECT_GT(whirl, 0.4 * speed);
  EXPECT_LT(whirl, 0.6 * speed);

  const toml::table& synchronous = *document["bearing"][0]["synchronous"].as_table();
  const auto at_speed = [](const auto& values) { return *values[1].template value<double>(); };
  const std::complex<double> of_speed =
      least_damped(mass, matrix_of(synchronous, 'k', at_speed), matrix_of(synchronous, 'c', at_speed));
  EXPECT_LT(of_speed.real(), 0.0);
}

}  // namespace
}  // namespace bumpfoil
