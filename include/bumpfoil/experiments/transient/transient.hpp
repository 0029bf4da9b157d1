#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/motion/machine.hpp"
#include "bumpfoil/motion/orbit.hpp"
#include "bumpfoil/motion/speed_program.hpp"
#include "bumpfoil/motion/work_balance.hpp"

namespace bumpfoil {

/// Entry of [[transient.speed]]: from one speed to another, evenly.
struct SpeedPhase {
  std::optional<double> from{};  ///< Omega, rad/s; absent: where the entry before ends, or `to` of the first
  double to{};                   ///< rad/s
  double time{};                 ///< that it takes, s

  bool operator==(const SpeedPhase&) const = default;
};

/// Entry of [[transient.pulse]]: half a sine wave of a force on the rotor.
struct RotorPulse {
  std::vector<double> force{0.0, 0.0};  ///< its largest value along X and Y, N, on the whole rotor
  double begin{};                       ///< s
  double duration{};                    ///< s
  std::string at{"bearing 1"};          ///< name of a bearing or station of the rotor

  bool operator==(const RotorPulse&) const = default;
};

/// Entry of [[transient.base]]: acceleration of the base on which the bearings stand: half a sine wave or, with a
/// frequency, so much of one.
struct BaseMotion {
  std::vector<double> acceleration{0.0, 0.0};  ///< largest, along X and Y, m/s^2
  double begin{};                              ///< s
  double duration{};                           ///< s
  std::optional<double> frequency{};           ///< rad/s

  bool operator==(const BaseMotion&) const = default;
};

/// Table [transient] of a case.
struct TransientSettings {
  static constexpr std::string_view table = "transient";

  std::vector<SpeedPhase> speed{};
  int steps_per_revolution{100};
  std::optional<double> longest_step{};  ///< s; absent: a step at a tenth of the highest speed
  std::vector<RotorPulse> pulses{};
  std::vector<BaseMotion> base{};
  int revolutions_per_spectrum{16};

  bool operator==(const TransientSettings&) const = default;
};

/// The speeds of a run.
SpeedProgram speed_program(const TransientSettings& settings);

/// What is kept of every step of a run, as rows of `width` numbers. A plain value.
struct StepLayout {
  std::size_t places{};    ///< bearings and stations of the rotor, two numbers each
  std::size_t bearings{};  ///< of them, the first

  [[nodiscard]] std::size_t width() const;
};

/// Rows of all steps, in memory or on the disk.
class StepTable {
 public:
  StepTable() = default;
  StepTable(const StepTable&) = delete;
  StepTable& operator=(const StepTable&) = delete;
  virtual ~StepTable() = default;

  [[nodiscard]] virtual std::size_t rows() const = 0;
  /// Adds whole rows.
  virtual void append(std::span<const double> rows) = 0;
  /// Entries `first` to `first + count` of a column.
  [[nodiscard]] virtual std::vector<double> column(std::size_t column, std::size_t first, std::size_t count) const = 0;
};

/// In memory.
std::unique_ptr<StepTable> make_step_table(std::size_t width);

/// How a run ended.
struct TransientResult {
  Machine machine;
  TransientSettings settings;
  StepLayout layout;
  std::shared_ptr<const StepTable> steps;  ///< row 0 is the start, without rows where it was not found; null before
  Status status{Status::interrupted};      ///< of the last step that was tried
  double time{};                           ///< that was reached, s
  double speed{};                          ///< there, rad/s
};

/// How a run goes on from what it has, and what is kept of it.
struct TransientRun {
  std::function<bool(double)> progress{};  ///< called with the fraction that is done; returning false ends the run
  std::optional<MachineState> from{};      ///< the state of the last row of the table, which has all rows up to it
  /// Called after rows were appended with the state of the last one.
  std::function<void(const MachineState&)> keep{};
};

/// A run that ended before its first step: its machine, and what it would write.
/// @throws Error (input) if the case cannot be built, or has no rotor or no speeds
TransientResult transient_not_begun(const Case& input);

/// Marches the rotor of a case through its speeds, from the equilibrium at the first one; where it turns there, from
/// the orbit that its unbalance makes, by the linear response with stuck contacts. A march that goes on from a state
/// that was kept goes on to the last bit.
/// @param begun  of transient_not_begun()
/// @param table  receives a row for each step, some at a time
TransientResult run_transient(const Case& input, TransientResult begun, const std::shared_ptr<StepTable>& table,
                              const TransientRun& run = {});

/// The same with a table in memory.
/// @throws Error (input) if the case cannot be built, or has no rotor or no speeds
TransientResult run_transient(const Case& input, const std::function<bool(double)>& progress = {});

/// What a place of the rotor does in a turn.
struct PlaceTurn {
  /// t = 0 of its phases is angle 0. Its harmonics are those of two turns with this one in their middle, so that whirl
  /// at half of the frequency is none of them; of the first and last turn those of the turn.
  StationOrbit orbit;
  /// At half the rotation frequency, of the same two turns, m. None of the first and last turn.
  std::optional<Eigen::Vector2cd> half{};
  Eigen::Vector2d at_end{Eigen::Vector2d::Zero()};  ///< m: a point of a Poincare section
};

/// What a bearing does in a turn.
struct BearingRecord {
  double thinnest{};       ///< minimum film thickness, m
  double power{};          ///< mean, W
  double asperity_load{};  ///< largest that asperities carry, N
};

/// A whole turn of the rotor.
struct TransientTurn {
  long number{};   ///< from 1
  double time{};   ///< at its end, s
  double speed{};  ///< mean, rad/s
  std::vector<PlaceTurn> places;
  std::vector<BearingRecord> bearings;
  WorkBalance energy;
};

/// All whole turns of a run.
std::vector<TransientTurn> turns_of(const TransientResult& result);

/// Asperities of a bearing that carry more than a hundredth of the weight on it, without a break.
struct RubEvent {
  std::size_t bearing{};  ///< from 0
  double begin{}, end{};  ///< s
  double load{};          ///< largest that they carry, N
};
std::vector<RubEvent> rubs_of(const TransientResult& result);

/// Spectra of the motion over turns that follow each other, as a waterfall shows them.
struct Waterfall {
  std::vector<double> orders;  ///< frequencies over that of rotation
  std::vector<double> times;   ///< of the middle of each spectrum, s
  std::vector<double> speeds;  ///< mean, rad/s
  /// Amplitudes of sine waves, m, over spectrum, place, axis and order; the last runs fastest.
  std::vector<double> amplitudes;
};

/// By the discrete Fourier transform of places at equal angles under a Hann window, which shows a sine wave at an order
/// on the grid at its full amplitude.
Waterfall waterfall_of(const TransientResult& result);

/// The balance of energy of all whole turns, and what its defects come to.
struct EnergyCheck {
  WorkBalance sum;
  double defect{};   ///< sum of the sizes of the defects of all turns, J
  double largest{};  ///< sum over turns of the largest of what drives, is taken and is stored, J

  [[nodiscard]] double relative() const { return largest > 0.0 ? defect / largest : 0.0; }
};
EnergyCheck energy_check(const std::vector<TransientTurn>& turns);

}  // namespace bumpfoil
