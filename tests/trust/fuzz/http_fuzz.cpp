// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as what a browser sends to the server of the page, over a real connection. `@` stands for the page's folder with
// its key. Answers are whole or none, never longer than the files that there are; afterwards the server still answers.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "web/server/page_server.hpp"

namespace {

namespace fs = std::filesystem;

void demand(bool good) {
  if (!good) std::abort();
}

/** A run folder with one table, and a server of it that lives as long as the process. */
struct Served {
  Served()
      : folder(fs::temp_directory_path() / ("hfrac-fuzz-" + std::to_string(::getpid()))), server(folder) {
    fs::create_directories(folder);
    std::ofstream(folder / "history.csv") << "step,time_s\n" << std::string(3000, '7') << "\n";
    demand(server.bind(0));
    const std::string address = server.address();
    const std::string before_port = "http://127.0.0.1:";
    port = static_cast<uint16_t>(std::stoi(address.substr(before_port.size())));
    base = address.substr(address.find('/', before_port.size()));
    thread = std::thread([this] { server.serve(); });
  }
  ~Served() {
    server.stop();
    thread.join();
    fs::remove_all(folder);
  }

  fs::path folder;
  hfrac::web::PageServer server;
  uint16_t port = 0;
  std::string base;
  std::thread thread;
};

/** A connection. Closed ones keep their port for a minute: a fast search runs out of ports and waits for them. */
int connect_to(std::uint16_t port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(port);
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (int tries = 0; tries < 200; ++tries) {
    const int plug = ::socket(AF_INET, SOCK_STREAM, 0);
    demand(plug >= 0);
    if (::connect(plug, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) return plug;
    demand(errno == EADDRNOTAVAIL);
    ::close(plug);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  demand(false);
  return -1;
}

/** All that comes back for `text`. */
std::string answer_to(const Served& served, const std::string& text) {
  const int plug = connect_to(served.port);
  ::send(plug, text.data(), text.size(), MSG_NOSIGNAL);
  ::shutdown(plug, SHUT_WR);
  std::string answer;
  char part[65536];
  for (ssize_t got = 0; (got = ::recv(plug, part, sizeof part, 0)) > 0;)
    answer.append(part, static_cast<size_t>(got));
  ::close(plug);
  return answer;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Served served;
  std::string text;
  for (std::size_t i = 0; i < size; ++i) {
    if (data[i] == '@')
      text += served.base;
    else
      text += static_cast<char>(data[i]);
  }
  const std::string answer = answer_to(served, text);
  demand(answer.empty() || answer.starts_with("HTTP/1."));
  demand(answer.find("HTTP/1.1 206") == std::string::npos);
  // The largest answer is the page's script, half a megabyte; a text of n bytes holds at most n / 16 requests.
  demand(answer.size() < (1 + size / 16) * 1000000);

  const std::string good =
      "GET " + served.base + "files/history.csv HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
  demand(answer_to(served, good).ends_with(std::string(3000, '7') + "\n"));
  return 0;
}
