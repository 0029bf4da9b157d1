#include "bumpfoil/readers/sampled_case.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "bumpfoil/core/error.hpp"
#include "support/ensemble_files.hpp"

namespace bumpfoil {
namespace {

class SampledCase : public test_support::EnsembleFiles {
 protected:
  [[nodiscard]] std::string refusal(std::size_t number, const Case& input) const {
    try {
      read_sampled_case(netcdf_, number, input, "cycle");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(SampledCase, AStoredSampleIsTheOneThatWasDrawn) {
  EXPECT_EQ(read_sampled_case(netcdf_, 2, input_, "cycle"), sampled_case(input_, draw_sample(input_, 2)));
  Case finer = input_;
  finer.settings.get<CycleSettings>().steps = 400;
  finer.montecarlo.reset();
  EXPECT_EQ(read_sampled_case(netcdf_, 2, finer, "cycle").settings.get<CycleSettings>().steps, 400);
}

TEST_F(SampledCase, AStoredSampleIsRunByTheSolverOfItsEnsemble) {
  const auto solver = [this](std::optional<SolverName> named, std::string_view command) {
    Case input = input_;
    input.solver.name = named;
    return read_sampled_case(netcdf_, 2, input, command).solver.chosen();
  };
  EXPECT_EQ(solver({}, "cycle"), SolverName::events);
  EXPECT_EQ(solver(SolverName::newton, "cycle"), SolverName::newton);
  EXPECT_EQ(solver({}, "equilibrium"), SolverName::newton);  // events cannot solve films
}

TEST_F(SampledCase, ASampleOfADamagedFileIsRefused) {
  // A flipped bit in sampled values: HDF5 reads it without an error.
  std::fstream file(netcdf_, std::ios::binary | std::ios::in | std::ios::out);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const double deviation = draw_sample(input_, 2).height_deviations.front();
  const std::size_t place = bytes.find(std::string_view(reinterpret_cast<const char*>(&deviation), sizeof deviation));
  ASSERT_NE(place, std::string::npos);
  file.clear();
  file.seekp(static_cast<std::streamoff>(place) + 6);
  file.put(static_cast<char>(bytes[place + 6] ^ 1));
  file.close();
  EXPECT_NE(refusal(2, input_).find("is damaged: its checksum is not the one that summary.json lists"),
            std::string::npos)
      << refusal(2, input_);
  std::filesystem::remove(netcdf_.parent_path() / "summary.json");
  EXPECT_NE(refusal(2, input_).find("contains no results: summary.json is missing"), std::string::npos);
}

TEST_F(SampledCase, AnotherBearingIsRefused) {
  EXPECT_NE(refusal(4, input_).find("sample = 4: is not there; give a number below 4"), std::string::npos);
  Case other = input_;
  other.bearing.radial_clearance = 30e-6;
  EXPECT_NE(refusal(0, other).find("bearing.radial_clearance = 3.18e-05: is 3e-05 in this case"), std::string::npos)
      << refusal(0, other);
  folder_.write("results/ensemble.nc", "none");
  EXPECT_NE(refusal(0, input_).find("is damaged: it has 4 bytes, summary.json lists"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
