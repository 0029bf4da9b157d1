#include "case/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace bumpfoil {
namespace {

double value_of(std::string_view text, Dimension dimension) {
  const auto quantity = parse_quantity(text, dimension);
  if (const auto* error = std::get_if<QuantityError>(&quantity)) {
    ADD_FAILURE() << text << ": " << error->what;
    return std::nan("");
  }
  return std::get<double>(quantity);
}

std::string error_of(std::string_view text, Dimension dimension) {
  const auto quantity = parse_quantity(text, dimension);
  if (const auto* error = std::get_if<QuantityError>(&quantity)) return error->what + "; " + error->advice;
  ADD_FAILURE() << text << " was read as " << std::get<double>(quantity);
  return {};
}

TEST(ParseQuantity, ReadsWhatCaseFilesHold) {
  // Exact: a decimal fraction is divided by a power of ten, which gives the nearest double.
  EXPECT_EQ(value_of("31.8 um", Dimension::length), 31.8e-6);
  EXPECT_EQ(value_of("19.05 mm", Dimension::length), 19.05e-3);
  EXPECT_EQ(value_of("0.102mm", Dimension::length), 0.102e-3);
  EXPECT_EQ(value_of("214 GPa", Dimension::pressure), 214e9);
  EXPECT_EQ(value_of("150 MN/m", Dimension::stiffness), 150e6);
  EXPECT_EQ(value_of("150 N um-1", Dimension::stiffness), 150e6);
  EXPECT_EQ(value_of("5 N", Dimension::force), 5.0);
  EXPECT_EQ(value_of(" -2e1 um ", Dimension::length), -20e-6);
  EXPECT_EQ(value_of("+1.5 m", Dimension::length), 1.5);
}

TEST(ParseQuantity, ReadsDamping) {
  EXPECT_EQ(value_of("200 N s/m", Dimension::damping), 200.0);
  EXPECT_EQ(value_of("0.2 N s mm-1", Dimension::damping), 200.0);
  EXPECT_EQ(value_of("3 kg/s", Dimension::damping), 3.0);
  EXPECT_NE(error_of("150 N/m", Dimension::damping).find("is a stiffness, expected a damping"), std::string::npos);
  EXPECT_EQ(name_of(Dimension::damping), "a damping");
  EXPECT_EQ(si_unit(Dimension::damping), "N s/m");
}

TEST(ParseQuantity, ReadsBothMicroSigns) {
  EXPECT_EQ(value_of("31.8 \xc2\xb5m", Dimension::length), 31.8e-6);  // micro sign
  EXPECT_EQ(value_of("31.8 \xce\xbcm", Dimension::length), 31.8e-6);  // Greek mu
}

TEST(ParseQuantity, ReadsDegreesInEverySpelling) {
  for (const char* text : {"180 deg", "180 degrees", "180 degree", "180 \xc2\xb0", "3.141592653589793 rad"}) {
    EXPECT_DOUBLE_EQ(value_of(text, Dimension::angle), std::numbers::pi) << text;
  }
}

TEST(ParseQuantity, ReadsTurnsAndRadians) {
  constexpr double turn = 2.0 * std::numbers::pi;
  EXPECT_DOUBLE_EQ(value_of("200 Hz", Dimension::frequency), turn * 200.0);
  EXPECT_DOUBLE_EQ(value_of("1.5 kHz", Dimension::frequency), turn * 1500.0);
  EXPECT_DOUBLE_EQ(value_of("2 hertz", Dimension::frequency), turn * 2.0);
  EXPECT_DOUBLE_EQ(value_of("45000 rpm", Dimension::frequency), turn * 750.0);
  EXPECT_DOUBLE_EQ(value_of("300 rad/s", Dimension::frequency), 300.0);
  EXPECT_DOUBLE_EQ(value_of("360 deg/s", Dimension::frequency), turn);
  for (const char* text : {"45000 1/min", "45000 min-1", "45000 min^-1", "45000 min\u207b\u00b9", "45000 1/minute"}) {
    EXPECT_DOUBLE_EQ(value_of(text, Dimension::frequency), turn * 750.0) << text;
  }
  for (const char* text : {"200 1/s", "200 s-1", "200 s^-1", "200 1/h"}) {
    EXPECT_NE(error_of(text, Dimension::frequency).find("which may count revolutions or radians"), std::string::npos)
        << text;
  }
  EXPECT_NE(error_of("30 deg", Dimension::frequency).find("is an angle, expected a frequency"), std::string::npos);
  EXPECT_NE(error_of("200 Hz", Dimension::length).find("is a frequency, expected a length"), std::string::npos);
  EXPECT_NE(error_of("200 Hz", Dimension::angle), "");
  EXPECT_NE(error_of("3 s", Dimension::frequency).find("is a time, expected a frequency"), std::string::npos);
}

TEST(ParseQuantity, ReadsWhatGasesAreToldBy) {
  EXPECT_EQ(value_of("293 K", Dimension::temperature), 293.0);
  EXPECT_NE(error_of("20 degC", Dimension::temperature).find("plain multiple"), std::string::npos);
  EXPECT_EQ(value_of("18.5 uPa s", Dimension::viscosity), 18.5e-6);
  EXPECT_DOUBLE_EQ(value_of("0.0185 mPa s", Dimension::viscosity), 18.5e-6);
}

TEST(ParseQuantity, ReadsOtherSystemsOfUnits) {
  EXPECT_DOUBLE_EQ(value_of("1 inch", Dimension::length), 25.4e-3);
  EXPECT_DOUBLE_EQ(value_of("1 mil", Dimension::length), 25.4e-6);
  EXPECT_DOUBLE_EQ(value_of("1 thou", Dimension::length), 25.4e-6);
  EXPECT_DOUBLE_EQ(value_of("1 rev/min", Dimension::frequency), 2.0 * std::numbers::pi / 60.0);
  EXPECT_DOUBLE_EQ(value_of("0.0185 cP", Dimension::viscosity), 18.5e-6);
  EXPECT_NEAR(value_of("1 psi", Dimension::pressure), 6894.757293168, 1e-8);  // all given digits of the definition
}

TEST(ParseQuantity, NamesTheDimensionThatWasMet) {
  EXPECT_EQ(error_of("19.05 N", Dimension::length),
            "is a force, expected a length; write a length with its unit, for example \"31.8 um\"");
  EXPECT_NE(error_of("30 deg", Dimension::length).find("is an angle, expected a length"), std::string::npos);
  EXPECT_NE(error_of("3 mm", Dimension::angle).find("is a length, expected an angle"), std::string::npos);
  EXPECT_NE(error_of("3 s2", Dimension::pressure).find("has the unit \"s2\", expected a pressure"), std::string::npos);
  EXPECT_NE(error_of("3 mm2", Dimension::length).find("has the unit \"mm2\""), std::string::npos);
}

TEST(ParseQuantity, WantsAUnitThatItKnows) {
  EXPECT_NE(error_of("0.019", Dimension::length).find("has no unit"), std::string::npos);
  EXPECT_NE(error_of("0.019", Dimension::length).find("number in m without quotes"), std::string::npos);
  EXPECT_NE(error_of("+-2 um", Dimension::length).find("does not start with a number"), std::string::npos);
  EXPECT_NE(error_of("3 parsnips", Dimension::length).find("unknown unit, \"parsnips\""), std::string::npos);
  EXPECT_NE(error_of("214 GPA", Dimension::pressure).find("unknown unit, \"GPA\""), std::string::npos);
}

TEST(ParseQuantity, TakesNoNumberInsideTheUnit) {
  EXPECT_NE(error_of("1 000 mm", Dimension::length).find("digits instead of a unit"), std::string::npos);
  EXPECT_NE(error_of("1 mm^1.5", Dimension::length).find("digits instead of a unit"), std::string::npos);
  EXPECT_NE(error_of("1 (10 mm)", Dimension::length).find("digits instead of a unit"), std::string::npos);
  EXPECT_NE(error_of("31,8 um", Dimension::length).find("decimal point"), std::string::npos);
  EXPECT_NE(error_of("mm^3.5", Dimension::length).find("does not start with a number"), std::string::npos);
}

TEST(ParseQuantity, TakesPlainMultiplesOnly) {
  EXPECT_NE(error_of("3 m from 5", Dimension::length), "");
  EXPECT_NE(error_of("3 m @ 5", Dimension::length), "");
  EXPECT_NE(error_of("3 lg(re 1 m)", Dimension::length), "");
  EXPECT_NE(error_of("30 %", Dimension::angle), "");
}

TEST(ParseQuantity, StaysFinite) {
  EXPECT_NE(error_of("nan mm", Dimension::length).find("not finite"), std::string::npos);
  EXPECT_NE(error_of("-inf mm", Dimension::length).find("not finite"), std::string::npos);
  EXPECT_NE(error_of("1e400 mm", Dimension::length).find("cannot hold"), std::string::npos);
  EXPECT_NE(error_of("1e305 Gm", Dimension::length).find("not finite"), std::string::npos);
}

TEST(ParseQuantity, SurvivesHostileTexts) {
  EXPECT_NE(error_of("", Dimension::length).find("is empty"), std::string::npos);
  EXPECT_NE(error_of("   ", Dimension::length).find("is empty"), std::string::npos);
  EXPECT_NE(error_of("1 " + std::string(100000, '('), Dimension::length).find("not a quantity"), std::string::npos);
  EXPECT_NE(error_of("1 " + std::string(50, '('), Dimension::length).find("unknown unit"), std::string::npos);
  EXPECT_NE(error_of(std::string("1 mm\0 N", 7), Dimension::length).find("not a quantity"), std::string::npos);
  EXPECT_NE(error_of("1 mm\x1b[2J", Dimension::length).find("not a quantity"), std::string::npos);
  EXPECT_NE(error_of("1 m^99999999999999999999", Dimension::length), "");
  EXPECT_NE(error_of("1 \xff\xfe", Dimension::length), "");
}

TEST(ParseQuantity, PrintsNothing) {
  ::testing::internal::CaptureStderr();
  error_of("3 parsnips", Dimension::length);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Dimension, TextsBelongToTheirDimension) {
  for (const Dimension dimension :
       {Dimension::length, Dimension::angle, Dimension::force, Dimension::stiffness, Dimension::pressure,
        Dimension::frequency, Dimension::temperature, Dimension::viscosity, Dimension::foundation_modulus,
        Dimension::mass, Dimension::moment_of_inertia, Dimension::acceleration, Dimension::density,
        Dimension::unbalance, Dimension::velocity, Dimension::duration}) {
    std::string example(example_quantity(dimension));
    example = example.substr(1, example.size() - 2);  // without its quotes
    EXPECT_TRUE(std::isfinite(value_of(example, dimension)));
    EXPECT_EQ(value_of("1 " + std::string(si_unit(dimension)), dimension), 1.0);
    EXPECT_NE(name_of(dimension).find(' '), std::string::npos);
  }
}

}  // namespace
}  // namespace bumpfoil
