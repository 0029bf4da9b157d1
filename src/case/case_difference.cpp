#include "case/case_difference.hpp"

#include <map>
#include <utility>

#include "case/case_json.hpp"
#include "case/key_list.hpp"

namespace bumpfoil {
namespace {

std::string text_of(const ListedKey& listed) {
  return listed.held ? dump_json(listed.value, -1) : "none";
}

}  // namespace

std::vector<CaseDifference> case_differences(const Case& theirs, const Case& ours) {
  // In the order of the case file; lists of tables may differ in length.
  std::vector<CaseDifference> differences;
  std::map<std::string, std::size_t> places;
  for (const ListedKey& listed : list_keys(theirs)) {
    if (listed.is_table()) continue;
    places.emplace(listed.path, differences.size());
    differences.push_back({listed.path, text_of(listed), "none"});
  }
  for (const ListedKey& listed : list_keys(ours)) {
    if (listed.is_table()) continue;
    const auto [place, is_new] = places.try_emplace(listed.path, differences.size());
    if (is_new) differences.push_back({listed.path, "none", {}});
    differences[place->second].ours = text_of(listed);
  }
  std::erase_if(differences, [](const CaseDifference& one) { return one.theirs == one.ours; });
  return differences;
}

}  // namespace bumpfoil
