#include "case/unit_table.hpp"

#include <gtest/gtest.h>
#include <udunits2.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace bumpfoil {
namespace {

/// Units as read by UDUNITS-2, with its printing of errors disabled.
class Udunits {
 public:
  struct Free {
    void operator()(ut_system* system) const { ut_free_system(system); }
    void operator()(ut_unit* unit) const { ut_free(unit); }
    void operator()(cv_converter* converter) const { cv_free(converter); }
  };
  using Unit = std::unique_ptr<ut_unit, Free>;

  Udunits() {
    ut_set_error_message_handler(ut_ignore);
    system_.reset(ut_read_xml(nullptr));
  }

  [[nodiscard]] Unit read(const std::string& text) const {
    return Unit(ut_parse(system_.get(), text.c_str(), UT_UTF8));
  }

  /// Expects that a unit of UDUNITS-2 has this meaning.
  void expect(const Unit& unit, const UnitMeaning& meaning, const std::string& text) const {
    ASSERT_TRUE(unit) << text;
    std::string si = "1";
    for (std::size_t i = 0; i < base.size(); ++i) {
      if (meaning.powers[i] != 0) si += std::string(" ") + base[i] + std::to_string(meaning.powers[i]);
    }
    const Unit expected = read(si);
    ASSERT_TRUE(ut_are_convertible(unit.get(), expected.get())) << text << " is no " << si;
    const std::unique_ptr<cv_converter, Free> converter(ut_get_converter(unit.get(), expected.get()));
    const bool shifted = cv_convert_double(converter.get(), 0.0) != 0.0;
    ASSERT_EQ(meaning.scale.has_value(), !shifted) << text;
    // Round-off: factors are multiplied in a different order.
    if (shifted) return;
    EXPECT_NEAR(cv_convert_double(converter.get(), 1.0) / *meaning.scale, 1.0, 1e-15) << text;
  }

