#include "film/column_chain.hpp"

#include <vector>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/block_tridiagonal_lu.hpp"

namespace bumpfoil {
namespace {

template <int B>
class ColumnChainOf final : public ColumnChain {
  using Storage = typename BlockTridiagonalLU<B>::Block;

 public:
  ColumnChainOf(int columns, int block_size)
      : block_size_(block_size),
        lu_(columns, block_size),
        answer_(static_cast<std::size_t>(columns), Storage::Zero(block_size, block_size)) {}

  [[nodiscard]] int columns() const override { return lu_.blocks(); }
  [[nodiscard]] int block_size() const override { return block_size_; }

  Block lower(int i) override { return map(lu_.lower(i)); }
  Block diagonal(int i) override { return map(lu_.diagonal(i)); }
  Block upper(int i) override { return map(lu_.upper(i)); }

  bool factor() override { return lu_.factor(); }
  void solve_in_place(Vector& x) const override { lu_.solve_in_place(x); }

  void respond(Response& to_before, Response& to_after) override {
    const int last = columns() - 1;
    lu_.solve_block_column(0, lu_.lower(0), answer_);
    to_before.first = answer_.front();
    to_before.last = answer_.back();
    lu_.solve_block_column(last, lu_.upper(last), answer_);
    to_after.first = answer_.front();
    to_after.last = answer_.back();
  }

 private:
  Block map(Storage& block) { return {block.data(), block_size_, block_size_}; }

  int block_size_;
  BlockTridiagonalLU<B> lu_;
  std::vector<Storage> answer_;
};

}  // namespace

std::unique_ptr<ColumnChain> make_column_chain(int columns, int block_size) {
  BUMPFOIL_ASSERT(columns >= 1 && block_size >= 1);
  switch (block_size) {
    case 8:
      return std::make_unique<ColumnChainOf<8>>(columns, block_size);
    case 16:
      return std::make_unique<ColumnChainOf<16>>(columns, block_size);
    default:
      return std::make_unique<ColumnChainOf<Eigen::Dynamic>>(columns, block_size);
  }
}

}  // namespace bumpfoil
