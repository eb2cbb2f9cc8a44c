// The server: connections in, responses out, on top of libmicrohttpd, which is included by
// server.cpp alone.
//
//     Server server({.listening = listen_on("127.0.0.1", 0), .router = router, .guard = guard});
//     …
//     server.stop(1s);
//
// Every request is looked at by the guard and the router before its body is read. Then it goes to a
// lane (lanes.hpp), and its connection sleeps until the answer is there. Slow connections are
// closed (deadlines.hpp), bodies together hold at most `most_bytes` of memory, and there are at
// most `connections` of them.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "serve/http/events.hpp"
#include "serve/http/guard.hpp"
#include "serve/http/lanes.hpp"
#include "serve/http/listen.hpp"
#include "serve/http/router.hpp"

namespace changeover::serve {

class Server {
 public:
  struct Settings {
    Listening listening = {};
    std::shared_ptr<const Router> router = {};
    std::shared_ptr<const Guard> guard = {};
    Lanes::Settings lanes = {};
    Deadlines::Settings deadlines = {};
    unsigned connections = 600;
    unsigned connections_of_one = 500;                  ///< from one address
    std::size_t most_bytes = std::size_t{256} << 20;    ///< of all bodies together
    std::size_t most_untaken = std::size_t{512} << 20;  ///< of answers that clients have not taken
    std::function<void(const std::string&)> log = {};   ///< a line a request, if it is wanted
    std::function<void(const std::string&)> complain = {};  ///< a line a fault
  };

  /// Serves from now on, until stop(). The socket is the server's. @throws MissingResource if the
  /// system lacks what it takes.
  explicit Server(Settings settings);
  /// stop() must have said true, or never been called.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Takes no more connections, answers what waits with 503 and closes all. Whether all ended
  /// within that time; if not, some answer is still being made, and only the end of the process
  /// ends it. Feeds of events must have been ended before.
  [[nodiscard]] bool stop(std::chrono::duration<double> patience);

  [[nodiscard]] std::size_t open_connections() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover::serve
