// SPDX-License-Identifier: BSD-3-Clause
// Linear solvers from outside, filled by a host: a dense elimination to which each rank brings its rows. What it solves is what the library
// solves by itself; where it is missing, or fails on one rank, everybody is told.
#include <algorithm>
#include <atomic>
#include <barrier>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim_support.hpp"
#include "thread_exchange.hpp"

namespace linear_solver_test {

using namespace testing_capi;

// L U by rows with exchange of rows.
struct Factor {
  std::size_t n;
  std::vector<double> a;
  std::vector<std::size_t> order;

  double& at(std::size_t row, std::size_t column) { return a[row * n + column]; }
  explicit Factor(std::size_t size) : n(size), a(size * size, 0.0), order(size) {}
  void make() {
    for (std::size_t k = 0; k < n; ++k) order[k] = k;
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t best = k;
      for (std::size_t r = k + 1; r < n; ++r)
        if (std::abs(at(r, k)) > std::abs(at(best, k))) best = r;
      if (best != k) {
        std::swap(order[k], order[best]);
        std::swap_ranges(&at(k, 0), &at(k, 0) + n, &at(best, 0));
      }
      for (std::size_t r = k + 1; r < n; ++r) {
        const double share = at(r, k) /= at(k, k);
        if (share == 0.0) continue;
        for (std::size_t c = k + 1; c < n; ++c) at(r, c) -= share * at(k, c);
      }
    }
  }
  void solve(const double* right, double* x) {
    for (std::size_t r = 0; r < n; ++r) {
      x[r] = right[order[r]];
      for (std::size_t c = 0; c < r; ++c) x[r] -= at(r, c) * x[c];
    }
    for (std::size_t r = n; r-- > 0;) {
      for (std::size_t c = r + 1; c < n; ++c) x[r] -= at(r, c) * x[c];
      x[r] /= at(r, r);
    }
  }
};

// A matrix that all ranks bring together, and its factor, which the first makes.
class Dense {
 public:
  explicit Dense(int32_t ranks) : ranks_(ranks), meet_(ranks) {}
  // From then on, on this rank.
  int32_t fails_on = -1;
  std::atomic<int> solved{0};

  hfrac_linear_solver table(int32_t rank) {
    seats_[rank] = {this, rank};
    hfrac_linear_solver solver;
    EXPECT_EQ(hfrac_linear_solver_init(&solver, sizeof solver), HFRAC_OK);
    solver.user = &seats_[rank];
    solver.prepare = [](void* user, const hfrac_matrix* matrix, void** prepared) {
      const auto& seat = *static_cast<Seat*>(user);
      return seat.dense->prepare(seat.rank, *matrix, *prepared);
    };
    solver.solve = [](void* user, void* prepared, const double* right, double* x, double,
                      int32_t* iterations) {
      *iterations = 1;
      const auto& seat = *static_cast<Seat*>(user);
      return seat.dense->solve(static_cast<Part*>(prepared), right, x);
    };
    solver.release = [](void*, void* prepared) {
      delete static_cast<Part*>(prepared);
      return 0;
    };
    solver.reason = [](void*, char* text, int64_t size) {
      EXPECT_GE(size, 16);
      std::strcpy(text, "out of patience");
      return 0;
    };
    return solver;
  }

 private:
  struct Seat {
    Dense* dense;
    int32_t rank;
  };
  struct Part {
    std::vector<int32_t> row, column;
    std::shared_ptr<Factor> factor;
  };

  int32_t prepare(int32_t rank, const hfrac_matrix& m, void*& prepared) {
    EXPECT_EQ(m.struct_size, static_cast<int32_t>(sizeof m));
    ends_[rank + 1] = m.end_row;  // every row is somebody's
    meet_.arrive_and_wait();
    EXPECT_EQ(m.first_row, ends_[rank]);
    EXPECT_EQ(ends_[ranks_], m.size);
    if (prepared == nullptr) {
      EXPECT_NE(m.row, nullptr);
      prepared = new Part;
    }
    auto& part = *static_cast<Part*>(prepared);
    if (m.row != nullptr) {
      part.row.assign(m.row, m.row + m.count);
      part.column.assign(m.column, m.column + m.count);
    }
    if (rank == 0) whole_ = std::make_shared<Factor>(static_cast<std::size_t>(m.size));
    meet_.arrive_and_wait();
    for (std::size_t k = 0; k < static_cast<std::size_t>(m.count); ++k) {  // rows of its own
      EXPECT_TRUE(part.row[k] >= m.first_row && part.row[k] < m.end_row);
      whole_->at(static_cast<std::size_t>(part.row[k]), static_cast<std::size_t>(part.column[k])) +=
          m.value[k];
    }
    meet_.arrive_and_wait();
    if (rank == 0) {
      for (std::size_t r = 0; m.kind == HFRAC_MATRIX_FLOW && r < whole_->n; ++r)
        for (std::size_t c = 0; c < r; ++c) EXPECT_EQ(whole_->at(r, c), whole_->at(c, r));
      whole_->make();
    }
    meet_.arrive_and_wait();
    part.factor = whole_;
    return rank == fails_on ? 1 : 0;
  }

  int32_t solve(Part* part, const double* right, double* x) {
    ++solved;
    part->factor->solve(right, x);
    return 0;
  }

  int32_t ranks_;
  std::barrier<> meet_;
  std::shared_ptr<Factor> whole_;
  Seat seats_[4];
  int64_t ends_[5] = {};
};

