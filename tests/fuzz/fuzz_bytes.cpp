// libFuzzer on the target named by FUZZ_TARGET: a reader of bytes, or "bearing", which generates a case from the bytes,
// runs it and checks the results.

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

#include "fuzz/byte_targets.hpp"
#include "fuzz/checked_run.hpp"

namespace {

void check_bearing_of(std::span<const std::uint8_t> bytes) {
  const bumpfoil::DrawnCase drawn = bumpfoil::draw_case(bumpfoil::DrawsOfBytes(bytes));
  const bumpfoil::Verdict verdict = bumpfoil::check_case(drawn, 1.0);
  if (verdict.wrong.empty()) return;
  fmt::print(stderr, "{}\n# {}\n{}", verdict.wrong, drawn.command, drawn.text);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string name = std::getenv("FUZZ_TARGET") == nullptr ? "bearing" : std::getenv("FUZZ_TARGET");
  if (name == "bearing") {
    check_bearing_of({data, size});
  } else {
    bumpfoil::byte_targets().at(name)({reinterpret_cast<const char*>(data), size});
  }
  return 0;
}
