// SPDX-License-Identifier: BSD-3-Clause
// A driver without a card: libcuda.so.1 as far as libhfrac_gpu calls it, with the kernels of lib/gpu compiled for the processor.
//
// Blocks run one after the other and the threads of a loop likewise, both in an order drawn anew each time: a loop in which one thread needs
// what another one does, or a launch in which one block does, gives other bits sooner or later. A block's own memory begins
// as not-a-number. What a driver would refuse is refused: no context current, a block with more memory than was asked for, an address that was
// not given out. HFRAC_EMULATED_LAUNCHES = n lets n launches succeed in this process and the next one fail; with
// HFRAC_EMULATED_DEATH nothing succeeds from then on, as after a fault of a real card.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#define HFRAC_KERNEL_NAMESPACE kernels_emulated
#include "gpu/device_gradient_kernels.hpp"
#include "gpu/device_kernels.hpp"

namespace {

using namespace hfrac;

enum Result : int {
  success = 0,
  invalid_value = 1,
  out_of_memory = 2,
  invalid_context = 201,
  not_found = 500,
  launch_failed = 719
};

struct HostBlock {
  static constexpr bool serial = false;
  std::int64_t number;
  double* shared;
  std::mt19937_64* random;
  std::vector<std::int64_t>* order;
  template <class Item>
  void each(std::int64_t n, const Item& item) const;
};

void shuffle(std::vector<std::int64_t>& order, std::int64_t n, std::mt19937_64& random) {
  order.resize(static_cast<std::size_t>(n < 0 ? 0 : n));
  std::iota(order.begin(), order.end(), std::int64_t{0});
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random() % k]);
}

template <class Item>
void HostBlock::each(std::int64_t n, const Item& item) const {
  shuffle(*order, n, *random);
  for (const auto k : *order) item(k);
}

struct Kernel {
  const char* name;
  void (*run)(HostBlock&, const void* task);
  unsigned threads;
  int most_shared;
  long launches;
};

template <class Task, void (*kernel)(HostBlock&, const Task&)>
void run_kernel(HostBlock& block, const void* task) {
  kernel(block, *static_cast<const Task*>(task));
}

#define HFRAC_DEVICE_KERNEL(name, Task, threads, blocks) \
  {#name, run_kernel<Task, kernels_emulated::name<HostBlock>>, threads, 48 * 1024, 0},
Kernel known_kernels[] = {
#include "gpu/device_kernel_list.inc"
};

// The one card. Its memory is the host's, each piece known by where it begins.
struct Card {
  std::mutex mutex;
  std::map<std::uint64_t, std::size_t> memory;
  std::mt19937_64 random{20261125};
  std::vector<std::int64_t> order, blocks;
  std::vector<double> shared;
  long launches = 0;
  bool dead = false;
  long long sent = 0, fetched = 0;  // bytes
};

Card& card() {
  static Card the_card;
  return the_card;
}

int context, module, stream;  // their addresses are the handles
thread_local std::vector<void*> current;

bool is_given_out(std::uint64_t address, std::size_t bytes) {
  const auto& memory = card().memory;
  auto at = memory.upper_bound(address);
  return at != memory.begin() && (--at, address + bytes <= at->first + at->second);
}

int copy(std::uint64_t on_card, void* to, const void* from, std::size_t bytes, long long& counted) {
  const std::lock_guard lock(card().mutex);
  if (current.empty()) return invalid_context;
  if (card().dead) return launch_failed;
  if (!is_given_out(on_card, bytes)) return invalid_value;
  std::memcpy(to, from, bytes);
  counted += static_cast<long long>(bytes);
  return success;
}

bool is_to_fail() {
  const char* limit = std::getenv("HFRAC_EMULATED_LAUNCHES");
  const bool fails = limit != nullptr && card().launches++ == std::atol(limit);
  card().dead = card().dead || (fails && std::getenv("HFRAC_EMULATED_DEATH") != nullptr);
  return fails || card().dead;
}

}  // namespace

#define DRIVER extern "C" __attribute__((visibility("default"))) int

