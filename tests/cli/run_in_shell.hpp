#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil::test_support {

/// A folder with a case file, in which a shell runs scripts; `$bumpfoil` in them is the program.
class RunInShell : public ::testing::Test {
 protected:
  RunInShell() {
    setenv("bumpfoil", std::filesystem::absolute(BUMPFOIL_PROGRAM).c_str(), 1);
    EXPECT_EQ(run("$bumpfoil init -o case.toml"), 0);
  }

  /// Exit code of the script; what it prints is in the file `log`.
  [[nodiscard]] int run(const std::string& script) const {
    const std::string command = "cd '" + folder_.path().string() + "' && { " + script + "\n} > log 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  [[nodiscard]] std::string log() const { return folder_.read("log"); }

  [[nodiscard]] std::string listing(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / name)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    std::string out;
    for (const std::string& one : names) out += one + ' ';
    return out;
  }

  /// summary.json of a folder as read by users; its checksums match the files.
  nlohmann::json consistent_summary(const std::string& name) const {
    const auto read = [&](const std::string& file) {
      const std::filesystem::path path = published_file(folder_.path() / name, file);
      return folder_.read(path.lexically_relative(folder_.path()).string());
    };
    nlohmann::json summary = nlohmann::json::parse(read("summary.json"));
    for (const auto& [file, recorded] : summary.at("files").items()) {
      EXPECT_EQ(xxh3_128(read(file)), recorded.at("xxh3_128")) << file;
    }
    return summary;
  }

  TemporaryFolder folder_;
};

/// The fastest run of an experiment, without the name of its folder.
inline std::string small_run_of(const ExperimentInfo& experiment) {
  std::string command = "$bumpfoil " + std::string(experiment.name) + " case.toml";
  for (const std::string& key : experiment.small_runs.front()) command += " --set '" + key + "'";
  return command;
}

/// All commands that run cases into a folder of results, without its name.
inline std::vector<std::string> running_commands() {
  std::vector<std::string> commands{
      "$bumpfoil sweep case.toml --over friction.coefficient=0:0.1:0.1 --set cycle.steps=2",
      "$bumpfoil montecarlo case.toml --samples 2 --set cycle.steps=2 --set montecarlo.bump_height.std=1um"};
  for (const ExperimentInfo& experiment : experiments()) commands.push_back(small_run_of(experiment));
  return commands;
}

}  // namespace bumpfoil::test_support
