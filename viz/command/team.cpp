// SPDX-License-Identifier: BSD-3-Clause
#include "command/team.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/exit_code.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {
namespace {

/** As launchers tell the processes they start: Open MPI, MPICH and Slurm, in this order. */
int processes_started() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* value = std::getenv(name);
    if (value != nullptr) return std::atoi(value);
  }
  return 1;
}

constexpr const char* kLibrary = "libhfrac_mpi.so.0";

template <class Function>
Function function_of(void* library, const char* name) {
  return reinterpret_cast<Function>(dlsym(library, name));
}

}  // namespace

Team::Team() {
  run::require(hfrac_exchange_init(&exchange_, sizeof exchange_), nullptr);
  const int processes = processes_started();
  if (processes <= 1) return;
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr)
    throw BadInput(
        fmt::format("{} processes were started together, but {} is not there ({}); build hfrac where MPI is "
                    "installed (libopenmpi-dev), or start one process",
                    processes, kLibrary, dlerror()));
  const auto begin = function_of<int32_t (*)(hfrac_exchange*)>(library, "hfrac_mpi_begin");
  const auto end = function_of<int32_t (*)(int32_t)>(library, "hfrac_mpi_end");
  if (begin == nullptr || end == nullptr || begin(&exchange_) != HFRAC_OK)
    throw BadInput(
        fmt::format("{} processes were started together, but MPI could not be begun; is {} of the MPI that "
                    "started them?",
                    processes, kLibrary));
  end_ = end;
}

Team::~Team() {
  if (end_ != nullptr) end_(1);
}

void Team::done() {
  if (end_ != nullptr) end_(0);
  end_ = nullptr;
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
