// SPDX-License-Identifier: BSD-3-Clause
#include "model_file.hpp"

#include <span>
#include <string>

#include "byte_file.hpp"
#include "core/hash.hpp"
#include "def_image.hpp"
#include "hfrac/state.h"
#include "internal.hpp"
#include "messages.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"
#include "sim_handle.hpp"
#include "state/seal.hpp"
#include "step/simulation.hpp"
#include "stepping.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 40U;

std::string path_of(const CaseDefinition& definition) {
  std::string path = definition.packing_file;
  constexpr std::string_view mark = "{seed}";
  const auto at = path.find(mark);
  if (at != std::string::npos) path.replace(at, mark.size(), number_text(definition.options.model_seed));
  return path;
}

// Reading, by all ranks or none.
template <class Do>
void all_or_none_read(const Ranks& ranks, const std::string& path, const Do& act) {
  const Error elsewhere(
      ErrorKind::file,
      "packing.file: '" + path + "' cannot be read by another rank; put it where all ranks find it.");
  all_or_none(ranks, elsewhere, [&] {
    try {
      act();
    } catch (const Error& error) {
      throw Error(ErrorKind::file,
                  std::string("packing.file: ") + error.what() +
                      " Without packing.file the model is packed anew, with the same result.");
    }
  });
}

// Each rank reads its part and tells it to the others, so that a disk that many machines share gives every byte once.
std::vector<std::byte> bytes_by_ranks(const std::string& path, const Ranks& ranks) {
  std::optional<SavedFile> file;
  std::vector<std::byte> head(seal_size);
  all_or_none_read(ranks, path, [&] {
    file.emplace(path, largest_file);
    file->read(0, head);
  });
  // The head has the checksum of what follows, so those of the same head are the same file. Half of a hash: a sum over all ranks does not overflow.
  Hash hash;
  hash.add(static_cast<std::int64_t>(file->size()));
  hash.add_all(std::span(reinterpret_cast<const unsigned char*>(head.data()), head.size()));
  const auto own = static_cast<std::int64_t>(hash.value() & 0xffffffffU);
  std::int64_t sum = own;
  ranks.sum({&sum, 1});
  if (ranks.any(sum != ranks.size() * own))
    throw Error(ErrorKind::file,
                "packing.file: '" + path +
                    "' is not the same file on all ranks; copy one of them to where all ranks find it.");
  constexpr std::int64_t grain = 1 << 20;
  std::vector<std::byte> bytes(file->size());
  const auto size = static_cast<std::int64_t>(bytes.size());
  std::vector<std::int64_t> begin{0};
  for (int r = 0; r < ranks.size(); ++r) begin.push_back(ranks.part(r, size, grain).end);
  const auto from = static_cast<std::size_t>(begin[static_cast<std::size_t>(ranks.rank())]),
             end = static_cast<std::size_t>(begin[static_cast<std::size_t>(ranks.rank()) + 1]);
  all_or_none_read(ranks, path, [&] { file->read(from, std::span(bytes).subspan(from, end - from)); });
  ranks.gather(bytes.data(), begin);
  return bytes;
}

}  // namespace

std::optional<PackedModel> hfrac::capi::packed_model_of(const CaseDefinition& definition, bool discs_given,
                                                        const Ranks& ranks) {
  if (definition.packing_file.empty()) return std::nullopt;
  if (discs_given)
    throw Error(ErrorKind::model,
                "packing.file names a packed model, and discs are given, too; leave one of them out.");
  const std::string path = path_of(definition);
  const std::vector<std::byte> bytes = bytes_by_ranks(path, ranks);
  try {
    return packed_model(bytes, PackingReuse{definition.options.packing_reuse} == PackingReuse::discs);
  } catch (const Error& error) {
    throw Error(ErrorKind::file, "packing.file: '" + path + "': " + error.what());
  }
}

int32_t hfrac_pack(const hfrac_sim_def* def, const char* path) {
  return guarded([&]() -> std::int32_t {
    require_not_null(path, "path");
    const hfrac_sim_def full = read_def(def);
    hfrac_sim speaker;  // whose listener and progress callback are the definition's
    speaker.listener = listener_of(full.log, full.log_user, full.log_level);
    ProgressPoll poll(speaker, full.progress, full.progress_user, 0.05);
    try {
      const CaseDefinition definition = case_of(full);
      const auto from = packed_model_of(definition, full.given_disc_count > 0);
      const PackedModel model = Simulation::pack(
          definition, given_discs_of(full),
          [&](double done, const char* what) { return poll.stop(done, what); }, given_bonds_of(full),
          from ? &*from : nullptr);
      write_whole_file(path, bytes_of(model));
      tell(speaker, HFRAC_LOG_INFO,
           "model of " + std::to_string(model.packing.x.size()) + " discs at rest saved to '" + path + "'");
    } catch (const Stopped&) {
      return HFRAC_STOPPED;
    }
    return HFRAC_OK;
  });
}
