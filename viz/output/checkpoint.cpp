// SPDX-License-Identifier: BSD-3-Clause
// The image carries a checksum of its own; the one here covers the course of the run and the lengths as well.
#include "output/checkpoint.hpp"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

#include "run/files.hpp"
#include "run/text.hpp"

namespace hfrac::output {
using namespace hfrac::run;
namespace fs = std::filesystem;

namespace {

using json = nlohmann::ordered_json;

constexpr char magic[8] = {'h', 'f', 'r', 'a', 'c', 'c', 'h', 'k'};
constexpr uint32_t format = 1, byte_order = 0x01020304;
constexpr size_t kept = 2;

struct Header {
  char magic[8];
  uint32_t format, byte_order;
  uint64_t course_size, image_size;
  uint32_t checksum, unused;
};
static_assert(sizeof(Header) == 40);

/** Of all but itself. */
uint32_t checksum_of(Header header, std::initializer_list<std::string_view> content) {
  header.checksum = 0;
  uint32_t sum = libdeflate_crc32(0, &header, sizeof header);
  for (const auto part : content) sum = libdeflate_crc32(sum, part.data(), part.size());
  return sum;
}

std::string_view bytes_of(const Header& header) {
  return {reinterpret_cast<const char*>(&header), sizeof header};
}

json course_of(const Checkpoint& checkpoint) {
  json snapshots = json::array();
  for (const auto& entry : checkpoint.snapshots) snapshots.push_back({entry.step, entry.time});
  return {{"step", checkpoint.step},
          {"snapshots", snapshots},
          {"steps_not_at_rest", checkpoint.steps_not_at_rest},
          {"wall_seconds", checkpoint.wall_seconds}};
}

// A whole number; json::exception for any other, such as one that no integer holds.
int64_t whole(const json& value) {
  return value.get_ref<const json::number_integer_t&>();
}

Checkpoint checkpoint_of(const json& course) {
  Checkpoint checkpoint;
  checkpoint.step = whole(course.at("step"));
  for (const auto& entry : course.at("snapshots"))
    checkpoint.snapshots.push_back({whole(entry.at(0)), entry.at(1).get<double>()});
  checkpoint.steps_not_at_rest = whole(course.at("steps_not_at_rest"));
  checkpoint.wall_seconds = course.at("wall_seconds").get<double>();
  return checkpoint;
}

/** "step_00012.checkpoint" -> 12; -1 if it is no such name. */
int64_t step_of(const std::string& name) {
  constexpr std::string_view begin = "step_", end = ".checkpoint";
  if (!name.starts_with(begin) || !name.ends_with(end) || name.size() <= begin.size() + end.size()) return -1;
  const auto number = std::string_view(name).substr(begin.size(), name.size() - begin.size() - end.size());
  return number_in<int64_t>(number).value_or(-1);
}

Header header_of(std::string_view course, std::string_view image) {
  Header header{};
  std::memcpy(header.magic, magic, sizeof magic);
  header.format = format;
  header.byte_order = byte_order;
  header.course_size = course.size();
  header.image_size = image.size();
  header.checksum = checksum_of(header, {course, image});
  return header;
}

}  // namespace

std::string pack_checkpoint(const Checkpoint& checkpoint) {
  const std::string course = course_of(checkpoint).dump();
  return std::string(bytes_of(header_of(course, checkpoint.image))) + course + checkpoint.image;
}

Checkpoint unpack_checkpoint(std::string bytes) {
  Header header{};
  if (bytes.size() < sizeof header) throw CheckpointError("it is shorter than a checkpoint's header");
  std::memcpy(&header, bytes.data(), sizeof header);
  const auto content = std::string_view(bytes).substr(sizeof header);
  if (std::memcmp(header.magic, magic, sizeof magic) != 0)
    throw CheckpointError("it is no checkpoint of hfrac");
  if (header.byte_order != byte_order)
    throw CheckpointError("it comes from a machine of the other byte order");
  if (header.format != format) {
    throw CheckpointError(
        fmt::format("its format is {}, and this hfrac reads format {}; use the version that wrote it",
                    header.format, format));
  }
  if (header.course_size > content.size() || header.image_size != content.size() - header.course_size)
    throw CheckpointError("its length is not what it says: it was cut, or something was added");
  if (header.checksum != checksum_of(header, {content}))
    throw CheckpointError("it is damaged: its checksum differs");
  try {
    const auto size = static_cast<size_t>(header.course_size);
    Checkpoint checkpoint = checkpoint_of(json::parse(content.substr(0, size)));
    bytes.erase(0, sizeof header + size);
    checkpoint.image = std::move(bytes);
    return checkpoint;
  } catch (const json::exception& error) {
    throw CheckpointError(fmt::format("its account of the run cannot be read: {}", error.what()));
  }
}

CheckpointFolder::CheckpointFolder(const fs::path& run_folder) : folder_(run_folder / "checkpoints") {}

fs::path CheckpointFolder::file(int64_t step) const {
  return folder_ / fmt::format("step_{:05}.checkpoint", step);
}

std::vector<int64_t> CheckpointFolder::steps() const {
  std::vector<int64_t> steps;
  std::error_code error;
  for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error))
    if (const int64_t step = step_of(entry->path().filename().string()); step >= 0) steps.push_back(step);
  std::sort(steps.rbegin(), steps.rend());
  return steps;
}

void CheckpointFolder::write(const Checkpoint& checkpoint) const {
  make_real_folder(folder_);
  const std::string course = course_of(checkpoint).dump();
  write_whole(file(checkpoint.step),
              {bytes_of(header_of(course, checkpoint.image)), course, checkpoint.image});
  const auto there = steps();
  for (size_t k = kept; k < there.size(); ++k) {
    std::error_code ignored;  // one too many does no harm
    fs::remove(file(there[k]), ignored);
  }
}

std::optional<Checkpoint> CheckpointFolder::newest(std::vector<std::string>& damaged) const {
  for (const int64_t step : steps()) {
    try {
      return unpack_checkpoint(read_whole(file(step)));
    } catch (const std::runtime_error& error) {  // not whole, or cannot be read
      damaged.push_back(fmt::format("'{}' cannot be used: {}", file(step).string(), error.what()));
    }
  }
  return std::nullopt;
}

void CheckpointFolder::remove_after(int64_t step) const {
  for (const int64_t there : steps())
    if (there > step) remove_file(file(there));
}

}  // namespace hfrac::output
