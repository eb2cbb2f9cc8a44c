// Runs that are kept: what several people write, and files that are damaged or in the way.
#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <thread>

#include "served.hpp"

namespace changeover::test::runs_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class Runs : public OfOneServer {
 protected:
  static json keep(const json& body) { return asked(*own_, "/api/run", body); }
  static json run(const std::string& id) { return json_of(get(port(), "/api/run?id=" + id)); }
  static Reply result(const std::string& id, const json& body) {
    return act(*own_, "/api/run/result?id=" + id, body.dump());
  }
  static std::string path(const std::string& id) {
    return own_->folder.file("runs/" + id + ".json");
  }
};

TEST_F(Runs, KeepWhatSeveralPeopleWrite) {
  const json kept = keep({{"title", "Pumps"}, {"tests", 3}, {"sheet", {{"a", {1, "ü"}}}}});
  const std::string id = kept["id"];
  EXPECT_EQ(kept["revision"], 1);
  ASSERT_EQ(
      result(id, {{"test", "2"}, {"result", "pass"}, {"by", "Ann"}, {"sheet_revision", 1}}).status,
      200);
  ASSERT_EQ(
      result(id, {{"test", "3"}, {"result", "FAIL"}, {"by", "Bo"}, {"sheet_revision", 1}}).status,
      200);
  ASSERT_EQ(result(id, {{"test", "2"}, {"result", ""}, {"sheet_revision", 1}}).status, 200);
  const json now = run(id);
  EXPECT_EQ(now["sheet"], json::parse(R"({"a":[1,"ü"]})"));
  EXPECT_EQ(now["revision"], 4);
  ASSERT_EQ(now["results"].size(), 1U);
  EXPECT_EQ(now["results"][0]["by"], "Bo");
  EXPECT_THAT(now["results"][0]["at"].get<std::string>(),
              ::testing::MatchesRegex("....-..-..T..:..:..Z"));
  const json listed = json_of(get(port(), "/api/run"));
  EXPECT_EQ(listed[0]["id"], id);
  EXPECT_EQ(listed[0]["done"], 1);
  EXPECT_EQ(act(*own_, "/api/run/remove?id=" + id).status, 200);
  EXPECT_EQ(get(port(), "/api/run?id=" + id).status, 404);
  EXPECT_FALSE(std::filesystem::exists(path(id)));
}

TEST_F(Runs, ResultsOfASheetThatWasReplacedAreRefused) {
  const std::string id = keep({{"title", "x"}, {"tests", 2}, {"sheet", json::object()}})["id"];
  ASSERT_EQ(result(id, {{"test", "1"}, {"result", "pass"}, {"sheet_revision", 1}}).status, 200);
  const json other = keep({{"id", id},
                           {"sheet_revision", 1},
                           {"title", "y"},
                           {"tests", 1},
                           {"sheet", json::object()},
                           {"results", {{{"test", "1"}, {"result", "pass"}}}}});
  EXPECT_EQ(other["sheet_revision"], 3);
  const Reply late = result(id, {{"test", "2"}, {"result", "fail"}, {"sheet_revision", 1}});
  EXPECT_EQ(late.status, 409);
  EXPECT_THAT(message_of(late), HasSubstr("replanned"));
  EXPECT_EQ(act(*own_, "/api/run",
                json({{"id", id},
                      {"sheet_revision", 1},
                      {"title", "z"},
                      {"tests", 1},
                      {"sheet", json::object()}})
                    .dump())
                .status,
            409);
  EXPECT_EQ(run(id)["title"], "y");
}

TEST_F(Runs, ResultsOfTestsThatAreNotOnTheSheetAreRefused) {
  const json sheet = {{"title", "x"}, {"tests", 17}, {"sheet", json::object()}};
  const std::string id = keep(sheet)["id"];
  for (const char* const test :
       {"99", "18", "0", "017", "North 18", "North", "1 ", "-1", " 1", "North  1", " North 1"}) {
    const Reply refused = result(id, {{"test", test}, {"result", "pass"}, {"sheet_revision", 1}});
    EXPECT_EQ(refused.status, 422) << test;
    EXPECT_THAT(message_of(refused), HasSubstr("is not on the sheet, which has 17 tests")) << test;
    json with = sheet;
    with["results"] = {{{"test", test}, {"result", "pass"}}};
    EXPECT_EQ(act(*own_, "/api/run", with.dump()).status, 422) << test;
  }
  for (const char* const test : {"17", "1", "North 17", "Bench 2 1"}) {
    EXPECT_EQ(result(id, {{"test", test}, {"result", "pass"}, {"sheet_revision", 1}}).status, 200)
        << test;
  }
}

