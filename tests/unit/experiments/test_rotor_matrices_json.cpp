#include "experiments/rotor_matrices_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/rotor_settings.hpp"
#include "support/case_texts.hpp"
#include "support/temporary_folder.hpp"
#include "support/wrong_cases.hpp"

namespace bumpfoil {
namespace {

using test_support::TemporaryFolder;
using test_support::whole_case;
using Json = nlohmann::json;

/// A rigid rotor of 2 kg with position and tilt as unknowns, and the displacements at its bearings and a station.
Json rotor_file() {
  // y = (X, Y, dx/dz, dy/dz) follows from the displacements a at -0.05 m and b at 0.05 m: X = (a + b) / 2,
  // dx/dz = (b - a) / 0.1.
  const double m = 2.0 / 4.0;
  const double t = 4e-3 / 0.01;
  const double p = 5e-4 / 0.01;
  const auto rows = [](double same, double other) {
    return Json{{same, 0.0, other, 0.0}, {0.0, same, 0.0, other}, {other, 0.0, same, 0.0}, {0.0, other, 0.0, same}};
  };
  const Json G{{0.0, p, 0.0, -p}, {-p, 0.0, p, 0.0}, {0.0, -p, 0.0, p}, {p, 0.0, -p, 0.0}};
  return {{"M", rows(m + t, m - t)},
          {"C", rows(0.0, 0.0)},
          {"G", G},
          {"K", rows(0.0, 0.0)},
          {"bearing",
           {{{"name", "drive end"}, {"z", -0.05}, {"x", 0}, {"y", 1}},
            {{"name", "wheel"}, {"z", 0.05}, {"x", 2}, {"y", 3}}}},
          {"station", {{{"name", "hub"}, {"z", 0.05}, {"x", 2}, {"y", 3}}}}};
}

/// "key: what" of all errors of a file with this text.
std::vector<std::string> errors_of(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("rotor.json", text);
  const std::string path = (folder.path() / "rotor.json").string();
  std::vector<std::string> errors;
  try {
    static_cast<void>(read_rotor_matrices(path));
  } catch (const Error& error) {
    for (const InputError& one : error.errors()) {
      EXPECT_EQ(one.file, path);
      errors.push_back(one.key + ": " + one.what);
    }
  }
  return errors;
}

using InputErrors = std::vector<std::string>;

TEST(ReadRotorMatrices, ReadsARotor) {
  const TemporaryFolder folder;
  folder.write("rotor.json", rotor_file().dump());
  const RotorMatrices read = read_rotor_matrices((folder.path() / "rotor.json").string());
  EXPECT_EQ(read.mass.size(), 16U);
  EXPECT_DOUBLE_EQ(read.mass[2], 0.5 - 0.4);
  EXPECT_DOUBLE_EQ(read.gyroscopic[1], 0.05);
  ASSERT_EQ(read.bearings.size(), 2U);
  EXPECT_EQ(read.bearings[1], (MatrixPlace{"wheel", 0.05, 2, 3}));
  EXPECT_EQ(read.stations.at(0).name, "hub");
}

TEST(ReadRotorMatrices, NamesAllThatIsWrong) {
  EXPECT_EQ(errors_of("[1, 2"), InputErrors{": is not JSON"});
  EXPECT_EQ(errors_of("[1, 2]"), InputErrors{": is not a JSON object"});
  EXPECT_EQ(errors_of("{}"),
            (InputErrors{"M: is missing", "C: is missing", "G: is missing", "K: is missing", "bearing: is missing"}));
  Json file = rotor_file();
  file["Q"] = 1;
  file["M"][1].push_back(0.0);
  file["K"][2] = "none";
  file["bearing"][0].erase("z");
  file["bearing"][1]["x"] = 2.5;
  file["bearing"][1]["why"] = 3;
  file["station"][0]["y"] = -1;
  EXPECT_EQ(
      errors_of(file.dump()),
      (InputErrors{"Q: unknown key", "M[2]: has 5 numbers, but there are 4 rows", "K[3]: is not a list of numbers",
                   "bearing[1].z: is missing", "bearing[2].why: unknown key",
                   "bearing[2].x: is no number of a row, from 0", "station[1].y: is no number of a row, from 0"}));
  // Lists that are none or too long.
  file = rotor_file();
  file["M"] = 3;
  file["C"] = std::vector<Json>(most_rotor_unknowns + 1, Json::array());
  file["K"] = Json{{1.0, "stiff"}, 7};
  file["bearing"] = "two";
  file["station"] = {1};
  EXPECT_EQ(errors_of(file.dump()),
            (InputErrors{"M: is not a list of rows", "C: has 301 rows", "K[1]: is not a list of numbers",
                         "K[2]: is not a list of numbers", "bearing: is no list", "station[1]: is no object"}));
  file = rotor_file();
  file["station"] = std::vector<Json>(most_rotor_unknowns + 1);
  EXPECT_EQ(errors_of(file.dump()), InputErrors{"station: has 301 entries"});
  // Properties of complete matrices.
  file = rotor_file();
  file["M"][0][2] = 7.0;
  file["G"][0][0] = 1.0;
  const InputErrors found = errors_of(file.dump());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].starts_with("M[3][1]: is not that of the entry opposite")) << found[0];
  EXPECT_TRUE(found[1].starts_with("G[1][1]: is not 0 on the diagonal")) << found[1];
}

