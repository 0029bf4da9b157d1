// A random walk over cases that are drawn from seeds, each checked in a process of its own, which may crash, hang or
// take too much memory without ending the walk.
//
//     fuzz_walk SECONDS [FIRST_SEED [FOLDER]]    checks seed after seed; keeps what is wrong in the folder
//     fuzz_walk CASE.toml...                     checks these again
//     fuzz_walk --draw SEED                      prints the case of a seed

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "fuzz/checked_run.hpp"

namespace bumpfoil {
namespace {

constexpr double budget = 1.0;       // s, for a run that is asked whether it goes on
constexpr rlim_t patience = 20;      // s of processor time, until it counts as hung
constexpr rlim_t most_memory = 4e9;  // bytes

/// One word for the outcome, followed by the error.
std::string checked_here(const DrawnCase& drawn) {
  try {
    const Verdict verdict = check_case(drawn, budget);
    if (!verdict.wrong.empty()) return "WRONG " + verdict.wrong;
    constexpr std::array words{"refused", "solved", "failed", "interrupted"};
    return words.at(static_cast<std::size_t>(verdict.end));
  } catch (const std::exception& error) {
    return std::string("WRONG throws ") + error.what();
  }
}

/// The same in a separate process.
std::string checked_apart(const DrawnCase& drawn) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) std::abort();
  const pid_t child = fork();
  if (child == 0) {
    const rlimit memory{most_memory, most_memory};
    setrlimit(RLIMIT_AS, &memory);
    const rlimit time{patience, patience + 1};
    setrlimit(RLIMIT_CPU, &time);
    const std::string word = checked_here(drawn);
    const ssize_t written = write(ends[1], word.data(), word.size());
    _exit(written < 0 ? 1 : 0);
  }
  close(ends[1]);
  std::string word;
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = read(ends[0], buffer.data(), buffer.size())) > 0;) {
    word.append(buffer.data(), static_cast<std::size_t>(count));
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFSIGNALED(status)) return word;
  return WTERMSIG(status) == SIGXCPU ? "WRONG hangs" : fmt::format("WRONG ends by signal {}", WTERMSIG(status));
}

std::string as_file(const DrawnCase& drawn) {
  return fmt::format("# {}\n{}", drawn.command, drawn.text);
}

DrawnCase from_file(const std::string& path) {
  std::ifstream file(path);
  DrawnCase drawn;
  std::string hash;
  file >> hash >> drawn.command;
  drawn.text.assign(std::istreambuf_iterator<char>(file), {});
  return drawn;
}

DrawnCase from_seed(std::uint64_t seed) {
  return draw_case(DrawsOfBytes(bytes_of_seed(seed)));
}

int walk(double seconds, std::uint64_t seed, const std::filesystem::path& folder) {
  const auto begin = std::chrono::steady_clock::now();
  std::map<std::string, std::map<std::string, int>> count;
  int wrong = 0;
  for (; std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < seconds; ++seed) {
    const DrawnCase drawn = from_seed(seed);
    const std::string word = checked_apart(drawn);
    ++count[drawn.command][word.substr(0, word.find(' '))];
    if (!word.starts_with("WRONG")) continue;
    ++wrong;
    fmt::print("seed {}, {}: {}\n", seed, drawn.command, word);
    std::fflush(stdout);
    if (folder.empty()) continue;
    std::filesystem::create_directories(folder);
    std::ofstream(folder / fmt::format("{}_{}.toml", drawn.command, seed)) << as_file(drawn);
  }
  for (const auto& [command, words] : count) {
    fmt::print("{}:", command);
    for (const auto& [word, times] : words) fmt::print(" {} {}", times, word);
    fmt::print("\n");
  }
  return wrong == 0 ? 0 : 1;
}

int check_files(int argc, char** argv) {
  int wrong = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string word = checked_apart(from_file(argv[i]));
    fmt::print("{}: {}\n", argv[i], word);
    wrong += word.starts_with("WRONG") ? 1 : 0;
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace bumpfoil

int main(int argc, char** argv) {
  using namespace bumpfoil;
  const std::string first = argc > 1 ? argv[1] : "60";
  if (first == "--draw") {
    fmt::print("{}", as_file(from_seed(std::strtoull(argc > 2 ? argv[2] : "0", nullptr, 10))));
    return 0;
  }
  if (first.ends_with(".toml")) return check_files(argc, argv);
  return walk(std::strtod(first.c_str(), nullptr), argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0,
              argc > 3 ? argv[3] : "");
}