struct End {
  int32_t status = 0;
  std::string error;
  std::vector<int64_t> broken;
  std::vector<double> pressure;
};

End end_of(hfrac_sim* sim, int32_t status) {
  End end{status, last_error(sim), {}, doubles(sim, HFRAC_DOMAIN_PRESSURE)};
  int64_t count = 0, next = 0;
  std::vector<hfrac_crack> cracks(1000);
  EXPECT_EQ(hfrac_cracks_since(sim, 0, sizeof(hfrac_crack), cracks.data(), 1000, &count, &next), HFRAC_OK);
  for (int64_t k = 0; k < count; ++k) end.broken.push_back(cracks[static_cast<std::size_t>(k)].bond);
  return end;
}

std::vector<End> on_ranks(const hfrac::Definition& def, int32_t size, Dense& dense, int64_t steps) {
  Meeting meeting(size);
  std::vector<End> ends(static_cast<std::size_t>(size));
  meeting.run([&](int32_t rank) {
    auto exchange = meeting.exchange(rank);
    const auto solver = dense.table(rank);
    exchange.linear_solver = &solver;
    hfrac_sim* sim = nullptr;
    const int32_t made = hfrac_sim_create_on(&def, &exchange, &sim);
    auto& end = ends[static_cast<std::size_t>(rank)];
    if (made != HFRAC_OK) {
      end = {made, last_error(), {}, {}};
      return;
    }
    end = end_of(sim, hfrac_step(sim, steps));
    hfrac_sim_destroy(&sim);
  });
  return ends;
}

hfrac::Definition quasi_static_def(const char* factor) {
  hfrac::Definition def = cracking_def(150);
  def.solver_kind = 1;
  def.stepping_mode = 2;
  def.stepping_flow_step = 1e-2;
  def.wells[0].pressure = 70e6;
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "solver.factor", factor), HFRAC_OK);
  return def;
}

hfrac::Definition flow_def(const char* solver) {
  hfrac::Definition def = cracking_def(200);
  def.stepping_flow_step = 1e-2;
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "flow.solver", solver), HFRAC_OK);
  return def;
}

TEST(LinearSolver, FactorFromOutsideBreaksTheSameBonds) {
  const hfrac::Definition own = quasi_static_def("own"), outside = quasi_static_def("petsc");
  const Sim sim(own);
  const End alone = end_of(sim, hfrac_step(sim, 2));
  ASSERT_GE(alone.status, 0) << alone.error;
  EXPECT_GE(alone.broken.size(), 1u);
  for (const int32_t size : {1, 2, 3}) {
    Dense dense(size);
    for (const End& end : on_ranks(outside, size, dense, 2)) {
      EXPECT_GE(end.status, 0) << end.error;
      EXPECT_EQ(end.broken, alone.broken) << size << " ranks";
    }
    EXPECT_GE(dense.solved, 1);
  }
}

TEST(LinearSolver, FlowFromOutsideGivesThePressures) {
  const hfrac::Definition own = flow_def("direct"), outside = flow_def("petsc");
  const Sim sim(own);
  const End alone = end_of(sim, hfrac_step(sim, 1));
  ASSERT_GE(alone.status, 0) << alone.error;
  for (const int32_t size : {1, 2, 3}) {
    Dense dense(size);
    for (const End& end : on_ranks(outside, size, dense, 1)) {
      EXPECT_GE(end.status, 0) << end.error;
      ASSERT_EQ(end.pressure.size(), alone.pressure.size());
      for (std::size_t d = 0; d < end.pressure.size(); ++d)
        EXPECT_NEAR(end.pressure[d], alone.pressure[d], 1e-9 * own.wells[0].pressure) << "pore " << d;
    }
    EXPECT_GE(dense.solved, 1);
  }
}

TEST(LinearSolver, FailureOnOneRankIsToldToAll) {
  for (const auto& def : {flow_def("petsc"), quasi_static_def("petsc")}) {
    Dense dense(3);
    dense.fails_on = 1;
    for (const End& end : on_ranks(def, 3, dense, 1)) {
      EXPECT_LT(end.status, 0);
      EXPECT_NE(end.error.find("out of patience"), std::string::npos) << end.error;
    }
  }
}

TEST(LinearSolver, MissingIsRefused) {
  hfrac_sim* sim = nullptr;
  for (const auto& def : {flow_def("petsc"), quasi_static_def("petsc")}) {
    EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_MODEL);
    EXPECT_NE(last_error().find("petsc-dev"), std::string::npos) << last_error();
    EXPECT_NE(last_error().find("mpirun"), std::string::npos) << last_error();
  }
  hfrac::Definition def = cracking_def(200);
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "solver.factor", "petsc"), HFRAC_OK);
  EXPECT_LT(hfrac_sim_create(&def, &sim), 0);
  EXPECT_NE(last_error().find("quasi-static"), std::string::npos) << last_error();
  Meeting meeting(1);
  Dense dense(1);
  auto exchange = meeting.exchange(0);
  auto solver = dense.table(0);
  solver.solve = nullptr;
  exchange.linear_solver = &solver;
  const auto flow = flow_def("petsc");
  EXPECT_EQ(hfrac_sim_create_on(&flow, &exchange, &sim), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error().find("NULL"), std::string::npos) << last_error();
}

}  // namespace linear_solver_test
