// SPDX-License-Identifier: BSD-3-Clause
#include "web/server/waiting_room.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace hfrac::web {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::milliseconds;

constexpr size_t kMostWaiting = 256;       // a page keeps six open
constexpr size_t kLongestHead = 16384;     // bytes
constexpr Milliseconds kHeadTime{5000};    // from the connection, or the answer before, to a whole head
constexpr Milliseconds kStandstill{5000};  // nothing read or written for so long ends a request
constexpr std::string_view kHeadEnd = "\r\n\r\n";

bool ready(int socket, short events) {
  pollfd one{socket, events, 0};
  const auto until = Clock::now() + kStandstill;
  for (;;) {
    const auto left = std::chrono::duration_cast<Milliseconds>(until - Clock::now());
    const int count = ::poll(&one, 1, static_cast<int>(std::max<int64_t>(0, left.count())));
    if (count >= 0 || errno != EINTR) return count > 0;
  }
}

/** Whether there is nothing more to come, with what there was added to the connection. */
bool receive(Connection& connection) {
  char part[4096];
  for (;;) {
    const ssize_t got = ::recv(connection.socket, part, sizeof part, MSG_DONTWAIT);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno != EAGAIN && errno != EWOULDBLOCK;
    if (got == 0) return true;
    connection.received.append(part, static_cast<size_t>(got));
    if (connection.received.size() > kLongestHead) return false;
  }
}

bool is_whole(const Connection& connection) {
  return connection.received.find(kHeadEnd) != std::string::npos;
}

}  // namespace

Connection::~Connection() {
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
}

bool ConnectionStream::is_readable() const {
  return !connection_.received.empty() || ready(connection_.socket, POLLIN);
}

bool ConnectionStream::is_writable() const {
  return ready(connection_.socket, POLLOUT);
}

ssize_t ConnectionStream::read(char* bytes, size_t size) {
  if (!connection_.received.empty()) {
    const size_t count = std::min(size, connection_.received.size());
    std::copy_n(connection_.received.data(), count, bytes);
    connection_.received.erase(0, count);
    return static_cast<ssize_t>(count);
  }
  if (!is_readable()) return -1;
  return ::recv(connection_.socket, bytes, size, 0);
}

ssize_t ConnectionStream::write(const char* bytes, size_t size) {
  if (!is_writable()) return -1;
  return ::send(connection_.socket, bytes, size, MSG_NOSIGNAL);
}

void ConnectionStream::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip = "127.0.0.1";
  port = 0;
}

void ConnectionStream::get_local_ip_and_port(std::string& ip, int& port) const {
  get_remote_ip_and_port(ip, port);
}

/** The thread that watches, and the pool that answers. */
class WaitingRoom::Room {
 public:
  Room(size_t threads, Answer answer)
      : answer_(std::move(answer)), pool_(threads), wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    watch_ = std::thread([this] { watch(); });
  }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;
  ~Room() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    wake();
    watch_.join();
    pool_.shutdown();
    ::close(wake_);
  }

  void enter(std::shared_ptr<Connection> connection) {
    {
      const std::lock_guard lock(mutex_);
      arrived_.push_back({std::move(connection), Clock::now() + kHeadTime});
    }
    wake();
  }

 private:
  struct Guest {
    std::shared_ptr<Connection> connection;
    Clock::time_point until;
  };

  void wake() const { ::eventfd_write(wake_, 1); }

  /** Lets in those that have arrived; false when all is over. */
  bool let_in() {
    eventfd_t count = 0;
    ::eventfd_read(wake_, &count);
    const std::lock_guard lock(mutex_);
    for (auto& guest : arrived_) waiting_.push_back(std::move(guest));
    arrived_.clear();
    if (waiting_.size() > kMostWaiting)  // they stand in the order in which they came
      waiting_.erase(waiting_.begin(), waiting_.end() - static_cast<std::ptrdiff_t>(kMostWaiting));
    return !ended_;
  }

  void watch() {
    std::vector<pollfd> polled;
    while (let_in()) {
      polled.assign(1, {wake_, POLLIN, 0});
      auto next = Clock::time_point::max();
      for (const auto& guest : waiting_) {
        polled.push_back({guest.connection->socket, POLLIN, 0});
        next = std::min(next, is_whole(*guest.connection) ? Clock::time_point::min() : guest.until);
      }
      ::poll(polled.data(), polled.size(), pause_until(next));
      const auto now = Clock::now();
      std::vector<Guest> stay;
      for (size_t i = 0; i < waiting_.size(); ++i) {
        auto& guest = waiting_[i];
        const bool over = polled[i + 1].revents != 0 && receive(*guest.connection);
        if (is_whole(*guest.connection))
          pool_.enqueue([this, connection = std::move(guest.connection)] { serve(connection); });
        else if (!over && guest.connection->received.size() <= kLongestHead && now < guest.until)
          stay.push_back(std::move(guest));
      }
      waiting_ = std::move(stay);
    }
    waiting_.clear();
  }

  static int pause_until(Clock::time_point next) {
    if (next == Clock::time_point::max()) return -1;
    if (next == Clock::time_point::min()) return 0;
    const auto left = std::chrono::ceil<Milliseconds>(next - Clock::now());
    return static_cast<int>(std::max<int64_t>(0, left.count()));
  }

  void serve(const std::shared_ptr<Connection>& connection) {
    if (answer_(*connection)) enter(connection);
  }

  Answer answer_;
  httplib::ThreadPool pool_;
  int wake_;
  std::mutex mutex_;
  std::vector<Guest> arrived_;  ///< guarded by mutex_
  bool ended_ = false;          ///< guarded by mutex_
  std::vector<Guest> waiting_;  ///< of the watching thread
  std::thread watch_;
};

WaitingRoom::WaitingRoom(size_t threads, Answer answer)
    : room_(std::make_unique<Room>(threads, std::move(answer))) {}

WaitingRoom::~WaitingRoom() = default;

void WaitingRoom::take(int socket) {
  room_->enter(std::make_shared<Connection>(socket));
}

}  // namespace hfrac::web
