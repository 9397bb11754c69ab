// SPDX-License-Identifier: BSD-3-Clause
// All that is read from an injection and its fall-off, as numbers, as words and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command/falloff.hpp"
#include "command/injection_record.hpp"
#include "command/step_rate.hpp"

namespace hfrac::command {

struct Analysis {
  ShutIn shut_in;
  double injection = 0.0;        ///< [s] that G is made with
  std::optional<double> volume;  ///< [m2]
  std::optional<double>
      breakdown;  ///< [Pa] largest pressure of the injection, if the pressure falls from it while fluid goes in
  double propagation = 0.0;  ///< [Pa] mean over the second half of the injection
  Falloff falloff;
  std::vector<double> g;  ///< of each of its rows
  FalloffReading reading;
  StepRateReading step_rate;
  std::vector<std::string> notes;  ///< what the record does not hold, and why
};

struct FalloffTerms {
  LeakOff leak_off = LeakOff::little;
  double injection = 0.0;  ///< [s] for G; 0: from when fluid goes in to shut-in
};

Analysis analyse_record(const InjectionRecord& record, const ShutIn& shut_in, const FalloffTerms& terms);

/** Lines for a terminal. */
std::string words_of(const Analysis& analysis, const InjectionRecord& record);

/** What is not there is null; SI units. */
nlohmann::ordered_json json_of(const Analysis& analysis, const InjectionRecord& record);

}  // namespace hfrac::command
