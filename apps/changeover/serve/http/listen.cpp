#include "serve/http/listen.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "changeover/core/error.hpp"

namespace changeover::serve {
namespace {

bool is_loopback(const sockaddr& address) {
  if (address.sa_family == AF_INET) {
    constexpr std::uint32_t first_byte = 24;
    constexpr std::uint32_t loopback_net = 127;
    return ntohl(reinterpret_cast<const sockaddr_in&>(address).sin_addr.s_addr) >> first_byte ==
           loopback_net;
  }
  return address.sa_family == AF_INET6 &&
         IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6&>(address).sin6_addr) != 0;
}

std::uint16_t port_of(int socket) {
  sockaddr_storage bound{};
  socklen_t length = sizeof bound;
  if (::getsockname(socket, reinterpret_cast<sockaddr*>(&bound), &length) != 0) {
    return 0;
  }
  return ntohs(bound.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6&>(bound).sin6_port
                                           : reinterpret_cast<sockaddr_in&>(bound).sin_port);
}

}  // namespace

std::string with_port(const std::string& host, std::uint16_t port) {
  return host.find(':') == std::string::npos ? fmt::format("{}:{}", host, port)
                                             : fmt::format("[{}]:{}", host, port);
}

Listening listen_on(const std::string& host, std::uint16_t port) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  const int failure = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (failure != 0) {
    throw MissingResource(fmt::format("--host {}: {}; give an address of this machine", host,
                                      ::gai_strerror(failure)));
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, ::freeaddrinfo);
  const addrinfo& address = *addresses;
  Listening listening;
  listening.loopback = is_loopback(*address.ai_addr);
  listening.socket =
      ::socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, address.ai_protocol);
  const int on = 1;
  constexpr int queue = 512;
  if (listening.socket < 0 ||
      ::setsockopt(listening.socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
      ::bind(listening.socket, address.ai_addr, address.ai_addrlen) != 0 ||
      ::listen(listening.socket, queue) != 0) {
    const int why = errno;
    if (listening.socket >= 0) {
      ::close(listening.socket);
    }
    const std::string mend =
        why == EADDRINUSE ? "; another program listens there: give another --port, or 0 for any"
        : why == EACCES   ? "; give a --port above 1023"
                          : "; give an address of this machine and a free port";
    throw MissingResource(
        fmt::format("cannot listen on {}: {}{}", with_port(host, port), std::strerror(why), mend));
  }
  listening.port = port_of(listening.socket);
  return listening;
}

}  // namespace changeover::serve
