// SPDX-License-Identifier: BSD-3-Clause
#include "model_file.hpp"

#include <string>

#include "byte_file.hpp"
#include "def_image.hpp"
#include "hfrac/state.h"
#include "internal.hpp"
#include "messages.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"
#include "sim_handle.hpp"
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

}  // namespace

std::optional<PackedModel> hfrac::capi::packed_model_of(const CaseDefinition& definition, bool discs_given) {
  if (definition.packing_file.empty()) return std::nullopt;
  if (discs_given)
    throw Error(ErrorKind::model,
                "packing.file names a packed model, and discs are given, too; leave one of them out.");
  const std::string path = path_of(definition);
  try {
    return packed_model(read_whole_file(path, largest_file),
                        PackingReuse{definition.options.packing_reuse} == PackingReuse::discs);
  } catch (const Error& error) {
    const std::string what = error.kind() == ErrorKind::file ? "" : "'" + path + "': ";
    throw Error(ErrorKind::file, "packing.file: " + what + error.what() +
                                     (error.kind() == ErrorKind::file
                                          ? " Without packing.file the model is packed anew, with the same "
                                            "result."
                                          : ""));
  }
}

std::optional<PackedModel> hfrac::capi::packed_model_of(const CaseDefinition& definition, bool discs_given,
                                                        const Ranks& ranks) {
  if (definition.packing_file.empty()) return std::nullopt;
  std::optional<PackedModel> model;
  std::optional<Error> fault;
  try {
    model = packed_model_of(definition, discs_given);
  } catch (const Error& error) {
    fault = error;
  }
  const bool failed = ranks.any(fault.has_value());
  if (fault) throw Error(*fault);
  const std::string path = "packing.file: '" + path_of(definition) + "'";
  if (failed)
    throw Error(ErrorKind::file, path + " cannot be read by another rank; put it where all ranks find it.");
  // Half of the checksum, of which a sum over all ranks does not overflow.
  const auto own = static_cast<std::int64_t>(model->checksum & 0xffffffffU);
  std::int64_t sum = own;
  ranks.sum({&sum, 1});
  if (ranks.any(sum != ranks.size() * own))
    throw Error(ErrorKind::file,
                path + " is not the same file on all ranks; copy one of them to where all ranks find it.");
  return model;
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
