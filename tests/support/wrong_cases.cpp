#include "support/wrong_cases.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace bumpfoil::test_support {
namespace {

using Fragments = std::vector<std::string>;

/// The whole case with `from` replaced by `to`; the error is expected in the line where `to` starts.
WrongCase edit(std::string name, const std::string& from, const std::string& to, Fragments fragments,
               std::size_t errors = 1) {
  std::string text = whole_case();
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the case has no " + from);
  text.replace(at, from.size(), to);
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
  return {std::move(name), std::move(text), errors, static_cast<std::size_t>(line), std::move(fragments)};
}

/// The whole case without the line of a key; the error is expected at the start of its table.
WrongCase without(std::string name, const std::string& line, const std::string& table, Fragments fragments) {
  WrongCase wrong = edit(std::move(name), line + "\n", "", std::move(fragments));
  wrong.line = line_of(wrong.text, "[" + table + "]");
  return wrong;
}

WrongCase text(std::string name, std::string content, std::size_t errors, std::size_t line, Fragments fragments) {
  return {std::move(name), std::move(content), errors, line, std::move(fragments)};
}

std::string repeated(const std::string& piece, std::size_t count) {
  std::string out;
  out.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) out += piece;
  return out;
}

void add_keys_and_types(std::vector<WrongCase>& table) {
  const auto add = [&table](WrongCase wrong) { table.push_back(std::move(wrong)); };
  add(edit("unknown key", "wrap =", "warp =", {"bearing.warp = clockwise", "did you mean \"wrap\"?"}));
  add(edit("transposed letters", "title =", "titel =", {"titel", "did you mean \"title\"?"}));
  add(edit("hyphen for underscore", "poisson_ratio = 0.29", "poisson-ratio = 0.29",
           {"bump_foil.poisson-ratio = 0.29", "did you mean \"poisson_ratio\"?"}, 2));
  table.back().line = 0;
  table.back().fragments = {"did you mean \"poisson_ratio\"?"};
  add(edit("capital letters", "pitch =", "Pitch =", {"did you mean \"pitch\"?"}, 2));
  table.back().line = 0;
  add(edit("nothing like it", "title =", "colour =", {"colour", "known here: title, bearing, bump_foil"}));
  add(edit("key outside its table", "title =", "viscosity =", {"viscosity", "did you mean \"gas.viscosity\"?"}));
  add(edit("unknown table", "[solver]", "[lubricant]\nname = \"air\"\n[solver]",
           {"lubricant", "unknown table", "known here"}));
  add(edit("misspelt table", "[solver]", "[sovler]", {"sovler", "did you mean \"solver\"?"}));
  add(edit("table where a value is due", "title = \"Whole\"", "[title]\nx = 1",
           {"title: is a table, expected a text"}));
  add(edit("value where a table is due", "[solver]\nname = \"newton\"", "[solver.name]\nx = 1",
           {"solver.name: is a table, expected a word in quotes"}));
  add(edit("list of tables", "[friction]", "[[friction]]", {"friction: is a list, expected a table"}, 1));
  add(edit("number as text", "bumps = 26", "bumps = \"26\"",
           {"bump_foil.bumps = 26: is a text", "a whole number without quotes"}));
  add(edit("broken number of bumps", "bumps = 26", "bumps = 26.5",
           {"bump_foil.bumps = 26.5", "write a whole number, such as 26"}));
  add(edit("whole steps as float", "steps = 100", "steps = 100.0", {"cycle.steps = 100", "expected a whole number"}));
  add(edit("bumps beyond int", "bumps = 26", "bumps = 3000000000", {"bump_foil.bumps = 3000000000: is out of range"}));
  add(edit("bumps below int", "bumps = 26", "bumps = -3000000000", {"is out of range; give a larger number"}));
  add(edit("steps beyond int", "steps = 100", "steps = 2147483648", {"cycle.steps = 2147483648: is out of range"}));
  add(edit("no name of a file", "sleeve_gaps = []", "height_errors_file = \"\"",
           {"bump_foil.height_errors_file: is empty", "leave it out"}));
  add(edit("ratio as text", "poisson_ratio = 0.29", "poisson_ratio = \"0.29\"",
           {"bump_foil.poisson_ratio = 0.29: is a text, expected a number", "without quotes"}));
  add(edit("length as true", "radius = \"19.05 mm\"", "radius = true",
           {"bearing.radius = true", "expected a length", "\"31.8 um\""}));
  add(edit("length as list", "radius = \"19.05 mm\"", "radius = [0.019]", {"bearing.radius: is a list"}));
  add(edit("length as date", "radius = \"19.05 mm\"", "radius = 2019-07-01",
           {"bearing.radius = 2019-07-01: is a date"}));
  add(edit("title as number", "title = \"Whole\"", "title = 3", {"title = 3: is a whole number, expected a text"}));
  add(edit("list as value", "directions = [\"+X\", \"37.5 deg\"]", "directions = \"+X\"",
           {"cycle.directions = +X: is a text, expected a list", "[\"+X\"]"}));
  add(edit("unknown word", "model = \"truss\"", "model = \"tress\"",
           {"bump_foil.model = tress: unknown value", "did you mean \"truss\"?"}));
  add(edit("unlike any word", "wrap = \"clockwise\"", "wrap = \"left\"",
           {"bearing.wrap = left", "\"clockwise\", \"counterclockwise\""}));
  add(edit("word as number", "name = \"newton\"", "name = 1", {"solver.name = 1: is a whole number, expected a word"}));
  add(edit("unknown axis", "\"+X\", ", "\"+Z\", ", {"cycle.directions[1] = +Z", "\"+X\", \"+Y\", \"-X\", \"-Y\""}));
}