 private:
  static constexpr std::array base{"kg", "m", "s", "K", "rad"};
  std::unique_ptr<ut_system, Free> system_;
};

/// Our spellings without an equivalent in UDUNITS-2, and its spellings.
const std::map<std::string, std::string>& other_spellings() {
  static const std::map<std::string, std::string> spellings{
      {"deg", "degree"}, {"thou", "mil"}, {"rev", "revolution"}, {"P", "poise"}};
  return spellings;
}

/// Different meanings in UDUNITS-2: "ph" is a phot, and "datm" begins with "da".
const std::set<std::string> other_readings{"ph", "datm", "datmosphere"};

std::vector<std::string> words_of(const KnownUnit& unit) {
  std::istringstream words(std::string(unit.symbols) + " " + std::string(unit.names));
  return {std::istream_iterator<std::string>(words), {}};
}

/// The units of all quoted texts in documents and examples that begin with a number.
std::set<std::string> units_of_the_repository() {
  std::set<std::string> units;
  constexpr std::size_t longest = 40;
  for (const char* folder : {"../docs", "../docs/howto", "../examples", "../studies", ".."}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".md" && entry.path().extension() != ".toml") continue;
      std::ifstream file(entry.path());
      const std::string text{std::istreambuf_iterator<char>(file), {}};
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

TEST(UnitTable, KnowsEveryUnitOfDocumentsAndExamples) {
  const Udunits udunits;
  const std::set<std::string> units = units_of_the_repository();
  for (const char* known : {"um", "GPa", "MN/m", "deg", "rpm", "Hz", "uPa s"})
    EXPECT_TRUE(units.contains(known)) << known;
  int read = 0;
  for (const std::string& text : units) {
    const Udunits::Unit unit = udunits.read(text);
    if (!unit) continue;
    const std::optional<UnitMeaning> found = read_unit(text);
    ASSERT_TRUE(found) << text;
    udunits.expect(unit, *found, text);
    ++read;
  }
  EXPECT_GT(read, 12);
}

TEST(UnitTable, SaysOfEveryUnitWhatUdunitsSays) {
  const Udunits udunits;
  EXPECT_GT(known_units().size(), 25U);
  for (const KnownUnit& unit : known_units()) {
    for (const std::string& word : words_of(unit)) {
      const auto other = other_spellings().find(word);
      EXPECT_TRUE(other == other_spellings().end() || !udunits.read(word)) << word << " is known to UDUNITS-2";
      const std::string theirs = other == other_spellings().end() ? word : other->second;
      udunits.expect(udunits.read(theirs), unit.meaning, word);
      const std::optional<UnitMeaning> alone = read_unit(word);
      ASSERT_TRUE(alone) << word;
      EXPECT_EQ(alone->powers, unit.meaning.powers) << word;
      EXPECT_EQ(alone->scale, unit.meaning.scale) << word;
      // A prefix can result in another unit, which must be that of UDUNITS-2: "min" is not a thousandth of an inch.
      for (const UnitPrefix& prefix : unit_prefixes()) {
        if (!unit.meaning.scale) continue;
        for (const std::string& before : {std::string(prefix.symbol), std::string(prefix.name)}) {
          const std::optional<UnitMeaning> found = read_unit(before + word);
          ASSERT_TRUE(found) << before + word;
          if (!other_readings.contains(before + word))
            udunits.expect(udunits.read(before + theirs), *found, before + word);
        }
      }
    }
  }
}

TEST(UnitTable, ReadsNamesHoweverTheyAreWritten) {
  for (const char* text :
       {"MegaPascal", "MEGAPASCAL", "megapascals", "MPa", "Mpascal", "N/mm\xc2\xb2", "MN m\xe2\x81\xbb\xc2\xb2"}) {
    const std::optional<UnitMeaning> unit = read_unit(text);
    ASSERT_TRUE(unit) << text;
    EXPECT_DOUBLE_EQ(unit->scale.value(), 1e6) << text;
  }
  for (const char* text : {"\xc2\xb5m", "\xce\xbcm", "um", "micron", "Microns", "micrometres"}) {
    const std::optional<UnitMeaning> unit = read_unit(text);
    ASSERT_TRUE(unit) << text;
    EXPECT_EQ(unit->scale.value(), 1e-6) << text;
  }
}

TEST(UnitTable, HasTheGrammarOfUdunits) {
  const Udunits udunits;
  for (const char* text :
       {"N m",     "N.m",       "N*m",      "N-m",       "N\xc2\xb7m",  "N/m",   "N / m",    "N um-1",
        "m2",      "m^2",       "m**2",     "m\xc2\xb2", "m\xc2\xb3/s", "s-1",   "s^-1",     "kg m2 s-2",
        "kg/m/s2", "kg/(m s2)", "J/(kg K)", "(N)",       "1/s",         "1/min", "rad/s",    "revolution/min",
        "N s/m",   "Pa s",      "psi s",    "mN/mm",     "lbf/in",      "degC",  "\xc2\xb0", "m m m",
        "N m^-2",  "m2 s",      "m0"}) {
    const std::optional<UnitMeaning> found = read_unit(text);
    ASSERT_TRUE(found) << text;
    udunits.expect(udunits.read(text), *found, text);
  }
}

TEST(UnitTable, ReadsNothingElse) {
  for (const char* text : {"",        " ",       "m^",   "m//s",     "/m",
                           "m/",      "(m",      "m)",   "()",       "parsnips",
                           "GPA",     "mM",      "Mmm",  "kkN",      "kilomillimeter",
                           "furlong", "m per s", "m2s",  "m10",      "m^-",
                           "(m)2",    "H2O",     "%",    "m from 5", "1 s",
                           "2/s",     "mdegC",   "s s-", "K @ 273",  "\xff\xfe"}) {
    EXPECT_FALSE(read_unit(text)) << text;
  }
}

TEST(UnitTable, GivesNoSizeThatNumbersCannotHold) {
  std::string large = "Gm9";
  for (int i = 0; i < 9; ++i) large += " Gm9";
  EXPECT_FALSE(read_unit(large).value().scale);
  EXPECT_FALSE(read_unit("1/" + large.substr(0, 3) + "/Gm9/Gm9/Gm9/Gm9").value().scale);
}

}  // namespace
}  // namespace bumpfoil
