#include "bumpfoil/studies/gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <vector>

extern char** environ;

namespace bumpfoil {
namespace {

/// In single quotes, where gnuplot doubles a quote that is meant.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + '\'';
}

}  // namespace

PlotStatus run_gnuplot(const std::filesystem::path& script, const std::map<std::string, std::string>& variables) {
  std::vector<std::string> words{"gnuplot"};
  for (const auto& [name, value] : variables) {
    words.emplace_back("-e");
    words.push_back(name + " = " + quoted(value));
  }
  words.push_back(script.string());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  pid_t process{};
  if (const int code = ::posix_spawnp(&process, "gnuplot", nullptr, nullptr, argv.data(), environ); code != 0) {
    return code == ENOENT ? PlotStatus::no_gnuplot : PlotStatus::failed;
  }
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return PlotStatus::failed;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? PlotStatus::drawn : PlotStatus::failed;
}

}  // namespace bumpfoil