void add_missing(std::vector<WrongCase>& table) {
  const auto add = [&table](WrongCase wrong) { table.push_back(std::move(wrong)); };
  add(without("no radius", "radius = \"19.05 mm\"", "bearing",
              {"bearing.radius: is missing", "[bearing], or bearing.diameter in its place"}));
  add(without("no clearance", "radial_clearance = \"31.8 um\"", "bearing", {"bearing.radial_clearance: is missing"}));
  add(without("no bumps", "bumps = 26", "bump_foil", {"bump_foil.bumps: is missing"}));
  add(without("no modulus", "youngs_modulus = \"214 GPa\"", "bump_foil", {"bump_foil.youngs_modulus: is missing"}));
  add(without("no amplitude", "amplitude = \"79.5 um\"", "cycle",
              {"cycle.amplitude: is missing", "or cycle.load in its place"}));
  add(edit("no friction coefficient", "coefficient = 0.1", "", {"friction.coefficient: is missing", "0 for none"}));
  table.back().line = line_of(table.back().text, "[friction]");
  add(edit("half of friction", "coefficient = 0.1", "top_bump = 0.1", {"friction.bump_sleeve: is missing"}));
  table.back().line = line_of(table.back().text, "[friction]");
  add(edit("no friction", "[friction]\ncoefficient = 0.1\n", "", {"friction: this table is missing", "0 for none"}));
  table.back().line = 0;
  add(edit("no top foil", "[top_foil]\nthickness = \"0.102 mm\"\n", "", {"top_foil: this table is missing"}));
  table.back().line = 0;
  add(edit("top foil without thickness", "[top_foil]\nthickness = \"0.102 mm\"\n", "[top_foil]\n",
           {"top_foil.thickness: is missing"}));
  add(text("nothing but a title", "title = \"x\"\n", 4, 0, {"bearing: this table is missing"}));
  add(text("empty", "", 1, 0, {"is empty", "bumpfoil init"}));
  add(text("white space", " \n\t\r\n", 1, 0, {"is empty", "bumpfoil init"}));
  add(text("comments only", "# nothing\n", 4, 0, {"bump_foil: this table is missing"}));
}

