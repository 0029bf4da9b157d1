#include "case/unit_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "case/udunits.hpp"

namespace bumpfoil {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Every text in quotes that begins with a number, in documents and examples: what follows the number.
std::set<std::string> units_of_the_repository() {
  std::set<std::string> units;
  constexpr std::size_t longest = 40;
  for (const char* folder : {"../docs", "../examples", "../studies", ".."}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".md" && entry.path().extension() != ".toml") continue;
      const std::string text = text_of(entry.path());
      for (std::size_t at = text.find('"'); at != std::string::npos; at = text.find('"', at + 1)) {
        const std::size_t end = text.find_first_of("\"\n", at + 1);
        if (end == std::string::npos || text[end] != '"' || end - at > longest) continue;
        const std::string quoted = text.substr(at + 1, end - at - 1);
        if (quoted.empty() || quoted.find_first_of("0123456789") > 1) continue;
        const std::size_t unit = quoted.find_first_not_of("+-.0123456789eE ");
        if (unit != std::string::npos) units.insert(quoted.substr(unit));
      }
    }
  }
  return units;
}

/// Both know the unit and mean the same by it, or neither knows it.
void expect_same(const Udunits& udunits, const std::string& text) {
  const std::optional<UnitMeaning> expected = udunits.read(text);
  const std::optional<UnitMeaning> found = read_unit(text, unit_table());
  ASSERT_EQ(found.has_value(), expected.has_value()) << text;
  if (!found) return;
  EXPECT_EQ(found->powers, expected->powers) << text;
  ASSERT_EQ(found->scale.has_value(), expected->scale.has_value()) << text;
  // Factors are multiplied in another order.
  if (!found->scale) return;
  EXPECT_NEAR(*found->scale / *expected->scale, 1.0, 4e-16) << text;
}

TEST(UnitTable, KnowsEveryUnitOfDocumentsAndExamples) {
  const Udunits udunits;
  const std::set<std::string> units = units_of_the_repository();
  for (const char* known : {"um", "GPa", "MN/m", "deg", "rpm", "Hz", "uPa s"})
    EXPECT_TRUE(units.contains(known)) << known;
  int read = 0;
  for (const std::string& unit : units) {
    expect_same(udunits, unit);
    if (udunits.read(unit)) ++read;
  }
  EXPECT_GT(read, 12);
}

TEST(UnitTable, SaysOfEveryNameWhatUdunitsSays) {
  const Udunits udunits;
  const UnitTable table = unit_table();
  EXPECT_GT(table.units.size(), 700U);
  EXPECT_EQ(table.prefixes.size(), 42U);
  for (const TableUnit& unit : table.units) {
    const std::string name(unit.name);
    expect_same(udunits, name);
    // Signs take no prefixes; nobody writes them with any.
    if (name == "%" || name == "'" || name == "\"") continue;
    for (const char* prefix : {"k", "milli", "da", "u"}) expect_same(udunits, prefix + name);
  }
}

TEST(UnitTable, HasTheGrammarOfUdunits) {
  const Udunits udunits;
  for (const char* text : {"N m",        "N.m",
                           "N*m",        "N-m",
                           "N\xc2\xb7m", "N/m",
                           "N per m",    "N / m",
                           "N um-1",     "m2",
                           "m^2",        "m**2",
                           "m\xc2\xb2",  "s-1",
                           "s^-1",       "m+2",
                           "kg m2 s-2",  "kg/m/s2",
                           "kg/(m s2)",  "(N)",
                           "1/s",        "1/min",
                           "rad/s",      "deg/s",
                           "Pa s",       "MegaPascal",
                           "MEGAPASCAL", "mM",
                           "mN/mm",      "kilomillimeter",
                           "Mmm",        "mum",
                           "lbf/in",     "degC",
                           "\xce\xbcm",  "\xc2\xb0",
                           "%",          "m^",
                           "m//s",       "/m",
                           "(m",         " ",
                           "m m m",      "parsnips",
                           "GPA",        "per m",
                           "m per",      "N m^-2",
                           "m2s",        "m2 s",
                           "H2O",        "m^99999999999",
                           "m0",         "m^0"}) {
    SCOPED_TRACE(text);
    expect_same(udunits, text);
  }
}

}  // namespace
}  // namespace bumpfoil
