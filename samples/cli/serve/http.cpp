// SPDX-License-Identifier: MIT
// HTTP/1.1 (RFC 9112), as much of it as one kind of request needs: POST /mcp with a length, a connection each. A library for it brings
// TLS and compression, which every start of the command would pay for.
#include "serve/carriers.hpp"
#include "sinew_formats/error.hpp"
#include "support.hpp"

#ifdef _WIN32

namespace sinew::cli {

void serve_http(Server*, const std::string&) {
  throw Error("sinew serve: not on Windows; call the command for each file");
}

}  // namespace sinew::cli

#else

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <thread>

namespace sinew::cli {
namespace {

constexpr size_t kMostHeader = 16384;
constexpr int kMostConnections = 32, kReadSeconds = 30;

bool is_this_machine(const std::string& host) { return host == "127.0.0.1" || host == "localhost" || host == "::1"; }

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Without a scheme before it and a port behind it.
std::string host_of(std::string text) {
  if (const size_t scheme = text.find("://"); scheme != std::string::npos) text = text.substr(scheme + 3);
  if (!text.empty() && text.front() == '[') return text.substr(1, text.find(']') - 1);
  return lower(text.substr(0, text.find(':')));
}

// A socket, closed with it.
class Socket {
 public:
  explicit Socket(int number) : number_(number) {}
  Socket(Socket&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  Socket& operator=(Socket&&) = delete;
  ~Socket() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

struct Refused {
  int status;
  const char* line;
};

const char* reason(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 202:
      return "Accepted";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 411:
      return "Length Required";
    case 413:
      return "Content Too Large";
    case 503:
      return "Service Unavailable";
    default:
      return "Bad Request";
  }
}

class Connection {
 public:
  Connection(Socket socket, Server* server) : socket_(std::move(socket)), server_(server) {
    const timeval patience = {kReadSeconds, 0};
    (void)setsockopt(socket_.number(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    (void)setsockopt(socket_.number(), SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  }

  void serve() {
    try {
      const std::string body = read_request();
      const auto reply = server_->answer(body, [](const OrderedJson&) {});
      respond(reply ? 200 : 202,
              reply ? reply->dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n" : "");
    } catch (const Refused& refused) {
      respond(refused.status, OrderedJson({{"error", refused.line}}).dump() + "\n");
    }
  }
  void refuse(const Refused& refused) { respond(refused.status, OrderedJson({{"error", refused.line}}).dump() + "\n"); }

 private:
  bool read_more() {
    char bytes[16384];
    const ssize_t count = recv(socket_.number(), bytes, sizeof bytes, 0);
    if (count <= 0) return false;
    read_.append(bytes, static_cast<size_t>(count));
    return true;
  }

  std::string read_request() {
    size_t end = 0;
    while ((end = read_.find("\r\n\r\n")) == std::string::npos) {
      if (read_.size() > kMostHeader) throw Refused{413, "expected a header of at most 16 KiB"};
      if (!read_more()) throw Refused{400, "expected a request of HTTP/1.1"};
    }
    const size_t line_end = read_.find("\r\n");
    const std::string line = read_.substr(0, line_end);
    std::map<std::string, std::string> fields;
    for (size_t at = line_end + 2; at < end;) {
      const size_t stop = std::min(read_.find("\r\n", at), end), colon = read_.find(':', at);
      if (colon == std::string::npos || colon >= stop) throw Refused{400, "expected fields with colons"};
      const size_t value = std::min(read_.find_first_not_of(" \t", colon + 1), stop);
      if (!fields.emplace(lower(read_.substr(at, colon - at)), read_.substr(value, stop - value)).second)
        throw Refused{400, "expected every field once"};
      at = stop + 2;
    }
    check(line, fields);
    const size_t length = length_of(fields), begin = end + 4;
    if (fields.count("expect") != 0) send_all("HTTP/1.1 100 Continue\r\n\r\n");
    while (read_.size() < begin + length)
      if (!read_more()) throw Refused{400, "expected as many bytes as Content-Length says"};
    return read_.substr(begin, length);
  }

  static void check(const std::string& line, const std::map<std::string, std::string>& fields) {
    // Pages of other hosts may send requests to this machine, too: browsers name who asks, and whom.
    const auto host = fields.find("host"), origin = fields.find("origin");
    if (host == fields.end() || !is_this_machine(host_of(host->second)) ||
        (origin != fields.end() && !is_this_machine(host_of(origin->second))))
      throw Refused{403, "expected a request from this machine"};
    if (line.size() < 9 || line.compare(line.size() - 8, 7, "HTTP/1.") != 0)
      throw Refused{400, "expected a request of HTTP/1.1"};
    const size_t space = line.find(' '), last = line.rfind(' ');
    if (line.substr(space + 1, last - space - 1) != "/mcp") throw Refused{404, "expected POST /mcp"};
    if (line.substr(0, space) != "POST") throw Refused{405, "expected POST /mcp"};
  }

  size_t length_of(const std::map<std::string, std::string>& fields) const {
    const auto length = fields.find("content-length");
    if (length == fields.end() || fields.count("transfer-encoding") != 0 || length->second.empty() ||
        length->second.size() > 12 || length->second.find_first_not_of("0123456789") != std::string::npos)
      throw Refused{411, "expected a Content-Length"};
    const unsigned long long bytes = std::stoull(length->second);
    if (bytes > server_->limits().message) throw Refused{413, "expected a shorter message"};
    return static_cast<size_t>(bytes);
  }

  void respond(int status, const std::string& body) {
    send_all("HTTP/1.1 " + std::to_string(status) + " " + reason(status) +
             "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" +
             (status == 405 ? "Allow: POST\r\n" : "") + "Connection: close\r\n\r\n" + body);
  }

  void send_all(const std::string& text) {
    for (size_t sent = 0; sent < text.size();) {
      const ssize_t count = send(socket_.number(), text.data() + sent, text.size() - sent, 0);
      if (count <= 0) return;
      sent += static_cast<size_t>(count);
    }
  }

  Socket socket_;
  Server* server_;
  std::string read_;
};

// Listens; the port that it got goes to `port`.
Socket listen_at(bool six, int* port) {
  Socket listener(socket(six ? AF_INET6 : AF_INET, SOCK_STREAM, 0));
  const int yes = 1;
  (void)setsockopt(listener.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_storage storage = {};
  socklen_t size = 0;
  if (six) {
    sockaddr_in6 at = {};
    at.sin6_family = AF_INET6;
    at.sin6_addr = in6addr_loopback;
    at.sin6_port = htons(static_cast<uint16_t>(*port));
    std::memcpy(&storage, &at, size = sizeof at);
  } else {
    sockaddr_in at = {};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    at.sin_port = htons(static_cast<uint16_t>(*port));
    std::memcpy(&storage, &at, size = sizeof at);
  }
  sockaddr* const address = reinterpret_cast<sockaddr*>(&storage);
  if (listener.number() < 0 || bind(listener.number(), address, size) != 0 ||
      listen(listener.number(), kMostConnections) != 0 || getsockname(listener.number(), address, &size) != 0)
    throw Error("--http: port " + std::to_string(*port) + " cannot be listened to: " + std::strerror(errno));
  const uint16_t got =
      six ? reinterpret_cast<sockaddr_in6*>(address)->sin6_port : reinterpret_cast<sockaddr_in*>(address)->sin_port;
  *port = ntohs(got);
  return listener;
}

}  // namespace

void serve_http(Server* server, const std::string& address) {
  const size_t colon = address.rfind(':');
  const std::string digits = colon == std::string::npos ? "" : address.substr(colon + 1), host = host_of(address);
  if (digits.empty() || digits.size() > 5 || digits.find_first_not_of("0123456789") != std::string::npos ||
      std::stoi(digits) > 65535 || !is_this_machine(host))
    throw UsageError("--http: expected 127.0.0.1:PORT, localhost:PORT or [::1]:PORT, found '" + printable(address) +
                     "'; other machines are not served");
  int port = std::stoi(digits);
  const Socket listener = listen_at(host == "::1", &port);
  std::signal(SIGPIPE, SIG_IGN);  // who goes away before the answer comes
  std::fprintf(stderr, "serving http://%s:%d/mcp\n", host == "::1" ? "[::1]" : host.c_str(), port);
  std::fflush(stderr);
  static std::atomic<int> open_connections{0};
  for (;;) {
    const int number = accept(listener.number(), nullptr, nullptr);
    if (number < 0) {
      if (errno == EINTR || errno == ECONNABORTED || errno == EMFILE || errno == ENFILE) continue;
      throw Error(std::string("--http: ") + std::strerror(errno));
    }
    Connection connection(Socket(number), server);
    if (open_connections >= kMostConnections) {
      connection.refuse({503, "too many connections"});
      continue;
    }
    ++open_connections;
    std::thread([connection = std::move(connection)]() mutable {
      connection.serve();
      --open_connections;
    }).detach();
  }
}

}  // namespace sinew::cli

#endif
