#include "bumpfoil/studies/gnuplot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using test_support::TemporaryFolder;

TEST(Gnuplot, DrawsWithTheVariablesItIsGiven) {
  const TemporaryFolder folder;
  const std::string script = folder.write("it's.gp", "set terminal svg\nset output picture\nset title word\nplot x\n");
  const std::string picture = (folder.path() / "it's \"here\".svg").string();
  EXPECT_EQ(run_gnuplot(script, {{"picture", picture}, {"word", "it's drawn"}}), PlotStatus::drawn);
  const std::string svg = folder.read("it's \"here\".svg");
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_NE(svg.find("s drawn"), std::string::npos) << svg;
}

TEST(Gnuplot, TellsAWrongScript) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_gnuplot(folder.write("wrong.gp", "plot nothing of this name\n"), {}), PlotStatus::failed);
  EXPECT_EQ(run_gnuplot(folder.path() / "missing.gp", {}), PlotStatus::failed);
}

TEST(Gnuplot, TellsThatItIsMissing) {
  const TemporaryFolder folder;
  const std::string script = folder.write("empty.gp", "\n");
  const char* path = std::getenv("PATH");
  const std::string before = path == nullptr ? "" : path;
  setenv("PATH", folder.path().c_str(), 1);
  EXPECT_EQ(run_gnuplot(script, {}), PlotStatus::no_gnuplot);
  setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(run_gnuplot(script, {}), PlotStatus::drawn);
}

}  // namespace
}  // namespace bumpfoil
