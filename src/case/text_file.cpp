#include "case/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void throw_unreadable(const std::string& path, int code) {
  const std::string reason = code == EISDIR ? "it is a folder" : std::generic_category().message(code);
  throw Error(ErrorKind::file, {{path, 0, "", "", "cannot be read: " + reason, "give the path of a text file"}});
}

}  // namespace

std::string read_text_file(const std::string& path) {
  const auto error = [&](std::size_t line, std::string what, std::string advice) {
    return Error(ErrorKind::input, {{path, line, "", "", std::move(what), std::move(advice)}});
  };
  const std::unique_ptr<std::FILE, CloseFile> file(path == standard_input ? stdin : std::fopen(path.c_str(), "rb"));
  if (!file) throw_unreadable(path, errno);
  std::string text;
  std::array<char, 65536> buffer{};
  // A pipe or a device has no known size: count the bytes.
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), count);
    if (text.size() > largest_text_file) {
      throw error(0, fmt::format("is larger than {} MB", largest_text_file / 1'000'000), "is it the right file?");
    }
  }
  if (std::ferror(file.get()) != 0) throw_unreadable(path, errno);
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  if (const std::size_t null = text.find('\0'); null != std::string::npos) {
    const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(null), '\n');
    throw error(static_cast<std::size_t>(lines) + 1, "is not a text file: it has a null byte", "save it as UTF-8 text");
  }
  return text;
}

}  // namespace bumpfoil
