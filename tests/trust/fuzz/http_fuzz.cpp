// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as what a browser sends to the server of the page, over a real connection. `@` stands for the page's folder with
// its key. Answers are whole or none, never longer than the files that there are; afterwards the server still answers.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "web/server/page_server.hpp"

namespace {

namespace fs = std::filesystem;

void demand(bool good, const std::string& what) {
  if (good) return;
  std::fprintf(stderr, "http_fuzz ERROR: %s\n", what.c_str());
  std::abort();
}

std::string reason() {
  return std::strerror(errno);
}

/** A run folder with one table, and a server of it that lives as long as the process. */
struct Served {
  Served()
      : folder(fs::temp_directory_path() / ("hfrac-fuzz-" + std::to_string(::getpid()))), server(folder) {
    fs::create_directories(folder);
    std::ofstream(folder / "history.csv") << "step,time_s\n" << std::string(3000, '7') << "\n";
    demand(server.bind(0), "no port for the server");
    const std::string address = server.address();
    const std::string before_port = "http://127.0.0.1:";
    port = static_cast<uint16_t>(std::stoi(address.substr(before_port.size())));
    base = address.substr(address.find('/', before_port.size()));
    // libFuzzer's clock is a signal, and one that comes while the server waits for connections would end it.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread = std::thread([this] { server.serve(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
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

/**
 * A connection to the server. A closed one keeps its pair of addresses for a minute, and a fast search makes more of them than one
 * address has ports: so each comes from an address of its own, of the 16 million that are this machine.
 */
int connect_to(std::uint16_t port) {
  static std::uint32_t count = 0;
  sockaddr_in from{}, to{};
  from.sin_family = to.sin_family = AF_INET;
  to.sin_port = htons(port);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (;;) {
    const int plug = ::socket(AF_INET, SOCK_STREAM, 0);
    demand(plug >= 0, "socket: " + reason());
    from.sin_addr.s_addr = htonl(INADDR_LOOPBACK + count++ % 0xffff00);
    demand(::bind(plug, reinterpret_cast<const sockaddr*>(&from), sizeof from) == 0, "bind: " + reason());
    if (::connect(plug, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) return plug;
    demand(errno == EINTR, "connect: " + reason());  // libFuzzer's clock
    ::close(plug);
  }
}

/** All that comes back for `text`, and why no more came. */
struct Heard {
  std::string text, end;
};
Heard answer_to(const Served& served, const std::string& text) {
  const int plug = connect_to(served.port);
  size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t count = ::send(plug, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count > 0) sent += static_cast<size_t>(count);
    if (count < 0 && errno != EINTR) break;  // it may answer and close before it has read all
  }
  ::shutdown(plug, SHUT_WR);
  Heard heard;
  for (;;) {
    char part[65536];
    const ssize_t got = ::recv(plug, part, sizeof part, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      heard.end = got == 0 ? "closed" : reason();
      break;
    }
    heard.text.append(part, static_cast<size_t>(got));
  }
  ::close(plug);
  return heard;
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
  const std::string answer = answer_to(served, text).text;
  demand(answer.empty() || answer.starts_with("HTTP/1."), "an answer that is none: " + answer.substr(0, 200));
  demand(answer.find("HTTP/1.1 206") == std::string::npos, "a part of a file");
  // The largest answer is the page's script, half a megabyte; a text of n bytes holds at most n / 16 requests.
  demand(answer.size() < (1 + size / 16) * 1000000, "an answer longer than the files");

  const std::string good =
      "GET " + served.base + "files/history.csv HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
  const Heard heard = answer_to(served, good);
  demand(heard.text.ends_with(std::string(3000, '7') + "\n"),
         "after it a good request got " + std::to_string(heard.text.size()) + " bytes (" + heard.end +
             "): " + heard.text.substr(0, 200));
  return 0;
}
