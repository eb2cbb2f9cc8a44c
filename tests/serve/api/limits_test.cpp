// docs/limits.md, the part on the server: each row at its limit and one beyond it.
#include <functional>
#include <map>

#include "limits_table.hpp"
#include "serve/api/cells.hpp"
#include "served.hpp"

namespace changeover::limits_test {
namespace {

using namespace test;

std::string times(std::uint64_t n, char c) { return std::string(static_cast<std::size_t>(n), c); }

// What the server says to a question, by the number in it: {0, ""} if nothing is refused.
using Ask = std::function<Reply(std::uint64_t)>;

class Limits : public Served {
 protected:
  static Reply send(const std::string& target, const std::string& body) {
    return post(target, body, "application/json");
  }
  static Reply search(const std::string& body) {
    return ask(server_->port(), "POST", "/api/search",
               {{"X-Changeover-Token", server_->token()}, {"Content-Type", "application/json"}},
               body);
  }
  // Without planning the table, which takes long.
  static Reply table(std::uint64_t cells) {
    serve::Request request;
    request.path = "api/table";
    request.parameters = {{"k", "3"}, {"v", "3.." + std::to_string(cells + 2)}};
    try {
      static_cast<void>(serve::table_range_of(request));
    } catch (const serve::Refusal& refusal) {
      const serve::Response response = serve::refused(refusal);
      return {.status = response.status, .headers = {}, .body = *response.body};
    }
    return {.status = 200, .headers = {}, .body = "{}"};
  }
  static std::string number(std::uint64_t n) { return std::to_string(n); }
};

TEST_F(Limits, EachRowOfThePageHoldsAtTheLimitAndOneBeyond) {
  const std::map<std::string, Ask> asks{
      {"target",
       [](std::uint64_t n) {
         const std::string front = "/api/cite?label=";
         return get(front + times(n - front.size(), 'a'));
       }},
      {"design-bytes",
       [](std::uint64_t n) {
         const std::string design = "0 1\n1 2\n0 2\n#";
         return post("/api/verify", design + times(n - design.size(), 'x'));
       }},
      {"json-bytes",
       [](std::uint64_t n) {
         const std::string body = R"({"parts":4,"at_once":2,"test_cost":1,"change_cost":1})";
         return send("/api/plan", body + times(n - body.size(), ' '));
       }},
      {"json-depth",
       [](std::uint64_t n) {
         return send("/api/plan", R"({"parts":)" + times(n - 1, '[') + times(n - 1, ']') + "}");
       }},
      {"table-cells", [](std::uint64_t n) { return table(n); }},
      {"load-items",
       [](std::uint64_t n) {
         return send("/api/loadorder",
                     R"({"items":)" + number(n) + R"(,"room":2,"pairs":[[0,1]]})");
       }},
      {"load-workers",
       [](std::uint64_t n) {
         return send("/api/loadorder", R"({"items":10,"room":3,"workers":)" + number(n) + "}");
       }},
      {"item-bytes",
       [](std::uint64_t n) {
         return send("/api/loadorder", R"({"items":10,"room":3,"item_bytes":)" + number(n) + "}");
       }},
      {"parts",
       [](std::uint64_t n) {
         return send("/api/plan",
                     R"({"at_once":3,"test_cost":1,"change_cost":1,"seconds":0.001,"parts":)" +
                         number(n) + "}");
       }},
      {"plan-seconds",
       [](std::uint64_t n) {
         // Nothing is left to plan, so nothing takes that long.
         return send(
             "/api/plan",
             R"({"parts":2,"at_once":2,"test_cost":1,"change_cost":1,"done":[["1","2"]],"seconds":)" +
                 number(n) + "}");
       }},
      {"search-seconds",
       [](std::uint64_t n) {
         return search(R"({"v":7,"k":3,"kind":"linear","seconds":)" + number(n) + "}");
       }},
      {"strength",
       [](std::uint64_t n) {
         return get("/api/bounds?v=20&k=6&kind=linear&strength=" + number(n));
       }},
  };
  const auto rows = limit_rows(std::string(CHANGEOVER_TEST_DATA) + "/../../docs/limits.md",
                               "Requests to the server");
  for (const auto& [name, row] : rows) {
    const auto question = asks.find(name);
    if (question == asks.end()) {
      ADD_FAILURE() << name << " is on the page and not tried";
      continue;
    }
    const Reply at = question->second(row.limit);
    EXPECT_LT(at.status, 500) << name << ": " << at.body.substr(0, 300);
    EXPECT_TRUE(at.status == 200 || message_of(at) != row.line)
        << name << " is refused at its limit";
    const Reply beyond = question->second(row.limit + 1);
    EXPECT_EQ(beyond.status, row.code) << name;
    EXPECT_EQ(message_of(beyond), row.line) << name;
  }
  EXPECT_EQ(rows.size(), asks.size());
}

}  // namespace
}  // namespace changeover::limits_test
