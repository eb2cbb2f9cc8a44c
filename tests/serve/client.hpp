// A browser in sixty lines: bytes to a socket, bytes back. What it sends need not be HTTP.
#pragma once

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace changeover::test {

/// How long a client waits for more, in milliseconds.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int usual_patience = 600'000;  // the table of all cells takes minutes
#else
inline constexpr int usual_patience = 60'000;
#endif

struct Reply {
  int status = 0;                              ///< 0: none came
  std::map<std::string, std::string> headers;  ///< names in lower case
  std::string body;

  [[nodiscard]] std::string header(const std::string& name) const {
    const auto found = headers.find(name);
    return found == headers.end() ? std::string() : found->second;
  }
};

/// A connection to the server that is at home on this port. Nothing is waited for longer than a
/// minute.
class Connection {
 public:
  explicit Connection(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    open_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~Connection() { ::close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Whether all of it was taken.
  bool send(std::string_view bytes) const {
    while (open_ && !bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) {
        return false;
      }
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return open_;
  }

  /// There is nothing more to say; what comes back is still read.
  void end() const { ::shutdown(socket_, SHUT_WR); }

  /// Whether the server has read all that was sent, which the system's table of sockets says.
  [[nodiscard]] bool was_read() const {
    sockaddr_in own{};
    socklen_t size = sizeof own;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size);
    sockaddr_in servers{};
    ::getpeername(socket_, reinterpret_cast<sockaddr*>(&servers), &size);
    const auto name = [](const sockaddr_in& address) {
      return fmt::format("{:08X}:{:04X}", address.sin_addr.s_addr, ntohs(address.sin_port));
    };
    std::ifstream table("/proc/net/tcp");
    std::string number;
    std::string local;
    std::string remote;
    std::string state;
    std::string queues;  // to be sent, and to be read
    for (std::string line; std::getline(table, line);) {
      std::istringstream(line) >> number >> local >> remote >> state >> queues;
      if (local == name(servers) && remote == name(own)) {
        return queues.ends_with(":00000000");
      }
    }
    return false;
  }

  /// More bytes into text(); false at the end.
  bool read_more(int patience = usual_patience) {
    pollfd ready{.fd = socket_, .events = POLLIN, .revents = 0};
    std::array<char, 65'536> room{};
    if (::poll(&ready, 1, patience) != 1) {
      return false;
    }
    const ssize_t got = ::recv(socket_, room.data(), room.size(), 0);
    if (got <= 0) {
      return false;
    }
    text_.append(room.data(), static_cast<std::size_t>(got));
    return true;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

  /// Waits until the text holds this.
  bool read_until(std::string_view part) {
    while (text_.find(part) == std::string::npos) {
      if (!read_more()) {
        return false;
      }
    }
    return true;
  }

  /// One reply, taken off the text. To a HEAD there comes no body.
  Reply reply(bool has_body = true) {
    Reply reply;
    if (!read_until("\r\n\r\n")) {
      return reply;
    }
    const std::size_t head_end = text_.find("\r\n\r\n") + 4;
    const std::string head = text_.substr(0, head_end);
    text_.erase(0, head_end);
    reply.status = std::stoi(head.substr(head.find(' ') + 1));
    for (std::size_t at = head.find("\r\n") + 2; at + 2 < head.size();) {
      const std::size_t end = head.find("\r\n", at);
      const std::size_t colon = head.find(':', at);
      std::string name = head.substr(at, colon - at);
      std::ranges::transform(name, name.begin(),
                             [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      reply.headers[name] = head.substr(colon + 2, end - colon - 2);
      at = end + 2;
    }
    const std::string length = reply.header("content-length");
    const std::size_t bytes = length.empty() || !has_body ? 0 : std::stoul(length);
    while (text_.size() < bytes && read_more()) {
    }
    reply.body = text_.substr(0, bytes);
    text_.erase(0, bytes);
    return reply;
  }

 private:
  int socket_;
  bool open_ = false;
  std::string text_;
};

using Headers = std::map<std::string, std::string>;

/// A request as a browser of this machine would send it; other headers replace those that go with
/// it.
inline std::string request_text(std::uint16_t port, const std::string& method,
                                const std::string& target, const Headers& others = {},
                                const std::string& body = "") {
  Headers headers{{"Host", "127.0.0.1:" + std::to_string(port)}};
  if (!body.empty() || method == "POST") {
    headers["Content-Length"] = std::to_string(body.size());
    headers["Content-Type"] = "application/octet-stream";
  }
  for (const auto& [name, value] : others) {
    headers[name] = value;
  }
  std::string text = method + " " + target + " HTTP/1.1\r\n";
  for (const auto& [name, value] : headers) {
    text += value.empty() ? "" : name + ": " + value + "\r\n";
  }
  return text + "\r\n" + body;
}

inline Reply ask(std::uint16_t port, const std::string& method, const std::string& target,
                 const Headers& others = {}, const std::string& body = "") {
  Connection connection(port);
  connection.send(request_text(port, method, target, others, body));
  return connection.reply(method != "HEAD");
}

inline Reply get(std::uint16_t port, const std::string& target, const Headers& others = {}) {
  return ask(port, "GET", target, others);
}

/// Waits up to a minute for something to become true.
template <typename Condition>
bool eventually(Condition&& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    ::usleep(10'000);
  }
  return true;
}

}  // namespace changeover::test
