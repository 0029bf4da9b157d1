#include "experiments/transient/machine_state_file.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace bumpfoil {
namespace {

/// Appends what it visits to a text.
class ByteWriter {
 public:
  template <typename Plain>
  void plain(const Plain& value) {
    static_assert(std::is_trivially_copyable_v<Plain>);
    raw(&value, sizeof value);
  }
  void array(const Vector& values) {
    plain<std::int64_t>(values.size());
    raw(values.data(), sizeof(double) * static_cast<std::size_t>(values.size()));
  }
  void array(const Matrix& values) {
    plain<std::int64_t>(values.rows());
    plain<std::int64_t>(values.cols());
    raw(values.data(), sizeof(double) * static_cast<std::size_t>(values.size()));
  }
  template <typename Value, typename Visit>
  void list(const std::vector<Value>& values, const Visit& visit) {
    plain<std::int64_t>(std::ssize(values));
    for (const Value& value : values) visit(value);
  }

  std::string bytes;

 private:
  void raw(const void* from, std::size_t size) { bytes.append(static_cast<const char*>(from), size); }
};

/// Reads what it visits from a text; missing values stay unchanged.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  template <typename Plain>
  void plain(Plain& value) {
    static_assert(std::is_trivially_copyable_v<Plain>);
    raw(&value, sizeof value);
  }
  void array(Vector& values) {
    values.resize(count());
    raw(values.data(), sizeof(double) * static_cast<std::size_t>(values.size()));
  }
  void array(Matrix& values) {
    const Eigen::Index rows = count();
    const Eigen::Index columns = count();
    if (static_cast<std::size_t>(rows * columns) > left_.size() / sizeof(double)) {
      whole_ = false;
      return;
    }
    values.resize(rows, columns);
    raw(values.data(), sizeof(double) * static_cast<std::size_t>(values.size()));
  }
  template <typename Value, typename Visit>
  void list(std::vector<Value>& values, const Visit& visit) {
    values.resize(static_cast<std::size_t>(count()));
    for (Value& value : values) visit(value);
  }

  [[nodiscard]] bool is_spent() const { return whole_ && left_.empty(); }

 private:
  /// A number of items of at least one byte each.
  Eigen::Index count() {
    std::int64_t number = 0;
    plain(number);
    if (number < 0 || static_cast<std::uint64_t>(number) > left_.size()) {
      whole_ = false;
      return 0;
    }
    return number;
  }
  void raw(void* to, std::size_t size) {
    if (size > left_.size()) {
      whole_ = false;
      return;
    }
    if (size > 0) std::memcpy(to, left_.data(), size);
    left_.remove_prefix(size);
  }

  std::string_view left_;
  bool whole_{true};
};

/// Visits all data of a state, to write or to read. @param bearing  BearingState or const BearingState
template <typename Bytes, typename Bearing>
void visit_bearing(Bytes& bytes, Bearing& bearing) {
  for (const int axis : {0, 1}) bytes.plain(bearing.position[axis]);
  for (const int axis : {0, 1}) bytes.plain(bearing.tilt[axis]);
  bytes.array(bearing.gap_offset);
  bytes.array(bearing.top_load);
  bytes.plain(bearing.time);
  bytes.plain(bearing.speed);
  bytes.plain(bearing.clearance_offset);
  bytes.array(bearing.loading.initial_gap);
  bytes.array(bearing.loading.load);
  bytes.array(bearing.contacts.x);
  bytes.array(bearing.contacts.gap);
  bytes.array(bearing.contacts.normal_force);
  bytes.array(bearing.contacts.friction_force);
  bytes.list(bearing.contacts.mode, [&](auto& mode) { bytes.plain(mode); });
  bytes.array(bearing.slip_origin);
  bytes.array(bearing.film.pressure);
  bytes.array(bearing.film.thickness);
  bytes.array(bearing.film.deflection);
  bytes.array(bearing.film.moment);
  bytes.array(bearing.film.membrane);
  bytes.plain(bearing.last_step.dt);
  bytes.array(bearing.last_step.content);
  bytes.plain(bearing.work);
  bytes.plain(bearing.dissipated_energy);
}

template <typename Bytes, typename State>
void visit_machine(Bytes& bytes, State& state) {
  bytes.plain(state.time);
  bytes.plain(state.angle);
  bytes.plain(state.speed);
  bytes.plain(state.last_dt);
  for (auto* motion : {&state.rotor, &state.rotor_before}) {
    bytes.array(motion->y);
    bytes.array(motion->v);
  }
  for (auto* bearings : {&state.bearings, &state.bearings_before}) {
    bytes.list(*bearings, [&](auto& bearing) { visit_bearing(bytes, bearing); });
  }
}

}  // namespace

std::string bytes_of(const MachineState& state) {
  ByteWriter writer;
  visit_machine(writer, state);
  return std::move(writer.bytes);
}

std::optional<MachineState> machine_state_of(std::string_view bytes) {
  ByteReader reader(bytes);
  MachineState state;
  visit_machine(reader, state);
  if (!reader.is_spent()) return std::nullopt;
  return state;
}

}  // namespace bumpfoil