TEST_F(Runs, HaveNoMoreTestsThanTheirSheet) {
  const json tests = json::array({json::array(), json::array()});
  for (const json& sheet :
       {json{{"outcome", {{"tests", tests}}}}, json{{"plan", {{"steps", tests}}}}}) {
    const Reply refused =
        act(*own_, "/api/run", json({{"title", "x"}, {"tests", 1000}, {"sheet", sheet}}).dump());
    EXPECT_EQ(refused.status, 422);
    EXPECT_THAT(message_of(refused),
                HasSubstr("tests: 1000, but the sheet has 2; write how many it has"));
    EXPECT_NO_FATAL_FAILURE((void)keep({{"title", "x"}, {"tests", 2}, {"sheet", sheet}}));
  }
}

TEST_F(Runs, AreToldOf) {
  Connection listener(port());
  listener.send(request_text(port(), "GET", "/api/events"));
  ASSERT_TRUE(listener.read_until("event: hello"));
  const std::string id = keep({{"title", "x"}, {"tests", 2}, {"sheet", json::object()}})["id"];
  EXPECT_TRUE(listener.read_until("\"id\":\"" + id + "\",\"revision\":1"));
  ASSERT_EQ(act(*own_, "/api/run/remove?id=" + id).status, 200);
  EXPECT_TRUE(listener.read_until("\"removed\":true"));
}

TEST_F(Runs, FilesThatAreNoRunsAreNamedAndStay) {
  const json empty = {{"title", "x"}, {"tests", 2}, {"sheet", json::object()}};
  const std::string id = keep(empty)["id"];
  const std::string other = keep(empty)["id"];
  const std::string good = slurp(path(id));
  const std::string there = json_of(get(port(), "/api/run")).dump();
  const auto with = [&](const char* key, const json& value) {
    json run = json::parse(good);
    run[key] = value;
    return run.dump();
  };
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  std::string with_deep_sheet = good;
  with_deep_sheet.replace(with_deep_sheet.find("{}"), 2, R"({"a":)" + deep + "}");
  const std::map<std::string, std::string> bad{
      {std::string(), "at 1:1: "},
      {good.substr(0, good.size() / 2), "at 1:"},
      {deep, "at 1:257: JSON nested more than 256 deep"},
      {with_deep_sheet, "JSON nested more than 256 deep"},
      {"[]", "give an object"},
      {good.substr(0, good.rfind('}')) + R"(,"sheet":{"b":1}})", "sheet: it is there twice"},
      {"{}", "format is missing"},
      {with("format", "changeover-run/2"), "format: write changeover-run/1"},
      {with("id", other), "id: it is that of another run"},
      {with("tests", -1), "tests: write a whole number"},
      {with("tests", nullptr), "tests is missing"},
      {with("revision", 1e300), "revision: write a whole number"},
      {with("revision", 0), "revision: write 1 to"},
      {with("revision", std::uint64_t{1} << 63), "revision: write 1 to"},
      {with("sheet_revision", 2), "sheet_revision: write 1 to 1"},
      {with("sheet", nullptr), "sheet is missing"},
      {with("sheet", json::array()), "sheet: write an object"},
      {with("title", 7), "title: write a string"},
      {with("title", std::string(300, 'x')), "title: more than 200 bytes"},
      {with("results", json::object()), "results: write a list"},
      {with("results", {{{"test", 1}}}), "test: write a string"},
      {with("results", {json::object(), json::object(), json::object()}), "one result per test"},
      {with("more", 1), "unknown key 'more'"}};
  for (const auto& [text, why] : bad) {
    spit(path(id), text);
    const Reply reply = get(port(), "/api/run?id=" + id);
    EXPECT_EQ(reply.status, 503) << text.substr(0, 200);
    EXPECT_THAT(message_of(reply), HasSubstr(path(id) + ": cannot be read as a run: "));
    EXPECT_THAT(message_of(reply), HasSubstr(why));
    EXPECT_EQ(result(id, {{"test", "1"}, {"result", "pass"}, {"sheet_revision", 1}}).status, 503);
    json again = empty;
    again["id"] = id;
    again["sheet_revision"] = 1;
    EXPECT_EQ(act(*own_, "/api/run", again.dump()).status, 503);
    EXPECT_EQ(slurp(path(id)), text);
    EXPECT_THAT(json_of(get(port(), "/api/run")).dump(), ::testing::Not(HasSubstr(id)));
  }
  EXPECT_EQ(run(other)["results"], json::array());
  spit(path(id), good);
  EXPECT_EQ(json_of(get(port(), "/api/run")).dump(), there);
}

