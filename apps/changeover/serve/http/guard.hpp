// Who may ask: pages of this server and programs of this machine's user, and no page of another
// site.
//
//     Guard guard({"127.0.0.1:8080", "localhost:8080"}, "0f1e…");
//     guard.check(request, Action::asks);            // throws Refusal
//
// A page of another site that a browser shows can make it send requests here. It cannot choose the
// header Host (so another name that leads here, DNS rebinding, is refused), it cannot hide its
// Origin when it posts, and it does not know the token. What changes anything needs the token,
// which is in the address that was printed and nowhere else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "serve/http/message.hpp"

namespace changeover::serve {

/// What a request does.
enum class Action : std::uint8_t {
  asks,     ///< nothing changes
  changes,  ///< something does, or long work begins: needs the token
};

/// 256 random bits of the system, in hexadecimal. @throws MissingResource if it has none.
[[nodiscard]] std::string make_token();

/// Compares in a time that depends on the length of `given` only.
[[nodiscard]] bool same_secret(std::string_view given, std::string_view secret);

class Guard {
 public:
  /// `hosts`: what the header Host may say, in lower case.
  Guard(std::vector<std::string> hosts, std::string token)
      : hosts_(std::move(hosts)), token_(std::move(token)) {}

  [[nodiscard]] const std::string& token() const { return token_; }

  /// @throws Refusal: 400 without one Host, 403 for a foreign Host or Origin, 401 without the
  /// token.
  void check(const Request& request, Action action) const;

 private:
  [[nodiscard]] bool knows(std::string_view host) const;

  std::vector<std::string> hosts_;
  std::string token_;
};

}  // namespace changeover::serve