DRIVER cuInit(unsigned /*flags*/) {
  return success;
}
DRIVER cuDeviceGetCount(int* count) {
  *count = 1;
  return success;
}
DRIVER cuDeviceGet(int* device, int ordinal) {
  *device = ordinal;
  return ordinal == 0 ? success : invalid_value;
}
DRIVER cuDeviceGetName(char* name, int size, int /*device*/) {
  const std::string text = "emulated card";
  text.copy(name, static_cast<std::size_t>(size) - 1);
  name[text.size()] = '\0';
  return success;
}
DRIVER cuDeviceTotalMem_v2(std::size_t* bytes, int /*device*/) {
  *bytes = std::size_t{1} << 30U;
  return success;
}
DRIVER cuDevicePrimaryCtxRetain(void** retained, int /*device*/) {
  *retained = &context;
  return success;
}
DRIVER cuDevicePrimaryCtxRelease_v2(int /*device*/) {
  return success;
}
DRIVER cuCtxPushCurrent_v2(void* pushed) {
  current.push_back(pushed);
  return pushed == &context ? success : invalid_context;
}
DRIVER cuCtxPopCurrent_v2(void** popped) {
  if (current.empty()) return invalid_context;
  *popped = current.back();
  current.pop_back();
  return success;
}
DRIVER cuModuleLoadData(void** loaded, const void* image) {
  const std::string ptx = static_cast<const char*>(image);
  for (const auto& kernel : known_kernels)
    if (ptx.find(std::string(".entry ") + kernel.name + "(") == std::string::npos) return not_found;
  *loaded = &module;
  return current.empty() ? invalid_context : success;
}
DRIVER cuModuleUnload(void* unloaded) {
  return unloaded == &module ? success : invalid_value;
}
DRIVER cuModuleGetFunction(void** function, void* /*module*/, const char* name) {
  for (auto& kernel : known_kernels) {
    if (std::strcmp(kernel.name, name) != 0) continue;
    *function = &kernel;
    return success;
  }
  return not_found;
}
DRIVER cuFuncSetAttribute(void* function, int attribute, int value) {
  constexpr int most_dynamic_shared_bytes = 8, most_of_a_block = 163 * 1024;  // of compute capability 8.0
  if (attribute != most_dynamic_shared_bytes || value > most_of_a_block) return invalid_value;
  static_cast<Kernel*>(function)->most_shared = value;
  return success;
}
DRIVER cuMemAlloc_v2(std::uint64_t* address, std::size_t bytes) {
  const std::lock_guard lock(card().mutex);
  if (current.empty()) return invalid_context;
  if (bytes == 0) return invalid_value;
  void* piece = std::aligned_alloc(256, (bytes + 255) / 256 * 256);
  if (piece == nullptr) return out_of_memory;
  *address = reinterpret_cast<std::uint64_t>(piece);
  card().memory[*address] = bytes;
  return success;
}
DRIVER cuMemFree_v2(std::uint64_t address) {
  const std::lock_guard lock(card().mutex);
  if (card().memory.erase(address) == 0) return invalid_value;
  std::free(reinterpret_cast<void*>(address));
  return success;
}
DRIVER cuMemcpyHtoDAsync_v2(std::uint64_t to, const void* from, std::size_t bytes, void* /*stream*/) {
  return copy(to, reinterpret_cast<void*>(to), from, bytes, card().sent);
}
DRIVER cuMemcpyDtoHAsync_v2(void* to, std::uint64_t from, std::size_t bytes, void* /*stream*/) {
  return copy(from, to, reinterpret_cast<const void*>(from), bytes, card().fetched);
}
DRIVER cuMemcpyDtoDAsync_v2(std::uint64_t to, std::uint64_t from, std::size_t bytes, void* /*stream*/) {
  long long within = 0;
  return is_given_out(to, bytes)
             ? copy(from, reinterpret_cast<void*>(to), reinterpret_cast<const void*>(from), bytes, within)
             : static_cast<int>(invalid_value);
}
DRIVER cuLaunchKernel(void* function, unsigned blocks, unsigned, unsigned, unsigned threads, unsigned,
                      unsigned, unsigned shared_bytes, void* /*stream*/, void** arguments, void** /*extra*/) {
  const std::lock_guard lock(card().mutex);
  Kernel& kernel = *static_cast<Kernel*>(function);
  if (current.empty()) return invalid_context;
  if (blocks == 0 || threads != kernel.threads || static_cast<int>(shared_bytes) > kernel.most_shared)
    return invalid_value;
  if (is_to_fail()) return launch_failed;
  ++kernel.launches;
  Card& c = card();
  shuffle(c.blocks, blocks, c.random);
  for (const auto number : c.blocks) {
    c.shared.assign(shared_bytes / sizeof(double), std::numeric_limits<double>::quiet_NaN());
    HostBlock block{number, c.shared.data(), &c.random, &c.order};
    kernel.run(block, arguments[0]);
  }
  return success;
}
DRIVER cuStreamCreate(void** created, unsigned /*flags*/) {
  *created = &stream;
  return success;
}
DRIVER cuStreamSynchronize(void* waited_for) {
  return waited_for == &stream ? success : invalid_value;
}
DRIVER cuStreamDestroy_v2(void* destroyed) {
  return destroyed == &stream ? success : invalid_value;
}
DRIVER cuGetErrorString(int result, const char** text) {
  *text = result == launch_failed ? "unspecified launch failure" : "an error of the emulated driver";
  return success;
}

// For tests, which a real driver does not have: launches of a kernel so far; bytes that went there and that came back.
extern "C" __attribute__((visibility("default"))) long hfrac_emulated_launches(const char* name) {
  for (const auto& kernel : known_kernels)
    if (std::strcmp(kernel.name, name) == 0) return kernel.launches;
  return -1;
}
extern "C" __attribute__((visibility("default"))) void hfrac_emulated_bytes(long long* sent,
                                                                            long long* fetched) {
  *sent = card().sent;
  *fetched = card().fetched;
}
