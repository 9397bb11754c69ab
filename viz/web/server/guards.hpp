// SPDX-License-Identifier: BSD-3-Clause
// Who may ask, and for what: the rules by which the page's server refuses.
//
// The server listens on loopback only, which keeps other machines out. Three things remain. A web page of
// somebody else, open in the same browser, can point a name of its own at 127.0.0.1 and ask in the user's
// stead; its requests carry that name in the header Host, so only loopback names are answered. Another user
// of the same machine can reach loopback too; the address therefore contains a random key. And whoever may
// ask could try to climb out of the run folder; a file is served only if its real place is inside.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hfrac::web {

/** Whether the header Host names this machine's loopback: localhost, 127.x.y.z or [::1], with or without a
 * port. */
bool is_loopback_host(std::string_view host);

/** 128 random bits as 32 hexadecimal digits. */
std::string random_key();

/** The file that `name` means inside `folder`, or nothing if there is no such regular file, if its kind is
 * none that a run consists of, or if it would lie outside: by "..", by an absolute path, by a link, or hidden.
 * `name` is the request's path after one decoding; slashes separate folders. */
std::optional<std::filesystem::path> file_inside(const std::filesystem::path& folder, std::string_view name);

}  // namespace hfrac::web
