#include "io/case_difference.hpp"

#include <utility>

#include "io/case_json.hpp"
#include "io/key_list.hpp"

namespace bumpfoil {
namespace {

std::string text_of(const ListedKey& listed) {
  return listed.held ? dump_json(listed.value, -1) : "none";
}

}  // namespace

std::vector<CaseDifference> case_differences(const Case& theirs, const Case& ours) {
  // Both have all keys, held or not.
  const std::vector<ListedKey> their_keys = list_keys(theirs);
  const std::vector<ListedKey> our_keys = list_keys(ours);
  std::vector<CaseDifference> differences;
  for (std::size_t i = 0; i < their_keys.size(); ++i) {
    if (their_keys[i].is_table()) continue;
    CaseDifference difference{their_keys[i].path, text_of(their_keys[i]), text_of(our_keys[i])};
    if (difference.theirs != difference.ours) differences.push_back(std::move(difference));
  }
  return differences;
}

}  // namespace bumpfoil
