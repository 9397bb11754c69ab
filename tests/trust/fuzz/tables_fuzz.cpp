// SPDX-License-Identifier: BSD-3-Clause
// Files a user hands in as tables: discs and bonds as CSV, discs as VTU, the logs of cracks and slips of a run folder. Refused with a
// sentence, or read; then what is written of it is the same when it is read again.
//
// Input: the first byte chooses the reader, the rest is the file.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include "output/disc_file.hpp"
#include "output/tables.hpp"
#include "run/files.hpp"

namespace {

namespace fs = std::filesystem;
using namespace hfrac::output;

void demand(bool good) {
  if (!good) std::abort();
}

// A file in memory. Which reader a file of discs gets goes by its name, so it has two: links to the open file.
class MemoryFile {
 public:
  MemoryFile() : folder_(fs::temp_directory_path() / "hfrac_tables_XXXXXX") {
    std::string name = folder_.string();
    demand(::mkdtemp(name.data()) != nullptr);
    folder_ = name;
    demand((file_ = ::memfd_create("table", MFD_CLOEXEC)) >= 0);
    const fs::path open_file = "/proc/self/fd/" + std::to_string(file_);
    for (const char* name_of : {"table.csv", "table.vtu"}) fs::create_symlink(open_file, folder_ / name_of);
  }
  ~MemoryFile() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    ::close(file_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  void put(std::string_view text) const {
    demand(::ftruncate(file_, 0) == 0);
    demand(::pwrite(file_, text.data(), text.size(), 0) == static_cast<::ssize_t>(text.size()));
  }
  fs::path csv() const { return folder_ / "table.csv"; }
  fs::path vtu() const { return folder_ / "table.vtu"; }

 private:
  fs::path folder_;
  int file_ = -1;
};

template <class Number>
bool same_bits(const std::vector<Number>& a, const std::vector<Number>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] != b[k] && !(a[k] != a[k] && b[k] != b[k])) return false;
  return true;
}

void read(const MemoryFile& file, unsigned which) {
  if (which == 0 || which == 1) {
    const auto discs = read_discs(which == 0 ? file.csv() : file.vtu());
    demand(!discs.empty() && discs.size() % 3 == 0);
    file.put(discs_as_csv(discs));
    demand(same_bits(read_discs(file.csv()), discs));
  } else if (which == 2) {
    const auto bonds = read_bonds(file.csv());
    demand(!bonds.empty() && bonds.size() % 2 == 0);
    file.put(bonds_as_csv(bonds));
    demand(read_bonds(file.csv()) == bonds);
  } else {
    const auto cracks = which == 3 ? read_crack_table(file.csv()) : std::vector<hfrac_crack>{};
    const auto slips = which == 4 ? read_slip_table(file.csv()) : std::vector<hfrac_slip>{};
    const auto events = events_of(cracks, slips, nullptr);
    demand(events.size() <= cracks.size() + slips.size());
    event_table(events);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const MemoryFile file;
  if (size < 1) return 0;
  file.put({reinterpret_cast<const char*>(data) + 1, size - 1});
  try {
    read(file, data[0] % 5U);
  } catch (const DiscFileError& error) {
    demand(error.what()[0] != '\0');
  } catch (const FileError& error) {
    demand(error.what()[0] != '\0');
  } catch (const EngineError& error) {
    demand(error.what()[0] != '\0');
  }
  return 0;
}
