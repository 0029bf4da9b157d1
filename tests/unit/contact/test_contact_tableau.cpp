#include "contact/contact_tableau.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "bumpfoil/core/vector_instructions.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// What the linear system says of where modes lead to from a state, by rates.
ContactState led_by_solves(ModeSystem& system, const LoadingPath& path, const ContactState& begin, double part) {
  const ContactLoading rate{path.end.initial_gap - path.begin.initial_gap, path.end.load - path.begin.load};
  ContactState led;
  system.solve(rate, Vector::Zero(begin.x.size()), led);
  for (Vector ContactState::*field :
       {&ContactState::x, &ContactState::gap, &ContactState::normal_force, &ContactState::friction_force}) {
    led.*field = begin.*field + part * (led.*field);
  }
  return led;
}

/// What the rates of the tableau say of it; of x the tangential unknowns.
ContactState led_by_rates(const ContactProblem& problem, ContactTableau& tableau, const ContactState& begin,
                          const std::vector<ContactMode>& mode, double part) {
  StraightPiece piece(problem);
  piece.begin = begin;
  piece.set_modes(mode);
  piece.lead(tableau.rates(), part);
  return piece.target;
}

/// With full stick only round-off remains: displacements are 1e-5 m, forces tens of N.
void expect_near(const Vector& found, const Vector& expected, double tolerance, std::uint64_t seed) {
  const double size = std::max(expected.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), tolerance * size) << seed;
}

/// A linear system whose displacements are off by a part of them after the first solve, as if digits had been lost.
class DriftingSystem : public ModeSystem {
 public:
  DriftingSystem(const ContactProblem& problem, double part) : system_(make_mode_system(problem)), part_(part) {}
  void set_elasticity(const BlockTridiagonal& K) override { system_->set_elasticity(K); }
  bool set_modes(const std::vector<ContactMode>& mode) override { return system_->set_modes(mode); }
  [[nodiscard]] int factorisations() const override { return system_->factorisations(); }
  void solve(const ContactLoading& loading, const Vector& previous_x, ContactState& state) override {
    system_->solve(loading, previous_x, state);
    if (++solves > 1) {
      state.x *= 1.0 + part_;
      state.gap *= 1.0 + part_;
    }
  }
  void solve_units(RowMajorMatrix& x, RowMajorMatrix& force) override {
    ++built;
    system_->solve_units(x, force);
  }
  void loading_of(const ContactState& state, ContactLoading& loading) override { system_->loading_of(state, loading); }

  int solves{};
  int built{};  ///< matrices of a tableau

 private:
  std::unique_ptr<ModeSystem> system_;
  double part_;
};

/// Sequences of random modes, more than are collected before an update: with and without friction, a few contacts at
/// once and all of them, every possible change.
TEST(ContactTableau, LeadsWhereTheLinearSystemDoes) {
  constexpr int blocks = 7;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto make = seed % 4 == 3 ? make_irregular_problem : make_random_problem;
    const RandomProblem random = make(seed, blocks, 6, seed % 3 == 0 ? 0.0 : 0.3);
    const LoadingPath path{random.first, random.second};
    const std::shared_ptr<ModeSystem> system = make_mode_system(random.problem);
    ContactTableau tableau(random.problem, make_mode_system(random.problem));
    tableau.set_path(path);
    std::vector<ContactMode> mode = random_modes(seed, random.problem);
    for (std::uint64_t change = 0; change < 40; ++change) {
      const std::vector<ContactMode> others = random_modes(100 * seed + change, random.problem);
      for (std::size_t c = change % 5; c < mode.size(); c += change % 7 == 0 ? 1 : 5) mode[c] = others[c];
      ASSERT_TRUE(system->set_modes(mode));
      // A state that obeys the modes.
      ContactState begin;
      system->solve(random.first, Vector::Zero(random.problem.K.rows()), begin);
      ASSERT_TRUE(tableau.set_modes(mode)) << seed << ' ' << change;
      const ContactState led = led_by_rates(random.problem, tableau, begin, mode, 0.7);
      const ContactState expected = led_by_solves(*system, path, begin, 0.7);
      // Of one exchange after the other; condition numbers are some 1e3.
      if (seed % 3 != 0) {  // with friction
        expect_near(tangential_displacements(random.problem, led.x),
                    tangential_displacements(random.problem, expected.x), 1e-10, seed);
      }
      expect_near(led.gap, expected.gap, 1e-10, seed);
      expect_near(led.normal_force, expected.normal_force, 1e-10, seed);
      EXPECT_LT((led.friction_force - expected.friction_force).cwiseAbs().maxCoeff(),
                1e-10 * expected.normal_force.cwiseAbs().maxCoeff());
    }
  }
}