/// A case file with matrices is read, keeps them, and reports errors.
TEST(RotorMatrices, GoThroughACaseFile) {
  const TemporaryFolder folder;
  folder.write("rotor.json", rotor_file().dump());
  const auto read = [&](std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(), "rotor.matrices=rotor.json");
    return parse_case(whole_case(), (folder.path() / "case.toml").string(), {.overrides = overrides, .commands = {}});
  };
  const auto refusal = [&](std::vector<std::string> overrides) -> std::string {
    try {
      static_cast<void>(read(std::move(overrides)));
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  const Case input =
      read({"rotor.unbalance=[{amount=1e-6, at=0.05}]", "rotor.bearing=[{}, {friction={coefficient=0}}]"});
  const RotorSettings& rotor = input.settings.get<RotorSettings>();
  ASSERT_TRUE(rotor.matrices.has_value());
  // Without the file, the written case contains everything.
  EXPECT_EQ(parse_case(case_to_toml(input), "written.toml"), input);
  const ReducedRotor made = rotor_of(rotor, 1000.0);
  EXPECT_EQ(made.rotor.bearings[0].name, "drive end");
  EXPECT_NEAR(made.rotor.total_mass(), 2.0, 1e-12);
  ASSERT_EQ(made.rotor.stations.size(), 2U);
  EXPECT_EQ(made.rotor.stations[1].name, "plane 1");
  EXPECT_EQ(made.rotor.stations[1].motion, made.rotor.bearings[1].motion);

  EXPECT_NE(
      refusal({"rotor.unbalance=[{amount=1e-6, at=0.04}]"}).find("rotor.unbalance[1].at = 0.04: is not a bearing"),
      std::string::npos);
  EXPECT_NE(refusal({"rotor.mass=2"}).find("rotor.mass = 2: is given in addition to matrices"), std::string::npos);
  EXPECT_NE(refusal({"rotor.bearings=[-0.05, 0.05]"}).find("rotor.bearings: is given in addition to matrices"),
            std::string::npos);
  EXPECT_NE(refusal({"rotor.matrix.M=[1.0]"}).find("conflicts with matrix"), std::string::npos);
  Json wrong = rotor_file();
  wrong["bearing"][1]["x"] = 9;
  folder.write("rotor.json", wrong.dump());
  EXPECT_NE(refusal({}).find("rotor.json: bearing[2].x = 9: is not an unknown of M"), std::string::npos) << refusal({});
  EXPECT_EQ(refusal({}).find("rotor.mass"), std::string::npos) << refusal({});
  EXPECT_EQ(refusal({}).find("rotor.matrix"), std::string::npos) << refusal({});
  EXPECT_NE(refusal({"rotor.matrices=none.json"}).find("none.json: cannot be read"), std::string::npos);
  EXPECT_EQ(refusal({"rotor.matrices=none.json"}).find("rotor.m"), std::string::npos);
  // Matrices within the case are checked in the same way.
  Case inner = input;
  inner.settings.get<RotorSettings>().matrices->mass[2] = 7.0;
  try {
    static_cast<void>(parse_case(case_to_toml(inner), "inner.toml"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("rotor.matrix.M[3][1]"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bumpfoil
