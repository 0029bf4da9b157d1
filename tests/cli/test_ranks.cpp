// `mpirun -n R bumpfoil montecarlo` and `sweep` from the command line and in batch systems.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/results/row_log.hpp"
#include "cli/montecarlo_program.hpp"

namespace bumpfoil {
namespace {

using namespace std::chrono_literals;

/// More ranks than cores, for any user. Memory left allocated by MPI is not checked.
std::vector<std::string> mpirun(int ranks) {
  return {BUMPFOIL_MPIRUN,      "--allow-run-as-root", "--oversubscribe", "-x", "ASAN_OPTIONS=detect_leaks=0", "-n",
          std::to_string(ranks)};
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class Ranks : public MonteCarloProgram {
 protected:
  /// All numbers of a run, as they lie in memory.
  [[nodiscard]] std::vector<std::vector<double>> numbers_of(const std::string& folder, int samples) const {
    std::vector<std::string> overrides;
    const std::vector<std::string> words = montecarlo(folder, samples);
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (words[i - 1] == "--set") overrides.push_back(words[i]);
    }
    overrides.push_back("montecarlo.samples=" + std::to_string(samples));
    const Case input = parse_case(read_case_text(case_path_), case_path_, {.overrides = overrides, .commands = {}});
    const std::size_t width = make_ensemble_layout(input).width();
    const RowLog log = RowLog::open(folder_.path() / folder / "ensemble.checkpoint", width);
    std::vector<std::vector<double>> columns;
    for (std::size_t place = 0; place < width; ++place) columns.push_back(log.column(place));
    return columns;
  }

  void expect_same_numbers(const std::string& a, const std::string& b, int samples) const {
    const std::vector<std::vector<double>> of_a = numbers_of(a, samples);
    const std::vector<std::vector<double>> of_b = numbers_of(b, samples);
    ASSERT_EQ(of_a.size(), of_b.size());
    for (std::size_t place = 0; place < of_a.size(); ++place) {
      ASSERT_EQ(of_a[place].size(), static_cast<std::size_t>(samples));
      ASSERT_EQ(of_b[place].size(), static_cast<std::size_t>(samples));
      EXPECT_EQ(std::memcmp(of_a[place].data(), of_b[place].data(), of_a[place].size() * sizeof(double)), 0) << place;
    }
  }
};

TEST_F(Ranks, MakeNoDifference) {
  constexpr int samples = 100;
  ASSERT_EQ(run(montecarlo("alone", samples) + std::vector<std::string>{"--threads", "1"}).exit_code, 0);
  for (const int ranks : {1, 2, 3}) {
    const std::string folder = "ranks" + std::to_string(ranks);
    const ProgramOutcome together = run(montecarlo(folder, samples), mpirun(ranks));
    ASSERT_EQ(together.exit_code, 0) << together.errors;
    EXPECT_EQ(count(together.output, "100 samples; results in"), 1) << together.output;
    expect_same_numbers("alone", folder, samples);
    EXPECT_EQ(summary_of(folder).at("statistics"), summary_of("alone").at("statistics"));
    std::smatch shares;
    const std::regex pattern(std::to_string(ranks) + " ranks ran (\\d+) to (\\d+) samples each");
    ASSERT_EQ(std::regex_search(together.output, shares, pattern), ranks > 1) << together.output;
    if (ranks > 1) {
      EXPECT_GT(std::stoi(shares[1]), 0);
    }
  }
}

/// One thread each, so that no rank finishes before the other has started.
TEST_F(Ranks, ShareTheirPointsOfASweep) {
  const auto sweep = [&](const std::string& folder) {
    return std::vector<std::string>{"sweep",     case_path_,
                                    "--over",    "friction.coefficient=0:0.39:0.01",
                                    "-o",        (folder_.path() / folder).string(),
                                    "--set",     "cycle.steps=100",
                                    "--threads", "1"};
  };
  ASSERT_EQ(run(sweep("alone")).exit_code, 0);
  const ProgramOutcome together = run(sweep("ranks"), mpirun(2));
  ASSERT_EQ(together.exit_code, 0) << together.errors;
  EXPECT_EQ(count(together.output, "40 points; results in"), 1) << together.output;
  std::smatch shares;
  ASSERT_TRUE(std::regex_search(together.output, shares, std::regex("2 ranks ran (\\d+) to (\\d+) points each")));
  EXPECT_GT(std::stoi(shares[1]), 0);
  // Stored results of each point, all digits, except for computing times.
  const auto points = [&](const std::string& folder) {
    json all = summary_of(folder).at("points");
    for (json& point : all) {
      for (json& cycle : point.at("cycles")) cycle.erase("wall_time_s");
    }
    return all;
  };
  EXPECT_EQ(points("ranks"), points("alone"));
}

TEST_F(Ranks, AreToldOnceWhatIsWrong) {
  const ProgramOutcome other = run(cycle_, mpirun(3));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(count(other.errors, "only 'montecarlo' and 'sweep' support several ranks"), 1) << other.errors;
  EXPECT_FALSE(wrote_results());
  const ProgramOutcome nothing_scatters = run({"montecarlo", case_path_, "-o", results_, "--samples", "5"}, mpirun(2));
  EXPECT_EQ(nothing_scatters.exit_code, 2);
  EXPECT_EQ(count(nothing_scatters.errors, "nothing scatters"), 1) << nothing_scatters.errors;
  const ProgramOutcome version = run({"--version"}, mpirun(2));
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(count(version.output, "bumpfoil "), 1) << version.output;
  EXPECT_EQ(run(cycle_, mpirun(1)).exit_code, 0);  // one rank is no different from none
}

TEST_F(Ranks, SayWhereTheErrorIsSmallEnough) {
  const std::vector<std::string> command =
      montecarlo("results", 100000) + std::vector<std::string>{"--set", "cycle.steps=1", "--target-error", "0.5"};
  const ProgramOutcome enough = run(command, mpirun(2));
  EXPECT_EQ(enough.exit_code, 0) << enough.errors;
  EXPECT_EQ(summary().at("samples"), 1000);
  EXPECT_EQ(summary().at("status"), "complete");
}

/// A killed job keeps what it had written, and its log shows its progress.
TEST_F(Ranks, GoOnWhereTheyWereKilled) {
  {
    Running job(montecarlo("results", 1000000), (folder_.path() / "output").string(), mpirun(2));
    const auto written = [&] {
      const std::string checkpoint = "results/ensemble.checkpoint";
      return has(checkpoint) ? std::filesystem::file_size(folder_.path() / checkpoint) : 0;
    };
    // A sample is 768 bytes: more than 20 of them.
    while (count(job.errors(), " left\n") == 0 || written() < 20'000) std::this_thread::sleep_for(20ms);
    EXPECT_NE(job.errors().find(" samples/s, "), std::string::npos) << job.errors();
    job.end(SIGKILL);
    EXPECT_EQ(job.wait(), 1000 + SIGKILL);
  }
  // The ranks end once their launcher is gone; until then they hold the folder.
  ProgramOutcome more;
  for (int tries = 0; tries < 500; ++tries) {
    more = run(montecarlo("results", 20) + std::vector<std::string>{"--resume"}, mpirun(3));
    if (more.exit_code != 4) break;
    std::this_thread::sleep_for(100ms);
  }
  ASSERT_EQ(more.exit_code, 0) << more.errors;
  const int samples = summary().at("samples").get<int>();
  EXPECT_GT(samples, 20);
  ASSERT_EQ(run(montecarlo("results", samples + 30) + std::vector<std::string>{"--resume"}, mpirun(3)).exit_code, 0);
  ASSERT_EQ(run(montecarlo("alone", samples + 30)).exit_code, 0);
  expect_same_numbers("results", "alone", samples + 30);
}

}  // namespace
}  // namespace bumpfoil
