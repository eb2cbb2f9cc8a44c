// Which addresses there are: an exact table, never a file system.
//
//     Router router;
//     router.add({.path = "api/bounds", .parameters = {"v", "k"},
//                 .answer = [](const Request& r) { … }});
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "serve/http/guard.hpp"
#include "serve/http/lanes.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {

/// What may be posted.
enum class Body : std::uint8_t {
  none,
  json,  ///< Content-Type application/json
  any    ///< a file of any type, but no form of several parts
};

struct Route {
  std::string path;
  std::string method = "GET";  ///< HEAD comes with GET
  Action action = Action::asks;
  Body body = Body::none;
  std::size_t most_bytes = 0;                ///< of the body
  std::vector<std::string> parameters = {};  ///< that may be in the query
  std::function<Lane(const Request&)> lane = [](const Request&) { return Lane::quick; };
  /// Called on a thread of the lane. @throws Refusal
  std::function<Response(const Request&)> answer;
};

class Router {
 public:
  /// @throws InternalError if it is there already.
  void add(Route route);

  /// For paths that are none of those, where `has` says that there is something.
  void add_elsewhere(Route route, std::function<bool(const std::string&)> has);

  /// @throws Refusal 404 for a path that there is not, 405 for a method that it does not have, 400
  /// for a parameter that it does not know, 411, 413 or 415 for a body that it does not take.
  [[nodiscard]] const Route& route_of(const Request& request) const;

  /// What a path takes, as in the header Allow; empty if there is no such path.
  [[nodiscard]] std::string allowed(const std::string& path) const;

 private:
  [[nodiscard]] std::string allowed_here(const std::string& path) const;
  [[nodiscard]] bool is_elsewhere(const std::string& path) const;

  std::map<std::pair<std::string, std::string>, Route> routes_;  // by path and method
  Route elsewhere_;
  std::function<bool(const std::string&)> has_;
};

/// The number in the header Content-Length; 0 if there is none. @throws Refusal if it is none.
[[nodiscard]] std::size_t declared_length(const Request& request);

/// Refuses a form where a file is expected. Programs that send a file rarely say what it is, and
/// many say that it is a form (curl does), so the bytes tell: fields are joined by = and &, before
/// any blank or end of a line. @throws Refusal
void refuse_form(const Route& route, const Request& request);

}  // namespace changeover::serve
