#include "case/udunits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// Collects what a unit is made of while UDUNITS-2 goes through it.
struct Walk {
  UnitMeaning meaning{.scale = 1.0};
  bool known{true};  ///< all of its base units are ours
};

ut_status add_power(Walk& walk, const ut_unit* basic, int power) {
  const char* symbol = ut_get_symbol(basic, UT_ASCII);
  const auto* const found = std::find(base_units.begin(), base_units.end(), symbol == nullptr ? "" : symbol);
  if (found == base_units.end()) {
    walk.known = false;
  } else {
    walk.meaning.powers[static_cast<std::size_t>(found - base_units.begin())] += power;
  }
  return UT_SUCCESS;
}

ut_status visit_basic(const ut_unit* unit, void* walk) {
  return add_power(*static_cast<Walk*>(walk), unit, 1);
}

ut_status visit_product(const ut_unit* /*unit*/, int count, const ut_unit* const* basic, const int* powers,
                        void* walk) {
  for (int i = 0; i < count; ++i) add_power(*static_cast<Walk*>(walk), basic[i], powers[i]);
  return UT_SUCCESS;
}

ut_status visit_inner(const ut_unit* inner, void* walk);

ut_status visit_galilean(const ut_unit* /*unit*/, double scale, const ut_unit* inner, double offset, void* walk) {
  const ut_status status = visit_inner(inner, walk);
  std::optional<double>& whole = static_cast<Walk*>(walk)->meaning.scale;
  whole = whole && offset == 0.0 ? std::optional(*whole * scale) : std::nullopt;
  return status;
}

ut_status visit_shifted(const ut_unit* /*unit*/, const ut_unit* inner, double /*origin*/, void* walk) {
  const ut_status status = visit_inner(inner, walk);
  static_cast<Walk*>(walk)->meaning.scale.reset();
  return status;
}

ut_status visit_logarithmic(const ut_unit* unit, double base, const ut_unit* reference, void* walk) {
  return visit_shifted(unit, reference, base, walk);
}

ut_status visit_inner(const ut_unit* inner, void* walk) {
  static const ut_visitor visitor{visit_basic, visit_product, visit_galilean, visit_shifted, visit_logarithmic};
  return ut_accept_visitor(inner, &visitor, walk);
}

std::optional<UnitMeaning> meaning_of(const Unit& unit) {
  Walk walk;
  if (!unit || visit_inner(unit.get(), &walk) != UT_SUCCESS || !walk.known) return std::nullopt;
  if (walk.meaning.scale && !std::isfinite(*walk.meaning.scale)) walk.meaning.scale.reset();
  return walk.meaning;
}

}  // namespace

Udunits::Udunits() {
  ut_set_error_message_handler(ut_ignore);  // it would print on standard error
  system_.reset(ut_read_xml(nullptr));
  if (!system_) {
    throw Error(ErrorKind::file, {{"", 0, "", "", "the units database of UDUNITS-2 cannot be read",
                                   "install the package libudunits2-data or set UDUNITS2_XML_PATH"}});
  }
  const Unit radian(ut_get_unit_by_name(system_.get(), "radian"));
  const Unit degree(ut_scale(std::numbers::pi / 180.0, radian.get()));
  ut_map_name_to_unit("deg", UT_UTF8, degree.get());
}

std::optional<UnitMeaning> Udunits::read(std::string_view text) const {
  return meaning_of(Unit(ut_parse(system_.get(), std::string(text).c_str(), UT_UTF8)));
}

std::optional<UnitMeaning> Udunits::named(const char* name) const {
  return meaning_of(Unit(ut_get_unit_by_name(system_.get(), name)));
}

std::optional<UnitMeaning> Udunits::with_symbol(const char* symbol) const {
  return meaning_of(Unit(ut_get_unit_by_symbol(system_.get(), symbol)));
}

}  // namespace bumpfoil
