// SPDX-License-Identifier: BSD-3-Clause
// libhfrac_gpu: cards of NVIDIA's by way of the driver alone (CUDA driver API 11, found with dlopen), with the kernels as PTX text within.
//
// Nothing of CUDA is needed to build this or to load it. The host's own use of a card is not disturbed: the context is the card's
// primary one, current only while a call lasts, on a stream of our own.
#include <dlfcn.h>

#include <array>
#include <bit>
#include <cstdio>
#include <cstring>
#include <new>

#include "core/device.hpp"
#include "linear/multigrid_task.hpp"
#include "solid/device_arrays.hpp"

// The kernels, as clang made them (lib/gpu/CMakeLists.txt); the text ends with a zero.
__asm__(
    ".section .rodata\n"
    ".global hfrac_kernels_ptx\n"
    ".hidden hfrac_kernels_ptx\n"
    "hfrac_kernels_ptx:\n"
    ".incbin \"" HFRAC_PTX_FILE
    "\"\n"
    ".byte 0\n"
    ".previous\n");
extern "C" const char hfrac_kernels_ptx[];

namespace hfrac {
namespace {

// Statuses beyond the driver's own.
enum Status : std::int32_t {
  good = 0,
  no_memory = 2,
  no_driver = 100001,
  old_driver = 100002,
  wrong_task = 100003
};

struct KernelEntry {
  const char* name;
  std::size_t task_bytes;
  unsigned threads;  // of a block
};
constexpr std::int64_t shared_bytes_of(std::int32_t kernel) {
  return kernel < device_smooth_forward ? device_shared_bytes(kernel, most_tile_bonds, 2 * tile_size)
                                        : grid_shared_bytes;
}
#define HFRAC_DEVICE_KERNEL(name, Task, threads, blocks) KernelEntry{#name, sizeof(Task), threads},
constexpr std::array known_kernels = {
#include "gpu/device_kernel_list.inc"
};
#undef HFRAC_DEVICE_KERNEL
static_assert(known_kernels.size() == static_cast<std::size_t>(device_kernel_count));

// The functions of libcuda.so.1 that are called, by their names there, with the types of the driver API's documentation: results and
// devices are int, contexts, modules, functions and streams pointers, addresses 64-bit numbers.
struct Cuda {
  int (*Init)(unsigned);
  int (*DeviceGetCount)(int*);
  int (*DeviceGet)(int*, int);
  int (*DeviceGetName)(char*, int, int);
  int (*DeviceTotalMem_v2)(std::size_t*, int);
  int (*DevicePrimaryCtxRetain)(void**, int);
  int (*DevicePrimaryCtxRelease_v2)(int);
  int (*CtxPushCurrent_v2)(void*);
  int (*CtxPopCurrent_v2)(void**);
  int (*ModuleLoadData)(void**, const void*);
  int (*ModuleUnload)(void*);
  int (*ModuleGetFunction)(void**, void*, const char*);
  int (*FuncSetAttribute)(void*, int, int);
  int (*MemAlloc_v2)(std::uint64_t*, std::size_t);
  int (*MemFree_v2)(std::uint64_t);
  int (*MemcpyHtoDAsync_v2)(std::uint64_t, const void*, std::size_t, void*);
  int (*MemcpyDtoHAsync_v2)(void*, std::uint64_t, std::size_t, void*);
  int (*MemcpyDtoDAsync_v2)(std::uint64_t, std::uint64_t, std::size_t, void*);
  int (*LaunchKernel)(void*, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, void*,
                      void**, void**);
  int (*StreamCreate)(void**, unsigned);
  int (*StreamSynchronize)(void*);
  int (*StreamDestroy_v2)(void*);
  int (*GetErrorString)(int, const char**);
};

struct Loaded {
  Cuda cuda{};
  std::int32_t status = no_driver;
};

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

Loaded load() {
  Loaded l;
  void* library =
      dlopen("libcuda.so.1", RTLD_NOW | RTLD_LOCAL);  // stays: the driver does not like to be unloaded
  if (library == nullptr) return l;
  Cuda& c = l.cuda;
  const bool all =
      find(library, "cuInit", c.Init) && find(library, "cuDeviceGetCount", c.DeviceGetCount) &&
      find(library, "cuDeviceGet", c.DeviceGet) && find(library, "cuDeviceGetName", c.DeviceGetName) &&
      find(library, "cuDeviceTotalMem_v2", c.DeviceTotalMem_v2) &&
      find(library, "cuDevicePrimaryCtxRetain", c.DevicePrimaryCtxRetain) &&
      find(library, "cuDevicePrimaryCtxRelease_v2", c.DevicePrimaryCtxRelease_v2) &&
      find(library, "cuCtxPushCurrent_v2", c.CtxPushCurrent_v2) &&
      find(library, "cuCtxPopCurrent_v2", c.CtxPopCurrent_v2) &&
      find(library, "cuModuleLoadData", c.ModuleLoadData) &&
      find(library, "cuModuleUnload", c.ModuleUnload) &&
      find(library, "cuModuleGetFunction", c.ModuleGetFunction) &&
      find(library, "cuFuncSetAttribute", c.FuncSetAttribute) &&
      find(library, "cuMemAlloc_v2", c.MemAlloc_v2) && find(library, "cuMemFree_v2", c.MemFree_v2) &&
      find(library, "cuMemcpyHtoDAsync_v2", c.MemcpyHtoDAsync_v2) &&
      find(library, "cuMemcpyDtoHAsync_v2", c.MemcpyDtoHAsync_v2) &&
      find(library, "cuMemcpyDtoDAsync_v2", c.MemcpyDtoDAsync_v2) &&
      find(library, "cuLaunchKernel", c.LaunchKernel) && find(library, "cuStreamCreate", c.StreamCreate) &&
      find(library, "cuStreamSynchronize", c.StreamSynchronize) &&
      find(library, "cuStreamDestroy_v2", c.StreamDestroy_v2) &&
      find(library, "cuGetErrorString", c.GetErrorString);
  l.status = all ? c.Init(0) : static_cast<std::int32_t>(old_driver);
  return l;
}

// The driver is the same for the whole process, so it is looked for once.
const Loaded& loaded() {
  static const Loaded once = load();
  return once;
}

struct Card {
  int device = 0;
  void *context = nullptr, *module = nullptr, *stream = nullptr;
  std::array<void*, known_kernels.size()> kernels{};
};

// The card's context, current while this lives.
class Current {
 public:
  explicit Current(const Card& card) : status_(loaded().cuda.CtxPushCurrent_v2(card.context)) {}
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;
  ~Current() {
    void* popped = nullptr;
    if (status_ == 0) loaded().cuda.CtxPopCurrent_v2(&popped);
  }
  [[nodiscard]] int status() const { return status_; }

