// SPDX-License-Identifier: BSD-3-Clause
// Work on many items that do not need each other, shared out to threads: coding of files, rows of pictures.
#pragma once

#include <cstddef>
#include <functional>

namespace hfrac::run {

/** Calls task(worker, item) once for every item below `count`, on at most `workers` threads: the calling one, which is worker 0,
 * and others that block all signals. Who does which item is open. Returns when all have ended; then throws what one of them
 * threw first, after which items may be left undone. If there can be no more threads, those that there are do all. */
void share_out(int workers, size_t count, const std::function<void(size_t worker, size_t item)>& task);

}  // namespace hfrac::run
