#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bumpfoil {

/// Rows of numbers on the disk, where millions have room: samples of an ensemble, steps of a march in time. They are
/// added at the end block by block, and read by columns. Each block carries a checksum and is flushed to the disk: if a
/// process is killed or power fails, the log is intact up to some row, and the torn end is discarded.
///
/// Numbers are written as they lie in memory: a log is for machines like the one that began it.
class RowLog {
 public:
  /// Begins a log; one that is there is replaced.
  /// @param identity  what the numbers depend on, for those who go on with them
  /// @param width     of a row
  /// @throws Error (file), as do all functions
  RowLog(const std::filesystem::path& path, std::string_view identity, std::size_t width);

  /// The identity of a log; nothing where there is no whole one.
  static std::optional<std::string> identity_of(const std::filesystem::path& path);

  /// Opens a log that has an identity and this width, to go on with it. A torn end is cut off.
  /// @param most  blocks that go beyond so many rows are cut off, too
  static RowLog open(const std::filesystem::path& path, std::size_t width,
                     std::size_t most = std::numeric_limits<std::size_t>::max());

  RowLog(RowLog&&) noexcept;
  ~RowLog();

  [[nodiscard]] std::size_t rows() const;

  /// Adds whole rows, one after the other, and flushes them.
  void append(std::span<const double> rows);

  /// Writes the file anew in blocks of one size: the same rows then are the same bytes, however fast they came. If it
  /// fails, the log stays what it was.
  void rewrite_evenly();

  /// Entries `first` to `first + count` of a column.
  [[nodiscard]] std::vector<double> column(std::size_t column, std::size_t first, std::size_t count) const;

  /// All of a column.
  [[nodiscard]] std::vector<double> column(std::size_t place) const { return column(place, 0, rows()); }

 private:
  struct Open;
  explicit RowLog(std::unique_ptr<Open> open);

  std::unique_ptr<Open> open_;
};

}  // namespace bumpfoil
