// libFuzzer on one of the targets, which FUZZ_TARGET names: a reader of bytes, or "bearing", whose bytes a case is
// drawn from that is run and judged.

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

#include "fuzz/byte_targets.hpp"
#include "fuzz/judged_run.hpp"

namespace {

void judge_bearing_of(std::span<const std::uint8_t> bytes) {
  const bumpfoil::DrawnCase drawn = bumpfoil::draw_case(bumpfoil::DrawsOfBytes(bytes));
  const bumpfoil::Verdict verdict = bumpfoil::judge_case(drawn, 1.0);
  if (verdict.wrong.empty()) return;
  fmt::print(stderr, "{}\n# {}\n{}", verdict.wrong, drawn.command, drawn.text);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string name = std::getenv("FUZZ_TARGET") == nullptr ? "bearing" : std::getenv("FUZZ_TARGET");
  if (name == "bearing") {
    judge_bearing_of({data, size});
  } else {
    bumpfoil::byte_targets().at(name)({reinterpret_cast<const char*>(data), size});
  }
  return 0;
}
