#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/temporary_folder.hpp"

extern char** environ;

namespace bumpfoil {

using nlohmann::json;
using test_support::TemporaryFolder;

/// A program that runs in the background; its output goes to files.
class Running {
 public:
  /// @param launcher  command that starts it, with its own arguments
  Running(const std::vector<std::string>& arguments, const std::string& output, std::vector<std::string> launcher = {})
      : output_(output) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    std::vector<std::string> words = std::move(launcher);
    words.emplace_back(BUMPFOIL_PROGRAM);
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    // Tests that a shell without job control runs in the background inherit that SIGINT is ignored.
    sigset_t interruption;
    sigemptyset(&interruption);
    sigaddset(&interruption, SIGINT);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &interruption);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    EXPECT_EQ(posix_spawn(&process_, words.front().c_str(), &actions, &attributes, argv.data(), environ), 0);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }

  /// Ends a program that a test left running as it failed.
  ~Running() {
    if (process_ <= 0) return;
    end(SIGKILL);
    wait();
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void interrupt() const { end(SIGINT); }
  void end(int signal) const { kill(process_, signal); }

  /// Exit code, or 1000 plus the signal that ended it.
  int wait() {
    int status = 0;
    waitpid(std::exchange(process_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }

  [[nodiscard]] std::string errors() const { return folder_.read("errors"); }

 private:
  TemporaryFolder folder_;
  std::string output_;
  std::string errors_{(folder_.path() / "errors").string()};
  pid_t process_{};
};

struct ProgramOutcome {
  int exit_code{};
  std::string output, errors;
};

inline ProgramOutcome run(const std::vector<std::string>& arguments, const std::vector<std::string>& launcher = {}) {
  const TemporaryFolder folder;
  Running program(arguments, (folder.path() / "output").string(), launcher);
  const int exit_code = program.wait();
  return {exit_code, folder.read("output"), program.errors()};
}

/// A folder with a case file and a place for results.
class Program : public ::testing::Test {
 protected:
  Program() { EXPECT_EQ(run({"init", "-o", case_path_}).exit_code, 0); }

  [[nodiscard]] bool wrote_results() const { return std::filesystem::exists(results_); }
  [[nodiscard]] json summary() const { return json::parse(folder_.read("results/summary.json")); }

  [[nodiscard]] std::set<std::string> names_in(const std::string& folder) const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / folder)) {
      names.insert(entry.path().filename());
    }
    return names;
  }

  TemporaryFolder folder_;
  std::string case_path_{(folder_.path() / "case.toml").string()};
  std::string results_{(folder_.path() / "results").string()};
  std::vector<std::string> cycle_{"cycle", case_path_, "-o", results_, "--set", "cycle.steps=4"};
};

inline std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace bumpfoil
