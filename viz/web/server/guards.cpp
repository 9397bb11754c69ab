// SPDX-License-Identifier: BSD-3-Clause
#include "web/server/guards.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <random>
#include <system_error>
#include <vector>

namespace hfrac::web {
namespace fs = std::filesystem;

namespace {

bool is_number(std::string_view text, int largest) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && text.size() <= 5 && value >= 0 &&
         value <= largest;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool is_loopback_number(std::string_view host) {
  const auto parts = split(host, '.');
  return parts.size() == 4 && parts[0] == "127" &&
         std::all_of(parts.begin(), parts.end(), [](std::string_view part) { return is_number(part, 255); });
}

/** The kinds of files that a run and what is drawn of it consist of. */
bool is_known_kind(const fs::path& file) {
  static constexpr std::array<std::string_view, 14> kinds = {".vtu",  ".pvtu", ".pvd",  ".csv", ".json",
                                                             ".toml", ".png",  ".svg",  ".pdf", ".mp4",
                                                             ".webp", ".gif",  ".html", ".py"};
  const std::string kind = file.extension().string();
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace

bool is_loopback_host(std::string_view host) {
  std::string lower(host);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const size_t colon = lower.rfind(':');
  const size_t bracket = lower.rfind(']');
  const bool has_port = colon != std::string::npos && (bracket == std::string::npos || colon > bracket);
  const std::string name = has_port ? lower.substr(0, colon) : lower;
  if (has_port && !is_number(std::string_view(lower).substr(colon + 1), 65535)) return false;
  return name == "localhost" || name == "[::1]" || is_loopback_number(name);
}

std::string random_key() {
  std::random_device device;
  std::string key;
  for (int word = 0; word < 4; ++word) {
    auto bits = static_cast<uint32_t>(device());
    for (int digit = 0; digit < 8; ++digit, bits >>= 4) key += "0123456789abcdef"[bits & 15U];
  }
  return key;
}

std::optional<fs::path> file_inside(const fs::path& folder, std::string_view name) {
  if (name.empty() || name.find('\0') != std::string_view::npos || name.find('\\') != std::string_view::npos)
    return std::nullopt;
  for (const std::string_view part : split(name, '/'))
    if (part.empty() || part.front() == '.') return std::nullopt;

  std::error_code error;
  const fs::path top = fs::canonical(folder, error);
  if (error) return std::nullopt;
  const fs::path file = fs::canonical(top / fs::path(name), error);
  if (error || !fs::is_regular_file(file, error) || !is_known_kind(file)) return std::nullopt;
  const auto [end_of_top, rest] = std::mismatch(top.begin(), top.end(), file.begin(), file.end());
  if (end_of_top != top.end() || rest == file.end()) return std::nullopt;
  return file;
}

}  // namespace hfrac::web
