#include "bumpfoil/results/run_identity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/vector_instructions.hpp"
#include "bumpfoil/core/version.hpp"
#include "case/case_difference.hpp"

namespace bumpfoil {
namespace {

/// Like our inner loops, the mathematical library selects functions by processor features, with different round-off.
std::string instruction_set() {
#if defined(__x86_64__)
  return fmt::format("x86-64{}{}{}", __builtin_cpu_supports("fma") != 0 ? " fma" : "",
                     __builtin_cpu_supports("avx2") != 0 ? " avx2" : "",
                     widest_vector_instructions() == VectorInstructions::avx512 ? " avx512" : "");
#elif defined(__aarch64__)
  return "aarch64";
#else
  return "unknown";
#endif
}

Case nameless(Case input) {
  input.title.clear();
  if (input.montecarlo) input.montecarlo->samples = 1;
  return input;
}

/// Removes and returns the first line of a text.
std::string take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string line(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

}  // namespace

std::string run_identity(const Case& input) {
  return fmt::format("bumpfoil {} ({})\n{}\n{}", version(), commit(), instruction_set(), case_to_toml(nameless(input)));
}

Case case_of_identity(const std::string& identity) {
  std::string_view text = identity;
  take_line(text);
  take_line(text);
  return parse_case(text, "identity");
}

void require_same_run(const std::string& identity, const Case& input, const std::string& file) {
  const std::string ours = run_identity(input);
  if (identity == ours) return;
  std::string_view their_text = identity;
  std::string_view our_text = ours;
  std::vector<InputError> errors;
  constexpr std::string_view advice = "continue with the original settings, or restart with --force";
  for (const char* const what : {"program", "instruction set"}) {
    const std::string theirs = take_line(their_text);
    const std::string now = take_line(our_text);
    if (theirs != now) errors.push_back({file, 0, what, theirs, fmt::format("is {} now", now), std::string(advice)});
  }
  // Another version may write cases that this one cannot read: then the version explains the difference.
  if (their_text != our_text && errors.empty()) {
    for (const CaseDifference& difference : case_differences(parse_case(their_text, file), nameless(input))) {
      errors.push_back(
          {file, 0, difference.key, difference.theirs, fmt::format("is {} now", difference.ours), std::string(advice)});
    }
  }
  throw Error(ErrorKind::input, std::move(errors));
}

}  // namespace bumpfoil
