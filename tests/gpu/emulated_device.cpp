// SPDX-License-Identifier: BSD-3-Clause
// A device without a card: the kernels of lib/gpu compiled for the processor, under the name under which libhfrac looks for libhfrac_gpu.
//
// Blocks run one after the other and the threads of a loop likewise, both in an order drawn anew each time: a loop in which one thread needs
// what another one does, or a launch in which one block does, gives other bits sooner or later. A block's own memory begins
// as not-a-number.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <numeric>
#include <random>
#include <vector>

#define HFRAC_KERNEL_NAMESPACE kernels_emulated
#include "core/device.hpp"
#include "gpu/device_kernels.hpp"

namespace hfrac {
namespace {

struct Emulated {
  std::mt19937_64 random{20261125};
  std::vector<std::int64_t> order, blocks;
  std::vector<double> shared;
};

void shuffle(std::vector<std::int64_t>& order, std::int64_t n, std::mt19937_64& random) {
  order.resize(static_cast<std::size_t>(n < 0 ? 0 : n));
  std::iota(order.begin(), order.end(), std::int64_t{0});
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random() % k]);
}

struct HostBlock {
  std::int64_t number;
  double* shared;
  Emulated* device;
  template <class Item>
  void each(std::int64_t n, const Item& item) const {
    shuffle(device->order, n, device->random);
    for (const auto k : device->order) item(k);
  }
};

#define HFRAC_DEVICE_KERNEL(name) kernels_emulated::name<HostBlock>,
void (*const kernels[])(HostBlock&, const DeviceTask&) = {
#include "gpu/device_kernel_list.inc"
};

std::int32_t count(std::int32_t* devices) {
  *devices = 1;
  return 0;
}

std::int32_t name(std::int32_t /*device*/, char* text, std::int32_t size, std::int64_t* memory_bytes) {
  std::snprintf(text, static_cast<std::size_t>(size), "emulated device");
  *memory_bytes = 0;
  return 0;
}

std::int32_t open(std::int32_t /*device*/, void** opened) {
  *opened = new (std::nothrow) Emulated;
  return *opened != nullptr ? 0 : 2;
}

void close(void* opened) {
  delete static_cast<Emulated*>(opened);
}

std::int32_t allocate(void* /*opened*/, std::int64_t bytes, void** address) {
  *address = std::aligned_alloc(64, (static_cast<std::size_t>(bytes) + 127) / 64 * 64);
  return *address != nullptr ? 0 : 2;
}

void release(void* /*opened*/, void* address) {
  std::free(address);
}

std::int32_t copy(void* /*opened*/, void* to, const void* from, std::int64_t bytes) {
  std::memcpy(to, from, static_cast<std::size_t>(bytes));
  return 0;
}

std::int32_t launch(void* opened, std::int32_t kernel, std::int64_t blocks, std::int64_t shared_bytes,
                    const void* task, std::int64_t /*task_bytes*/) {
  Emulated& device = *static_cast<Emulated*>(opened);
  DeviceTask copied;
  std::memcpy(&copied, task, sizeof copied);
  shuffle(device.blocks, blocks, device.random);
  for (const auto number : device.blocks) {
    device.shared.assign(static_cast<std::size_t>(shared_bytes) / sizeof(double),
                         std::numeric_limits<double>::quiet_NaN());
    HostBlock block{number, device.shared.data(), &device};
    kernels[kernel](block, copied);
  }
  return 0;
}

void describe(std::int32_t status, char* text, std::int32_t size) {
  std::snprintf(text, static_cast<std::size_t>(size), "emulated error (%d)", status);
}

}  // namespace
}  // namespace hfrac

extern "C" __attribute__((visibility("default"))) const hfrac::DeviceDriver* hfrac_device_driver(void) {
  using namespace hfrac;
  static const DeviceDriver driver = {
      device_driver_version, count, name, open, close, allocate, release, copy, copy, copy, launch, describe};
  return &driver;
}
