// Heads of requests that are large, long, many or malformed: each gets one answer, and no other
// client
// gets it.
#include <gmock/gmock.h>

#include <array>
#include <thread>

#include "served.hpp"

namespace changeover::test::heads_test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

class Heads : public OfOneServer {
 protected:
  static std::string host() { return "Host: 127.0.0.1:" + std::to_string(port()) + "\r\n"; }
  /// The reply to a request with these lines more; nothing but this one reply may come.
  static Reply reply_to(const std::string& first, const std::string& lines) {
    Connection connection(port());
    connection.send(first + "\r\n" + lines + "\r\n");
    Reply reply = connection.reply();
    EXPECT_EQ(reply.body.find("HTTP/1.1"), std::string::npos) << reply.body;
    return reply;
  }
  static Reply with(const std::string& lines) {
    return reply_to("GET /api/search HTTP/1.1", host() + lines);
  }
};

std::string times(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    all += text;
  }
  return all;
}

TEST_F(Heads, CookiesOfAnyNumberAreAnswered) {
  for (const int count : {100, 300, 350, 370, 400, 440, 480, 520, 560, 600, 700, 720, 740, 3000}) {
    const Reply reply = with("Cookie: " + times(count, "c=1;") + "\r\n");
    EXPECT_EQ(reply.status, count <= 350 ? 200 : 431) << count;
    if (reply.status != 200) {
      EXPECT_THAT(message_of(reply), HasSubstr("too many lines or cookies")) << count;
    }
  }
  for (const std::string& value : {times(15'000, ";"), times(10'000, "a,"), times(16'000, "\"")}) {
    EXPECT_THAT(with("Cookie: " + value + "\r\n").status, AnyOf(200, 431)) << value.substr(0, 9);
  }
}

// What the library cuts at a zero byte would be judged as another head than was sent.
TEST_F(Heads, ZeroBytesAreRefusedWhereverTheyAre) {
  const std::string zero(1, '\0');
  const std::string address = "127.0.0.1:" + std::to_string(port());
  const auto ask = [](const std::string& first, const std::string& lines) {
    return reply_to(first, lines).status;
  };
  EXPECT_EQ(ask("GET /api/about HTTP/1.1", host() + "X-A: ab\r\n"), 200);
  EXPECT_EQ(ask("GET /api/about HTTP/1.1", host() + "X-A: a" + zero + "b\r\n"), 400);
  EXPECT_EQ(ask("GET /api/about HTTP/1.1", host() + "X-A: a" + zero + "\r\n"), 400);
  EXPECT_EQ(ask("GET /api/about HTTP/1.1", host() + "X-A" + zero + ": a\r\n"), 400);
  EXPECT_EQ(ask("GET /api/about HTTP/1.1", "Host: " + address + zero + ".evil\r\n"), 400);
  EXPECT_EQ(ask("GET /api/about HTTP/1.1", "Host: " + address + zero + "\r\n"), 400);
  EXPECT_EQ(ask("GET /api/ab" + zero + "out HTTP/1.1", host()), 400);
  EXPECT_EQ(ask("GET /api/about" + zero + " HTTP/1.1", host()), 400);
  EXPECT_EQ(ask("GET /api/bounds?v=9&k=3" + zero + " HTTP/1.1", host()), 400);
  EXPECT_EQ(ask("GE" + zero + "T /api/about HTTP/1.1", host()), 400);
  EXPECT_EQ(ask("GET /api/about HTTP/1" + zero + ".1", host()), 400);
}

// Where the body ends cannot be known, so nothing behind it is taken for a request.
TEST_F(Heads, TwoLengthsEndTheConnection) {
  for (const char* const second : {"18", "5"}) {
    Connection connection(port());
    connection.send("POST /api/verify HTTP/1.1\r\n" + host() +
                    "Content-Length: 18\r\nContent-Length: " + second +
                    "\r\n\r\n0 1 2\n0 1 3\n0 2 3\nGET /api/about HTTP/1.1\r\n" + host() + "\r\n");
    while (connection.read_more()) {
    }
    EXPECT_THAT(connection.text(), HasSubstr("HTTP/1.1 400"));
    EXPECT_THAT(connection.text(), HasSubstr("content-length is there twice"));
    EXPECT_EQ(connection.text().find("HTTP/1.1 200"), std::string::npos);
  }
}

TEST_F(Heads, TwoLengthsOfWhatIsRefusedAnywayAreAnsweredToo) {
  for (const char* const line : {"PUT /api/verify", "POST /nowhere", "POST /api/search"}) {
    EXPECT_GE(reply_to(std::string(line) + " HTTP/1.1",
                       host() + "Origin: http://evil.example\r\nContent-Length: 0\r\n"
                                "Content-Length: 0\r\n")
                  .status,
              400)
        << line;
  }
}

// So does a length that is missing, or that only others would see.
TEST_F(Heads, NoLengthEndsTheConnection) {
  for (const char* const length : {"", "Content-Length : 61\r\n", "Content-Length\t: 61\r\n",
                                   "Transfer-Encoding : chunked\r\n"}) {
    Connection connection(port());
    connection.send("POST /api/verify HTTP/1.1\r\n" + host() + length +
                    "\r\nGET /api/about HTTP/1.1\r\n" + host() + "\r\n");
    while (connection.read_more()) {
    }
    EXPECT_THAT(connection.text(), HasSubstr(*length == '\0' ? "HTTP/1.1 411" : "HTTP/1.1 400"));
    EXPECT_EQ(connection.text().find("HTTP/1.1", 1), std::string::npos) << connection.text();
  }
}

TEST_F(Heads, AFormIsNoFile) {
  const auto post = [](const std::string& type, const std::string& body) {
    Connection connection(port());
    connection.send("POST /api/verify HTTP/1.1\r\n" + host() + type +
                    "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
    return connection.reply().status;
  };
  const std::string form = "Content-Type: application/x-www-form-urlencoded; charset=utf-8\r\n";
  const std::string design = "0 1 2\n0 1 3\n0 2 3\n1 2 3\n";
  EXPECT_EQ(post("", design), 200);
  EXPECT_EQ(post(form, design), 200);  // curl --data-binary says that it is one
  EXPECT_EQ(post(form, "# v=4 k=3\n" + design), 200);
  EXPECT_EQ(post(form, "text=0+1+2%0A0+1+3"), 415);
  EXPECT_EQ(post(form, "v=4&k=3"), 415);
  EXPECT_EQ(post("Content-Type: multipart/form-data; boundary=x\r\n", design), 415);
}

TEST_F(Heads, RefusalsSayWhatIsWrong) {
  struct Case {
    std::string first;
    std::string lines;
    int status;
    std::string words;
  };
  const std::string get = "GET /api/about HTTP/1.1";
  const std::string post = "POST /api/verify HTTP/1.1";
  const std::string form = "Content-Type: application/x-www-form-urlencoded\r\n";
  for (
      const auto& [first, lines, status, words] : std::vector<Case>{
          {"GET /" + std::string(9000, 'a') + " HTTP/1.1", host(), 414,
           "the address has more than 8192 bytes; ask for less"},
          {get, "Host: evil.example\r\n", 403,
           "this server does not go by the name in the header Host; use the address that it printed"},
          {get, host() + "Origin: http://evil.example\r\n", 403,
           "pages of other sites are not answered"},
          {get, host() + "X-A : b\r\n", 400, "there is a blank in the name of a header"},
          {get, host() + std::string("X-A: a\0b\r\n", 10), 400,
           "the head of the request has zero bytes, or blanks in its first line"},
          {get, host() + "X: " + std::string(33'000, 'y') + "\r\n", 431,
           "the head of the request has more than 32768 bytes"},
          {get, host() + "Content-Length: 3\r\n\r\nabc", 413, "api/about takes no body"},
          {post, host(), 411, "say in the header Content-Length how many bytes are sent"},
          {post, host() + "Content-Length: 99999999999\r\n", 413,
           "api/verify takes at most 67108864 bytes, not 99999999999"},
          {post, host() + "Content-Length: 0\r\nContent-Encoding: gzip\r\n", 415,
           "send the body as it is, without Content-Encoding"},
          {post, host() + form + "Content-Length: 3\r\n\r\na=b", 415,
           "send the file itself as the body, not a form"},
          {"POST /api/search HTTP/1.1",
           host() + "Content-Type: application/json\r\nContent-Length: 0\r\n", 401,
           "this needs the token of the address that the server printed, in the header "
           "X-Changeover-Token"}}) {
    const Reply reply = reply_to(first, lines);
    EXPECT_EQ(reply.status, status) << words;
    EXPECT_EQ(message_of(reply), words);
  }
}

TEST_F(Heads, LinesOfAnyNumberAndLengthAreAnswered) {
  for (const int count : {300, 370, 390, 400, 440, 450, 480, 500, 550, 600, 700, 900, 3000}) {
    EXPECT_EQ(with(times(count, "X: y\r\n")).status, count <= 370 ? 200 : 431) << count;
  }
  for (int length = 31'000; length <= 34'000; length += 100) {
    const Reply reply = with("X: " + std::string(static_cast<std::size_t>(length), 'y') + "\r\n");
    EXPECT_EQ(reply.status, length <= 32'700 ? 200 : 431) << length;
  }
  for (int length = 8000; length <= 50'000; length += 700) {
    const Reply reply = reply_to(
        "GET /" + std::string(static_cast<std::size_t>(length), 'a') + " HTTP/1.1", host());
    EXPECT_EQ(reply.status, length < 8192 ? 404 : 414) << length;
  }
  // Beyond what is held of a head the library answers, in its own words.
  for (const int length : {90'000, 98'304, 100'000, 400'000}) {
    EXPECT_EQ(with("X: " + std::string(static_cast<std::size_t>(length), 'y') + "\r\n").status,
              431);
  }
}

TEST_F(Heads, MalformedOnesGetOneAnswer) {
  const Reply nowhere = reply_to("GET /api/search HTTP/1.1", "");
  EXPECT_EQ(nowhere.status, 400);
  EXPECT_THAT(message_of(nowhere), HasSubstr("the header Host is missing"));
  for (const char* const length : {"", "-1", "+3", "abc", "3x", "3, 3", "0x3", "1e3"}) {
    const Reply reply = reply_to("POST /api/verify HTTP/1.1",
                                 host() + "Content-Length: " + std::string(length) + "\r\n");
    EXPECT_EQ(reply.status, 400) << length;
    EXPECT_EQ(message_of(reply), "the header Content-Length is not a number of bytes") << length;
    EXPECT_EQ(reply.header("x-content-type-options"), "nosniff");
  }
  const Reply endless =
      reply_to("POST /api/verify HTTP/1.1", host() + "Content-Length: 18446744073709551616\r\n");
  EXPECT_EQ(endless.status, 413);
  EXPECT_EQ(message_of(endless), "the header Content-Length is too large");
  for (const char* const target : {"/api/a b", " /api/search ", "/api/\x01", "/api/\x7f"}) {
    const Reply reply = reply_to("GET " + std::string(target) + " HTTP/1.1", host());
    EXPECT_EQ(reply.status, 400) << target;
    EXPECT_THAT(message_of(reply), HasSubstr("a blank in the address")) << target;
  }
  // A coding that is named, and has no name: the body would never end.
  EXPECT_EQ(with("Transfer-Encoding: \r\n").status, 411);
  const std::string twice = "Content-Type: text/plain\r\nContent-Type: application/json\r\n";
  EXPECT_EQ(reply_to("POST /api/plan HTTP/1.1", host() + "Content-Length: 0\r\n" + twice).status,
            400);
}

TEST_F(Heads, BlanksAndCapitalsMeanNothing) {
  EXPECT_EQ(reply_to("GET /api/search HTTP/1.1",
                     "hOST: \t 127.0.0.1:" + std::to_string(port()) + " \t\r\n")
                .status,
            200);
  EXPECT_EQ(
      ask(port(), "POST", "/api/verify", {{"Content-Encoding", "Identity"}}, "0 1 2\n").status,
      200);
}

// As nc and others do when their input ends.
TEST_F(Heads, WhoSendsNoMoreIsAnswered) {
  for (const auto& [method, target, body] :
       std::vector<std::array<std::string, 3>>{{"GET", "/api/search", ""},
                                               {"GET", "/api/cell?v=9&k=4&kind=linear", ""},
                                               {"GET", "/api/about", ""},
                                               {"POST", "/api/verify", "0 1 2\n"}}) {
    Connection connection(port());
    connection.send(request_text(port(), method, target, {}, body));
    connection.end();
    EXPECT_EQ(connection.reply().status, 200) << target;
  }
}

// Those whose heads are on their way meanwhile hear nothing of what another one did.
TEST_F(Heads, NobodyIsRefusedForAnother) {
  std::vector<std::unique_ptr<Connection>> patient;
  for (int i = 0; i < 8; ++i) {
    patient.push_back(std::make_unique<Connection>(port()));
    patient.back()->send("GET /api/search HTTP/1.1\r\n" + host() + "X: y");
  }
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(with("Content-Length: abc\r\n").status, 400);
    EXPECT_EQ(with("Cookie: " + times(3000, "c;") + "\r\n").status, 431);
    EXPECT_EQ(with("no colon\r\n").status, 400);
  }
  for (const auto& each : patient) {
    each->send("\r\n\r\n");
    EXPECT_EQ(each->reply().status, 200);
  }
}

// Those whom the library refuses in its words are still there when others are refused in ours.
TEST_F(Heads, RefusalsAtTheSameTimeReachWhomTheyAreFor) {
  const std::string request = "GET /api/search HTTP/1.1\r\n" + host();
  struct Kind {
    std::string head;
    int status;
    std::string words;  // of its answer
  };
  const std::array<Kind, 3> kinds{
      Kind{request + "X: " + std::string(100'000, 'y') + "\r\n\r\n", 431, "too big"},
      Kind{request + "Content-Length: abc\r\n\r\n", 400, "Content-Length is not a number of bytes"},
      Kind{request + "Cookie: " + times(3000, "c=1;") + "\r\n\r\n", 431,
           "too many lines or cookies"}};
  for (int round = 0; round < 5; ++round) {
    std::vector<std::jthread> clients;
    for (std::size_t i = 0; i < 24; ++i) {
      clients.emplace_back([&kind = kinds[i % 3]] {
        Connection connection(port());
        connection.send(kind.head);
        const Reply reply = connection.reply();
        while (connection.read_more()) {
        }
        EXPECT_EQ(reply.status, kind.status);
        EXPECT_THAT(reply.body, HasSubstr(kind.words));
        EXPECT_EQ(connection.text(), "");
      });
    }
  }
}

}  // namespace
}  // namespace changeover::test::heads_test
