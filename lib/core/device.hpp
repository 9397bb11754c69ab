// SPDX-License-Identifier: BSD-3-Clause
// A card that computes beside the processor, by way of a library of its own (lib/gpu): this one knows no driver and needs none.
//
// libhfrac_gpu gives a table of functions; it is looked for beside this library, and then where the system looks for libraries, when a
// device is asked for. What is launched runs in the order of launches; what is copied is there when the call returns. An address of
// the device is a number that only the device can follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hfrac {

// Functions return 0, or a number that `describe` puts into words; the symbol that gives the table: hfrac_device_driver.
struct DeviceDriver {
  std::int32_t version;  // device_driver_version
  std::int32_t (*count)(std::int32_t* devices);
  std::int32_t (*name)(std::int32_t device, char* text, std::int32_t size, std::int64_t* memory_bytes);
  std::int32_t (*open)(std::int32_t device, void** opened);
  void (*close)(void* opened);
  std::int32_t (*allocate)(void* opened, std::int64_t bytes, void** address);
  void (*release)(void* opened, void* address);
  std::int32_t (*upload)(void* opened, void* to, const void* from, std::int64_t bytes);
  std::int32_t (*download)(void* opened, void* to, const void* from, std::int64_t bytes);
  std::int32_t (*copy)(void* opened, void* to, const void* from, std::int64_t bytes);  // both on the device
  // Kernel number `kernel` in so many blocks, with so many bytes of memory to a block; `task`: its one argument, of `task_bytes`.
  std::int32_t (*launch)(void* opened, std::int32_t kernel, std::int64_t blocks, std::int64_t shared_bytes,
                         const void* task, std::int64_t task_bytes);
  void (*describe)(std::int32_t status, char* text, std::int32_t size);
};
constexpr std::int32_t device_driver_version = 1;

// The devices of this machine, and why there are none.
struct DeviceList {
  struct Entry {
    std::string name;
    std::int64_t memory_bytes;
  };
  std::vector<Entry> devices;
  std::string why_none;
};
DeviceList list_devices();

// The first device, opened.
class Device {
 public:
  // Null, and why, where there is none.
  static std::unique_ptr<Device> open_first(std::string& why_none);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  // All throw Error(device) with the driver's words; allocate std::bad_alloc where the device's memory is out.
  void* allocate(std::size_t bytes) const;
  void release(void* address) const noexcept;
  void upload(void* to, const void* from, std::size_t bytes) const;
  void download(void* to, const void* from, std::size_t bytes) const;
  // Within the device, `times` over and to the end: for benchmarks.
  void copy(void* to, const void* from, std::size_t bytes, int times) const;
  void launch(std::int32_t kernel, std::int64_t blocks, std::int64_t shared_bytes, const void* task,
              std::size_t task_bytes) const;

 private:
  Device() = default;
  void check(std::int32_t status, const char* what) const;

  void* library_ = nullptr;
  const DeviceDriver* driver_ = nullptr;
  void* opened_ = nullptr;
  std::string name_;
};

// An array on a device, that grows as needed.
class DeviceArray {
 public:
  explicit DeviceArray(const Device& device) : device_(&device) {}
  DeviceArray(DeviceArray&& other) noexcept
      : device_(other.device_), address_(other.address_), room_(other.room_) {
    other.address_ = nullptr;
  }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  DeviceArray& operator=(DeviceArray&&) = delete;
  ~DeviceArray() { device_->release(address_); }

  // Room for so many bytes; what was there is lost where it grows.
  void* reserve(std::size_t bytes) {
    if (bytes <= room_) return address_;
    device_->release(address_);
    address_ = nullptr;
    room_ = 0;
    address_ = device_->allocate(bytes);
    room_ = bytes;
    return address_;
  }
  void put(const void* from, std::size_t bytes) {
    reserve(bytes);
    if (bytes > 0) device_->upload(address_, from, bytes);
  }
  void get(void* to, std::size_t bytes) const {
    if (bytes > 0) device_->download(to, address_, bytes);
  }
  template <class T>
  [[nodiscard]] T* as() const {
    return static_cast<T*>(address_);
  }

 private:
  const Device* device_;
  void* address_ = nullptr;
  std::size_t room_ = 0;
};

}  // namespace hfrac