void add_units(std::vector<WrongCase>& table) {
  const auto add = [&table](WrongCase wrong) { table.push_back(std::move(wrong)); };
  add(edit("force for a length", "\"19.05 mm\"", "\"19.05 N\"",
           {"bearing.radius = 19.05 N: is a force, expected a length", "\"31.8 um\""}));
  add(edit("length for a pressure", "\"214 GPa\"", "\"214 mm\"", {"is a length, expected a pressure", "\"214 GPa\""}));
  add(edit("length for a stiffness", "\"150 MN/m\"", "\"150 mm\"",
           {"bump_foil.truss.k1 = 150 mm", "expected a stiffness"}));
  add(edit("length for an angle", "\"15.83 deg\"", "\"15.83 mm\"", {"bump_foil.truss.theta_d", "expected an angle"}));
  add(edit("area for a length", "\"4.572 mm\"", "\"4.572 mm2\"", {"has the unit \"mm2\", expected a length"}));
  add(edit("unknown unit", "\"4.572 mm\"", "\"4.572 parsnips\"", {"unknown unit, \"parsnips\"", "\"31.8 um\""}));
  add(edit("capital letters of a unit", "\"214 GPa\"", "\"214 GPA\"", {"unknown unit, \"GPA\""}));
  add(edit("broken exponent", "\"4.572 mm\"", "\"4.572 mm^3.5\"", {"digits instead of a unit", "mm^3.5"}));
  add(edit("exponent that hides a half", "\"4.572 mm\"", "\"4.572 mm^1.5\"", {"digits instead of a unit"}));
  add(edit("no unit", "\"4.572 mm\"", "\"4.572\"", {"bump_foil.pitch = 4.572: has no unit", "number in m"}));
  add(edit("no number", "\"4.572 mm\"", "\"mm\"", {"does not start with a number"}));
  add(edit("empty text", "\"4.572 mm\"", "\"\"", {"bump_foil.pitch: is empty"}));
  add(edit("decimal comma in a text", "\"4.572 mm\"", "\"4,572 mm\"", {"digits instead of a unit", "decimal point"}));
  add(edit("thousands", "\"4.572 mm\"", "\"4 572 um\"", {"digits instead of a unit", "without separators"}));
  add(edit("shifted unit", "\"4.572 mm\"", "\"4.572 m from 3\"", {"bump_foil.pitch"}));
  add(edit("huge unit", "\"4.572 mm\"", "\"1 m^99999999999999999999\"", {"bump_foil.pitch", "is not a quantity"}));
  table.back().fragments = {"bump_foil.pitch = 1 m^99999999999999999999"};
  add(edit("degrees as a number", "weld_angle = \"180 deg\"", "weld_angle = 180",
           {"bearing.weld_angle = 180: is more than a full turn", "\"180 deg\""}));
  add(edit("more degrees than a turn has", "\"180 deg\"", "\"361 deg\"",
           {"bearing.weld_angle = 361 deg: is more than a full turn; give at most 360 degrees either way"}));
  add(edit("degrees of the rods as a number", "\"15.83 deg\"", "15.83",
           {"bump_foil.truss.theta_d = 15.83: must lie between", "write \"15.83 deg\" if degrees are meant"}));
  add(edit("two signs", "\"19.05 mm\"", "\"+-19.05 mm\"",
           {"bearing.radius = +-19.05 mm: does not start with a number"}));
  add(edit("nan", "\"19.05 mm\"", "nan", {"bearing.radius = nan: is not finite"}));
  add(edit("infinite", "\"19.05 mm\"", "-inf", {"bearing.radius = -inf: is not finite"}));
  add(edit("nan in a text", "\"19.05 mm\"", "\"nan mm\"", {"bearing.radius = nan mm: is not finite"}));
  add(edit("too large in a text", "\"19.05 mm\"", "\"1e400 mm\"", {"bearing.radius = 1e400 mm", "cannot hold"}));
}

