// Plans that are followed, files that are read for the form, and runs that are kept.
#include <gmock/gmock.h>

#include <filesystem>
#include <thread>

#include "changeover/plan/run_plan.hpp"
#include "served.hpp"

namespace changeover::test::plans_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

Reply act(const OwnServer& own, const std::string& target, const std::string& body = "") {
  return ask(own.port(), "POST", target, own.token(), body);
}

json asked(const OwnServer& own, const std::string& target, const json& body) {
  const Reply reply = act(own, target, body.dump());
  EXPECT_EQ(reply.status, 200) << target << "\n" << reply.body.substr(0, 500);
  return json_of(reply);
}

json followed(const OwnServer& own, int id) {
  return json_of(get(own.port(), "/api/plan/job?id=" + std::to_string(id)));
}

const json nine = {{"parts", 9}, {"at_once", 3}, {"test_cost", 1}, {"change_cost", 5}};

TEST(Plans, FollowedThatEndAreWhatIsWaitedForAndFiles) {
  const OwnServer own;
  Connection listener(own.port());
  listener.send(request_text(own.port(), "GET", "/api/events"));
  ASSERT_TRUE(listener.read_until("event: hello"));
  const int id = asked(own, "/api/plan/start", nine)["id"];
  ASSERT_TRUE(listener.read_until("event: plan"));
  ASSERT_TRUE(listener.read_until("\"state\":\"done\""));
  const json job = followed(own, id);
  EXPECT_EQ(job["best"], 117) << job;
  EXPECT_EQ(job["bound"], 117);
  EXPECT_EQ(job["tests"], 17);
  EXPECT_EQ(job["answer"], asked(own, "/api/plan", nine));
  const auto file = [&](const std::string& format) {
    return get(own.port(), "/api/plan/file?id=" + std::to_string(id) + "&format=" + format);
  };
  EXPECT_EQ(file("csv").body, job["answer"]["csv"]);
  EXPECT_THAT(file("xlsx").body, ::testing::StartsWith("PK"));
  EXPECT_THAT(file("html").header("content-disposition"), HasSubstr("run_sheet.html"));
  EXPECT_EQ(file("exe").status, 400);
}

TEST(Plans, ThatAreStoppedHaveTheBestSoFar) {
  const OwnServer own;
  json large = nine;
  large["parts"] = 60;
  large["at_once"] = 7;
  large["seconds"] = 3600;
  const int id = asked(own, "/api/plan/start", large)["id"];
  ASSERT_TRUE(eventually([&] { return !followed(own, id)["best"].is_null(); }));
  EXPECT_EQ(followed(own, id)["answer"], nullptr);
  EXPECT_EQ(get(own.port(), "/api/plan/file?id=" + std::to_string(id)).status, 404);
  ASSERT_EQ(act(own, "/api/plan/stop?id=" + std::to_string(id)).status, 200);
  ASSERT_TRUE(eventually([&] { return followed(own, id)["state"] != "running"; }));
  const json job = followed(own, id);
  EXPECT_EQ(job["state"], "stopped");
  EXPECT_EQ(job["answer"]["plan"]["pairs_tested"], 60 * 59 / 2);
  EXPECT_EQ(job["answer"]["plan"]["cost"], job["best"]);
  EXPECT_GE(job["best"], job["bound"]);
}

TEST(Plans, AreFollowedUpToALimitAndRefusedLikeOthers) {
  const OwnServer own;
  json large = nine;
  large["parts"] = 60;
  large["seconds"] = 3600;
  for (int i = 0; i < 4; ++i) {
    asked(own, "/api/plan/start", large);
  }
  EXPECT_EQ(act(own, "/api/plan/start", large.dump()).status, 429);
  large["seconds"] = 3601;
  EXPECT_EQ(act(own, "/api/plan/start", large.dump()).status, 422);
  EXPECT_EQ(act(own, "/api/plan/start", R"({"parts":1})").status, 422);
  EXPECT_EQ(act(own, "/api/plan/stop?id=77").status, 404);
  EXPECT_EQ(ask(own.port(), "POST", "/api/plan/start", {{"Content-Type", "application/json"}},
                nine.dump())
                .status,
            401);
}

TEST(Plans, OfAServerThatWritesNothingAreNotFollowed) {
  const OwnServer own({.may_write = false});
  EXPECT_EQ(act(own, "/api/plan/start", nine.dump()).status, 403);
  EXPECT_EQ(act(own, "/api/run", R"({"title":"x","tests":1,"sheet":{}})").status, 403);
  EXPECT_EQ(json_of(get(own.port(), "/api/run")), json::array());
}

