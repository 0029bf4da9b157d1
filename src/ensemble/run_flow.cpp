#include "bumpfoil/ensemble/run_flow.hpp"

#include <algorithm>
#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

RunFlow::RunFlow(std::size_t begin, std::size_t end, std::size_t window)
    : end_(end), window_(window), next_(begin), first_(begin) {
  BUMPFOIL_ASSERT(begin <= end && window > 0);
}

std::optional<std::size_t> RunFlow::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return closed_ || room() > 0 || first_ + rows_.size() == end_; });
  if (closed_ || room() == 0) return std::nullopt;
  return next_++;
}

void RunFlow::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

bool RunFlow::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

RunRange RunFlow::take(std::size_t count) {
  const std::lock_guard lock(mutex_);
  const RunRange range{next_, closed_ ? 0 : std::min(count, room())};
  next_ += range.count;
  return range;
}

void RunFlow::put(std::size_t number, std::vector<double> row) {
  const std::lock_guard lock(mutex_);
  BUMPFOIL_ASSERT(number >= first_ && number < next_ && !rows_.contains(number));
  rows_.emplace(number, std::move(row));
  if (first_ + rows_.size() == end_) changed_.notify_all();
}

std::vector<double> RunFlow::leave(std::size_t count) {
  const std::lock_guard lock(mutex_);
  std::vector<double> left;
  for (auto row = rows_.begin(); count > 0 && row != rows_.end() && row->first == first_; --count) {
    left.insert(left.end(), row->second.begin(), row->second.end());
    row = rows_.erase(row);
    ++first_;
  }
  changed_.notify_all();
  return left;
}

std::size_t RunFlow::done() const {
  const std::lock_guard lock(mutex_);
  return first_ + rows_.size();
}

std::size_t RunFlow::waiting() const {
  const std::lock_guard lock(mutex_);
  return rows_.size();
}

std::size_t RunFlow::room() const {
  return std::min(end_, first_ + window_) - next_;
}

}  // namespace bumpfoil
