// What --set does to a case.

#include "bumpfoil/case/case_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/case_texts.hpp"
#include "support/wrong_cases.hpp"

namespace bumpfoil {
namespace {

using test_support::cut;
using test_support::refusal;
using test_support::whole_case;
using test_support::with;

TEST(Overrides, TakeTomlAndBareStrings) {
  EXPECT_EQ(with({"friction.coefficient=0.2"}).friction.top_bump, 0.2);
  EXPECT_EQ(with({"bump_foil.height=0.5 mm"}).bump_foil.height.values,
            std::vector{0.5e-3});  // as the shell leaves "0.5 mm"
  EXPECT_EQ(with({"bump_foil.height=\"0.5 mm\""}).bump_foil.height.values,
            std::vector{0.5e-3});  // as it leaves '"0.5 mm"'
  EXPECT_EQ(with({"bump_foil.height=0.0005"}).bump_foil.height.values, std::vector{0.5e-3});
  EXPECT_EQ(with({"bearing.wrap=counterclockwise"}).bearing.wrap, Wrap::counterclockwise);
  EXPECT_EQ(with({"title=a = \"b\" # c"}).title, "a = \"b\" # c");
  EXPECT_EQ(with({"title="}).title, "");
  EXPECT_EQ(with({"bump_foil.truss={k1=1e8}"}).bump_foil.truss,
            (TrussOverrides{.k1 = 1e8, .k2 = {}, .k3 = {}, .k4 = {}, .theta_d = {}}));
}

TEST(Overrides, MayAddTablesAndTheLastOneWins) {
  const std::string text = cut(whole_case(), "[friction]\ncoefficient = 0.1\n");
  const CaseRequest request{.overrides = {"friction.coefficient=0.3", "friction.coefficient=0.2"}, .commands = {}};
  EXPECT_EQ(parse_case(text, "case.toml", request).friction.top_bump, 0.2);
}

TEST(Overrides, AreBlamedInPlaceOfTheFile) {
  EXPECT_EQ(refusal({"bearing.radius=-1 mm"}),
            "--set: bearing.radius = -1 mm: must be positive; give a value from 1e-09 m to 1000 m");
  EXPECT_EQ(refusal({"bearing.radus=1 mm"}), "--set: bearing.radus = 1 mm: unknown key; did you mean \"radius\"?");
  EXPECT_NE(refusal({"lubricant.name=air"}).find("--set: lubricant: unknown table"), std::string::npos);
  EXPECT_NE(refusal({"bump_foil.height_errors=[1, 2]"}).find("--set: bump_foil.height_errors = 2 values"),
            std::string::npos);
}

TEST(Overrides, AreToldTheWholeKeyThatWasMeant) {
  const auto meant = [](const std::string& key) {
    const std::string message = refusal({key + "=0.2"});
    const std::size_t at = message.find("did you mean");
    return at == std::string::npos ? message : message.substr(at);
  };
  EXPECT_EQ(meant("coefficient"), "did you mean \"friction.coefficient\"?");
  EXPECT_EQ(meant("coeficient"), "did you mean \"friction.coefficient\"?");
  EXPECT_EQ(meant("friction_coefficient"), "did you mean \"friction.coefficient\"?");
  EXPECT_EQ(meant("Bump-Sleeve"), "did you mean \"friction.bump_sleeve\"?");
  EXPECT_EQ(meant("radius"), "did you mean \"bearing.radius\" or \"asperity.radius\"?");
  EXPECT_EQ(meant("clearance"), "did you mean \"bearing.radial_clearance\"?");
  EXPECT_EQ(meant("pitch"), "did you mean \"bump_foil.pitch\"?");  // and not the table path
  EXPECT_EQ(meant("thickness"), "did you mean \"bump_foil.thickness\" or \"top_foil.thickness\"?");
  EXPECT_EQ(meant("steps"),
            "did you mean \"cycle.steps\", \"strip.steps\", \"path.steps\", \"vibration.steps\" or "
            "\"equilibrium.steps\"?");
  EXPECT_NE(meant("std").find("\", ...?"), std::string::npos);
  EXPECT_EQ(meant("foil.height"), "did you mean \"bump_foil.height\"?");
  EXPECT_EQ(meant("bearing.coefficient"), "did you mean \"friction.coefficient\"?");
  // A slip in the name of a table or of a key in its table is one.
  EXPECT_EQ(meant("frction.coefficient"), "did you mean \"friction\"?");
  EXPECT_EQ(meant("vibration.amplitude"), "did you mean \"amplitudes\"?");
  EXPECT_NE(meant("mu").find("known here: title, bearing"), std::string::npos);
  EXPECT_EQ(refusal({"friction=0.2"}),
            "--set: friction = 0.2: is a number, expected a table; set one of its keys, such as friction.coefficient");
}

TEST(Overrides, AreToldThatNumbersAreMetres) {
  const std::string hint = "; numbers are metres: write a unit if that is not meant, \"31.8 mm\"";
  EXPECT_TRUE(refusal({"bearing.radial_clearance=31.8"}).ends_with(hint));
  EXPECT_EQ(refusal({"bearing.radial_clearance=0.0318"}).find("numbers are"), std::string::npos);
  EXPECT_EQ(refusal({"bearing.radial_clearance=31.8 m"}).find("numbers are"), std::string::npos);
}

/// Results hold the title, and their files are UTF-8.
TEST(Overrides, AreUtf8) {
  EXPECT_EQ(refusal({"title=Rig \xb5"}),
            "--set: title = Rig \\xb5: is not UTF-8 text; use a terminal or script whose character encoding is UTF-8");
}

TEST(Overrides, WithNumbersThatAreNone) {
  for (const std::string number : {"99999999999999999999", "-99999999999999999999", "1e400"}) {
    EXPECT_EQ(refusal({"bump_foil.bumps=" + number}),
              "--set: bump_foil.bumps = " + number + ": is out of range; give a number that the program can hold");
  }
  // Invalid TOML is a text; the message does not call it one if it was not quoted.
  EXPECT_EQ(refusal({"bump_foil.bumps=026"}),
            "--set: bump_foil.bumps = 026: is not a whole number; write a whole number, such as 26");
  EXPECT_EQ(refusal({"friction.coefficient=.1"}),
            "--set: friction.coefficient = .1: is not a number; write a number, such as 0.1");
  EXPECT_EQ(refusal({"friction.coefficient=0,2"}),
            "--set: friction.coefficient = 0,2: is not a number; write a decimal point: 0.2");
  EXPECT_NE(refusal({"friction.coefficient=0,2,3"}).find("such as 0.1"), std::string::npos);
  EXPECT_NE(refusal({"strip.displacement=20 um", "strip.top_foil=yes"}).find("is not true or false"),
            std::string::npos);
  EXPECT_NE(refusal({"cycle.directions=+X"}).find("cycle.directions = +X: is not a list"), std::string::npos);
  EXPECT_EQ(with({"title=99999999999999999999 mm"}).title, "99999999999999999999 mm");
}

TEST(Overrides, MustBeAssignments) {
  for (const std::string argument : {"", "=", "friction", "=0.2", ".=1", "friction.=1", ".coefficient=1", "a b=1",
                                     "\n=1", "a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q=1"}) {
    EXPECT_NE(refusal({argument}).find("does not assign"), std::string::npos) << argument;
  }
  EXPECT_NE(refusal({"title.x=1"}).find("\"title\" is a value, not a table"), std::string::npos);
  EXPECT_NE(refusal({"bearing[0].radius=1"}).find("does not assign a key"), std::string::npos);
  EXPECT_NE(refusal({"bearing[1]=1"}).find("does not assign a key"), std::string::npos);
  EXPECT_NE(refusal({"bump_foil.shim[2].from=1"}).find("\"shim[2]\" does not exist: there are 0"), std::string::npos);
}

TEST(Overrides, CannotSmuggleInOtherKeys) {
  EXPECT_EQ(with({"title=\"x\"\n[friction]\ncoefficient=0.4"}).friction.top_bump, 0.1);
  EXPECT_EQ(with({"title=1\nb=2"}).title, "1\nb=2");
}

TEST(Overrides, AreReportedWithTheOtherErrors) {
  const std::string message = refusal({"nonsense", "bearing.radius=0", "friction.coefficient=true"});
  EXPECT_NE(message.find("nonsense"), std::string::npos);
  EXPECT_NE(message.find("bearing.radius"), std::string::npos);
  EXPECT_NE(message.find("friction.coefficient"), std::string::npos);
}

TEST(Overrides, CountTablesOfAList) {
  const std::vector<std::string> shim{"bump_foil.shim[1].from=1", "bump_foil.shim.to=2",
                                      "bump_foil.shim[1].thickness=5 um"};
  EXPECT_EQ(with(shim).bump_foil.shims, (std::vector<Shim>{{1, 2, 5e-6}}));
  const std::string two = "bump_foil.shim=[{from=1, to=2, thickness=1e-6}, {from=5, to=6, thickness=1e-6}]";
  EXPECT_EQ(with({two, "bump_foil.shim[2].thickness=5 um"}).bump_foil.shims,
            (std::vector<Shim>{{1, 2, 1e-6}, {5, 6, 5e-6}}));
  EXPECT_NE(refusal({two, "bump_foil.shim[3].to=7"}).find("\"shim[3]\" does not exist: there are 2"),
            std::string::npos);
  EXPECT_NE(refusal({two, "bump_foil.shim.to=7"}).find("\"shim\" does not exist: there are 2"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