void add_physics(std::vector<WrongCase>& table) {
  const auto add = [&table](WrongCase wrong) { table.push_back(std::move(wrong)); };
  add(edit("negative radius", "\"19.05 mm\"", "\"-19.05 mm\"", {"bearing.radius = -19.05 mm: must be positive"}));
  add(edit("radius of zero", "\"19.05 mm\"", "0", {"bearing.radius = 0: must be positive"}));
  add(edit("clearance in mm", "\"31.8 um\"", "\"31.8 mm\"", {"bearing.radial_clearance = 31.8 mm", "too large"}, 1));
  add(edit("modulus without giga", "\"214 GPa\"", "214", {"bump_foil.youngs_modulus = 214: is unphysical"}));
  add(edit("Poisson's ratio above a half", "poisson_ratio = 0.29", "poisson_ratio = 0.6",
           {"bump_foil.poisson_ratio = 0.6: is unphysical", "0 to 0.5"}));
  add(edit("negative ratio", "poisson_ratio = 0.29", "poisson_ratio = -0.29", {"must not be negative"}));
  add(edit("no bumps at all", "bumps = 26", "bumps = 0", {"bump_foil.bumps = 0: is not a valid number"}, 1));
  add(edit("foil overlaps itself", "bumps = 26", "bumps = 28",
           {"bump_foil.bumps = 28: the foil would overlap itself", "at most 26 bumps"}));
  add(edit("bumps overlap", "length = \"3.556 mm\"", "length = \"4.6 mm\"",
           {"bump_foil.length = 4.6 mm: bumps would overlap", "below the pitch"}));
  add(edit("no rise", "height = \"0.508 mm\"", "height = \"0.1 mm\"",
           {"bump_foil.height = 0.1 mm: leaves no rise", "midsurface"}));
  add(edit("bulging bumps overlap", "height = \"0.508 mm\"", "height = \"5 mm\"",
           {"bump_foil.height = 5 mm: bumps would overlap: arcs of more than a half circle"}));
  add(edit("thick foil", "thickness = \"0.102 mm\"\nyoungs", "thickness = \"3 mm\"\nyoungs",
           {"bump_foil.thickness = 3 mm"}, 2));
  add(edit("negative friction", "coefficient = 0.1", "coefficient = -0.1",
           {"friction.coefficient = -0.1: must not be negative"}));
  add(edit("friction in percent", "coefficient = 0.1", "coefficient = 10",
           {"friction.coefficient = 10: is unphysical", "0 to 1"}));
  add(edit("too few height errors", "height_errors = []", "height_errors = [\"1 um\", 2e-6]",
           {"bump_foil.height_errors = 2 values: there must be one value per bump, 26 in all"}));
  add(edit("height errors in m", "height_errors = []", "height_errors = [" + repeated("10, ", 26) + "]",
           {"bump_foil.height_errors[1] = 10: is more than the rise", "is the unit right?"}, 26));
  add(edit("a height error that is nan", "height_errors = []", "height_errors = [" + repeated("0, ", 25) + "nan]",
           {"bump_foil.height_errors[26] = nan: is not finite"}));
  add(edit("too many sleeve gaps", "sleeve_gaps = []", "sleeve_gaps = [" + repeated("0, ", 27) + "]",
           {"bump_foil.sleeve_gaps = 27 values", "26 in all"}));
  add(edit("negative spring", "\"150 MN/m\"", "\"-150 MN/m\"", {"bump_foil.truss.k1 = -150 MN/m: must be positive"}));
  add(edit("upright rods", "\"15.83 deg\"", "\"90 deg\"",
           {"bump_foil.truss.theta_d = 90 deg", "between 0 and 90 degrees"}));
  add(edit("arc start of a truss", "\"mid_flat\"", "\"arc_start\"", {"bump_foil.weld_at = arc_start: only the frame"}));
  add(edit("large displacements of a truss", "\"linear\"", "\"nonlinear\"",
           {"bump_foil.geometry = nonlinear: only the frame model can follow large displacements"}));
  add(edit("large displacements from event to event", "name = \"newton\"", "name = \"events\"",
           {"solver.name = events: follows a response that is linear between events", "set name = \"newton\""}));
  std::string& large = table.back().text;
  const std::string small = "model = \"truss\"\ngeometry = \"linear\"";
  large.replace(large.find(small), small.size(), "model = \"frame\"\ngeometry = \"nonlinear\"");
  add(edit("penalty of zero", "eps_alm = \"100 MN/m\"", "eps_alm = 0", {"solver.eps_alm = 0: must be positive"}));
  add(edit("no direction", "directions = [\"+X\", \"37.5 deg\"]", "directions = []",
           {"cycle.directions: no direction specified"}));
  add(edit("a direction twice", "\"37.5 deg\"", "\"37.5 deg\", \"360 deg\"",
           {"cycle.directions[3] = 360 deg: repeats cycle.directions[1]", "every direction once"}));
  add(edit("amplitude of zero", "\"79.5 um\"", "0.0", {"cycle.amplitude = 0: must be positive"}));
  add(edit("amplitude in mm", "\"79.5 um\"", "\"79.5 mm\"", {"cycle.amplitude = 79.5 mm: would press the bumps flat"}));
  add(edit("no steps", "steps = 100", "steps = 0", {"cycle.steps = 0", "1 to 1000000"}));
  add(edit("more steps than memory", "steps = 100", "steps = 1000000",
           {"cycle.steps = 1000000", "would not fit in memory"}));
  add(edit("both frictions", "coefficient = 0.1", "coefficient = 0.1\ntop_bump = 0.2",
           {"friction.coefficient = 0.1: conflicts with top_bump"}));
  add(edit("radius and diameter", "radius = \"19.05 mm\"", "radius = \"19.05 mm\"\ndiameter = \"38.1 mm\"",
           {"bearing.radius = 19.05 mm: conflicts with diameter"}));
  add(edit("height errors twice", "height_errors = []",
           "height_errors = [" + repeated("0, ", 26) + "]\nheight_errors_file = \"heights.csv\"",
           {"bump_foil.height_errors_file = heights.csv: conflicts with height_errors"}));
  table.back().line += 1;
}

