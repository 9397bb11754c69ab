// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out on demand: this program's malloc stands before the C library's, also for libhfrac, and refuses what
// it is told to refuse. It counts what is taken and given back, so that a leak shows.
#pragma once

namespace failing_memory {

// The request after `good` further ones is refused; with `lasting`, so are all after it.
void refuse_after(long good, bool lasting);
// Nothing is refused any more. Whether anything was.
bool stop_refusing();
// Blocks taken and not given back.
long outstanding();

}  // namespace failing_memory
