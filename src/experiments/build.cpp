#include "bumpfoil/experiments/build.hpp"

#include <memory>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/validation.hpp"

namespace bumpfoil {

SharedFoils make_bearing_foils(const Case& input, const std::vector<std::string>& commands) {
  require_bearing(input, commands);
  return std::make_shared<const Foils>(make_foils(input));
}

SharedFoils make_strip_foils(const Case& input) {
  require_valid(input, {"strip"});
  if (!input.strip) throw Error(ErrorKind::input, {{"", 0, "strip", "", "this table is missing", "add [strip]"}});
  return std::make_shared<const Foils>(make_foils(input, *input.strip));
}

FilmBearing make_film_bearing(const Case& input, const Gas& gas, const FilmResolution& resolution) {
  return make_film_bearing(input, *make_bearing_foils(input, {"equilibrium"}), gas, resolution);
}

FilmBearing make_film_bearing(const Case& input) {
  return make_film_bearing(input, gas_of(input.gas),
                           {.columns_per_pitch = input.film.columns_per_pitch, .rows = input.film.rows});
}

}  // namespace bumpfoil
