#include "fuzz/byte_targets.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/case/swept_key.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/row_log.hpp"
#include "case/deviations_csv.hpp"
#include "case/height_errors_csv.hpp"
#include "case/path_csv.hpp"
#include "case/profile_csv.hpp"
#include "experiments/cycle/measured_loops_csv.hpp"
#include "experiments/rotor_matrices_json.hpp"
#include "experiments/transient/machine_state_file.hpp"
#include "fuzz/changed_result.hpp"
#include "pages/result_reader.hpp"
#include "readers/summary_reader.hpp"

namespace bumpfoil {
namespace {

[[noreturn]] void end_with(const std::string& what) {
  fmt::print(stderr, "{}\n", what);
  std::abort();
}

void require(bool right, const char* what) {
  if (!right) end_with(what);
}

/// A file in memory that readers open by its path.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
    require(write(descriptor_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()), "no memory file");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

/// Rejects input only with an Error that is safe to print.
template <typename Read>
void reads(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    require(!std::string_view(error.what()).empty(), "an error without a word");
    require(printable_lines(error.what()) == error.what(), "a message that steers the terminal");
    require(std::string_view(error.what()).size() < 1'000'000, "a message without end");
  }
}

void require_finite(const std::vector<double>& numbers) {
  for (const double number : numbers) require(std::isfinite(number), "a number that is none");
}

/// A valid case is written so that reading it again gives the same bits. Remarks on defaults are not: they are explicit
/// then.
void expect_case(std::string_view text, const std::vector<std::string>& overrides) {
  reads([&] {
    Case input = parse_case(text, "/dev/null/case.toml", {.overrides = overrides, .commands = {}});
    input.remarks.clear();
    const std::string written = case_to_toml(input);
    try {
      require(parse_case(written, "again.toml") == input, "a case that is another one when it is written and read");
    } catch (const Error& error) {
      end_with(fmt::format("a case that is refused when it is written: {}", error.what()));
    }
    static_cast<void>(case_to_json(input));
  });
}

/// Lines of `--set`, on the reference case.
void read_overrides(std::string_view bytes) {
  static const std::string reference = case_template("gen1");
  std::vector<std::string> overrides;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    overrides.emplace_back(bytes.substr(0, end));
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  expect_case(reference, overrides);
}

void read_swept_key(std::string_view bytes) {
  reads([&] {
    const SweptKey swept = parse_swept_key(bytes);
    require(!swept.values.empty() && swept.values.size() <= most_sweep_points, "a sweep of no or too many points");
  });
}

void read_loops(std::string_view bytes) {
  const std::size_t end = std::min(bytes.find('\n'), bytes.size());
  const MemoryFile file(bytes.substr(std::min(end + 1, bytes.size())));
  reads([&] {
    const MeasuredColumns columns = end > 0 ? parse_measured_columns(bytes.substr(0, end)) : MeasuredColumns{};
    static_cast<void>(read_measured_loops(file.path(), "direction", columns, "+X"));
  });
  reads([&] { static_cast<void>(read_measured_loops(file.path(), "cycle")); });
}

void read_log(std::string_view bytes) {
  const MemoryFile file(bytes);
  reads([&] {
    if (!RowLog::identity_of(file.path())) return;
    const RowLog log = RowLog::open(file.path(), 3);
    static_cast<void>(log.column(2));
  });
}

/// The data of a page are in a script element that they must not close.
void fill_page(std::string_view bytes) {
  constexpr std::string_view page = "<script>@bumpfoil-report-data@</script>";
  const std::string filled = fill_report(page, bytes);
  const std::string_view data = std::string_view(filled).substr(8, filled.size() - 17);
  require(data.find("</") == std::string_view::npos && data.find("<!--") == std::string_view::npos,
          "data that end their script element");
}

}  // namespace

const std::map<std::string, std::function<void(std::string_view)>>& byte_targets() {
  static const std::map<std::string, std::function<void(std::string_view)>> targets{
      {"case", [](std::string_view bytes) { expect_case(bytes, {}); }},
      {"set", read_overrides},
      {"over", read_swept_key},
      {"csv_heights",
       [](std::string_view bytes) {
         const MemoryFile file(bytes);
         const std::vector<double> heights(5, 0.5e-3);
         const std::vector<double> rises(5, 0.4e-3);
         reads([&] { require_finite(read_height_errors(file.path(), heights, rises)); });
       }},
      {"csv_profile",
       [](std::string_view bytes) {
         const MemoryFile file(bytes);
         reads([&] { require_finite(read_profile(file.path())); });
       }},
      {"csv_path",
       [](std::string_view bytes) {
         const MemoryFile file(bytes);
         reads([&] {
           for (const Eigen::Vector2d& point : read_path(file.path()).values) require_finite({point.x(), point.y()});
         });
       }},
      {"csv_deviations",
       [](std::string_view bytes) {
         const MemoryFile file(bytes);
         reads([&] { require_finite(read_deviations(file.path())); });
       }},
      {"csv_loops", read_loops},
      {"row_log", read_log},
      {"machine_state", [](std::string_view bytes) { static_cast<void>(machine_state_of(bytes)); }},
      {"summary",
       [](std::string_view bytes) { reads([&] { static_cast<void>(read_summary(bytes, "summary.json")); }); }},
      {"result",
       [](std::string_view bytes) {
         const std::span draws(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
         reads(
             [&] { static_cast<void>(read_result(changed_result(DrawsOfBytes(draws)), "result.nc", 10'000).dump()); });
       }},
      {"page", fill_page},
      {"rotor",
       [](std::string_view bytes) {
         const MemoryFile file(bytes);
         reads([&] { static_cast<void>(read_rotor_matrices(file.path())); });
       }},
  };
  return targets;
}

}  // namespace bumpfoil
