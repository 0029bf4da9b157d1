#pragma once

#include <string>

namespace bumpfoil {

/// What result.nc of each experiment has, as JSON: `experiments` by name, each a list of small runs with the keys that
/// they `set` and the `variables` that those before have not. A variable has its `name`, its `key` in tables and
/// summaries, which carries the unit, `unit` (as UDUNITS spells it, "1" for none, empty for words), `long_name`,
/// `form` ("real", "whole", "truth", "flag"), the `words` of truths and flags, `dims`, whether it is a `coordinate`,
/// its `label` in tables for people and the unit `shown` there with its `size` in SI, and `tags`, names of those of
/// quantity.hpp. Made by running the experiments, which takes seconds.
std::string result_schema();

}  // namespace bumpfoil
