// A socket that listens on an address of this machine.
#pragma once

#include <cstdint>
#include <string>

namespace changeover::serve {

struct Listening {
  int socket = -1;
  std::uint16_t port = 0;
  bool loopback = false;  ///< it cannot be reached from another machine
};

/// Listens on a name or number of this machine; port 0 picks one that is free. The caller closes
/// the socket.
/// @throws MissingResource with one line if the port is taken or the address is none of this
/// machine.
[[nodiscard]] Listening listen_on(const std::string& host, std::uint16_t port);

/// "127.0.0.1:8080", "[::1]:8080".
[[nodiscard]] std::string with_port(const std::string& host, std::uint16_t port);

}  // namespace changeover::serve
