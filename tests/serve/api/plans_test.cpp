// Plans that are followed, and files that are read for the form.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <set>

#include "changeover/plan/run_plan.hpp"
#include "io/scan/base64.hpp"
#include "run_workbooks.hpp"
#include "served.hpp"

namespace changeover::test::plans_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

json followed(const OwnServer& own, int id) {
  return json_of(get(own.port(), "/api/plan/job?id=" + std::to_string(id)));
}

const json nine = {{"parts", 9}, {"at_once", 3}, {"test_cost", 1}, {"change_cost", 5}};

TEST(Plans, FollowedThatEndAreWhatIsWaitedForAndFiles) {
  const OwnServer own;
  Connection listener(own.port());
  listener.send(request_text(own.port(), "GET", "/api/events"));
  ASSERT_TRUE(listener.read_until("event: hello"));
  json quick = nine;  // both times it ends long before a clock would end it
  quick["steps"] = 2000;
  const int id = asked(own, "/api/plan/start", quick)["id"];
  ASSERT_TRUE(listener.read_until("event: plan"));
  ASSERT_TRUE(listener.read_until("\"state\":\"done\""));
  const json job = followed(own, id);
  EXPECT_EQ(job["best"], 117) << job;
  EXPECT_EQ(job["bound"], 117);
  EXPECT_EQ(job["tests"], 17);
  EXPECT_EQ(job["answer"], asked(own, "/api/plan", quick));
  const auto file = [&](const std::string& format) {
    return get(own.port(), "/api/plan/file?id=" + std::to_string(id) + "&format=" + format);
  };
  EXPECT_EQ(job["answer"]["csv"], file("csv").body);
  EXPECT_THAT(file("xlsx").body, ::testing::StartsWith("PK"));
  EXPECT_THAT(file("html").header("content-disposition"), HasSubstr("run_sheet.html"));
  EXPECT_EQ(file("exe").status, 400);
}

TEST(Plans, ThatAClockStoppedSaySo) {
  const OwnServer own;
  json large = nine;
  large["parts"] = 40;
  large["at_once"] = 6;
  large["benches"] = 2;
  large["seconds"] = 0.2;
  EXPECT_EQ(asked(own, "/api/plan", large)["benches"]["why_stopped"], "time limit");
  json quick = nine;
  quick["steps"] = 300;
  EXPECT_NE(asked(own, "/api/plan", quick)["plan"]["why_stopped"], "time limit");
}

TEST(Plans, TakeASeed) {
  const OwnServer own;
  json job = nine;
  job["parts"] = 11;
  job["at_once"] = 4;
  job["benches"] = 3;
  job["steps"] = 50;
  std::set<std::string> plans;
  for (int seed = 1; seed <= 4; ++seed) {
    job["seed"] = seed;
    const json answer = asked(own, "/api/plan", job)["benches"];
    const json again = asked(own, "/api/plan", job)["benches"];
    const auto by_the_clock = [](const json& plan) { return plan["why_stopped"] == "time limit"; };
    EXPECT_TRUE(answer == again || by_the_clock(answer) || by_the_clock(again)) << seed;
    plans.insert(answer["sheets"].dump());
  }
  EXPECT_GT(plans.size(), 1U);
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
  const Reply early = get(own.port(), "/api/plan/file?id=" + std::to_string(id));
  EXPECT_EQ(early.status, 404);
  EXPECT_EQ(message_of(early),
            "plan " + std::to_string(id) + " has no answer yet; wait for it, or stop it");
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

TEST(Plans, OfWhichTheAnswerIsTooLargeAreTakenAsFiles) {
  serve::ExplorerSettings settings;
  settings.limits.plan_bytes = 2'000;
  const OwnServer own(std::move(settings));
  const Reply at_once = act(own, "/api/plan", nine.dump());
  EXPECT_EQ(at_once.status, 413);
  EXPECT_EQ(message_of(at_once),
            "the answer has more than 2000 bytes; take a file of csv with api/plan/start and "
            "api/plan/file, or use changeover plan");
  const int id = asked(own, "/api/plan/start", nine)["id"];
  ASSERT_TRUE(eventually([&] { return followed(own, id)["state"] != "running"; }));
  const json job = followed(own, id);
  EXPECT_EQ(job["state"], "done");
  EXPECT_EQ(job["answer"], nullptr);
  EXPECT_EQ(job["best"], 117);
  EXPECT_THAT(job["message"].get<std::string>(), HasSubstr("the answer has more than 2000 bytes"));
  const std::string file = "/api/plan/file?id=" + std::to_string(id);
  EXPECT_EQ(get(own.port(), file + "&format=csv").status, 200);
  const Reply large = get(own.port(), file + "&format=json");
  EXPECT_EQ(large.status, 413);
  EXPECT_THAT(message_of(large), HasSubstr("the answer has more than 2000 bytes"));
  // Names alone may be more than that.
  json names = nine;
  names["parts"] = json::array();
  for (const char name : {'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i'}) {
    names["parts"].push_back(std::string(150, name));
  }
  EXPECT_EQ(act(own, "/api/plan", names.dump()).status, 413);
}

TEST(Plans, ThatEndedAreForgottenWhenTheyAreLarge) {
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{1} << 28}) {
    serve::ExplorerSettings settings;
    settings.limits.remembered_bytes = bytes;
    const OwnServer own(std::move(settings));
    std::vector<int> ids;
    for (int i = 0; i < 3; ++i) {
      ids.push_back(asked(own, "/api/plan/start", nine)["id"]);
      ASSERT_TRUE(eventually([&] { return followed(own, ids.back())["state"] != "running"; }));
    }
    const int before = bytes == 1 ? 404 : 200;
    const auto status = [&](int id) {
      return get(own.port(), "/api/plan/job?id=" + std::to_string(id)).status;
    };
    EXPECT_EQ(status(ids[0]), before);
    EXPECT_EQ(status(ids[1]), before);
    EXPECT_EQ(status(ids[2]), 200);
    EXPECT_EQ(get(own.port(), "/api/plan/file?id=" + std::to_string(ids[2])).status, 200);
  }
}

