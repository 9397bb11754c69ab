// SPDX-License-Identifier: BSD-3-Clause
// The balance of energy is the same sum, in the same order, whoever adds it up.
#include "step/ledger.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "small_case.hpp"
#include "solid/bond_law.hpp"

namespace ledger_test {

using namespace testing_unit;

// Of enough bonds that workers share them.
CaseDefinition ledger_case(int workers) {
  CaseDefinition definition = cracking_case();
  definition.options.packing_disc_count = 2500;
  definition.options.stepping_mode = choice(SteppingMode::dynamic);
  definition.options.run_workers = workers;
  return definition;
}

TEST(Ledger, HasTheSameBitsOnAnyNumberOfWorkersAndInAForkedChild) {
  double contacts = 0.0;  // with one worker, who adds them up as he comes to them
  for (const int workers : {1, 2, 3}) {
    Simulation sim(ledger_case(workers), {}, {});
    sim.step();
    const Assembly& a = sim.engine().model.assembly;
    ASSERT_GT(a.bond_count(), 4096);
    double bonds = 0.0;
    for (std::int64_t e = 0; e < a.bond_count(); ++e)
      bonds += view_bond(a, sim.engine().options, e).bond_energy;
    const ElasticEnergy energy = elastic_energy(sim.engine());
    EXPECT_GT(energy.bonds, 0.0);
    EXPECT_EQ(energy.bonds, bonds) << workers;
    if (workers == 1) contacts = energy.contacts;
    EXPECT_GT(contacts, 0.0);
    EXPECT_EQ(energy.contacts, contacts) << workers;
    const ::pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::alarm(60);
      const ElasticEnergy there = elastic_energy(sim.engine());
      ::_exit(there.bonds == energy.bonds && there.contacts == energy.contacts ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0) << workers;
  }
}

}  // namespace ledger_test
