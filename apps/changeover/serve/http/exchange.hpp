// Requests on their way, as the server keeps them while libmicrohttpd reads them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "serve/http/lanes.hpp"
#include "serve/http/message.hpp"
#include "serve/http/microhttpd.hpp"
#include "serve/http/router.hpp"

namespace changeover::serve {

/// One request on its way.
struct Exchange {
  MHD_Connection* connection = nullptr;
  int socket = -1;
  std::thread::id thread = std::this_thread::get_id();  // of libmicrohttpd, always the same
  std::string target;                                   // as it came
  Request request = {};
  const Route* route = nullptr;
  std::optional<Response> response = {};
  std::size_t head_bytes = 0;  // of the head, as far as libmicrohttpd hands it out
  std::size_t expected = 0;    // bytes of the body
  std::size_t held = 0;        // of the body
  std::size_t untaken = 0;     // bytes of the answer, if they are held for this exchange alone
  bool blank_in_name = false;  // of a header: others read "Content-Length : 3" as a length
  bool begun = false;
  std::optional<Lane> lane = {};  // in which it waits for its answer
  bool refused_at_once = false;
};

/// The exchanges whose address has been read, and the rest of the head not yet.
class Heads {
 public:
  void add(Exchange& exchange) {
    const std::scoped_lock lock(mutex_);
    all_.insert(&exchange);
  }
  void remove(Exchange& exchange) {
    const std::scoped_lock lock(mutex_);
    all_.erase(&exchange);
  }
  /// The one that libmicrohttpd is looking at on this thread; nullptr if its head is not complete.
  /// All others of the thread wait for lines, as soon as a head is complete it goes on or is
  /// refused; or they are being refused by the library before that, which looks as if their heads
  /// had come, with no bytes.
  [[nodiscard]] Exchange* complete() {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find_if(all_, [](const Exchange* each) {
      if (each->thread != std::this_thread::get_id()) {
        return false;
      }
      const MHD_ConnectionInfo* const head =
          MHD_get_connection_info(each->connection, MHD_CONNECTION_INFO_REQUEST_HEADER_SIZE);
      return head != nullptr && head->header_size > 0;
    });
    return found == all_.end() ? nullptr : *found;
  }

 private:
  std::mutex mutex_;
  std::set<Exchange*> all_;
};

}  // namespace changeover::serve