// Clients that ask for much and take nothing hold no more than that.
TEST(Plans, AnswersThatAreNotTakenAreBounded) {
  serve::ExplorerSettings settings;
  settings.limits.untaken_bytes = 1'000;
  const OwnServer own(std::move(settings));
  const Reply reply = act(own, "/api/plan", nine.dump());
  EXPECT_EQ(reply.status, 503);
  EXPECT_THAT(message_of(reply), HasSubstr("too many answers wait to be taken"));
  EXPECT_EQ(get(own.port(), "/api/constructions").status, 200);  // kept, so all share it
  serve::ExplorerSettings more;
  more.limits.untaken_bytes = 20'000;
  const OwnServer other(std::move(more));
  for (int i = 0; i < 20; ++i) {
    asked(other, "/api/plan", nine);
  }
}

// News of a plan with first tests, of benches and of a model count the whole plan.
TEST(Plans, FollowedTellCostsOfTheWholePlan) {
  const OwnServer own;
  json first = nine;
  first["first"] = {{"1", "2", "3"}, {"7", "8", "9"}};
  json benches = nine;
  benches["benches"] = 2;
  benches["steps"] = 20'000;
  const json model = {
      {"model", "A: a, b, c\nB: d, e, f\nC: g, h\n"}, {"test_cost", 2}, {"change_cost", 1}};
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
            json::parse(R"({"bench":null,"places":["A","B"],"result":"ok","verdict":"pass",
                            "notes":"warm"})"));
  EXPECT_EQ(results["done"]["tests"][1]["verdict"], "fail");
  EXPECT_EQ(results["done"]["places"][1]["number"], 2);
  EXPECT_EQ(read({{"model", "A: a, b\nB: c, d\n"}})["request"]["model"], "A: a, b\nB: c, d\n");
  for (const char* const bad :
       {R"({"parts":{"text":"A\nA\n"}})", R"({"parts":{"file":"/etc/passwd"}})",
        R"({"parts":{"workbook":"UEsDBA=="}})", R"({"model":"A"})", R"([])"}) {
    EXPECT_EQ(act(own, "/api/plan/read", bad).status, 422) << bad;
  }
  EXPECT_THAT(message_of(act(own, "/api/plan/read", R"({"parts":{"workbook":""}})")),
              HasSubstr("parts: write {\"workbook\":the bytes of an .xlsx file in base64}"));
}

// A workbook of several benches is the whole question, also for who knows nothing else.
TEST(PlanFiles, TheWorkbookOfBenchesIsAllThatIsNeeded) {
  const OwnServer own;
  const json lab = {{"parts", {"H100", "A40", "L4", "Epyc", "Xeon"}},
                    {"at_once", 3},
                    {"test_cost", 2},
                    {"change_cost", 1},
                    {"steps", 2000},
                    {"benches", {"North", {{"name", "South"}, {"without", {"H100"}}}}}};
  const int id = asked(own, "/api/plan/start", lab)["id"];
  ASSERT_TRUE(eventually([&] { return followed(own, id)["state"] == "done"; }));
  const std::string week =
      get(own.port(), fmt::format("/api/plan/file?id={}&format=xlsx", id)).body;
  const auto sent = [](const std::string& bytes) {
    return json{{"parts", {{"workbook", base64_of(bytes)}}}};
  };
  const std::string filled = filled_in(filled_in(week, {"pass"}, "North"), {"FAILED"}, "South");
  const json read = asked(own, "/api/plan/read", sent(filled));
  EXPECT_EQ(read["request"]["benches"].size(), 2U) << read;
  ASSERT_EQ(read["done"]["tests"].size(), 2U) << read;
  EXPECT_EQ(read["done"]["tests"][0]["bench"], "North");
  EXPECT_EQ(read["done"]["tests"][1]["bench"], "South");
  EXPECT_EQ(read["done"]["tests"][1]["verdict"], "fail");
  const json plan = asked(own, "/api/plan", sent(filled))["benches"];
  EXPECT_EQ(plan["tests_done"], 2);
  EXPECT_EQ(plan["sheets"][1]["tests_done"], 1);
  EXPECT_EQ(asked(own, "/api/plan", sent(week))["benches"]["tests_done"], 0);
}

TEST(PlanFiles, NumbersOfPartsAreNamedAsTheyAreSent) {
  const OwnServer own;
  for (const char* const number : {"0", "1", "1001", "-1", "2.5"}) {
    for (const std::string key : {"parts", "items"}) {
      const std::string body =
          fmt::format(R"({{"{}":{},"at_once":2,"test_cost":1,"change_cost":1}})", key, number);
      for (const char* const address : {"/api/plan", "/api/plan/read"}) {
        const Reply reply = act(own, address, body);
        EXPECT_EQ(reply.status, 422) << body;
        EXPECT_THAT(message_of(reply), ::testing::StartsWith(key + ": ")) << body;
      }
    }
  }
}

}  // namespace
}  // namespace changeover::test::plans_test