void add_syntax(std::vector<WrongCase>& table) {
  const auto add = [&table](WrongCase wrong) { table.push_back(std::move(wrong)); };
  add(edit("quantity without quotes", "radius = \"19.05 mm\"", "radius = 19.05 mm",
           {"is not TOML", "saw 'm'", "radius = \"19.05 mm\""}));
  add(edit("decimal comma", "poisson_ratio = 0.29", "poisson_ratio = 0,29",
           {"is not TOML", "saw ','", "decimal point"}));
  add(edit("key twice", "bumps = 26", "bumps = 26\nbumps = 27", {"cannot redefine existing integer 'bumps'", "once"}));
  table.back().line += 1;
  add(edit("table twice", "[friction]", "[bearing]\n[friction]", {"cannot redefine existing table 'bearing'"}));
  add(edit("no value", "bumps = 26", "bumps =", {"expected value", "after the equals sign"}));
  add(edit("no equals sign", "bumps = 26", "bumps 26", {"is not TOML", "key = value"}));
  add(edit("open quote", "title = \"Whole\"", "title = \"Whole", {"parsing string", "close the text"}));
  add(edit("open bracket", "[friction]", "[friction", {"table header", "[name]"}));
  add(text("open list", "a = [1, 2", 1, 1, {"parsing array", "close the list"}));
  add(edit("number beyond double", "bumps = 26", "bumps = 1e400", {"1e400", "the number is too large"}));
  add(edit("number beyond 64 bits", "bumps = 26", "bumps = 99999999999999999999", {"not representable"}));
}

