#include "serve/http/guard.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "changeover/core/error.hpp"
#include "core/each.hpp"
#include "core/words.hpp"

namespace changeover::serve {

std::string make_token() {
  std::array<unsigned char, 32> bits{};
  std::size_t got = 0;
  while (got < bits.size()) {
    const ssize_t more = ::getrandom(bits.data() + got, bits.size() - got, 0);
    if (more < 0 && errno != EINTR) {
      throw MissingResource(
          fmt::format("the system gives no random bits: {}; try again", std::strerror(errno)));
    }
    got += more > 0 ? static_cast<std::size_t>(more) : 0;
  }
  return joined(bits, "", [&](const unsigned char byte) { return fmt::format("{:02x}", byte); });
}

bool same_secret(std::string_view given, std::string_view secret) {
  unsigned difference = given.size() == secret.size() ? 0U : 1U;
  for (std::size_t i = 0; i < given.size() && !secret.empty(); ++i) {
    difference |= static_cast<unsigned char>(given[i]) ^
                  static_cast<unsigned>(static_cast<unsigned char>(secret[i % secret.size()]));
  }
  return difference == 0 && !secret.empty();
}

bool Guard::knows(std::string_view host) const {
  return std::ranges::find(hosts_, lower_case(host)) != hosts_.end();
}

void Guard::check(const Request& request, Action action) const {
  for (const char* const once : {"host", "origin", "content-length", "content-type",
                                 "content-encoding", "x-changeover-token"}) {
    if (std::ranges::find(request.repeated, once) != request.repeated.end()) {
      throw Refusal{400, fmt::format("the header {} is there twice; send it once", once)};
    }
  }
  const std::string_view host = request.header("host");
  if (host.empty()) {
    throw Refusal{400, "the header Host is missing; send it"};
  }
  if (!knows(host)) {
    throw Refusal{403,
                  "this server does not go by the name in the header Host; use the address "
                  "that it printed"};
  }
  const std::string_view origin = request.header("origin");
  constexpr std::string_view scheme = "http://";
  const bool own_page = origin.starts_with(scheme) && knows(origin.substr(scheme.size()));
  if (!origin.empty() && !own_page) {
    throw Refusal{403, "pages of other sites are not answered"};
  }
  // Browsers say whether the page that asks is of the same site; they show an address that was
  // typed or followed.
  const bool to_page = !request.path.starts_with("api/");
  const std::string_view site = request.header("sec-fetch-site");
  if (!to_page && !site.empty() && site != "same-origin" && site != "none") {
    throw Refusal{403, "pages of other sites are not answered"};
  }
  if (action == Action::changes && !same_secret(request.header("x-changeover-token"), token_)) {
    throw Refusal{401,
                  "this needs the token of the address that the server printed, in the header "
                  "X-Changeover-Token"};
  }
}

}  // namespace changeover::serve
