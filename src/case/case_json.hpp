#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The case in the structure and key order of the case file, with SI numbers.
nlohmann::ordered_json case_json(const Case& input);

/// Titles and units of all tables and keys by their paths: {"bearing.radius": {"title": "Radius", "unit": "m"}, ...}.
nlohmann::ordered_json case_labels();

/// JSON text with an indentation, safe to print: see printable_json. Invalid UTF-8 is repaired.
std::string dump_json(const nlohmann::ordered_json& json, int indent);

}  // namespace bumpfoil
