#include "results/quantity_limit.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

const std::vector<LimitedQuantity> limited{{"h_min", "m"}, {"power", "W"}, {"torque", "N m"}, {"loss_factor", "1"}};

double bound_of(const std::string& text) {
  return parse_quantity_limit(text, limited, {"limits", "the result", "see there", "h_min > 5 um"}).bound;
}

std::string refusal_of(const std::string& text) {
  try {
    bound_of(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(QuantityLimit, HasAUnitOrNone) {
  EXPECT_DOUBLE_EQ(bound_of("h_min > 5 um"), 5e-6);
  EXPECT_DOUBLE_EQ(bound_of("h_min > 5e-6 m"), 5e-6);
  EXPECT_DOUBLE_EQ(bound_of("h_min > 5e-6"), 5e-6);
  EXPECT_DOUBLE_EQ(bound_of("torque < 7 N mm"), 7e-3);
  // No case key is a power: only the unit of the result is accepted.
  EXPECT_DOUBLE_EQ(bound_of("power < 37 W"), 37.0);
  EXPECT_DOUBLE_EQ(bound_of("power < 37"), 37.0);
  EXPECT_NE(refusal_of("power < 37 kW").find("write a number in W"), std::string::npos);
  EXPECT_DOUBLE_EQ(bound_of("loss_factor > 0.31"), 0.31);
  EXPECT_NE(refusal_of("loss_factor > 3 %").find("write a number without a unit"), std::string::npos);
  EXPECT_NE(refusal_of("h_min > 5 N").find("is a force"), std::string::npos) << refusal_of("h_min > 5 N");
  EXPECT_NE(refusal_of("h_min > nan").find("is not finite"), std::string::npos) << refusal_of("h_min > nan");
}

}  // namespace
}  // namespace bumpfoil
