#include "serve/http/guard.hpp"

#include <gtest/gtest.h>

#include <set>

namespace changeover::serve::guard_test {
namespace {

Request asked(std::map<std::string, std::string> headers, const std::string& path = "api/about") {
  Request request;
  request.method = "GET";
  request.path = path;
  request.headers = std::move(headers);
  return request;
}

Refusal refusal_of(const Guard& guard, const Request& request, Action action = Action::asks) {
  try {
    guard.check(request, action);
    return {200, ""};
  } catch (const Refusal& refusal) {
    return refusal;
  }
}

int status_of(const Guard& guard, const Request& request, Action action = Action::asks) {
  return refusal_of(guard, request, action).status;
}

const Guard& guard() {
  static const Guard guard({"127.0.0.1:8080", "localhost:8080", "[::1]:8080"}, "secret");
  return guard;
}

TEST(Guard, TakesTheNamesOfTheServerOnly) {
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "LOCALHOST:8080", "[::1]:8080"}) {
    EXPECT_EQ(status_of(guard(), asked({{"host", host}})), 200) << host;
  }
  for (const char* host :
       {"evil.example", "127.0.0.1", "127.0.0.1:80", "localhost:8080.evil.example",
        "evil.example:8080", "127.0.0.1:8080 ", "0x7f000001:8080"}) {
    EXPECT_EQ(status_of(guard(), asked({{"host", host}})), 403) << host;
  }
  EXPECT_EQ(status_of(guard(), asked({})), 400);
}

TEST(Guard, RefusesPagesOfOtherSites) {
  const std::string host = "127.0.0.1:8080";
  EXPECT_EQ(status_of(guard(), asked({{"host", host}, {"origin", "http://127.0.0.1:8080"}})), 200);
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:8080",
                             "http://127.0.0.1:8081", "http://127.0.0.1:8080.evil.example"}) {
    EXPECT_EQ(status_of(guard(), asked({{"host", host}, {"origin", origin}})), 403) << origin;
  }
  EXPECT_EQ(status_of(guard(), asked({{"host", host}, {"sec-fetch-site", "cross-site"}})), 403);
  EXPECT_EQ(status_of(guard(), asked({{"host", host}, {"sec-fetch-site", "same-site"}})), 403);
  EXPECT_EQ(status_of(guard(), asked({{"host", host}, {"sec-fetch-site", "same-origin"}})), 200);
  // Other pages may link to the page.
  EXPECT_EQ(status_of(guard(), asked({{"host", host}, {"sec-fetch-site", "cross-site"}}, "")), 200);
}

TEST(Guard, AsksForTheTokenWhereSomethingChanges) {
  std::map<std::string, std::string> headers{{"host", "127.0.0.1:8080"}};
  EXPECT_EQ(status_of(guard(), asked(headers)), 200);
  EXPECT_EQ(status_of(guard(), asked(headers), Action::changes), 401);
  for (const char* wrong : {"", "secre", "secrets", "Secret", "secretsecret"}) {
    headers["x-changeover-token"] = wrong;
    EXPECT_EQ(status_of(guard(), asked(headers), Action::changes), 401) << wrong;
  }
  headers["x-changeover-token"] = "secret";
  EXPECT_EQ(status_of(guard(), asked(headers), Action::changes), 200);
}

TEST(Guard, RefusesHeadersThatAreThereTwice) {
  Request request = asked({{"host", "127.0.0.1:8080"}});
  request.repeated = {"host"};
  EXPECT_EQ(status_of(guard(), request), 400);
  EXPECT_EQ(refusal_of(guard(), request).message, "the header host is there twice; send it once");
}

TEST(Token, IsNewEachTimeAndLong) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const std::string token = make_token();
    EXPECT_EQ(token.size(), 64U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
    tokens.insert(token);
  }
  EXPECT_EQ(tokens.size(), 100U);
}

TEST(SameSecret, KnowsEveryDifference) {
  EXPECT_TRUE(same_secret("abc", "abc"));
  for (const char* other : {"", "a", "ab", "abd", "xbc", "abcabc", "abca"}) {
    EXPECT_FALSE(same_secret(other, "abc")) << other;
  }
  EXPECT_FALSE(same_secret("", ""));
}

}  // namespace
}  // namespace changeover::serve::guard_test
