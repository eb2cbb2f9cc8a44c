#include "serve/http/events.hpp"

#include <gtest/gtest.h>

#include <array>

#include "client.hpp"

namespace changeover::serve::events_test {
namespace {

// All that comes until the feed holds this text, or has ended.
std::string read_until(EventFeed& feed, const std::string& part) {
  std::string text;
  std::array<char, 64> room{};
  test::eventually([&] {
    std::size_t count = 0;
    const auto read = feed.read(room, count, [] {});
    text.append(room.data(), count);
    return read == EventFeed::Read::ended || text.find(part) != std::string::npos;
  });
  return text;
}

TEST(Events, ReachEveryListener) {
  EventHub hub;
  const auto one = hub.listen();
  const auto other = hub.listen();
  hub.publish("search", "1", "{\"id\":1}");
  for (const auto& feed : {one, other}) {
    const std::string text = read_until(*feed, "{\"id\":1}\n\n");
    EXPECT_TRUE(text.starts_with("event: hello\n")) << text;
    EXPECT_NE(text.find("event: search\ndata: {\"id\":1}\n\n"), std::string::npos) << text;
  }
}

TEST(Events, OfAKeyTheLastCounts) {
  EventHub hub;
  const auto feed = hub.listen();
  for (int i = 0; i < 1000; ++i) {
    hub.publish("search", "1", std::to_string(i));
  }
  const std::string text = read_until(*feed, "data: 999\n\n");
  EXPECT_LT(text.size(), 500U);
}

TEST(Events, AreForgottenWithTheirListener) {
  EventHub hub;
  auto feed = hub.listen();
  EXPECT_EQ(hub.listeners(), 1U);
  feed.reset();
  EXPECT_EQ(hub.listeners(), 0U);
}

TEST(Events, EndWithTheHub) {
  EventHub hub;
  const auto feed = hub.listen();
  bool told = false;
  feed->on_more([&] { told = true; });
  read_until(*feed, "data: {}\n\n");
  std::array<char, 64> room{};
  std::size_t count = 0;
  bool paused = false;
  EXPECT_EQ(feed->read(room, count, [&] { paused = true; }), EventFeed::Read::nothing_yet);
  EXPECT_TRUE(paused);
  hub.close();
  EXPECT_TRUE(told);
  EXPECT_EQ(feed->read(room, count, [] {}), EventFeed::Read::ended);
  EXPECT_EQ(read_until(*hub.listen(), "never"), "event: hello\ndata: {}\n\n");
}

TEST(Events, WhoNeverReadsIsLetGo) {
  EventHub hub;
  const auto feed = hub.listen();
  const std::string large(600'000, 'x');
  std::array<char, 64> room{};
  std::size_t count = 0;
  EXPECT_TRUE(test::eventually([&] {
    hub.publish("search", "1", large);
    // Reads nothing unless the feed has ended.
    return feed->read(std::span(room).first(0), count, [] {}) == EventFeed::Read::ended;
  }));
}

}  // namespace
}  // namespace changeover::serve::events_test
