#include "experiments/transient/transient_checkpoint.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/row_log.hpp"
#include "bumpfoil/results/run_identity.hpp"
#include "bumpfoil/results/write_file.hpp"
#include "experiments/transient/machine_state_file.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

constexpr const char* steps_name = "transient.steps";
constexpr const char* state_name = "transient.checkpoint";

class TableOnDisk : public StepTable {
 public:
  explicit TableOnDisk(RowLog log) : log_(std::move(log)) {}
  [[nodiscard]] std::size_t rows() const override { return log_.rows(); }
  void append(std::span<const double> rows) override { log_.append(rows); }
  [[nodiscard]] std::vector<double> column(std::size_t column, std::size_t first, std::size_t count) const override {
    return log_.column(column, first, count);
  }

 private:
  RowLog log_;
};

/// File content: a checksum, the number of rows so far, and the state.
struct KeptState {
  std::size_t rows{};
  MachineState state;
};

void write_state(const fs::path& path, std::size_t rows, const MachineState& state) {
  write_file(path, sealed(fmt::format("{}{}\n{}", blank_checksum, rows, bytes_of(state))), Existing::replace);
}

std::optional<KeptState> read_state(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t begin = blank_checksum.size();
  const std::size_t end = text.find('\n', begin);
  if (end == std::string::npos || !is_sealed(text, text.substr(0, begin))) return std::nullopt;
  std::optional<MachineState> state = machine_state_of(std::string_view(text).substr(end + 1));
  if (!state) return std::nullopt;
  return KeptState{std::stoul(text.substr(begin, end - begin)), *std::move(state)};
}

}  // namespace

std::vector<std::string> transient_checkpoint_names() {
  return {steps_name, state_name};
}

KeptRun keep_run(const fs::path& folder, bool resumes, const Case& input, std::size_t width) {
  const fs::path steps = folder / steps_name;
  const fs::path state = folder / state_name;
  KeptRun kept;
  const std::optional<std::string> identity = resumes ? RowLog::identity_of(steps) : std::nullopt;
  std::optional<KeptState> last = identity ? read_state(state) : std::nullopt;
  if (identity) require_same_run(*identity, input, steps.string());
  if (last) {
    kept.table = std::make_shared<TableOnDisk>(RowLog::open(steps, width, last->rows));
    if (kept.table->rows() == last->rows) kept.run.from = std::move(last->state);
  }
  if (!kept.run.from) {
    fs::remove(state);
    kept.table = std::make_shared<TableOnDisk>(RowLog(steps, run_identity(input), width));
  }
  kept.run.keep = [table = kept.table, state](const MachineState& now) { write_state(state, table->rows(), now); };
  return kept;
}

}  // namespace bumpfoil
