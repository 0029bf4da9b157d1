#include "bumpfoil/experiments/optimise/optimise_settings.hpp"

#include <gtest/gtest.h>

#include <string>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

constexpr const char* table =
    "\n[optimise]\ncommand = \"cycle\"\nmaximise = \"loss_factor\"\nlimits = [\"max_force > 100 N\"]\n";
constexpr const char* clearance =
    "[[optimise.key]]\nkey = \"bearing.radial_clearance\"\nlower = \"25 um\"\nupper = \"0.045 mm\"\n";

Case read_optimisation(const std::string& text) {
  return parse_case(case_template("gen1") + text, "case.toml",
                    {.overrides = {}, .commands = {"optimise"}, .check = errors_of_run});
}

/// The errors, one per line; each has its position in the file, except for missing tables.
std::string errors_in(const std::string& text) {
  try {
    read_optimisation(text);
  } catch (const Error& error) {
    for (const InputError& one : error.errors()) {
      EXPECT_TRUE(one.line > 0 || one.what == "this table is missing") << format_error(one);
    }
    return error.what();
  }
  return "";
}

void expect_error(const std::string& text, const std::string& key, const std::string& words) {
  const std::string found = errors_in(text);
  EXPECT_NE(found.find(key), std::string::npos) << found;
  EXPECT_NE(found.find(words), std::string::npos) << found;
}

TEST(OptimiseSettings, AreReadFromCaseFilesAndWritten) {
  const Case input = read_optimisation(std::string(table) + clearance + "start = 3e-5\nlog = true\n");
  const OptimiseSettings& optimise = input.settings.get<OptimiseSettings>();
  EXPECT_EQ(optimise.command, "cycle");
  EXPECT_EQ(optimise.maximise, std::vector<std::string>{"loss_factor"});
  EXPECT_EQ(optimise.limits, std::vector<std::string>{"max_force > 100 N"});
  ASSERT_EQ(optimise.keys.size(), 1U);
  EXPECT_NEAR(optimise.keys[0].lower, 25e-6, 1e-18);
  EXPECT_NEAR(optimise.keys[0].upper, 45e-6, 1e-18);
  EXPECT_EQ(optimise.keys[0].start, 3e-5);
  EXPECT_TRUE(optimise.keys[0].log);
  EXPECT_EQ(parse_case(case_to_toml(input), "written"), input);
}

TEST(OptimiseSettings, TellWhatIsWrongAndWhere) {
  const std::string good = std::string(table) + clearance;
  EXPECT_EQ(errors_in(good), "");
  expect_error(good + "start = \"50 um\"\n", "optimise.key[1].start", "outside the bounds");
  expect_error(good + "lowr = 1\n", "optimise.key[1].lowr", "did you mean \"lower\"?");
  expect_error(std::string(table) + "[[optimise.key]]\nkey = \"friction.coefficient\"\nlower = 0.3\nupper = 0.1\n",
               "optimise.key[1].upper", "is not above lower");
  expect_error(
      std::string(table) + "[[optimise.key]]\nkey = \"friction.coefficient\"\nlower = 0\nupper = 0.1\nlog = true\n",
      "optimise.key[1].lower", "is not positive");
  expect_error(std::string(table) + "[[optimise.key]]\nkey = \"friction.coeficient\"\nlower = 0\nupper = 0.1\n",
               "optimise.key[1].key", "did you mean \"friction.coefficient\"?");
  expect_error(std::string(table) + "[[optimise.key]]\nkey = \"bump_foil.bumps\"\nlower = 10\nupper = 20\n",
               "optimise.key[1].key", "real-valued key");
  expect_error(good + clearance, "optimise.key[2].key", "chosen twice");
  std::string six = table;
  for (const char* key : {"bearing.radial_clearance", "bump_foil.height", "bump_foil.length", "bump_foil.thickness",
                          "top_foil.thickness", "bearing.axial_length"}) {
    six += "[[optimise.key]]\nkey = \"" + std::string(key) + "\"\nlower = 1e-5\nupper = 1e-2\n";
  }
  expect_error(six, "optimise.key", "at most 5");
  const auto with = [&](const std::string& lines) { return "\n[optimise]\ncommand = \"cycle\"\n" + lines + clearance; };
  expect_error(with("maximise = \"los_factor\"\n"), "optimise.maximise[1]", "did you mean \"loss_factor\"?");
  expect_error(with("minimise = [\"max_force\", \"loss_factor\", \"loop_energy\"]\n"), "optimise.minimise", "3 aims");
  expect_error(with("limits = [\"max_force > 1 N\"]\n"), "optimise.maximise", "is missing");
  expect_error(with("maximise = \"loss_factor\"\nlimits = [\"max_force > 1 N\", \"max_force > 5 um\"]\n"),
               "optimise.limits[2]", "expected a force");
  expect_error(with("maximise = \"loss_factor\"\nbearing_limits = [\"max_force > 1 N\"]\n"), "optimise.bearing_limits",
               "ensemble");
  expect_error(with("maximise = \"loss_factor\"\nevaluations = 0\n"), "optimise.evaluations", "number of points");
  // The bounds of an unknown or missing key cause no further errors, as their unit is unknown.
  const auto errors = [&](const std::string& key) {
    return errors_in(std::string(table) + "[[optimise.key]]\n" + key + "lower = \"25 um\"\nupper = \"45 um\"\n");
  };
  const std::string misspelt = errors("key = \"bearing.radial_clearence\"\n");
  EXPECT_NE(misspelt.find("did you mean \"bearing.radial_clearance\"?"), std::string::npos) << misspelt;
  EXPECT_EQ(misspelt.find("lower"), std::string::npos) << misspelt;
  EXPECT_EQ(misspelt.find("upper"), std::string::npos) << misspelt;
  EXPECT_EQ(errors("").find("lower"), std::string::npos);
  EXPECT_NE(errors("key = \"friction.coefficient\"\n").find("optimise.key[1].lower"), std::string::npos);
  // Errors of quantities are reported with other errors of the table, except its command.
  const std::string other = "[[optimise.key]]\nkey = \"friction.coeficient\"\nlower = 0\nupper = 1\n";
  const std::string all =
      errors_in("\n[optimise]\ncommand = \"cycle\"\nmaximise = \"los_factor\"\nstarts = 0\n" + other);
  for (const char* words : {"\"loss_factor\"?", "optimise.starts", "\"friction.coefficient\"?"}) {
    EXPECT_NE(all.find(words), std::string::npos) << all;
  }
  const std::string unknown = errors_in("\n[optimise]\ncommand = \"cicle\"\nmaximise = \"los_factor\"\n" + other);
  EXPECT_NE(unknown.find("\"cycle\"?"), std::string::npos) << unknown;
  EXPECT_EQ(unknown.find("loss_factor"), std::string::npos) << unknown;
  // All at once, each with its own place.
  const std::string both = errors_in(with("maximise = \"los_factor\"\nlimits = [\"max_forc > 5\"]\n"));
  EXPECT_NE(both.find("loss_factor"), std::string::npos);
  EXPECT_NE(both.find("\"max_force\"?"), std::string::npos);
}

