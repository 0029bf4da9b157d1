#include "bumpfoil/results/row_log.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "results/posix_file.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

// A log consists of the signature, a record with the identity, and a record for each block of rows, stored by columns.
// A record is the number of its bytes, their checksum, and the bytes.
constexpr std::string_view signature = "bumpfoil-rows/1\n";
constexpr std::size_t checksum_size = blank_checksum.size();
constexpr std::size_t head_size = sizeof(std::uint64_t) + checksum_size;

/// Rows of a block where all have one size.
constexpr std::size_t even_block = 1000;

/// The checksum includes the size.
std::string head_of(std::string_view bytes) {
  const std::uint64_t size = bytes.size();
  std::string head(reinterpret_cast<const char*>(&size), sizeof size);
  return head + xxh3_128(head + xxh3_128(bytes));
}

std::string record_of(std::string_view bytes) {
  return head_of(bytes).append(bytes);
}

}  // namespace

struct RowLog::Open {
  struct Block {
    std::size_t first;   ///< row
    std::size_t count;   ///< of rows
    std::size_t offset;  ///< of its numbers in the file
  };

  /// Reads up to `size` bytes at an offset.
  [[nodiscard]] std::string read(std::size_t offset, std::size_t size) const {
    std::string bytes(size, '\0');
    std::size_t have = 0;
    while (have < size) {
      const ssize_t count = ::pread(file.get(), bytes.data() + have, size - have, static_cast<off_t>(offset + have));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) throw_unwritable(path, errno);
      if (count == 0) break;
      have += static_cast<std::size_t>(count);
    }
    bytes.resize(have);
    return bytes;
  }

  /// The identity record, which comes first; nothing if this is not a log, or the record is incomplete.
  std::optional<std::string> begin() {
    file_size = static_cast<std::size_t>(fs::file_size(path));
    end = signature.size();
    return read(0, signature.size()) == signature ? next_record() : std::nullopt;
  }

  /// The next record; nothing if it is incomplete.
  std::optional<std::string> next_record() {
    const std::string head = read(end, head_size);
    if (head.size() < head_size) return std::nullopt;
    std::uint64_t size = 0;
    std::memcpy(&size, head.data(), sizeof size);
    if (size > file_size - std::min(file_size, end + head_size)) return std::nullopt;
    std::string bytes = read(end + head_size, static_cast<std::size_t>(size));
    if (head_of(bytes) != head) return std::nullopt;
    end += head_size + bytes.size();
    return bytes;
  }

  void add(const std::string& record) {
    if (::lseek(file.get(), static_cast<off_t>(end), SEEK_SET) < 0) throw_unwritable(path, errno);
    write_all(file, record, path);
    if (::fdatasync(file.get()) != 0 && errno != EINVAL) throw_unwritable(path, errno);
    end += record.size();
  }

  void add_block(std::size_t bytes) {
    const std::size_t count = bytes / (sizeof(double) * width);
    blocks.push_back({rows, count, end - bytes});
    rows += count;
  }

  /// Drops the last block. @param before  its offset in the file
  void drop_block(std::size_t before) {
    rows -= blocks.back().count;
    blocks.pop_back();
    end = before;
  }

  fs::path path;
  FileDescriptor file;
  std::size_t width;
  std::size_t file_size{};
  std::size_t end{};
  std::vector<Block> blocks{};
  std::size_t rows{};
};

RowLog::RowLog(std::unique_ptr<Open> open) : open_(std::move(open)) {}
RowLog::RowLog(RowLog&&) noexcept = default;
RowLog::~RowLog() = default;

RowLog::RowLog(const fs::path& path, std::string_view identity, std::size_t width)
    : open_(new Open{.path = path, .file = FileDescriptor(path, path, O_RDWR | O_CREAT | O_TRUNC), .width = width}) {
  open_->add(std::string(signature) + record_of(identity));
}

std::optional<std::string> RowLog::identity_of(const fs::path& path) {
  std::error_code code;
  if (!fs::is_regular_file(path, code)) return std::nullopt;
  return Open{.path = path, .file = FileDescriptor(path, path, O_RDONLY), .width = 1}.begin();
}

RowLog RowLog::open(const fs::path& path, std::size_t width, std::size_t most) {
  std::unique_ptr<Open> open(new Open{.path = path, .file = FileDescriptor(path, path, O_RDWR), .width = width});
  [[maybe_unused]] const bool known = open->begin().has_value();
  BUMPFOIL_ASSERT(known);
  for (std::size_t end = open->end; open->rows < most; end = open->end) {
    const std::optional<std::string> block = open->next_record();
    if (!block) break;
    open->add_block(block->size());
    if (open->rows <= most) continue;
    open->drop_block(end);
    break;
  }
  if (::ftruncate(open->file.get(), static_cast<off_t>(open->end)) != 0) throw_unwritable(path, errno);
  return RowLog(std::move(open));
}

std::size_t RowLog::rows() const {
  return open_->rows;
}

void RowLog::append(std::span<const double> rows) {
  const std::size_t width = open_->width;
  BUMPFOIL_ASSERT(!rows.empty() && rows.size() % width == 0);
  const std::size_t count = rows.size() / width;
  std::string bytes(rows.size_bytes(), '\0');
  for (std::size_t column = 0; column < width; ++column) {
    for (std::size_t row = 0; row < count; ++row) {
      std::memcpy(bytes.data() + (column * count + row) * sizeof(double), &rows[row * width + column], sizeof(double));
    }
  }
  open_->add(record_of(bytes));
  open_->add_block(bytes.size());
}

void RowLog::rewrite_evenly() {
  const std::size_t width = open_->width;
  const fs::path fresh = fs::path(open_->path) += ".new";
  try {
    RowLog even(fresh, identity_of(open_->path).value(), width);
    for (std::size_t first = 0; first < rows(); first += even_block) {
      const std::size_t count = std::min(even_block, rows() - first);
      std::vector<double> block(count * width);
      for (std::size_t place = 0; place < width; ++place) {
        const std::vector<double> values = column(place, first, count);
        for (std::size_t row = 0; row < count; ++row) block[row * width + place] = values[row];
      }
      even.append(block);
    }
    rename_file(fresh, open_->path);
    even.open_->path = open_->path;
    open_ = std::move(even.open_);
  } catch (...) {
    std::error_code ignored;
    fs::remove(fresh, ignored);
    throw;
  }
}

std::vector<double> RowLog::column(std::size_t column, std::size_t first, std::size_t count) const {
  BUMPFOIL_ASSERT(column < open_->width && first + count <= rows());
  std::vector<double> values;
  values.reserve(count);
  for (const Open::Block& block : open_->blocks) {
    const std::size_t from = std::max(first, block.first);
    const std::size_t to = std::min(first + count, block.first + block.count);
    if (from >= to) continue;
    const std::size_t place = column * block.count + (from - block.first);
    const std::string bytes = open_->read(block.offset + place * sizeof(double), (to - from) * sizeof(double));
    // Written data are present, unless another process has truncated the file.
    if (bytes.size() != (to - from) * sizeof(double)) throw_unwritable(open_->path, EIO);
    values.resize(values.size() + (to - from));
    std::memcpy(values.data() + values.size() - (to - from), bytes.data(), bytes.size());
  }
  return values;
}

}  // namespace bumpfoil