/// Its rates are compared with those of the linear system after 128 exchanges: with deviations of a thousandth of the
/// tolerance, and a thousand times as much.
TEST(ContactTableau, IsBuiltAnewWhereDisplacementsHaveDrifted) {
  const RandomProblem random = make_random_problem(3, 7, 6, 0.3);
  const auto system_after_changes = [&](double part) {
    auto system = std::make_shared<DriftingSystem>(random.problem, part);
    ContactTableau tableau(random.problem, system);
    tableau.set_path({random.first, random.second});
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      EXPECT_TRUE(tableau.set_modes(random_modes(seed, random.problem))) << seed;
    }
    return system;
  };
  const auto close = system_after_changes(1e-12);
  EXPECT_EQ(close->built, 1);
  EXPECT_GT(close->solves, 1);
  EXPECT_LE(close->solves, 1 + 40 * 35 / 128);  // one exchange of 7 contacts, two of 14
  EXPECT_GT(system_after_changes(1e-6)->built, 1);
}

/// Modes are kept, and another path has other rates.
TEST(ContactTableau, TakesAnotherPath) {
  const RandomProblem random = make_random_problem(3, 5, 6, 0.3);
  const std::vector<ContactMode> mode = random_modes(3, random.problem);
  const std::shared_ptr<ModeSystem> system = make_mode_system(random.problem);
  ASSERT_TRUE(system->set_modes(mode));
  ContactState begin;
  system->solve(random.first, Vector::Zero(random.problem.K.rows()), begin);
  ContactTableau tableau(random.problem, make_mode_system(random.problem));
  for (const LoadingPath& path : {LoadingPath{random.first, random.second}, LoadingPath{random.second, random.first}}) {
    tableau.set_path(path);
    ASSERT_TRUE(tableau.set_modes(mode));
    const ContactState led = led_by_rates(random.problem, tableau, begin, mode, 1.0);
    const ContactState expected = led_by_solves(*system, path, begin, 1.0);
    expect_near(led.gap, expected.gap, 1e-12, 0);
    expect_near(led.normal_force, expected.normal_force, 1e-12, 0);
  }
}

/// A block held along the floor by friction only.
TEST(ContactTableau, RefusesModesThatLeaveAMechanism) {
  ContactProblem problem = toy::dragged_block();
  problem.K = BlockTridiagonal(1, 2);
  problem.K.add(0, 1, 0, 1, 1e6);
  ContactTableau tableau(problem, make_mode_system(problem));
  tableau.set_path({toy::pull(0.0, 1.0), toy::pull(0.0, 2.0)});
  ASSERT_TRUE(tableau.set_modes({ContactMode::stick}));
  EXPECT_FALSE(tableau.set_modes({ContactMode::slip_forward}));
  EXPECT_TRUE(tableau.set_modes({ContactMode::stick}));
}

/// Ensembles require bit-identical results, independent of previous ones.
TEST(ContactTableau, ForgetsToTheLastBit) {
  const RandomProblem random = make_random_problem(4, 5, 6, 0.3);
  const auto rates_after_all = [&](ContactTableau& tableau) {
    tableau.set_path({random.first, random.second});
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      EXPECT_TRUE(tableau.set_modes(random_modes(seed, random.problem)));
    }
    return tableau.rates();
  };
  ContactTableau used(random.problem, make_mode_system(random.problem));
  EXPECT_TRUE(used.set_modes(random_modes(77, random.problem)));
  const ContactRates before = rates_after_all(used);
  used.forget();
  ContactTableau fresh(random.problem, make_mode_system(random.problem));
  const ContactRates expected = rates_after_all(fresh);
  EXPECT_NE(before.normal, expected.normal);  // different round-off: otherwise this test could not fail
  const ContactRates after = rates_after_all(used);
  EXPECT_EQ(after.normal, expected.normal);
  EXPECT_EQ(after.tangential, expected.tangential);
}

TEST(ContactTableau, PaysForShortFoilsWhereVectorsAreWide) {
  const bool wide = vector_instructions().size() > 1;
  EXPECT_EQ(ContactTableau::pays(make_random_problem(0, 40, 6, 0.3).problem), wide);  // 200 coordinates
  EXPECT_FALSE(ContactTableau::pays(make_random_problem(0, 41, 6, 0.3).problem));
}

}  // namespace
}  // namespace bumpfoil
