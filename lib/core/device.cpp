// SPDX-License-Identifier: BSD-3-Clause
#include "core/device.hpp"

#include <dlfcn.h>

#include <array>
#include <new>

#include "core/error.hpp"

namespace hfrac {
namespace {

constexpr const char* library_name = "libhfrac_gpu.so.0";
constexpr std::int32_t out_of_memory = 2;  // of the driver (CUDA_ERROR_OUT_OF_MEMORY)

struct Library {
  void* handle = nullptr;
  const DeviceDriver* driver = nullptr;
  std::string why_not;
};

std::string words(const DeviceDriver& driver, std::int32_t status) {
  std::array<char, 256> text{};
  driver.describe(status, text.data(), static_cast<std::int32_t>(text.size()));
  return text.data();
}

Library load() {
  Library found;
  Dl_info here{};
  if (dladdr(reinterpret_cast<const void*>(&list_devices), &here) != 0 && here.dli_fname != nullptr) {
    const std::string path = here.dli_fname;
    if (const auto end = path.find_last_of('/'); end != std::string::npos)
      found.handle = dlopen((path.substr(0, end + 1) + library_name).c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (found.handle == nullptr) found.handle = dlopen(library_name, RTLD_NOW | RTLD_LOCAL);
  if (found.handle == nullptr) {
    found.why_not = std::string(library_name) +
                    " is neither beside this library nor where the system looks for libraries; build with "
                    "HFRAC_GPU=ON";
    return found;
  }
  using Give = const DeviceDriver* (*)();
  const auto give = reinterpret_cast<Give>(dlsym(found.handle, "hfrac_device_driver"));
  const DeviceDriver* driver = give != nullptr ? give() : nullptr;
  if (driver == nullptr || driver->version != device_driver_version)
    found.why_not = std::string(library_name) + " is of another version of hfrac";
  else
    found.driver = driver;
  return found;
}

void unload(const Library& library) {
  if (library.handle != nullptr) dlclose(library.handle);
}

DeviceList list_of(const Library& library) {
  DeviceList list;
  list.why_none = library.why_not;
  if (library.driver == nullptr) return list;
  std::int32_t count = 0;
  if (const auto status = library.driver->count(&count); status != 0) {
    list.why_none = words(*library.driver, status);
    return list;
  }
  if (count == 0) list.why_none = "the driver finds no device";
  for (std::int32_t k = 0; k < count; ++k) {
    std::array<char, 256> name{};
    std::int64_t memory = 0;
    library.driver->name(k, name.data(), static_cast<std::int32_t>(name.size()), &memory);
    list.devices.push_back({name.data(), memory});
  }
  return list;
}

}  // namespace

DeviceList list_devices() {
  const Library library = load();
  DeviceList list = list_of(library);
  unload(library);
  return list;
}

std::unique_ptr<Device> Device::open_first(std::string& why_none) {
  const Library library = load();
  const DeviceList list = list_of(library);
  if (list.devices.empty()) {
    why_none = list.why_none;
    unload(library);
    return nullptr;
  }
  std::unique_ptr<Device> device(new Device);
  device->library_ = library.handle;
  device->driver_ = library.driver;
  device->name_ = list.devices[0].name;
  if (const auto status = library.driver->open(0, &device->opened_); status != 0) {
    why_none = device->name_ + ": " + words(*library.driver, status);
    return nullptr;
  }
  return device;
}

Device::~Device() {
  if (opened_ != nullptr) driver_->close(opened_);
  if (library_ != nullptr) dlclose(library_);
}

void Device::check(std::int32_t status, const char* what) const {
  if (status == 0) return;
  throw Error(
      ErrorKind::device,
      "the device (" + name_ + ") failed at " + what + ": " + words(*driver_, status) +
          "; the state before the step stands if the device can still be read, else the last one saved. "
          "Set run.device to \"cpu\" to go on.");
}

void* Device::allocate(std::size_t bytes) const {
  void* address = nullptr;
  const auto status = driver_->allocate(opened_, static_cast<std::int64_t>(bytes), &address);
  if (status == out_of_memory) throw std::bad_alloc();
  check(status, "asking for memory");
  return address;
}

void Device::release(void* address) const noexcept {
  if (address != nullptr) driver_->release(opened_, address);
}

void Device::upload(void* to, const void* from, std::size_t bytes) const {
  check(driver_->upload(opened_, to, from, static_cast<std::int64_t>(bytes)), "copying to it");
}

void Device::download(void* to, const void* from, std::size_t bytes) const {
  check(driver_->download(opened_, to, from, static_cast<std::int64_t>(bytes)), "copying from it");
}

void Device::copy(void* to, const void* from, std::size_t bytes, int times) const {
  for (int k = 0; k < times; ++k)
    check(driver_->copy(opened_, to, from, static_cast<std::int64_t>(bytes)), "copying within it");
  char last = 0;
  download(&last, to, 1);  // waits for all before
}

void Device::launch(std::int32_t kernel, std::int64_t blocks, std::int64_t shared_bytes, const void* task,
                    std::size_t task_bytes) const {
  if (blocks <= 0) return;
  check(driver_->launch(opened_, kernel, blocks, shared_bytes, task, static_cast<std::int64_t>(task_bytes)),
        "starting a kernel");
}

}  // namespace hfrac
