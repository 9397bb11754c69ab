// SPDX-License-Identifier: BSD-3-Clause
#include "command/team.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "command/exit_code.hpp"
#include "command/interrupt.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {

// Open MPI's variable, that of MPICH and Slurm.
int processes_started() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* value = std::getenv(name);
    if (value != nullptr) return std::atoi(value);
  }
  return 1;
}

void add_one_model(CLI::App& command, bool& one_model) {
  command.add_flag("--one-model", one_model,
                   "Under mpirun: one model for all processes of a machine, with a worker for each; it takes "
                   "the memory of one process");
}

namespace {

template <class Function>
Function function_of(void* library, const char* name) {
  return reinterpret_cast<Function>(dlsym(library, name));
}

void* load(const char* name, const std::string& who, const char* package) {
  void* library = dlopen(name, RTLD_NOW | RTLD_GLOBAL);
  if (library != nullptr) return library;
  throw BadInput(fmt::format("{} needs {}, which is not there ({}); build hfrac where {} is installed", who,
                             name, dlerror(), package));
}

constexpr const char* kMpiLibrary = "libhfrac_mpi.so.0";
constexpr const char* kPetscLibrary = "libhfrac_petsc.so.0";

bool asks_for_petsc(const hfrac_sim_def& definition) {
  for (const char* key : {"flow.solver", "solver.factor"}) {
    char word[32] = "";
    int32_t length = 0;
    if (hfrac_sim_def_get_str(&definition, key, word, sizeof word, &length) == HFRAC_OK &&
        std::string_view(word) == "petsc")
      return true;
  }
  return false;
}

}  // namespace

Team::Team(bool one_model) {
  run::require(hfrac_exchange_init(&exchange_, sizeof exchange_), nullptr);
  const int processes = processes_started();
  if (processes <= 1) return;
  void* library = load(kMpiLibrary, fmt::format("a run of {} processes started together", processes),
                       "MPI (libopenmpi-dev)");
  int32_t status = HFRAC_ERR_EXCHANGE;
  if (one_model) {
    const auto begin =
        function_of<int32_t (*)(hfrac_exchange*, int32_t*)>(library, "hfrac_mpi_begin_on_machines");
    if (begin != nullptr) status = begin(&exchange_, &processes_here_);
    end_ = function_of<int32_t (*)(int32_t)>(library, "hfrac_mpi_end");
  } else {
    status = join(exchange_);
  }
  if (status != HFRAC_OK)
    throw BadInput(
        fmt::format("{} processes were started together, but MPI could not be begun; is {} of the MPI that "
                    "started them?",
                    processes, kMpiLibrary));
}

int32_t Team::join(hfrac_exchange& exchange) const {
  void* library = load(kMpiLibrary, "MPI", "MPI (libopenmpi-dev)");
  const auto begin = function_of<int32_t (*)(hfrac_exchange*)>(library, "hfrac_mpi_begin");
  const auto end = function_of<int32_t (*)(int32_t)>(library, "hfrac_mpi_end");
  const int32_t status = begin != nullptr && end != nullptr ? begin(&exchange) : HFRAC_ERR_EXCHANGE;
  if (status == HFRAC_OK) end_ = end;
  return status;
}

int32_t Team::create(const hfrac_sim_def& definition, hfrac_sim** sim) const {
  if (!asks_for_petsc(definition)) return hfrac_sim_create_on(&definition, &exchange_, sim);
  if (processes_here_ > 1)
    throw BadInput(
        "--one-model leaves one process of a machine at work, and \"petsc\" shares work among "
        "processes; leave either out");
  void* library = load(kPetscLibrary, "\"petsc\" as a solver", "PETSc (petsc-dev)");
  hfrac_exchange exchange = exchange_;
  if (end_ == nullptr) run::require(join(exchange), nullptr);
  const auto begin = function_of<int32_t (*)(hfrac_linear_solver*)>(library, "hfrac_petsc_begin");
  hfrac_linear_solver solver{};
  if (begin == nullptr || begin(&solver) != HFRAC_OK)
    throw BadInput(
        fmt::format("PETSc could not be begun; is {} of the MPI that hfrac was built with?", kPetscLibrary));
  exchange.linear_solver = &solver;
  return hfrac_sim_create_on(&definition, &exchange, sim);
}

Team::~Team() {
  if (end_ != nullptr) end_(1);
}

ExitCode Team::rest() {
  catch_interrupts();
  const auto end = end_;
  end_ = nullptr;
  return end(0) == HFRAC_OK ? kGood : kRunFailed;
}

void Team::done() {
  if (end_ != nullptr) end_(0);
  end_ = nullptr;
}

output::Writers Team::writers() const {
  return {exchange_.rank, exchange_.size, [this](int64_t number) {
            if (exchange_.sum(exchange_.user, &number, 1) != 0)
              throw std::runtime_error("another process of this run has failed");
            return number;
          }};
}

std::string Team::share(std::string bytes) const {
  if (alone()) return bytes;
  auto size = static_cast<int64_t>(follows() ? 0 : bytes.size());
  int32_t status = exchange_.sum(exchange_.user, &size, 1);
  bytes.resize(static_cast<std::size_t>(size));
  std::vector<int64_t> begin(static_cast<std::size_t>(exchange_.size) + 1, size);
  begin[0] = 0;  // all of it is the first one's
  if (status == 0) status = exchange_.gather(exchange_.user, bytes.data(), begin.data());
  if (status != 0) throw std::runtime_error("another process of this run has failed");
  return bytes;
}

}  // namespace hfrac::command