/// Where the case has other errors, names are still compared with those that results of the command may have.
TEST(OptimiseSettings, TellUnknownQuantitiesBesideErrorsElsewhere) {
  const std::string elsewhere = "\n[nonsense]\nx = 1\n";
  const auto expect_all = [](const std::string& found, const std::vector<std::string>& words) {
    for (const std::string& word : words) EXPECT_NE(found.find(word), std::string::npos) << word << '\n' << found;
  };
  const std::string wrong = "maximise = \"los_factor\"\nlimits = [\"loop_energy < 1\", \"max_forc > 1 N\"]\n";
  const std::string text = elsewhere + "\n[optimise]\ncommand = \"cycle\"\nstarts = 0\n" + wrong + clearance;
  const std::string all = errors_in(text);
  expect_all(all, {"nonsense", "optimise.starts", "\"loss_factor\"?", "\"max_force\"?"});
  EXPECT_EQ(all.find("loop_energy"), std::string::npos) << all;
  // `check`, which runs no command, says the same.
  try {
    check_case(case_template("gen1") + text, "case.toml", {}, errors_of_run);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), all);
  }
  // Names that only some results have, such as those of limits; of ensembles those of limits of bearings, too.
  EXPECT_EQ(errors_in(elsewhere + "[equilibrium]\nspeeds = [\"45000 rpm\"]\nloads = [[50, 0]]\n" +
                      "\n[optimise]\ncommand = \"equilibrium\"\nmaximise = \"pad_force_x\"\n" + clearance)
                .find("pad_force_x"),
            std::string::npos);
  expect_all(
      errors_in(elsewhere + "[montecarlo]\nsamples = 2\nbump_height.std = \"1 um\"\n\n[optimise]\n" +
                "command = \"montecarlo\"\nmaximise = \"yeld\"\nbearing_limits = [\"max_forc > 1 N\"]\n" + clearance),
      {"nonsense", "\"yield\"", "\"max_force\"?"});
  // An unknown command has no known quantities.
  EXPECT_EQ(errors_in(elsewhere + "\n[optimise]\ncommand = \"cicle\"\n" + wrong + clearance).find("loss_factor"),
            std::string::npos);
}

TEST(OptimiseSettings, NeedTheTablesOfTheirCommand) {
  const std::string lines = "\n[optimise]\ncommand = \"vibration\"\nmaximise = \"loss_factor\"\n";
  expect_error(lines + clearance, "vibration", "this table is missing");
}

/// Of a case that was not read from a file.
TEST(OptimiseSettings, NameACommandThatCanBeRepeated) {
  const auto keys_of = [](const char* command) {
    return test_support::wrong_keys([command](Case& input) {
      OptimiseSettings settings{.minimise = {"power"},
                                .keys = {{.key = "friction.coefficient", .lower = 0.1, .upper = 0.2}}};
      settings.command = command;
      input.settings.set(settings);
    });
  };
  EXPECT_EQ(keys_of("cycle"), test_support::Keys{});
  EXPECT_EQ(keys_of("path"), test_support::Keys{"optimise.command"});
  EXPECT_EQ(keys_of(""), test_support::Keys{"optimise.command"});
}

}  // namespace
}  // namespace bumpfoil