 private:
  int status_;
};

std::int32_t count(std::int32_t* devices) {
  *devices = 0;
  return loaded().status != 0 ? loaded().status : loaded().cuda.DeviceGetCount(devices);
}

std::int32_t name(std::int32_t device, char* text, std::int32_t size, std::int64_t* memory_bytes) {
  const Cuda& c = loaded().cuda;
  int handle = 0;
  int status = c.DeviceGet(&handle, device);
  if (status == 0) status = c.DeviceGetName(text, size, handle);
  std::size_t bytes = 0;
  if (status == 0) status = c.DeviceTotalMem_v2(&bytes, handle);
  *memory_bytes = static_cast<std::int64_t>(bytes);
  return status;
}

void close(void* opened) {
  Card* card = static_cast<Card*>(opened);
  const Cuda& c = loaded().cuda;
  if (card->context != nullptr) {
    {
      const Current here(*card);
      if (card->stream != nullptr) c.StreamDestroy_v2(card->stream);
      if (card->module != nullptr) c.ModuleUnload(card->module);
    }
    c.DevicePrimaryCtxRelease_v2(card->device);
  }
  delete card;
}

std::int32_t start(Card& card) {
  const Cuda& c = loaded().cuda;
  const Current here(card);
  constexpr unsigned apart_from_the_default_stream = 1;
  int status = here.status();
  if (status == 0) status = c.StreamCreate(&card.stream, apart_from_the_default_stream);
  if (status == 0) status = c.ModuleLoadData(&card.module, hfrac_kernels_ptx);
  for (std::size_t k = 0; status == 0 && k < known_kernels.size(); ++k) {
    status = c.ModuleGetFunction(&card.kernels[k], card.module, known_kernels[k].name);
    constexpr int most_dynamic_shared_bytes = 8;  // CU_FUNC_ATTRIBUTE_MAX_DYNAMIC_SHARED_SIZE_BYTES
    const auto most = shared_bytes_of(static_cast<std::int32_t>(k));
    if (status == 0)
      status = c.FuncSetAttribute(card.kernels[k], most_dynamic_shared_bytes, static_cast<int>(most));
  }
  return status;
}

std::int32_t open(std::int32_t device, void** opened) {
  const Cuda& c = loaded().cuda;
  Card* card = new (std::nothrow) Card;
  if (card == nullptr) return no_memory;
  int status = c.DeviceGet(&card->device, device);
  if (status == 0) status = c.DevicePrimaryCtxRetain(&card->context, card->device);
  if (status == 0) status = start(*card);
  if (status != 0) {
    close(card);
    return status;
  }
  *opened = card;
  return good;
}

std::int32_t allocate(void* opened, std::int64_t bytes, void** address) {
  const Current here(*static_cast<Card*>(opened));
  std::uint64_t at = 0;
  const int status = here.status() != 0
                         ? here.status()
                         : loaded().cuda.MemAlloc_v2(&at, static_cast<std::size_t>(bytes < 1 ? 1 : bytes));
  *address = std::bit_cast<void*>(at);
  return status;
}

void release(void* opened, void* address) {
  const Current here(*static_cast<Card*>(opened));
  if (here.status() == 0) loaded().cuda.MemFree_v2(reinterpret_cast<std::uint64_t>(address));
}

std::int32_t upload(void* opened, void* to, const void* from, std::int64_t bytes) {
  const Card& card = *static_cast<Card*>(opened);
  const Cuda& c = loaded().cuda;
  const Current here(card);
  int status = here.status();
  if (status == 0)
    status = c.MemcpyHtoDAsync_v2(reinterpret_cast<std::uint64_t>(to), from, static_cast<std::size_t>(bytes),
                                  card.stream);
  return status != 0 ? status : c.StreamSynchronize(card.stream);
}

std::int32_t download(void* opened, void* to, const void* from, std::int64_t bytes) {
  const Card& card = *static_cast<Card*>(opened);
  const Cuda& c = loaded().cuda;
  const Current here(card);
  int status = here.status();
  if (status == 0)
    status = c.MemcpyDtoHAsync_v2(to, reinterpret_cast<std::uint64_t>(from), static_cast<std::size_t>(bytes),
                                  card.stream);
  return status != 0 ? status : c.StreamSynchronize(card.stream);
}

std::int32_t copy(void* opened, void* to, const void* from, std::int64_t bytes) {
  const Card& card = *static_cast<Card*>(opened);
  const Current here(card);
  return here.status() != 0 ? here.status()
                            : loaded().cuda.MemcpyDtoDAsync_v2(reinterpret_cast<std::uint64_t>(to),
                                                               reinterpret_cast<std::uint64_t>(from),
                                                               static_cast<std::size_t>(bytes), card.stream);
}

std::int32_t launch(void* opened, std::int32_t kernel, std::int64_t blocks, std::int64_t shared_bytes,
                    const void* task, std::int64_t task_bytes) {
  const Card& card = *static_cast<Card*>(opened);
  if (kernel < 0 || kernel >= device_kernel_count) return wrong_task;
  const KernelEntry& known = known_kernels[static_cast<std::size_t>(kernel)];
  if (static_cast<std::size_t>(task_bytes) != known.task_bytes) return wrong_task;
  const Current here(card);
  if (here.status() != 0) return here.status();
  std::array<void*, 1> arguments = {const_cast<void*>(task)};  // it is only read
  return loaded().cuda.LaunchKernel(
      card.kernels[static_cast<std::size_t>(kernel)], static_cast<unsigned>(blocks), 1, 1, known.threads, 1,
      1, static_cast<unsigned>(shared_bytes), card.stream, arguments.data(), nullptr);
}

void describe(std::int32_t status, char* text, std::int32_t size) {
  const char* words = nullptr;
  if (status == no_driver)
    words = "no driver: libcuda.so.1 cannot be loaded";
  else if (status == old_driver)
    words = "the driver is too old (CUDA 11 is needed)";
  else if (status == wrong_task)
    words = "libhfrac and libhfrac_gpu are not of one build";
  else if (loaded().cuda.GetErrorString != nullptr)
    loaded().cuda.GetErrorString(status, &words);
  std::snprintf(text, static_cast<std::size_t>(size), "%s (%d)", words != nullptr ? words : "unknown error",
                status);
}

}  // namespace
}  // namespace hfrac

extern "C" __attribute__((visibility("default"))) const hfrac::DeviceDriver* hfrac_device_driver(void) {
  using namespace hfrac;
  static const DeviceDriver driver = {device_driver_version,
                                      count,
                                      name,
                                      open,
                                      close,
                                      allocate,
                                      release,
                                      upload,
                                      download,
                                      copy,
                                      launch,
                                      describe};
  return &driver;
}
