// SPDX-License-Identifier: BSD-3-Clause
// The routes. Bodies are handed out by providers, which the HTTP library does not compress: on loopback
// compressing costs more time than it saves.
#include "web/server/page_server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include "run/files.hpp"
#include "web/server/grid_cache.hpp"
#include "web/server/guards.hpp"
#include "web/server/page_files.hpp"
#include "web/server/run_index.hpp"
#include "web/server/waiting_room.hpp"

namespace hfrac::web {
namespace fs = std::filesystem;

namespace {

using httplib::Request;
using httplib::Response;

constexpr const char* kLoopback = "127.0.0.1";
constexpr size_t kCacheBytes = 512U << 20U;
constexpr size_t kThreads = 12;      // browsers keep six connections open
constexpr int kMostRequests = 1000;  // on one connection
constexpr const char* kPlain = "text/plain; charset=utf-8";
constexpr const char* kCsv = "text/csv; charset=utf-8";
constexpr const char* kJson = "application/json";
constexpr const char* kBytes = "application/octet-stream";

// Scripts, styles and data come from here alone, and no other page may show or read this one.
const httplib::Headers kHeaders = {{"Content-Security-Policy",
                                    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src "
                                    "'self'; img-src 'self' data: blob:; "
                                    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
                                   {"Cross-Origin-Resource-Policy", "same-origin"},
                                   {"Cross-Origin-Opener-Policy", "same-origin"},
                                   {"Referrer-Policy", "no-referrer"},
                                   {"X-Content-Type-Options", "nosniff"},
                                   {"Accept-Ranges", "none"},
                                   {"Cache-Control", "no-store"}};

void answer(Response& response, std::string body, const char* type) {
  const auto kept = std::make_shared<const std::string>(std::move(body));
  if (kept->empty()) {
    response.set_content("", type);
    return;
  }
  response.set_content_provider(
      kept->size(), type, [kept](size_t offset, size_t length, httplib::DataSink& sink) {
        if (offset > kept->size()) return false;
        return sink.write(kept->data() + offset, std::min(length, kept->size() - offset));
      });
}

void refuse(Response& response, int status, const std::string& sentence) {
  response.status = status;
  response.set_content(sentence + "\n", kPlain);
}

/** A file to be saved, read piece by piece: it may be larger than memory. */
void answer_file(Response& response, const fs::path& file) {
  const auto stream = std::make_shared<std::ifstream>(file, std::ios::binary);
  std::error_code error;
  const auto size = static_cast<size_t>(fs::file_size(file, error));
  if (error || !*stream) return refuse(response, 404, "the file cannot be read");
  response.set_header("Content-Disposition",
                      fmt::format("attachment; filename=\"{}\"", file.filename().string()));
  if (size == 0) return response.set_content("", kBytes);
  response.set_content_provider(size, kBytes,
                                [stream](size_t offset, size_t length, httplib::DataSink& sink) {
                                  std::string piece(std::min<size_t>(length, 1U << 20U), '\0');
                                  stream->seekg(static_cast<std::streamoff>(offset));
                                  stream->read(piece.data(), static_cast<std::streamsize>(piece.size()));
                                  if (stream->gcount() <= 0) return false;
                                  return sink.write(piece.data(), static_cast<size_t>(stream->gcount()));
                                });
}

std::vector<std::string> split_names(const std::string& list) {
  std::vector<std::string> names;
  for (size_t begin = 0; begin < list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    if (end > begin) names.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

/** A whole number that is not negative; -1 for anything else. */
int64_t count_in(const std::string& text) {
  if (text.empty() || text.size() > 15) return -1;
  if (!std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; })) return -1;
  return std::stoll(text);
}

/** history.csv grows at its end only, so the page asks for what it has not seen. */
void answer_history(const fs::path& folder, const Request& request, Response& response) {
  const int64_t from = request.has_param("from") ? count_in(request.get_param_value("from")) : 0;
  std::ifstream stream(folder / "history.csv", std::ios::binary | std::ios::ate);
  if (from < 0) return refuse(response, 400, "from must be a number of bytes");
  if (!stream && from == 0) return answer(response, "", kCsv);  // the run has not begun yet
  if (!stream) return refuse(response, 416, "history.csv is not there any more");
  const auto size = static_cast<int64_t>(stream.tellg());
  if (from > size) return refuse(response, 416, "history.csv is shorter than that; it is another run's");
  std::string text(static_cast<size_t>(size - from), '\0');
  stream.seekg(from);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(std::max<std::streamsize>(0, stream.gcount())));
  text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
  answer(response, std::move(text), kCsv);
}

/** The library's server, with a waiting room in place of a thread for every connection. */
class PatientServer : public httplib::Server {
 public:
  PatientServer() {
    new_task_queue = [this] { return new Queue(room_, *this); };  // the server deletes it
  }

  /** The library has five connections wait to be accepted; one beyond that tries again after a second. */
  void lengthen_queue() { ::listen(svr_sock_, 512); }

 private:
  /** The library queues the handling of each accepted socket, which here only hands it on. */
  class Queue : public httplib::TaskQueue {
   public:
    Queue(std::unique_ptr<WaitingRoom>& room, PatientServer& server) : room_(room) {
      room_ = std::make_unique<WaitingRoom>(
          kThreads, [&server](Connection& connection) { return server.answer_one(connection); });
    }
    void enqueue(std::function<void()> hand_on) override { hand_on(); }
    void shutdown() override { room_.reset(); }

