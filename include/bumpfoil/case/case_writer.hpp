#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The case as interpreted, as a case file: SI numbers, defaults filled in, units in comments. Reading it gives the
/// same case, to the last bit.
std::string case_to_toml(const Case& input);

/// The same as a JSON object with the keys of the case file, m, rad, Pa and N/m.
std::string case_to_json(const Case& input);

/// Names of the presets that `case_template` knows.
std::vector<std::string> preset_names();

/// A commented case file to start from, with every key. "gen1" is reference_case(). Unpublished values are marked as
/// assumed.
/// @throws Error (input) if the preset is not known.
std::string case_template(std::string_view name);

/// All keys of the case file with type, meaning and default, in Markdown: docs/case_file.md.
std::string case_reference();

/// All keys as a JSON Schema (draft 7, which editors read): titles, meanings, units as patterns, words, and the ranges
/// of single numbers. It accepts every case that parse_case() accepts, except names of units in capitals.
std::string case_schema();

/// File of the schema, beside the case, as the first line of case_template() has it.
inline constexpr std::string_view case_schema_name = "case.schema.json";

/// The same by their names alone, as --set takes them: "bump_foil.height". Keys of lists of tables, which go by the
/// number of the table, are left out.
std::vector<std::string> case_key_names();

}  // namespace bumpfoil
