// What is refused, with its status and one clear line; nothing that is sent harms the server.
#include <gmock/gmock.h>

#include "served.hpp"

namespace changeover::test::refusals_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) {
    all += text;
  }
  return all;
}

struct Refused {
  std::string target;
  int status;
  std::string says;
};

using Refusals = OfOneServer;

TEST_F(Refusals, QuestionsThatCannotBe) {
  const std::vector<Refused> cases{
      {"/api/nothing", 404, "nothing at this address"},
      {"/api/", 404, "nothing at this address"},
      {"/api/cell", 400, "kind is missing"},
      {"/api/cell?kind=round&v=5&k=3", 400, "write circular or linear"},
      {"/api/cell?kind=linear&k=3", 400, "v is missing"},
      {"/api/cell?kind=linear&v=x&k=3", 400, "v=x: write a whole number"},
      {"/api/cell?kind=linear&v=-5&k=3", 400, "whole number"},
      {"/api/cell?kind=linear&v=5.0&k=3", 400, "whole number"},
      {"/api/cell?kind=linear&v=&k=3", 400, "whole number"},
      {"/api/cell?kind=linear&v=99999999999999999999999&k=3", 400, "whole number"},
      {"/api/cell?kind=linear&v=5&k=9", 400, "k"},
      {"/api/cell?kind=linear&v=5&k=3&change=4", 400, "change"},
      {"/api/cell?kind=linear&v=5&k=3&strength=9", 400, "strength=9: give 2 to 4"},
      {"/api/cell?kind=linear&v=5&v=6&k=3", 400, "v is given twice"},
      {"/api/cell?kind=linear&v=5&k=3&colour=red", 400, "no parameter 'colour'"},
      {"/api/about?x=1", 400, "takes no parameters"},
      {"/api/table?k=5..3", 400, "range is empty"},
      {"/api/table?k=1..3", 400, "k"},
      {"/api/table?v=2..5000", 413, "more than 20000 cells"},
      {"/api/table?k=3&v=5..2000", 400, "v = 1000"},
      {"/api/table?change=0", 400, "differ in at least 1"},
      {"/api/heatmap?k=3&v=5..9", 400, "kind is missing"},
      {"/api/heatmap?k=3&v=5..9&kind=linear&theme=pink", 400, "light, dark"},
      {"/api/design", 400, "name a design by v"},
      {"/api/design?v=5&label=x", 400, "two ways"},
      {"/api/design?label=unknown", 404, "no design unknown"},
      {"/api/design?label=%1b%5b2J", 404, "no design \\x1b[2J"},
      {"/api/design?file=1", 404, "there is no file 1"},
      {"/api/design?job=1", 404, "there is no search 1"},
      {"/api/design?v=4&k=2", 404, "exists"},
      {"/api/design?v=3001&k=3&kind=circular", 413, "changeover design"},
      {"/api/dossier?v=8&k=5&format=exe", 400, "write html, json"},
      {"/api/dossier?v=4&k=2&format=html", 404, "no circular DCCD(4,2) exists"},
      {"/api/download?v=8&k=5&format=exe", 400, "write text, json"},
      {"/api/draw?v=8&k=5&picture=cat", 400, "array"},
      {"/api/draw?v=8&k=5&from=900", 400, "from 900: there are fewer blocks"},
      {"/api/draw?v=8&k=5&from=0", 400, "from 0: blocks are counted from 1"},
      {"/api/draw?v=8&k=5&from=3&to=2", 400, "from 3 to 2: there is no block between"},
      {"/api/draw?v=8&k=5&to=900", 400, "to 900: there are only"},
      {"/api/draw?v=8&k=5&picture=recipe&from=0", 400,
       "from has no meaning with picture recipe; it is for array, stays, coverage, circle"},
      {"/api/draw?v=8&k=5&picture=recipe&to=3", 400, "to has no meaning"},
      {"/api/draw?v=8&k=5&picture=recipe&order=stays", 400, "order has no meaning"},
      {"/api/draw?v=8&k=5&order=first", 400, "it is for stays, coverage"},
      {"/api/draw?v=8&k=5&picture=circle&colour=length", 400, "it is for stays"},
      {"/api/draw?v=8&k=5&picture=stays&leaving=no", 400, "it is for array"},
      {"/api/draw?label=x&k=3", 400, "k has no meaning with label; leave it out"},
      {"/api/explain?label=x&kind=linear", 400, "kind has no meaning with label"},
      {"/api/design?file=1&change=2", 400, "change has no meaning with file"},
      {"/api/download?job=1&strength=2", 400, "strength has no meaning with job"},
      {"/api/design?k=3&kind=linear", 400, "name a design by v"},
      {"/api/draw?v=601&k=4&kind=circular", 413, "draw a part of them with from and to"},
      {"/api/about?x=1&" + repeated("a=1&", 98), 400, "takes no parameters"},
      {"/api/about?" + repeated("a=1&", 100), 414, "more than 100 parameters"},
      {"/api/about?" + repeated("a&", 600), 414, "more than 100 parameters"},
      {"/api/about?" + repeated("a=1&", 2000), 414, "more than 100 parameters"},
      {"/api/explain?v=4&k=2&kind=linear", 404, "exists"},
      {"/api/search?id=7", 404, "there is no search 7"},
      {"/api/cite?label=x", 404, "no design x"},
      {"/api/verify", 405, "use POST"},
      {"/index.html?x=1", 400, "no parameter 'x'"},
      {"/api/cell%00?kind=linear", 400, "zero byte"},
      {"/" + std::string(10'000, 'a'), 414, "the address has more than 8192 bytes"},
  };
  for (const Refused& each : cases) {
    const Reply reply = get(port(), each.target);
    EXPECT_EQ(reply.status, each.status) << each.target.substr(0, 100) << "\n" << reply.body;
    EXPECT_THAT(message_of(reply), HasSubstr(each.says)) << each.target.substr(0, 100);
    EXPECT_EQ(message_of(reply).find('\n'), std::string::npos);
  }
}

TEST_F(Refusals, PathsLeadNowhereElse) {
  EXPECT_EQ(get(port(), "/").status, 200);
  EXPECT_EQ(get(port(), "/?token=abc").status, 200);
  EXPECT_EQ(get(port(), "/assets/app.js").header("content-type"), "text/javascript; charset=utf-8");
  for (const char* const path :
       {"/../outside.txt", "/assets/../../outside.txt", "/%2e%2e/outside.txt", "/..%2foutside.txt",
        "//etc/passwd", "/etc/passwd", "/link.txt", "/secret", "/assets", "/assets/",
        "/./index.html", "/assets//app.js", "/index.html/", "/INDEX.HTML", "/%00",
        "/assets\\app.js"}) {
    const Reply reply = get(port(), path);
    EXPECT_TRUE(reply.status == 404 || reply.status == 400) << path << reply.status;
    EXPECT_EQ(reply.body.find("not a page"), std::string::npos) << path;
    EXPECT_EQ(reply.body.find("root:"), std::string::npos) << path;
  }
}

TEST_F(Refusals, EveryAnswerHasTheHeadersOfSafety) {
  for (const char* const target :
       {"/", "/assets/app.js", "/api/about", "/api/nothing", "/api/cell"}) {
    const Reply reply = get(port(), target);
    EXPECT_EQ(reply.header("content-security-policy"),
              "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: "
              "blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors "
              "'none'");
    EXPECT_EQ(reply.header("x-content-type-options"), "nosniff");
    EXPECT_EQ(reply.header("referrer-policy"), "no-referrer");
    EXPECT_EQ(reply.header("cross-origin-opener-policy"), "same-origin");
    EXPECT_EQ(reply.header("cross-origin-resource-policy"), "same-origin");
    EXPECT_EQ(reply.header("access-control-allow-origin"), "");
  }
}

// A page that another site opened must not be in that site's hands. What its user or the explorer
// itself opened has no opener elsewhere.
TEST_F(Refusals, PagesThatOtherSitesOpenAreCutOffFromThem) {
  const auto policy = [this](const char* from) {
    return get(port(), "/", {{"Sec-Fetch-Site", from}}).header("cross-origin-opener-policy");
  };
  EXPECT_EQ(policy("cross-site"), "same-origin");
  EXPECT_EQ(policy("same-site"), "same-origin");
  EXPECT_EQ(policy("unknown"), "same-origin");
  EXPECT_EQ(policy("none"), "");
  EXPECT_EQ(policy("same-origin"), "");
}

TEST_F(Refusals, StrangersAreNotAnswered) {
  const std::string own = "127.0.0.1:" + std::to_string(port());
  EXPECT_EQ(get(port(), "/api/about", {{"Host", "evil.example"}}).status, 403);
  EXPECT_EQ(get(port(), "/", {{"Host", "evil.example:" + std::to_string(port())}}).status, 403);
  EXPECT_EQ(get(port(), "/api/about", {{"Host", ""}}).status, 400);
  EXPECT_EQ(get(port(), "/api/about", {{"Host", "localhost:" + std::to_string(port())}}).status,
            200);
  EXPECT_EQ(ask(port(), "POST", "/api/verify", {{"Origin", "http://evil.example"}}, "0 1\n").status,
            403);
  EXPECT_EQ(ask(port(), "POST", "/api/verify", {{"Origin", "http://" + own}}, "0 1 2\n").status,
            200);
  Connection twice(port());
  twice.send("GET /api/about HTTP/1.1\r\nHost: " + own + "\r\nHost: evil.example\r\n\r\n");
  EXPECT_EQ(twice.reply().status, 400);
}

TEST_F(Refusals, OnlyTheTokenChangesSomething) {
  for (const char* const target :
       {"/api/search", "/api/search/stop?id=1", "/api/search/keep?id=1", "/api/catalog/add"}) {
    Headers wrong = own_->token();
    wrong["X-Changeover-Token"].front() ^= 1;
    EXPECT_EQ(ask(port(), "POST", target).status == 401, target != std::string("/api/search"))
        << target;  // which wants JSON first
    EXPECT_EQ(ask(port(), "POST", target, wrong).status, 401) << target;
  }
}

TEST_F(Refusals, MethodsThatThereAreNot) {
  for (const char* const method : {"PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "POST", "BREW"}) {
    const Reply reply = ask(port(), method, "/api/about");
    EXPECT_EQ(reply.status, 405) << method;
    EXPECT_EQ(reply.header("allow"), "GET, HEAD") << method;
  }
  EXPECT_EQ(ask(port(), "PUT", "/index.html").header("allow"), "GET, HEAD");
  const Reply head = ask(port(), "HEAD", "/api/about");
  EXPECT_EQ(head.status, 200);
  EXPECT_NE(head.header("content-length"), "0");
  EXPECT_EQ(ask(port(), "HEAD", "/api/events").status, 200);
}

TEST_F(Refusals, DesignsThatAreTooLongAreNotBuiltFirst) {
  // 5.4 GB of text, and a minute to build.
  const Reply reply = ask(port(), "GET", "/api/design?v=60000&k=30000");
  EXPECT_EQ(reply.status, 413);
  EXPECT_NE(reply.body.find(" blocks, too many for a page; changeover design"), std::string::npos);
}

TEST_F(Refusals, BodiesThatAreNotTaken) {
  const std::string json = "application/json";
  const auto status = [&](const std::string& target, const Headers& headers,
                          const std::string& body) {
    return ask(port(), "POST", target, headers, body).status;
  };
  EXPECT_EQ(status("/api/plan", {{"Content-Type", "text/plain"}}, "{}"), 415);
  EXPECT_EQ(status("/api/verify", {{"Content-Type", "multipart/form-data; boundary=x"}}, "--x--"),
            415);
  // What curl and others say of a file unless they are told what it is.
  EXPECT_EQ(status("/api/verify", {{"Content-Type", "application/x-www-form-urlencoded"}},
                   "0 1 2\n1 2 3\n2 3 0\n"),
            200);
  EXPECT_EQ(status("/api/verify", {{"Content-Encoding", "gzip"}}, "0 1 2\n"), 415);
  EXPECT_EQ(status("/api/verify", {{"Content-Encoding", "identity"}}, "0 1 2\n"), 200);
  EXPECT_EQ(status("/api/verify", {{"Content-Length", ""}}, ""), 411);
  EXPECT_EQ(status("/api/plan", {{"Content-Type", json}}, std::string((1 << 20) + 1, ' ')), 413);
  EXPECT_EQ(status("/api/verify", {{"Content-Length", "99999999999"}}, ""), 413);
  EXPECT_EQ(status("/api/verify", {{"Content-Length", "99999999999999999999999999"}}, ""), 413);
  EXPECT_EQ(ask(port(), "GET", "/api/about", {}, "a body").status, 413);
  Connection chunked(port());
  chunked.send("POST /api/verify HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port()) +
               "\r\nTransfer-Encoding: chunked\r\n\r\n5\r\n0 1 2\r\n0\r\n\r\n");
  EXPECT_EQ(chunked.reply().status, 411);
}

TEST_F(Refusals, JsonThatIsNotWhatWasAsked) {
  const std::vector<Refused> cases{
      {"", 422, ""},
      {"[]", 422, "object"},
      {"{", 422, "not JSON"},
      {"{}", 422, "missing"},
      {std::string(100'000, '['), 422, "JSON nested more than 256 deep; use fewer levels"},
      {"{\"parts\":" + std::string(300, '[') + std::string(300, ']') + "}", 422, "256"},
      {R"({"parts":9,"at_once":3,"test_cost":1,"change_cost":1,"colour":1})", 422,
       "unknown key 'colour'"},
      {R"({"parts":["b",{"name":"a","cost":1,"slot":"CPU"}],"at_once":2,"test_cost":1,"change_cost":1})",
       422, "parts has a column slot"},
      {R"({"parts":[{"name":"a","Cost":1},"b"],"at_once":2,"test_cost":1,"change_cost":1})", 422,
       "parts[0]: write \"name\" or"},
      {R"({"parts":9,"at_once":"3","test_cost":1,"change_cost":1})", 422,
       "at_once: write a whole number"},
      {R"({"parts":9,"at_once":-3,"test_cost":1,"change_cost":1})", 422, "whole number"},
      {R"({"parts":9,"at_once":1,"test_cost":1,"change_cost":1})", 422,
       "at_once 1: no pair can meet"},
      {R"({"parts":1,"at_once":3,"test_cost":1,"change_cost":1})", 422, "two parts"},
      {R"({"parts":99999,"at_once":3,"test_cost":1,"change_cost":1})", 422, ""},
      {R"({"parts":9,"at_once":3,"test_cost":-1,"change_cost":1})", 422, "test_cost"},
      {R"({"parts":9,"at_once":3,"test_cost":true})", 422, "test_cost"},
      {R"({"parts":{"file":"/etc/hostname"},"at_once":3,"test_cost":1,"change_cost":1})", 422,
       "the server opens no files"},
      {R"({"parts":9,"at_once":3,"test_cost":1,"change_cost":1,"compact":true})", 422,
       "compact: not here"},
      {R"({"parts":9,"items":9,"at_once":3,"test_cost":1,"change_cost":1})", 422,
       "parts means the same"},
      {R"({"parts":9,"at_once":3,"test_cost":1,"change_cost":1,"shuffle":5,"benches":2})", 422,
       "shuffle has no meaning with benches"},
      {R"({"parts":9,"at_once":3,"test_cost":1,"change_cost":1,"format":"changeover-job/2"})", 422,
       "changeover-job/1"},
      {R"({"parts":9,"at_once":3,"test_cost":1,"change_cost":1,"seconds":1e9})", 422, "seconds"},
      {R"({"parts":["a","a"],"at_once":2,"test_cost":1,"change_cost":1})", 422,
       "a second part is called 'a'"},
      {R"({"parts":["a\u0007","b"],"at_once":2,"test_cost":1,"change_cost":1})", 422, "parts[0]"},
      {R"({"parts":[1,2],"at_once":2,"test_cost":1,"change_cost":1})", 422, "parts[0]"},
      {R"({"parts":["a","b"],"at_once":2,"test_cost":1,"change_cost":1,"pairs":[["a","c"]]})", 422,
       "no part 'c'"},
      {R"({"parts":["a","b"],"at_once":2,"test_cost":1,"change_cost":1,"pairs":[["a","a"]]})", 422,
       "twice"},
      {R"({"parts":["a","b"],"at_once":2,"test_cost":1,"change_cost":1,"pairs":[["a"]]})", 422,
       "pairs[0]: write [a,b]"},
      {R"({"parts":["a","b"],"at_once":2,"test_cost":1,"change_cost":1,"pairs":[]})", 422,
       "no pair"},
      {R"({"parts":["a","b"],"at_once":2,"test_cost":1,"change_cost":1,"done":[["a","a"]]})", 422,
       ""},
  };
  for (const Refused& each : cases) {
    const Reply reply =
        ask(port(), "POST", "/api/plan", {{"Content-Type", "application/json"}}, each.target);
    EXPECT_EQ(reply.status, each.status) << each.target.substr(0, 100) << reply.body;
    EXPECT_THAT(message_of(reply), HasSubstr(each.says)) << each.target.substr(0, 100);
  }
  for (const char* const body :
       {R"({"items":0,"room":3})", R"({"items":10,"room":1})", R"({"items":99999999,"room":3})",
        R"({"items":10,"room":3,"workers":0})", R"({"items":10,"room":3,"pairs":[[0,10]]})",
        R"({"items":10,"room":3,"pairs":[]})", R"({"items":10,"room":3,"bytes_per_item":0})"}) {
    EXPECT_EQ(
        ask(port(), "POST", "/api/loadorder", {{"Content-Type", "application/json"}}, body).status,
        422)
        << body;
  }
}

TEST_F(Refusals, WhatIsWrongInARequestHasItsPlace) {
  struct Placed {
    std::string address;
    std::string body;
    int line;
    int column;
    std::string says;
  };
  const std::vector<Placed> cases{
      {"/api/plan", "{\"parts\":9,\n\"at_once\":\"3\",\"test_cost\":1,\"change_cost\":1}", 2, 11,
       "at_once: write a whole number"},
      {"/api/plan", "{\"parts\":9,\n\"at_once\":1,\"test_cost\":1,\"change_cost\":1}", 2, 11,
       "at_once 1: no pair can meet; give at least 2"},
      {"/api/plan",
       "{\"parts\":9,\"at_once\":3,\"test_cost\":1,\"change_cost\":1,\n\"weekends\":true}", 2, 12,
       "weekends is for first_day; give both"},
      {"/api/plan", "{\"parts\":9,\"at_once\":3,\"test_cost\":1,\"change_cost\":1,\n\"colour\":1}",
       2, 10, "unknown key 'colour'"},
      {"/api/plan",
       "{\"parts\":9,\"at_once\":3,\"test_cost\":1,\"change_cost\":1,\n\"compact\":true}", 2, 11,
       "compact: not here"},
      {"/api/plan",
       "{\"parts\":9,\"at_once\":3,\"test_cost\":1,\"change_cost\":1,\n\"pairs\":[[1,2],\n[1,10]]}",
       3, 1, "pairs[1]: "},
      {"/api/plan",
       "{\"parts\":9,\"at_once\":3,\"test_cost\":1,\"change_cost\":1,\n\"seconds\":61}", 2, 11,
       "seconds: write 0 to 60; the command line takes more"},
      {"/api/loadorder", "{\"items\":9,\n\"room\":1}", 2, 8, "room 1: no two items"},
      {"/api/loadorder", "{\"room\":3,\n\"items\":99999}", 2, 9, "items: write 1 to 20000"},
      {"/api/loadorder", "{\"items\":9,\"room\":3,\n\"bytes_per_item\":0}", 2, 18,
       "item_bytes: write 1 to "},
      {"/api/loadorder", "{\"memory\":9,\"item_bytes\":2,\n\"sizes\":[[0,1],[1,2]]}", 2, 9,
       "sizes has no meaning with item_bytes"},
      {"/api/loadorder", " {\"items\":9}", 1, 2, "items and room are required"},
  };
  for (const Placed& each : cases) {
    const Reply reply =
        ask(port(), "POST", each.address, {{"Content-Type", "application/json"}}, each.body);
    EXPECT_EQ(reply.status, 422) << each.body;
    EXPECT_THAT(message_of(reply), StartsWith(each.says)) << each.body;
    const auto error = json_of(reply)["error"];
    EXPECT_EQ(error["line"], each.line) << each.body << reply.body;
    EXPECT_EQ(error["column"], each.column) << each.body << reply.body;
  }
}

TEST_F(Refusals, DesignsThatAreNone) {
  for (const std::string& body :
       {std::string(),
        std::string("\x7f"
                    "ELF\x01\x02"),
        std::string(200'000, '['),
        std::string("<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY b \"c\">]><a>&b;</a>"),
        std::string("0 1 2\n0 1\n"), std::string("0 1 1\n"),
        std::string("# changeover design v=5 k=3\n7 8 9\n")}) {
    const Reply reply = ask(port(), "POST", "/api/verify", {}, body);
    EXPECT_EQ(reply.status, 422) << body.substr(0, 40) << reply.body;
  }
  // Declared by the client: the file is not at fault.
  EXPECT_EQ(ask(port(), "POST", "/api/verify?k=0", {}, "0 1 2\n").status, 400);
  EXPECT_EQ(ask(port(), "POST", "/api/draw?picture=circle&leaving=yes", {}, "0 1 2\n").status, 400);
}

}  // namespace
}  // namespace changeover::test::refusals_test
