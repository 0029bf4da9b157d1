#include "bumpfoil/experiments/result_schema.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

const json& schema() {
  static const json read = json::parse(result_schema());
  return read;
}

/// The first run of an experiment with this variable; -1 if there is none. @param found  receives the variable
int run_with(const std::string& experiment, const std::string& name, json& found) {
  const json& runs = schema().at("experiments").at(experiment);
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (const json& variable : runs[run].at("variables")) {
      if (variable.at("name") != name) continue;
      found = variable;
      return static_cast<int>(run);
    }
  }
  return -1;
}

TEST(ResultSchema, DescribesEveryExperiment) {
  for (const ExperimentInfo& experiment : experiments()) {
    ASSERT_FALSE(experiment.small_runs.empty()) << experiment.name;
    json status;
    EXPECT_NE(run_with(std::string(experiment.name), "status", status), -1) << experiment.name;
    EXPECT_EQ(status.at("form"), "flag");
    EXPECT_EQ(status.at("words").at(0), "converged");
  }
}

TEST(ResultSchema, SaysAllOfAVariable) {
  json found;
  ASSERT_EQ(run_with("cycle", "loaded_stiffness", found), 0);
  EXPECT_EQ(found.at("key"), "loaded_stiffness_N_per_m");
  EXPECT_EQ(found.at("unit"), "N/m");
  EXPECT_EQ(found.at("dims"), json({"direction"}));
  EXPECT_EQ(found.at("label"), "structural stiffness");
  EXPECT_EQ(found.at("shown"), json({{"unit", "MN/m"}, {"size", 1e6}}));
  EXPECT_EQ(found.at("tags"), json({"headline", "sampled", "measured", "leading"}));
  EXPECT_FALSE(found.at("coordinate"));
  ASSERT_EQ(run_with("strip", "force_direct", found), 0);
  EXPECT_EQ(found.at("long_name"), "applied force on the plate, towards the base");
  EXPECT_EQ(found.at("dims"), json({"cycle", "increment"}));
}

TEST(ResultSchema, HasWhatOnlySomeResultsHave) {
  json found;
  EXPECT_EQ(run_with("cycle", "event_from", found), 0);
  EXPECT_EQ(run_with("cycle", "crest_offset", found), 1);
  EXPECT_EQ(run_with("cycle", "pad_forces_x", found), 2);
  EXPECT_EQ(run_with("path", "orbit_number", found), 1);
  EXPECT_EQ(run_with("vibration", "sense", found), 1);
  EXPECT_EQ(run_with("equilibrium", "lift_off_speed", found), 1);
  EXPECT_EQ(run_with("equilibrium", "h_min_pad", found), 2);
  EXPECT_EQ(run_with("equilibrium", "asperity_share", found), 3);
  EXPECT_EQ(run_with("equilibrium", "asperity_pressure", found), 3);
  EXPECT_EQ(run_with("equilibrium", "h_min_z", found), 4);
  EXPECT_EQ(run_with("equilibrium", "film_top_parabola", found), 4);
  EXPECT_EQ(run_with("equilibrium", "moment_x", found), 4);
  EXPECT_EQ(run_with("film", "film_thickness", found), 0);
  EXPECT_EQ(found.at("dims"), json({"state", "row", "column"}));
}

TEST(ResultSchema, HasHowFormedFoilsLieWithoutAJournal) {
  for (const char* experiment : {"cycle", "path", "equilibrium"}) {
    for (const auto& [name, unit] : {std::pair{"formed_radius", "m"}, std::pair{"assembled_hold_down", "N"},
                                     std::pair{"assembled_lifted_bumps", "1"}, std::pair{"assembled_bulge", "m"},
                                     std::pair{"assembled_bulge_theta", "rad"}, std::pair{"assembled_room", "m"}}) {
      json found;
      EXPECT_EQ(run_with(experiment, name, found), 1) << experiment << ' ' << name;
      EXPECT_EQ(found.value("unit", ""), unit) << experiment << ' ' << name;
    }
  }
}

}  // namespace
}  // namespace bumpfoil
