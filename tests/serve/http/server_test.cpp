// What a server says when what it calls fails, when much is sent to it, and when it stops.
#include "serve/http/server.hpp"

#include <gtest/gtest.h>

#include <latch>
#include <new>
#include <stdexcept>
#include <thread>

#include "served.hpp"

namespace changeover::test::server_test {
namespace {

using serve::Request;
using serve::Response;

Response fail_with(const std::string& what) {
  if (what == "memory") {
    throw std::bad_alloc();
  }
  throw std::logic_error(what);
}

/// A server of three addresses on a free port.
class OfFew {
 public:
  explicit OfFew(std::size_t most_bytes = 1000) {
    const serve::Listening listening = serve::listen_on("127.0.0.1", 0);
    port = listening.port;
    auto router = std::make_shared<serve::Router>();
    router->add({.path = "fails", .parameters = {"of"}, .answer = [](const Request& request) {
                   return fail_with(*request.parameter("of"));
                 }});
    router->add({.path = "takes",
                 .method = "POST",
                 .body = serve::Body::any,
                 .most_bytes = 5000,
                 .answer = [](const Request&) { return serve::json_response("{}"); }});
    router->add({.path = "waits", .answer = [this](const Request&) {
                   begun.count_down();
                   may_end.wait();
                   return serve::json_response("{}");
                 }});
    server = std::make_unique<serve::Server>(serve::Server::Settings{
        .listening = listening,
        .router = std::move(router),
        .guard = std::make_shared<const serve::Guard>(
            std::vector<std::string>{"127.0.0.1:" + std::to_string(port)}, "secret"),
        .lanes = {.quick = 1, .slow = 1},
        .most_bytes = most_bytes,
        .complain = [this](const std::string& line) { complaint = line; }});
  }

  std::uint16_t port = 0;
  std::string complaint;
  std::latch begun{1};
  std::latch may_end{1};
  std::unique_ptr<serve::Server> server;
};

TEST(Server, ComplainsOfItsMistakesAndTellsNothingOfThem) {
  const OfFew own;
  const Reply reply = get(own.port, "/fails?of=a%20secret");
  EXPECT_EQ(reply.status, 500);
  EXPECT_EQ(message_of(reply), "the server made a mistake, which its log names");
  EXPECT_EQ(own.complaint, "GET fails: a secret");
}

TEST(Server, SaysThatItHasNoMemory) {
  const OfFew own;
  const Reply reply = get(own.port, "/fails?of=memory");
  EXPECT_EQ(reply.status, 503);
  EXPECT_EQ(message_of(reply), "the server has no memory left for this; try again later");
}

TEST(Server, TakesNotTooMuchAtOnce) {
  const OfFew own;
  EXPECT_EQ(ask(own.port, "POST", "/takes", {}, std::string(900, 'x')).status, 200);
  const Reply reply = ask(own.port, "POST", "/takes", {}, std::string(1100, 'x'));
  EXPECT_EQ(reply.status, 503);
  EXPECT_EQ(message_of(reply), "too much is being sent to the server at once; try again");
}

TEST(Server, AnswersWhatWaitsWhenItStops) {
  OfFew own;
  Connection first(own.port);
  first.send(request_text(own.port, "GET", "/waits"));
  own.begun.wait();
  Connection second(own.port);
  second.send(request_text(own.port, "GET", "/fails?of=x"));
  ASSERT_TRUE(eventually([&] { return second.was_read(); }));
  std::jthread stopping([&] { EXPECT_TRUE(own.server->stop(std::chrono::minutes(1))); });
  ASSERT_TRUE(eventually([&] { return get(own.port, "/nowhere").status == 503; }));
  own.may_end.count_down();
  const Reply reply = second.reply();
  EXPECT_EQ(reply.status, 503);
  EXPECT_EQ(message_of(reply), "the server is stopping; start it again");
}

}  // namespace
}  // namespace changeover::test::server_test
