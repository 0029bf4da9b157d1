#include "bumpfoil/studies/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

extern char** environ;

namespace bumpfoil {
namespace {

/// In single quotes; gnuplot doubles a literal quote.
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
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  // Silent: warnings about curves without points are no errors. In its own process group: Ctrl-C goes to the caller
  // only, which lets it finish.
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process{};
  const int code = ::posix_spawnp(&process, "gnuplot", &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (code != 0) return code == ENOENT ? PlotStatus::no_gnuplot : PlotStatus::failed;
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return PlotStatus::failed;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? PlotStatus::drawn : PlotStatus::failed;
}

}  // namespace bumpfoil