void add_hostile(std::vector<WrongCase>& table) {
  const auto add = [&table](WrongCase wrong) { table.push_back(std::move(wrong)); };
  add(text("null byte", std::string("title = \"x\"\n\0", 13), 1, 2, {"is not a text file", "UTF-8"}));
  add(text("binary",
           std::string("\x7f"
                       "ELF\x02\x01\x01\0\0\0",
                       10),
           1, 1, {"is not a text file"}));
  add(text("UTF-16",
           std::string("\xff\xfe"
                       "a\0=\0",
                       6),
           1, 1, {"is not a text file", "UTF-8"}));
  add(text("invalid UTF-8", "title = \"\xff\"\n", 1, 1, {"utf-8", "save the file as UTF-8"}));
  add(text("control character", "title = \"x\x1b[2J\"\n", 1, 1, {"control characters", "remove what cannot be seen"}));
  add(edit("escaped control characters", "wrap = \"clockwise\"", R"(wrap = "\u001b[2J\u0007\u009b")",
           {R"(bearing.wrap = \x1b[2J\x07\xc2\x9b: unknown value)"}));
  add(edit("key with control characters", "wrap = ", R"("wr\nap\u001b" = )", {R"(bearing.wr\x0aap\x1b = clockwise)"}));
  add(edit("unit with control characters", "\"19.05 mm\"", R"("19.05 mm\u0000N")",
           {R"(19.05 mm\x00N: is not a quantity)"}));
  add(edit("endless text", "\"19.05 mm\"", "\"19.05 " + repeated("m", 1'000'000) + "\"",
           {"is not a quantity", "(1000006 characters)"}));
  add(edit("endless parentheses", "\"19.05 mm\"", "\"19.05 " + repeated("(", 100'000) + "\"", {"is not a quantity"}));
  add(edit("endless key", "wrap =", repeated("w", 1'000'000) + " =", {"(1000008 characters)", "unknown key"}));
  add(edit("a million entries", "height_errors = []", "height_errors = [" + repeated("0,", 1'000'000) + "]",
           {"bump_foil.height_errors: has 1000000 entries", "at most 100000"}));
  add(edit("a million texts", "directions = [\"+X\", \"37.5 deg\"]",
           "directions = [" + repeated("\"+X\",", 1'000'000) + "]", {"cycle.directions: has 1000000 entries"}));
  add(text("a million keys",
           [] {
             std::string keys;
             for (int i = 0; i < 500'000; ++i) keys += "k" + std::to_string(i) + "=1\n";
             return keys;
           }(),
           51, 0, {"and 499954 more errors"}));
  add(text("deep arrays", "a = " + repeated("[", 1'000'000), 1, 1, {"nested", "no such nesting"}));
  add(text("deep inline tables", "a = " + repeated("{a = ", 1'000'000), 1, 1, {"nested", "no such nesting"}));
  add(text("deep keys", "\na" + repeated(".a", 1'000'000) + " = 1", 1, 2, {"more than 16 parts"}));
  add(text("deep table name", "[a" + repeated(" . \"b\"", 1'000'000) + "]", 1, 1, {"more than 16 parts"}));
  add(text("deep keys behind a text", "title = '''\n#'''\na" + repeated(".a", 1'000'000) + " = 1", 1, 3, {"16 parts"}));
  add(text("over 10 MB", "# " + repeated("x", 10'000'000), 1, 0, {"is larger than 10 MB"}));
}

}  // namespace

std::string whole_case() {
  return R"(title = "Whole"
[bearing]
radius = "19.05 mm"
axial_length = "38.1 mm"
radial_clearance = "31.8 um"
weld_angle = "180 deg"
wrap = "clockwise"
[bump_foil]
model = "truss"
geometry = "linear"
bumps = 26
pitch = "4.572 mm"
length = "3.556 mm"
height = "0.508 mm"
height_reference = "overall"
thickness = "0.102 mm"
youngs_modulus = "214 GPa"
poisson_ratio = 0.29
height_errors = []
sleeve_gaps = []
weld_at = "mid_flat"
[bump_foil.truss]
k1 = "150 MN/m"
theta_d = "15.83 deg"
[top_foil]
thickness = "0.102 mm"
[friction]
coefficient = 0.1
[solver]
name = "newton"
eps_alm = "100 MN/m"
[cycle]
directions = ["+X", "37.5 deg"]
amplitude = "79.5 um"
steps = 100
)";
}

std::size_t line_of(const std::string& text, const std::string& fragment) {
  const std::size_t at = text.find(fragment);
  if (at == std::string::npos) return 0;
  return static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) + 1;
}

std::vector<WrongCase> wrong_cases() {
  std::vector<WrongCase> table;
  add_keys_and_types(table);
  add_missing(table);
  add_units(table);
  add_physics(table);
  add_syntax(table);
  add_hostile(table);
  return table;
}

}  // namespace bumpfoil::test_support
