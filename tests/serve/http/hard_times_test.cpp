// Clients that are slow, many, gone, or speak no HTTP.
#include <gmock/gmock.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "served.hpp"

namespace changeover::test::hard_times_test {
namespace {

using ::testing::HasSubstr;

serve::ExplorerSettings impatient() {
  serve::ExplorerSettings settings;
  settings.deadlines = {.head = std::chrono::milliseconds(400),
                        .body = std::chrono::milliseconds(400),
                        .reading = std::chrono::milliseconds(1500)};
  return settings;
}

TEST(HardTimes, WhoSendsNoHttpIsLetGo) {
  const OwnServer own(impatient());
  for (const std::string& bytes :
       {std::string("\r\n\r\n"), std::string("GET\r\n\r\n"), std::string(100, '\0'),
        std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc", 9), std::string("GET /"),
        "GET / HTTP/1.1\r\nHost: x\r\n" + std::string(200'000, 'a'),
        "GET / HTTP/1.1\r\n" + std::string(100'000, ':') + "\r\n\r\n"}) {
    Connection connection(own.port());
    connection.send(bytes);
    const Reply reply = connection.reply();
    EXPECT_TRUE(reply.status == 0 || reply.status >= 400) << reply.status;
  }
  EXPECT_EQ(get(own.port(), "/api/search").status, 200);
  EXPECT_TRUE(eventually([&] { return own.server->connections() == 0; }));
}

TEST(HardTimes, ASenderThatTakesTooLongIsLetGo) {
  const OwnServer own(impatient());
  Connection body(own.port());
  body.send("POST /api/verify HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(own.port()) +
            "\r\nContent-Length: 1000\r\n\r\n0 1 2\n");
  Connection head(own.port());
  bool open = head.send("GET / HTTP/1.1\r\n");
  // A header line now and then keeps no connection open.
  for (int i = 0; i < 6000 && open; ++i) {
    ::usleep(10'000);
    open = head.send("X: y\r\n");
  }
  EXPECT_FALSE(open);
  EXPECT_EQ(head.reply().status, 408);
  const Reply late = body.reply();
  EXPECT_EQ(late.status, 408);
  EXPECT_THAT(message_of(late), HasSubstr("too long"));
  EXPECT_EQ(late.header("x-content-type-options"), "nosniff");
  EXPECT_EQ(get(own.port(), "/api/search").status, 200);
}

// Clients that announced much, sent little and went hold no place until their time is up.
TEST(HardTimes, WhoIsGoneIsNoticed) {
  serve::ExplorerSettings settings;
  settings.deadlines.body = std::chrono::hours(1);
  const OwnServer own(settings);
  const std::string host = "Host: 127.0.0.1:" + std::to_string(own.port()) + "\r\n";
  for (int i = 0; i < 600; ++i) {
    Connection connection(own.port());
    connection.send("POST /api/verify HTTP/1.1\r\n" + host + "Content-Length: 60000000\r\n\r\n" +
                    std::string(100, '0'));
  }
  EXPECT_TRUE(eventually([&] { return own.server->connections() == 0; }));
  EXPECT_EQ(get(own.port(), "/api/search").status, 200);
}

// Nor those that went within the lines of a request.
TEST(HardTimes, WhoIsGoneWithinAHeadIsNoticed) {
  serve::ExplorerSettings settings;
  settings.deadlines.head = std::chrono::hours(1);
  const OwnServer own(settings);
  for (int i = 0; i < 200; ++i) {
    Connection connection(own.port());
    connection.send("GET / HTTP/1.1\r\n");
  }
  EXPECT_TRUE(eventually([&] { return own.server->connections() == 0; }));
}

// Who has sent all and says no more is answered, however many do so at once.
TEST(HardTimes, WhoSendsNoMoreIsAnswered) {
  const OwnServer own;
  const std::string body = request_text(own.port(), "POST", "/api/verify", {}, "0 1 2\n");
  const std::string bare = request_text(own.port(), "GET", "/api/bounds?v=9&k=4&kind=circular");
  std::atomic<int> answered = 0;
  constexpr int clients = 4;
  constexpr int requests = 100;
  std::vector<std::thread> all;
  for (int i = 0; i < clients; ++i) {
    all.emplace_back([&] {
      for (int j = 0; j < requests; ++j) {
        Connection patient(own.port());
        patient.send(j % 2 == 0 ? body : bare);
        patient.end();
        answered += patient.reply().status == 200 ? 1 : 0;
      }
    });
  }
  for (std::thread& each : all) {
    each.join();
  }
  EXPECT_EQ(answered, clients * requests);
}

// Nor do clients that stay and only hold connections keep others out.
TEST(HardTimes, WhoHoldsManyConnectionsMakesRoom) {
  serve::ExplorerSettings settings;
  settings.deadlines = {.head = std::chrono::hours(1),
                        .body = std::chrono::hours(1),
                        .reading = std::chrono::hours(1),
                        .crowd = 50,
                        .in_a_crowd = std::chrono::milliseconds(100)};
  const OwnServer own(settings);
  const std::string host = "Host: 127.0.0.1:" + std::to_string(own.port()) + "\r\n";
  std::vector<std::unique_ptr<Connection>> all;
  for (int i = 0; i < 150; ++i) {
    all.push_back(std::make_unique<Connection>(own.port()));
    all.back()->send(i % 3 == 0   ? ""
                     : i % 3 == 1 ? "GET / HTTP/1.1\r\n"
                                  : "POST /api/verify HTTP/1.1\r\n" + host +
                                        "Content-Length: 60000000\r\n\r\n0 1 2\n");
  }
  EXPECT_TRUE(eventually([&] { return own.server->connections() <= 50; }));
  EXPECT_EQ(get(own.port(), "/api/search").status, 200);
  EXPECT_FALSE(all.front()->read_more());  // the first came first
  // Those who are no crowd are waited for.
  EXPECT_GE(own.server->connections(), 40);
}

TEST(HardTimes, WhoNeverReadsIsLetGo) {
  const OwnServer own(impatient());
  Connection connection(own.port());
  // Far more than sockets hold: the design has 30,000 blocks.
  for (int i = 0; i < 40; ++i) {
    connection.send(request_text(own.port(), "GET", "/api/design?v=601&k=4&kind=circular"));
  }
  EXPECT_TRUE(eventually([&] { return own.server->connections() == 0; }));
}

TEST(HardTimes, ListenersThatVanishAreForgotten) {
  const OwnServer own;
  {
    Connection one(own.port());
    Connection other(own.port());
    for (Connection* const each : {&one, &other}) {
      each->send(request_text(own.port(), "GET", "/api/events"));
      ASSERT_TRUE(each->read_until("event: hello"));
      EXPECT_THAT(each->text(), HasSubstr("text/event-stream"));
    }
    EXPECT_EQ(own.server->listeners(), 2U);
  }
  EXPECT_TRUE(eventually([&] { return own.server->listeners() == 0; }));
  EXPECT_TRUE(eventually([&] { return own.server->connections() == 0; }));
}

TEST(HardTimes, ListenersAreLimited) {
  const OwnServer own;
  std::vector<std::unique_ptr<Connection>> all;
  for (int i = 0; i < 64; ++i) {
    all.push_back(std::make_unique<Connection>(own.port()));
    all.back()->send(request_text(own.port(), "GET", "/api/events"));
    ASSERT_TRUE(all.back()->read_until("event: hello"));
  }
  const Reply one_more = get(own.port(), "/api/events");
  EXPECT_EQ(one_more.status, 503);
  EXPECT_EQ(message_of(one_more), "64 streams of events are open; close one");
}

TEST(HardTimes, WorkOfWhoLeavesIsGivenUp) {
  serve::ExplorerSettings settings;
  settings.threads = 2;  // one for long answers
  settings.limits.seconds = std::chrono::hours(1);
  const OwnServer own(std::move(settings));
  for (int i = 0; i < 3; ++i) {
    Connection connection(own.port());
    // Hours of work.
    connection.send(request_text(own.port(), "GET", "/api/table?k=20..30&v=31..800&change=1"));
    ASSERT_TRUE(eventually([&] { return connection.was_read(); }));
  }
  EXPECT_EQ(get(own.port(), "/api/constructions").status, 200);  // on the same thread
}

TEST(HardTimes, LongAnswersEndWithTheirTime) {
  serve::ExplorerSettings settings;
  settings.limits.seconds = std::chrono::milliseconds(300);
  const OwnServer own(std::move(settings));
  const Reply reply = get(own.port(), "/api/table?k=20..30&v=31..800&change=1");
  EXPECT_EQ(reply.status, 503);
  EXPECT_THAT(message_of(reply), HasSubstr("command line"));
}

TEST(HardTimes, CrowdsAreAnswered) {
  const OwnServer own;
  for (const int v : {30, 31}) {
    const std::string body = R"({"v":)" + std::to_string(v) + R"(,"k":6,"seconds":600})";
    ASSERT_EQ(ask(own.port(), "POST", "/api/search", own.token(), body).status, 200);
  }
  const std::vector<std::string> targets{"/",
                                         "/api/about",
                                         "/api/search",
                                         "/api/cell?v=20&k=5&kind=linear",
                                         "/api/design?v=253&k=13&kind=circular",
                                         "/api/table?k=3..5&v=5..12",
                                         "/api/table?k=3..8&v=5..61",
                                         "/api/bounds?v=61&k=4&kind=circular",
                                         "/api/explain?v=61&k=4&kind=circular",
                                         "/api/draw?v=20&k=5&kind=linear"};
  constexpr std::size_t many = 200;
  std::vector<std::unique_ptr<Connection>> all;
  for (std::size_t i = 0; i < many; ++i) {
    all.push_back(std::make_unique<Connection>(own.port()));
    // Every second one is a new question.
    const std::string target =
        i % 2 == 0 ? targets[i / 2 % targets.size()]
                   : "/api/cell?v=" + std::to_string(10 + i / 2) + "&k=4&kind=linear";
    ASSERT_TRUE(all.back()->send(request_text(own.port(), "GET", target)));
  }
  for (const auto& connection : all) {
    EXPECT_EQ(connection->reply().status, 200);
  }
  const auto jobs = json_of(get(own.port(), "/api/search"));
  EXPECT_EQ(jobs[0]["state"], "running");
  EXPECT_EQ(jobs[1]["state"], "running");
  EXPECT_TRUE(own.server->stop(std::chrono::minutes(1)));
}

TEST(HardTimes, StoppingEndsEverything) {
  auto own = std::make_unique<OwnServer>();
  Connection listener(own->port());
  listener.send(request_text(own->port(), "GET", "/api/events"));
  ASSERT_TRUE(listener.read_until("event: hello"));
  Connection worker(own->port());
  worker.send(request_text(own->port(), "GET", "/api/table?k=20..30&v=31..800&change=1"));
  Connection idle(own->port());
  Connection half(own->port());
  half.send("POST /api/verify HTTP/1.1\r\nHost: x\r\nContent-Length: 1000\r\n\r\n0 1 2\n");
  ASSERT_TRUE(eventually([&] { return worker.was_read() && half.was_read(); }));
  EXPECT_TRUE(own->server->stop(std::chrono::minutes(1)));
  own.reset();
  while (listener.read_more()) {
  }
  EXPECT_NE(worker.reply().status, 200);
}

TEST(HardTimes, WhoComesWhileTheServerStopsIsToldSo) {
  for (int round = 0; round < 20; ++round) {
    const OwnServer own;
    std::vector<std::unique_ptr<Connection>> late;
    for (int i = 0; i < 8; ++i) {
      late.push_back(std::make_unique<Connection>(own.port()));
    }
    std::thread stopping([&] { EXPECT_TRUE(own.server->stop(std::chrono::minutes(1))); });
    for (const auto& connection : late) {
      connection->send(request_text(own.port(), "GET", "/api/constructions"));
    }
    for (const auto& connection : late) {
      const int status = connection->reply().status;
      EXPECT_TRUE(status == 200 || status == 503 || status == 0) << status;
    }
    stopping.join();
  }
}

}  // namespace
}  // namespace changeover::test::hard_times_test
