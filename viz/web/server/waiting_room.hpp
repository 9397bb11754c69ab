// SPDX-License-Identifier: BSD-3-Clause
// Connections wait here until their request is whole; only then a thread takes them.
//
// The HTTP library gives a thread to every connection from the moment it is made, so that a few that send nothing, or one byte
// a second, keep everybody else out. Any user of the machine can make such connections: they need no key. Here one thread
// watches all that wait; each has so long to send the head of a request, and when there are too many, the one that has waited
// longest goes. After its answer a connection waits again.
#pragma once

#include <httplib.h>

#include <functional>
#include <memory>
#include <string>

namespace hfrac::web {

/** An accepted connection and what it has sent that nobody has read yet. Closed when it is gone. */
struct Connection {
  explicit Connection(int descriptor) : socket(descriptor) {}
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection();

  int socket;
  std::string received;
  int requests = 0;  ///< answered so far
};

/** Reads what a connection has sent, and then from its socket; writes to its socket. No call takes longer than a few
 * seconds if the other side does nothing. */
class ConnectionStream : public httplib::Stream {
 public:
  explicit ConnectionStream(Connection& connection) : connection_(connection) {}
  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* bytes, size_t size) override;
  ssize_t write(const char* bytes, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return connection_.socket; }

 private:
  Connection& connection_;
};

class WaitingRoom {
 public:
  /** Answers the one request that is whole; says whether the connection may wait for another. */
  using Answer = std::function<bool(Connection&)>;

  WaitingRoom(size_t threads, Answer answer);
  WaitingRoom(const WaitingRoom&) = delete;
  WaitingRoom& operator=(const WaitingRoom&) = delete;
  /** Closes those that wait; requests under way are answered first. */
  ~WaitingRoom();

  /** Takes over an accepted socket. */
  void take(int socket);

 private:
  class Room;
  std::unique_ptr<Room> room_;
};

}  // namespace hfrac::web