// News of a plan with first tests, of benches and of a model count the whole plan.
TEST(Plans, FollowedTellCostsOfTheWholePlan) {
  const OwnServer own;
  json first = nine;
  first["first"] = {{"1", "2", "3"}, {"7", "8", "9"}};
  json benches = nine;
  benches["benches"] = 2;
  benches["steps"] = 20'000;
  const json model = {{"model", "A: a, b, c\nB: d, e, f\nC: g, h\n"}, {"test_cost", 2}};
  json triples = nine;
  triples["strength"] = 3;
  triples["steps"] = 5'000;
  for (const json& body : {first, benches, model, triples}) {
    const int id = asked(own, "/api/plan/start", body)["id"];
    ASSERT_TRUE(eventually([&] { return followed(own, id)["state"] != "running"; }));
    const json job = followed(own, id);
    const json& answer = job["answer"];
    ASSERT_EQ(job["state"], "done") << job;
    const bool several = answer.contains("benches");
    EXPECT_EQ(job["best"], several ? answer["benches"]["makespan"] : answer["plan"]["cost"])
        << body;
    EXPECT_EQ(job["tests"], several ? answer["benches"]["tests"] : answer["plan"]["tests"]);
  }
}

TEST(PlanFiles, AreReadAsTheFormHasThem) {
  const OwnServer own;
  const auto read = [&](const json& body) { return asked(own, "/api/plan/read", body); };
  const json list =
      read({{"parts", {{"text", "part;price;slot;qty\nA;9,50;CPU;2\nB;;disk;\nC;1;;3\n"}}}});
  EXPECT_EQ(list["request"]["parts"],
            json::parse(R"([{"name":"A","cost":"9.50","slot":"CPU","quantity":2},
                            {"name":"B","slot":"disk","quantity":1},
                            {"name":"C","cost":1,"quantity":3}])"));
  EXPECT_EQ(list["request"]["slots"],
            json::parse(R"([{"name":"CPU","least":0},{"name":"disk","least":0}])"));
  for (const char* const key : {"at_once", "test_cost", "change_cost"}) {
    EXPECT_FALSE(list["request"].contains(key)) << key;
  }
  EXPECT_THAT(list["notes"].dump(), HasSubstr("header"));
  const json results = read({{"parts", {"A", "B", "C"}},
                             {"at_once", 2},
                             {"done",
                              {{"text",
                                "step,slot_1,slot_2,result,notes\n1,A,B,ok,warm\n"
                                "2,C,B,n.i.O. (hing),\n3,C,A,,\n"}}}});
  ASSERT_EQ(results["done"]["tests"].size(), 2U);
  EXPECT_EQ(results["done"]["tests"][0],
            json::parse(R"({"places":["A","B"],"result":"ok","verdict":"pass","notes":"warm"})"));
  EXPECT_EQ(results["done"]["tests"][1]["verdict"], "fail");
  EXPECT_EQ(results["done"]["places"][1]["number"], 2);
  EXPECT_EQ(read({{"model", "A: a, b\nB: c, d\n"}})["request"]["model"], "A: a, b\nB: c, d\n");
  for (const char* const bad :
       {R"({"parts":{"text":"A\nA\n"}})", R"({"parts":{"file":"/etc/passwd"}})",
        R"({"parts":{"workbook":"UEsDBA=="}})", R"({"model":"A"})", R"([])"}) {
    EXPECT_EQ(act(own, "/api/plan/read", bad).status, 422) << bad;
  }
}

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
  EXPECT_THAT(message_of(late), HasSubstr("planned anew"));
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
  // The sheet has one test, and it has a result.
  EXPECT_EQ(result(id, {{"test", "9"}, {"result", "pass"}, {"sheet_revision", 3}}).status, 422);
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

TEST_F(Runs, FilesThatAreDamagedAreNamedAndStay) {
  const std::string id = keep({{"title", "x"}, {"tests", 2}, {"sheet", json::object()}})["id"];
  const std::string good = slurp(path(id));
  const std::string there = json_of(get(port(), "/api/run")).dump();
  for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), std::string("{}"),
                                 std::string(R"({"format":"changeover-run/2"})")}) {
    spit(path(id), bad);
    const Reply reply = get(port(), "/api/run?id=" + id);
    EXPECT_EQ(reply.status, 503);
    EXPECT_THAT(message_of(reply), HasSubstr("damaged, or no run"));
    EXPECT_EQ(result(id, {{"test", "1"}, {"result", "pass"}, {"sheet_revision", 1}}).status, 503);
    EXPECT_EQ(slurp(path(id)), bad);
    EXPECT_THAT(json_of(get(port(), "/api/run")).dump(), ::testing::Not(HasSubstr(id)));
  }
  spit(path(id), good);
  EXPECT_EQ(json_of(get(port(), "/api/run")).dump(), there);
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
      const json body = {{"test", std::to_string(i)}, {"result", "pass"}, {"sheet_revision", 1}};
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
}  // namespace changeover::test::plans_test
