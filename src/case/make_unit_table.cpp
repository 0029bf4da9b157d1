// Writes the table of units for where UDUNITS-2 is not to be had, out of its database: every name and symbol in its
// files that UDUNITS-2 itself knows, with what it says of it.
//
// Usage: make_unit_table FILE

#include <fmt/format.h>
#include <fmt/os.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "case/text_file.hpp"
#include "case/udunits.hpp"

namespace bumpfoil {
namespace {

struct Element {
  std::string name;
  std::string text;
};

/// A sign by its number, in UTF-8.
std::string utf8_of(unsigned number) {
  if (number < 0x80) return {static_cast<char>(number)};
  const auto last = static_cast<char>(0x80 | (number & 0x3f));
  if (number < 0x800) return {static_cast<char>(0xc0 | (number >> 6)), last};
  return {static_cast<char>(0xe0 | (number >> 12)), static_cast<char>(0x80 | ((number >> 6) & 0x3f)), last};
}

std::string without_references(std::string text) {
  for (std::size_t at = text.find("&#x"); at != std::string::npos; at = text.find("&#x", at + 1)) {
    const std::size_t end = text.find(';', at);
    unsigned number = 0;
    std::from_chars(text.data() + at + 3, text.data() + end, number, 16);
    text.replace(at, end + 1 - at, utf8_of(number));
  }
  return text;
}

/// The innermost elements of a file, in their order. (Those of the database hold no other markup than character
/// references and comments.)
std::vector<Element> elements_of(const std::string& xml) {
  std::vector<Element> elements;
  for (std::size_t open = xml.find('<'); open != std::string::npos; open = xml.find('<', open + 1)) {
    if (xml.compare(open, 4, "<!--") == 0) {
      open = xml.find("-->", open);
      continue;
    }
    const std::size_t close = xml.find('>', open);
    const std::size_t next = xml.find('<', close);
    if (next == std::string::npos) break;
    const std::string name = xml.substr(open + 1, xml.find_first_of(" >", open) - open - 1);
    if (xml.compare(next, 3 + name.size(), "</" + name + ">") == 0)
      elements.push_back({name, without_references(xml.substr(close + 1, next - close - 1))});
  }
  return elements;
}

std::string literal(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    // Octal, of which there are three digits at most: what follows is not taken for more of them.
    out += byte < 0x80 && c != '"' && c != '\\' ? std::string(1, c) : fmt::format("\\{:03o}", byte);
  }
  return out + '"';
}

/// What is found in the files of the database.
class Table {
 public:
  void add_file(const std::filesystem::path& path) {
    std::string value;
    for (const auto& [name, text] : elements_of(read_text_file(path.string()))) {
      if (name == "import") add_file(path.parent_path() / text);
      if (name == "value") value = text;
      if (name != "name" && name != "singular" && name != "plural" && name != "symbol") continue;
      if (path.filename() == "udunits2-prefixes.xml") {
        prefixes_ += fmt::format("    {{{}, {}, {}}},\n", literal(text), name == "symbol", value);
      } else {
        words_.insert(text);
        words_.insert(text + "s");
        words_.insert(text + "es");
        if (text.ends_with('y')) words_.insert(text.substr(0, text.size() - 1) + "ies");
      }
    }
  }

  [[nodiscard]] std::string source() const {
    std::string units;
    for (const std::string& word : words_) {
      if (const auto unit = udunits_.named(word.c_str())) units += line(word, false, *unit);
      if (const auto unit = udunits_.with_symbol(word.c_str())) units += line(word, true, *unit);
    }
    return fmt::format(
        "// Written by make_unit_table out of the database of UDUNITS-2.\n"
        "#include \"case/unit_table.hpp\"\n\n#include <array>\n\n"
        "namespace bumpfoil {{\nnamespace {{\n\n"
        "constexpr auto units = std::to_array<TableUnit>({{\n{}}});\n\n"
        "constexpr auto prefixes = std::to_array<TablePrefix>({{\n{}}});\n\n"
        "}}  // namespace\n\nUnitTable unit_table() {{\n  return {{units, prefixes}};\n}}\n\n}}  // namespace "
        "bumpfoil\n",
        units, prefixes_);
  }

 private:
  static std::string line(const std::string& word, bool is_symbol, const UnitMeaning& unit) {
    const std::string scale = unit.scale ? fmt::format("{:.17g}", *unit.scale) : "std::nullopt";
    return fmt::format("    {{{}, {}, {{{{{}}}, {}}}}},\n", literal(word), is_symbol, fmt::join(unit.powers, ", "),
                       scale);
  }

  Udunits udunits_;
  std::set<std::string> words_{"deg"};
  std::string prefixes_;
};

void write(const char* path) {
  ut_status status{};
  Table table;
  table.add_file(ut_get_path_xml(nullptr, &status));
  fmt::output_file(path).print("{}", table.source());
}

}  // namespace
}  // namespace bumpfoil

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::invalid_argument("usage: make_unit_table FILE");
    bumpfoil::write(argv[1]);
  } catch (const std::exception& error) {
    std::fputs((std::string(error.what()) + '\n').c_str(), stderr);
    return 1;
  }
}