   private:
    std::unique_ptr<WaitingRoom>& room_;
  };

  bool process_and_close_socket(socket_t socket) override {
    room_->take(socket);
    return true;
  }

  bool answer_one(Connection& connection) {
    ConnectionStream stream(connection);
    // What follows the head of any other request is its body, not the next request.
    const bool reads = connection.received.starts_with("GET ") || connection.received.starts_with("HEAD ");
    const bool last = !reads || ++connection.requests >= kMostRequests;
    bool closed = last;
    return process_request(stream, last, closed, nullptr) && !closed && !last;
  }

  std::unique_ptr<WaitingRoom> room_;
};

}  // namespace

struct PageServer::Parts {
  Parts(fs::path run, std::string pressures) : folder(std::move(run)), measured(std::move(pressures)) {}

  fs::path folder;
  std::string measured;
  std::string key = random_key();
  int port = 0;
  std::atomic<bool> ended = false;
  GridCache cache{kCacheBytes};
  PatientServer http;

  std::shared_ptr<const Grid> grid_of(const Request& request) {
    const auto file = file_inside(folder, request.get_param_value("file"));
    if (!file || (file->extension() != ".vtu" && file->extension() != ".pvtu"))
      throw GridError("there is no such VTU file in the run");
    return cache.get(*file);
  }

  /** A route below the key; what it throws becomes a sentence. */
  template <class Handler>
  void route(const std::string& pattern, Handler handler) {
    http.Get(fmt::format("/{}{}", key, pattern), [handler](const Request& request, Response& response) {
      try {
        handler(request, response);
      } catch (const GridError& error) {
        refuse(response, 404, error.what());
      } catch (const std::bad_alloc&) {
        refuse(response, 500, "the server is out of memory");
      } catch (const std::exception& error) {
        refuse(response, 500, error.what());
      }
    });
  }

  void add_page() {
    // The page's own addresses are relative to the folder that its address names.
    route("", [this](const Request&, Response& response) { response.set_redirect("/" + key + "/"); });
    for (const PageFile& file : page_files()) {
      const auto give = [file](const Request&, Response& response) {
        answer(response, std::string(file.bytes), file.type.data());
      };
      route(fmt::format("/{}", file.name == "index.html" ? "" : file.name), give);
    }
  }

  void add_data() {
    route("/api/run", [this](const Request&, Response& response) {
      answer(response,
             describe_run(folder).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace),
             kJson);
    });
    route("/api/history",
          [this](const Request& request, Response& response) { answer_history(folder, request, response); });
    route("/api/record", [this](const Request&, Response& response) {
      answer(response, measured.empty() ? run::read_if_there(folder / "record.csv") : measured, kCsv);
    });
    route("/api/grid", [this](const Request& request, Response& response) {
      answer(response, grid_message(*grid_of(request), split_names(request.get_param_value("arrays"))),
             kBytes);
    });
    route("/api/values", [this](const Request& request, Response& response) {
      const auto values = values_of(*grid_of(request), request.get_param_value("of"),
                                    count_in(request.get_param_value("index")));
      answer(response, values.dump(), kJson);
    });
    route("/files/(.+)", [this](const Request& request, Response& response) {
      const auto file = file_inside(folder, request.matches[1].str());
      if (!file) return refuse(response, 404, "there is no such file in the run");
      answer_file(response, *file);
    });
  }

  void set_up() {
    http.set_default_headers(kHeaders);
    http.set_keep_alive_max_count(kMostRequests);
    http.set_tcp_nodelay(true);
    // The library's own choice lets two servers share a port without a word.
    http.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    http.set_pre_routing_handler([](const Request& request, Response& response) {
      if (!is_loopback_host(request.get_header_value("Host"))) {
        refuse(response, 403, "this server answers to localhost only");
        return httplib::Server::HandlerResponse::Handled;
      }
      if (request.method != "GET" && request.method != "HEAD") {
        refuse(response, 405, "this server only reads");
        return httplib::Server::HandlerResponse::Handled;
      }
      // The library sends what lies beyond an answer if a range says so; answers are whole, whatever is asked for.
      const_cast<Request&>(request).ranges.clear();
      return httplib::Server::HandlerResponse::Unhandled;
    });
    http.set_error_handler([](const Request&, Response& response) {
      if (response.body.empty()) response.set_content("there is nothing here\n", kPlain);
    });
    add_page();
    add_data();
  }
};

PageServer::PageServer(fs::path folder, std::string measured)
    : parts_(std::make_unique<Parts>(std::move(folder), std::move(measured))) {
  parts_->set_up();
}

PageServer::~PageServer() = default;

bool PageServer::bind(int port) {
  parts_->port = port;
  if (port == 0) parts_->port = parts_->http.bind_to_any_port(kLoopback);
  const bool bound = port == 0 ? parts_->port > 0 : parts_->http.bind_to_port(kLoopback, port);
  if (bound) parts_->http.lengthen_queue();
  return bound;
}

std::string PageServer::address() const {
  return fmt::format("http://{}:{}/{}/", kLoopback, parts_->port, parts_->key);
}

void PageServer::serve() {
  parts_->http.listen_after_bind();
  parts_->ended = true;
}

// The library forgets a stop that comes before it listens.
void PageServer::stop() {
  while (!parts_->http.is_running() && !parts_->ended)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  parts_->http.stop();
}

}  // namespace hfrac::web
