// SPDX-License-Identifier: BSD-3-Clause
// The two streams to the shell. Standard output carries results: one that cannot be written is an error. Standard error
// carries what a person may want to read: text that cannot be written there, on a full disk, a closed terminal or a pipe
// that nobody reads, is lost and never stops the work.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace hfrac::command {

/** Gives descriptors 0 to 2 that are closed a place at /dev/null, opened the wrong way round so that using them still fails:
 * the next file that is opened would take the number, and messages would be written into it. */
void reserve_standard_streams();

/** Writes `text` to standard error, or not at all. */
void tell_text(std::string_view text) noexcept;

/** A sentence to standard error: tell("hfrac: {} is missing\n", name). */
template <class... Values>
void tell(fmt::format_string<Values...> format, Values&&... values) {
  tell_text(fmt::format(format, std::forward<Values>(values)...));
}

/** Sends what was printed to standard output on its way. Throws std::runtime_error if it cannot be written. */
void flush_results();

/** Forgets what standard output could not take, after it was told. */
void drop_results();

}  // namespace hfrac::command