// A result that a run has no room for would make it unreadable.
TEST_F(Runs, DoNotGrowBeyondWhatIsRead) {
  const std::string id = keep({{"title", "x"}, {"tests", 9}, {"sheet", json::object()}})["id"];
  json large = json::parse(slurp(path(id)));
  large["sheet"]["filled"] = "";
  constexpr std::size_t most = std::size_t{4} << 20;
  large["sheet"]["filled"] = std::string(most - large.dump().size() - 1'000, 'x');
  spit(path(id), large.dump());
  const auto noted = [&](std::size_t letters) {
    return result(id, {{"test", "1"},
                       {"result", "pass"},
                       {"notes", std::string(letters, 'y')},
                       {"sheet_revision", 1}});
  };
  const Reply reply = noted(1'500);
  EXPECT_EQ(reply.status, 413);
  EXPECT_THAT(message_of(reply), HasSubstr("more than the 4194304 that a run may have"));
  EXPECT_TRUE(slurp(path(id)) == large.dump());
  EXPECT_EQ(noted(500).status, 200);
  EXPECT_EQ(run(id)["results"].size(), 1U);
  large["revision"] = (std::uint64_t{1} << 53) - 1;
  large["sheet"] = json::object();
  spit(path(id), large.dump());
  EXPECT_EQ(noted(5).status, 422);
  EXPECT_TRUE(slurp(path(id)) == large.dump());
}

TEST(RunsFolder, OnlyRunsAreCounted) {
  const OwnServer own;
  const json empty = {{"title", "x"}, {"tests", 2}, {"sheet", json::object()}};
  const std::string id = asked(own, "/api/run", empty)["id"];
  const auto name = [](int n) { return std::to_string(100'000 + n) + "0123456789abcdef01"; };
  for (int i = 0; i < 200; ++i) {
    spit(own.folder.file("runs/" + name(i) + ".json.lock"), "");
    spit(own.folder.file("runs/" + name(i) + ".json.new-1"), "{");
    spit(own.folder.file("runs/notes" + std::to_string(i) + ".json"), "{}");
    std::filesystem::create_directory(own.folder.file("runs/" + name(i) + ".json"));
  }
  EXPECT_EQ(act(own, "/api/run", empty.dump()).status, 200);
  // A file of another kind where the lock would be stays, and is no fault of the body.
  spit(own.folder.file("runs/" + id + ".json.lock"), "mine");
  const Reply locked =
      act(own, "/api/run/result?id=" + id, R"({"test":"1","result":"pass","sheet_revision":1})");
  EXPECT_EQ(locked.status, 503);
  EXPECT_THAT(message_of(locked), HasSubstr(id + ".json.lock is not a lock of changeover"));
  EXPECT_EQ(slurp(own.folder.file("runs/" + id + ".json.lock")), "mine");
  for (int i = 0; i < 200; ++i) {
    std::filesystem::remove(own.folder.file("runs/" + name(i) + ".json"));
    spit(own.folder.file("runs/" + name(i) + ".json"), "{}");
  }
  const Reply full = act(own, "/api/run", empty.dump());
  EXPECT_EQ(full.status, 422);
  EXPECT_THAT(message_of(full), HasSubstr("202 runs are kept, as many as may be; remove one"));
}

TEST(RunsFolder, ThatCannotBeUsedIsNamed) {
  const OwnServer own;
  const json empty = {{"title", "x"}, {"tests", 2}, {"sheet", json::object()}};
  const std::string folder = own.folder.file("runs");
  const std::string one = "?id=" + std::string(24, '0');
  const auto all_are_503 = [&] {
    for (const Reply& reply :
         {act(own, "/api/run", empty.dump()), get(own.port(), "/api/run"),
          get(own.port(), "/api/run" + one),
          act(own, "/api/run/result" + one, R"({"test":"1","sheet_revision":1})"),
          act(own, "/api/run/remove" + one)}) {
      EXPECT_EQ(reply.status, 503);
      EXPECT_THAT(message_of(reply), HasSubstr(folder));
    }
  };
  spit(folder, "a file");
  all_are_503();
  EXPECT_THAT(message_of(act(own, "/api/run", empty.dump())),
              HasSubstr("; correct that on the server"));
  std::filesystem::remove(folder);
  std::filesystem::create_symlink("runs", folder);  // leads in a circle
  all_are_503();
  EXPECT_THAT(message_of(get(own.port(), "/api/run")), HasSubstr(": cannot read this folder: "));
  EXPECT_THAT(
      message_of(get(own.port(), "/api/run" + one)),
      HasSubstr(
          ": cannot be read: Too many levels of symbolic links; allow reading it, or move it away"));
}

// A list reads what has changed since the list before, and nothing else.
TEST_F(Runs, AreReadForTheListWhenTheyHaveChanged) {
  const json sheet = {{"title", "Pumps"}, {"tests", 3}, {"sheet", json::object()}};
  const std::string id = keep(sheet)["id"];
  const auto listed = [&] {
    for (const json& each : json_of(get(port(), "/api/run"))) {
      if (each["id"] == id) {
        return each;
      }
    }
    return json();
  };
  EXPECT_EQ(listed()["title"], "Pumps");
  const auto when = std::filesystem::last_write_time(path(id));
  std::string text = slurp(path(id));
  text.replace(text.find("Pumps"), 5, "Valve");
  spit(path(id), text);
  std::filesystem::last_write_time(path(id), when);
  EXPECT_EQ(listed()["title"], "Pumps");  // neither time nor size tells that it is another
  std::filesystem::last_write_time(path(id), when + std::chrono::seconds(1));
  EXPECT_EQ(listed()["title"], "Valve");
  ASSERT_EQ(result(id, {{"test", "2"}, {"result", "pass"}, {"sheet_revision", 1}}).status, 200);
  EXPECT_EQ(listed()["done"], 1);
}

TEST_F(Runs, NamesAndBodiesThatAreNoneAreRefused) {
  for (const char* const id : {"", "x", "../mine", "..%2f..%2fmine", "0123456789abcdef0123456G"}) {
    EXPECT_EQ(get(port(), std::string("/api/run?id=") + id).status, 404) << id;
    EXPECT_EQ(act(*own_, std::string("/api/run/remove?id=") + id).status, 404) << id;
  }
  for (const char* const body :
       {R"({})", R"({"title":"x","tests":1})", R"({"title":"x","tests":1,"sheet":[]})",
        R"({"title":"x","tests":1,"sheet":{},"more":1})",
        R"({"title":"x","tests":0,"sheet":{},"results":[{"test":"1","result":"pass"}]})",
        R"({"title":"x","tests":1,"sheet":{},"results":[{"result":"pass"}]})",
        R"({"title":"x","tests":-1,"sheet":{}})"}) {
    EXPECT_EQ(act(*own_, "/api/run", body).status, 422) << body;
  }
  EXPECT_EQ(
      act(*own_, "/api/run",
          R"({"id":"000000000000000000000000","sheet_revision":1,"title":"x","tests":1,"sheet":{}})")
          .status,
      404);
  EXPECT_EQ(
      act(*own_, "/api/run",
          json({{"title", std::string(300, 'x')}, {"tests", 1}, {"sheet", json::object()}}).dump())
          .status,
      422);
}

TEST(RunsOfTwoServers, MeetInOneFile) {
  const OwnServer own;
  serve::ExplorerServer other({}, const_cast<Catalog&>(own.catalog));
  const json kept =
      asked(own, "/api/run", {{"title", "x"}, {"tests", 40}, {"sheet", json::object()}});
  const std::string id = kept["id"];
  const auto write = [&](std::uint16_t port, const std::string& token, int from) {
    for (int i = from; i < 40; i += 2) {
      const json body = {
          {"test", std::to_string(i + 1)}, {"result", "pass"}, {"sheet_revision", 1}};
      EXPECT_TRUE(eventually([&] {
        return ask(port, "POST", "/api/run/result?id=" + id,
                   {{"X-Changeover-Token", token}, {"Content-Type", "application/json"}},
                   body.dump())
                   .status == 200;
      }));
    }
  };
  std::thread beside([&] { write(other.port(), other.token(), 1); });
  write(own.port(), own.server->token(), 0);
  beside.join();
  EXPECT_EQ(json_of(get(own.port(), "/api/run?id=" + id))["results"].size(), 40U);
}

}  // namespace
}  // namespace changeover::test::runs_test
