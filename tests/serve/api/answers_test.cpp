// Every address answers, and says what the command line says.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <map>
#include <vector>

#include "changeover/catalog/entry.hpp"
#include "changeover/io/input.hpp"
#include "changeover/verify/verdict.hpp"
#include "served.hpp"

namespace changeover::test::answers_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// What the program says.
std::string said(const std::string& arguments) {
  static const TemporaryFolder folder;
  return run("$changeover " + arguments, folder.path()).out;
}

class Answers : public Served {};

TEST_F(Answers, About) {
  const auto about = json("/api/about");
  EXPECT_FALSE(about["static"]);
  EXPECT_TRUE(about["write"]);
  EXPECT_GT(about["catalog"]["designs"], 20'000);
  EXPECT_GT(about["limits"]["memory"], 0);
  std::uint64_t designs = 0;
  std::set<Parameters> cells;
  standard_catalog().each({.best_only = false}, [&](const CatalogEntry& entry) {
    ++designs;
    cells.insert(entry.parameters);
    return true;
  });
  EXPECT_EQ(about["catalog"]["designs"], designs);
  EXPECT_EQ(about["catalog"]["cells"], cells.size());
}

TEST_F(Answers, TableIsThatOfTheProgram) {
  auto table = json("/api/table?k=3..5&v=4..12&change=2&kind=linear");
  const auto program =
      nlohmann::json::parse(said("table --k 3..5 --v 4..12 --change 2 --linear --json"));
  EXPECT_EQ(table.size(), 27U);
  std::size_t labelled = 0;
  for (auto& cell : table) {
    labelled += cell["label"].is_string() ? 1U : 0U;
    cell.erase("label");
  }
  EXPECT_EQ(table, program);
  EXPECT_GT(labelled, 10U);
  EXPECT_EQ(json("/api/table?k=3&v=5").size(), 2U);  // both kinds
}

TEST_F(Answers, BoundsExplainAndCiteAreThoseOfTheProgram) {
  EXPECT_EQ(get("/api/bounds?v=20&k=5&kind=linear").body, said("bounds 20 5 --linear --json"));
  EXPECT_EQ(get("/api/explain?v=15&k=3&kind=circular").body,
            said("explain 15 3 --circular --json"));
  const auto cell = json("/api/cell?v=20&k=5&change=2&kind=linear");
  const std::string label = cell["designs"][0]["label"];
  EXPECT_EQ(get("/api/cite?label=" + label).body, said("catalog cite " + label));
  EXPECT_EQ(get("/api/completeness").body, said("catalog completeness --json"));
}

TEST_F(Answers, CellSaysAllThatIsKnown) {
  const auto cell = json("/api/cell?v=20&k=5&change=2&kind=linear");
  EXPECT_EQ(cell["lower_bound"], 29);
  EXPECT_EQ(cell["best"]["b"], 29);
  EXPECT_EQ(cell["best"]["status"], "minimum");
  EXPECT_GE(cell["bounds"].size(), 2U);
  EXPECT_EQ(cell["bounds"][0]["blocks"], 29);
  EXPECT_GE(cell["offers"].size(), 2U);
  EXPECT_LE(cell["offers"].size(), 20U);
  EXPECT_TRUE(cell["impossible"].is_null());
  EXPECT_EQ(cell["history"].back()["b"], cell["designs"][0]["b"]);
  EXPECT_TRUE(cell.at("reported").is_null());
  const auto reported = json("/api/cell?v=26&k=6&change=1&kind=linear")["reported"];
  EXPECT_EQ(reported["blocks"], 63);
  EXPECT_EQ(reported["cites"], "Bean2026");
  const auto none = json("/api/cell?v=4&k=2&kind=circular");
  EXPECT_TRUE(none["impossible"].is_string());
  EXPECT_TRUE(none["best"].is_null());
  EXPECT_TRUE(none["lower_bound"].is_null());
  EXPECT_EQ(json("/api/cell?v=7&k=4&change=1&kind=linear&strength=3")["strength"], 3);
}

TEST_F(Answers, DesignsAreDesigns) {
  for (const char* const query :
       {"v=20&k=5&change=2&kind=linear", "v=253&k=13&kind=circular", "v=8&k=5&kind=circular",
        "v=9&k=4&change=1&kind=circular", "v=12&k=5&change=3"}) {
    const Reply reply = get(std::string("/api/design?") + query);
    ASSERT_EQ(reply.status, 200) << reply.body;
    const Design design = read_design(input_from_text(reply.body));
    EXPECT_TRUE(verify(design).valid()) << query;
    const auto document = json_of(reply);
    EXPECT_EQ(document["verdict"]["valid"], true);
    EXPECT_EQ(document["verdict"]["b"], design.block_count());
    if (document["label"].is_string()) {
      const std::string by_label =
          get("/api/design?label=" + document["label"].get<std::string>()).body;
      EXPECT_EQ(read_design(input_from_text(by_label)).block_count(), design.block_count());
    }
  }
}

TEST_F(Answers, ALabelNamesTheseBlocks) {
  // The catalog has a design with as many blocks, and others.
  std::size_t labelled = 0;
  for (std::uint64_t v = 6; v <= 24; ++v) {
    for (const char* const kind : {"linear", "circular"}) {
      const Reply reply = get(fmt::format("/api/design?v={}&k=4&change=2&kind={}", v, kind));
      const auto said = nlohmann::json::parse(reply.body);
      const Design design = read_design(input_from_text(reply.body));
      if (said["label"].is_string()) {
        DesignSource source(design);
        const DesignDigest digest = design_digest(source);
        EXPECT_EQ(said["label"],
                  design_label(design.parameters(), design.block_count(), digest.checksum));
        ++labelled;
      }
    }
  }
  EXPECT_GT(labelled, 20U);
}

TEST_F(Answers, DownloadsCanBeReadBack) {
  for (const char* const format : {"text", "json", "csv", "gap", "sage", "designtheory"}) {
    const Reply reply =
        get(std::string("/api/download?v=20&k=5&change=2&kind=linear&format=") + format);
    ASSERT_EQ(reply.status, 200) << format << reply.body;
    EXPECT_EQ(reply.header("content-disposition"),
              std::string("attachment; filename=\"20.5.2.linear.29.") + format + "\"");
    const Design design = read_design(input_from_text(reply.body), {.kind = Kind::linear});
    EXPECT_TRUE(verify(design).valid()) << format;
  }
  for (const char* const format : {"latex", "ljcr", "svg", "tikz"}) {
    EXPECT_EQ(get(std::string("/api/download?v=20&k=5&kind=linear&format=") + format).status, 200)
        << format;
  }
}

TEST_F(Answers, PicturesObeyThePolicy) {
  for (const char* const query :
       {"api/heatmap?k=3..5&v=5..12&kind=linear", "api/draw?v=20&k=5&kind=linear&picture=array",
        "api/draw?v=20&k=5&kind=linear&picture=stays&order=stays&theme=dark",
        "api/draw?v=20&k=5&kind=linear&picture=coverage&from=1&to=10",
        "api/draw?v=11&k=4&kind=circular&picture=circle",
        "api/draw?v=20&k=5&kind=linear&picture=recipe"}) {
    const Reply reply = get(std::string("/") + query);
    EXPECT_EQ(reply.status, 200) << query << reply.body.substr(0, 300);
    EXPECT_EQ(reply.header("content-type"), "image/svg+xml");
    EXPECT_THAT(reply.body, HasSubstr("<svg"));
    EXPECT_EQ(reply.body.find("<style"), std::string::npos) << query;
    EXPECT_EQ(reply.body.find("style="), std::string::npos) << query;
    EXPECT_EQ(reply.body.find("<script"), std::string::npos) << query;
  }
  EXPECT_THAT(get("/api/heatmap?k=3..5&v=5..12&kind=linear").body, HasSubstr("class=\"cell"));
}

TEST_F(Answers, ConstructionsAndTheoremsHaveExamples) {
  const auto constructions = json("/api/constructions");
  const auto program = nlohmann::json::parse(said("constructions --json"));
  ASSERT_EQ(constructions.size(), program.size());
  std::size_t examples = 0;
  for (std::size_t i = 0; i < program.size(); ++i) {
    EXPECT_EQ(constructions[i]["name"], program[i]["name"]);
    EXPECT_EQ(constructions[i]["serves"], program[i]["preconditions"]);
    const auto& example = constructions[i]["example"];
    if (example.is_object()) {
      ++examples;
      const auto cell = json("/api/cell?v=" + example["v"].dump() + "&k=" + example["k"].dump() +
                             "&change=" + example["change"].dump() +
                             "&kind=" + example["kind"].get<std::string>());
      const bool offered = std::ranges::any_of(cell["offers"], [&](const auto& offer) {
        return offer["construction"] == constructions[i]["name"];
      });
      EXPECT_TRUE(offered) << constructions[i]["name"];
    }
  }
  EXPECT_GT(examples, 20U);
  const auto theorems = json("/api/theorems");
  ASSERT_EQ(theorems.size(), 40U);
  for (std::size_t i = 0; i < theorems.size(); ++i) {
    EXPECT_EQ(theorems[i]["number"], std::to_string(i + 1));
    EXPECT_FALSE(theorems[i]["title"].get<std::string>().empty());
    EXPECT_THAT(theorems[i]["statement"].get<std::string>(), HasSubstr("**Theorem"));
    EXPECT_EQ(theorems[i]["statement"].get<std::string>().find("*Proof"), std::string::npos);
  }
}

TEST_F(Answers, VerifySaysWhatIsWrongAndWhere) {
  const auto good =
      json_of(post("/api/verify?kind=circular", "0 1 2 3\n4 5 2 3\n4 5 0 1\n", "text/plain"));
  EXPECT_TRUE(good["valid"]);
  EXPECT_EQ(good["design"]["blocks"].size(), 3U);
  EXPECT_EQ(good["verdict"]["minimum"], "proved");
  const auto bad = json_of(post("/api/verify?kind=circular", "0 1 2 3\n4 5 2 3\n4 5 0 2\n"));
  EXPECT_FALSE(bad["valid"]);
  ASSERT_EQ(bad["bad_steps"].size(), 1U);
  EXPECT_EQ(bad["bad_steps"][0]["block"], 3);
  EXPECT_EQ(bad["uncovered_pairs"], nlohmann::json::parse("[[1,4],[1,5]]"));
  const Reply malformed = post("/api/verify", "{\"blocks\":[[0,1,2,3],\n[1,\"a\",{}]]}");
  EXPECT_EQ(malformed.status, 422);
  EXPECT_EQ(json_of(malformed)["error"]["line"], 2);
  EXPECT_EQ(json_of(malformed)["error"]["column"], 8);
}

TEST_F(Answers, VerifyTakesAllFormatsThatAreWritten) {
  for (const char* const format : {"text", "json", "csv", "gap", "sage", "designtheory", "ljcr"}) {
    const std::string file =
        get(std::string("/api/download?v=20&k=5&kind=linear&format=") + format).body;
    const auto answer = json_of(post("/api/verify?kind=linear", file));
    EXPECT_EQ(answer["valid"], true) << format << answer.dump().substr(0, 300);
  }
}

TEST_F(Answers, DrawsWhatIsSent) {
  const Reply reply = post("/api/draw?kind=circular&picture=stays", "0 1 2 3\n4 5 2 3\n4 5 0 2\n");
  EXPECT_EQ(reply.status, 200) << reply.body;
  EXPECT_THAT(reply.body, HasSubstr("<svg"));
}

TEST_F(Answers, PlanIsCountedAndComplete) {
  const auto plan = json_of(post(
      "/api/plan", R"({"parts":9,"at_once":3,"test_cost":1,"change_cost":5})", "application/json"));
  EXPECT_EQ(plan["verified"], true);
  EXPECT_EQ(plan["cost"], 117);  // plan/run_plan.hpp
  EXPECT_EQ(plan["bound"], 117);
  std::set<std::pair<std::string, std::string>> met;
  double cost = 0;
  for (const auto& test : plan["tests"]) {
    cost += test["cost"].get<double>();
    for (const auto& a : test["parts"]) {
      for (const auto& b : test["parts"]) {
        met.emplace(a, b);
      }
    }
  }
  EXPECT_EQ(met.size(), 81U);
  EXPECT_EQ(cost, 117);
  EXPECT_GE(plan["alternatives"].size(), 2U);
  EXPECT_THAT(plan["csv"].get<std::string>(), StartsWith("step,take_out,put_in"));
  const auto rest = json_of(post(
      "/api/plan",
      R"({"parts":[{"name":"pump","cost":"2.50"},"motor","fan",{"name":"disk","cost":3}],"at_once":2,
          "test_cost":"1","change_cost":1,"pairs":[["pump","motor"],["fan","disk"]],
          "done":[["pump","motor"]]})",
      "application/json"));
  ASSERT_EQ(rest["tests"].size(), 2U) << rest;
  EXPECT_EQ(rest["tests"][0]["done"], true);
  EXPECT_EQ(rest["tests"][1]["parts"], nlohmann::json::parse(R"(["fan","disk"])"));
  EXPECT_EQ(rest["cost"], 5);
}

TEST_F(Answers, PlansTestAgainWhatMetOnlyInFailedTests) {
  const auto rest = [&](const std::string& more) {
    return json_of(post(
        "/api/plan",
        R"({"parts":4,"at_once":2,"test_cost":1,"change_cost":1,"done":[["1","2"],{"parts":["1","3"],"result":)"
        R"("FAILED - hang"},{"parts":["2","3"],"result":"skipped"}])" +
            more + "}",
        "application/json"));
  };
  const auto again = rest("");
  EXPECT_EQ(again["met_only_in_failed"], 1) << again;
  EXPECT_EQ(again["tests"].size(), 2U + 5U);
  EXPECT_EQ(rest(R"(,"trust_failed":true)")["tests"].size(), 2U + 4U);
}

TEST_F(Answers, PlansKnowWhatTheCommandLineKnows) {
  const auto asked = [&](const std::string& more) {
    return json_of(
        post("/api/plan",
             R"({"parts":8,"at_once":3,"test_cost":2,"change_cost":1,"steps":1000)" + more + "}",
             "application/json"));
  };
  EXPECT_EQ(asked("")["plan"]["format"], "changeover-plan/1");
  EXPECT_EQ(asked(R"(,"title":"T","budget":"20")")["plan"]["title"], "T");
  EXPECT_EQ(asked(R"(,"benches":2)")["benches"]["format"], "changeover-benches/1");
  EXPECT_EQ(asked(R"(,"what_if":true)")["what_if"]["format"], "changeover-what-if/1");
  EXPECT_EQ(asked(R"(,"strength":3)")["plan"]["triples_needed"], 56);
  const auto faulty = json_of(post(
      "/api/plan",
      R"({"parts":8,"at_once":3,"test_cost":1,"change_cost":1,"diagnose":true,"done":[{"parts":["1","2","3"],"result":"FAIL"},{"parts":["1","2","4"],"result":"ok"}]})",
      "application/json"));
  EXPECT_EQ(faulty["diagnosis"]["format"], "changeover-diagnosis/1");
  const auto in_slots = json_of(post(
      "/api/plan",
      R"({"parts":{"text":"name,slot\nXeon,CPU\nEpyc,CPU\nd1,disk\nd2,disk"},"at_once":3,"test_cost":1,"change_cost":1,"slot":"CPU=1,disk=1..2"})",
      "application/json"));
  EXPECT_EQ(in_slots["plan"]["pairs_needed"], 5) << in_slots;
}

TEST_F(Answers, LoadOrdersSayWhatIsComputedAndStored) {
  const auto asked = [&](const std::string& more) {
    return json_of(
        post("/api/loadorder", R"({"items":12,"room":4,)" + more + "}", "application/json"));
  };
  const auto computed = [](const nlohmann::json& answer) {
    std::vector<nlohmann::json> pairs;
    for (const auto& step : answer["steps"]) {
      pairs.insert(pairs.end(), step["new_pairs"].begin(), step["new_pairs"].end());
    }
    return pairs;
  };
  const auto each = asked(R"("new_pairs":true,"ordered":true,"self":true)");
  EXPECT_EQ(computed(each).size(), 144U) << each;
  const auto in_order = asked(R"("new_pairs":true)");
  EXPECT_EQ(computed(in_order).size(), 66U);
  const auto shuffled = asked(R"("new_pairs":true,"shuffle":true,"seed":7)");
  EXPECT_NE(computed(shuffled), computed(in_order));
  EXPECT_EQ(shuffled, asked(R"("new_pairs":true,"shuffle":true,"seed":7)"));
  EXPECT_TRUE(asked(R"("new_pairs":true,"spread":true)")["order"].contains("pairs_per_step"));
  EXPECT_TRUE(asked(R"("write_back":true)")["order"].contains("stores"));
  const auto costs = asked(R"("workers":2,"pair_cost":[[0,1,50]])");
  EXPECT_EQ(costs["order"]["worker_costs"].size(), 2U) << costs;
  const auto later = asked(R"("from_step":5)");
  EXPECT_EQ(later["steps"][0]["step"], 5);
  EXPECT_EQ(later["step_count"], in_order["step_count"]);
  EXPECT_EQ(asked(R"("item_bytes":8)")["order"]["bytes_loaded"],
            asked(R"("bytes_per_item":8)")["bytes"]);
}

TEST_F(Answers, LoadOrdersAreCutWhereTheyAreLong) {
  serve::ExplorerSettings settings;
  settings.limits.plan_bytes = 3'000;
  const OwnServer own(std::move(settings));
  const auto answer =
      json_of(ask(own.port(), "POST", "/api/loadorder", {{"Content-Type", "application/json"}},
                  R"({"items":30,"room":8,"new_pairs":true})"));
  EXPECT_EQ(answer["truncated"], true);
  EXPECT_LT(answer["steps"].size(), answer["step_count"].get<std::size_t>());
  EXPECT_EQ(answer["pairs"], 30 * 29 / 2);
}

TEST_F(Answers, LoadOrdersBringAllPairsTogether) {
  const auto order = json_of(
      post("/api/loadorder", R"({"items":64,"room":16,"item_bytes":1000})", "application/json"));
  EXPECT_EQ(order["lower_bound"], 144);  // loadorder/load_order.hpp
  EXPECT_EQ(order["bytes"], order["loads"].get<std::uint64_t>() * 1000);
  EXPECT_EQ(order["pairs"], 64 * 63 / 2);
  EXPECT_EQ(order["pairs_done"].back(), 64 * 63 / 2);
  std::set<int> memory;
  std::set<std::pair<int, int>> met;
  for (const auto& step : order["steps"]) {
    for (const int item : step["evict"]) {
      memory.erase(item);
    }
    for (const int item : step["load"]) {
      for (const int other : memory) {
        met.emplace(std::min(item, other), std::max(item, other));
      }
      memory.insert(item);
    }
    EXPECT_LE(memory.size(), 16U);
  }
  EXPECT_EQ(met.size(), 64U * 63 / 2);
  const auto split =
      json_of(post("/api/loadorder", R"({"items":40,"room":8,"workers":3})", "application/json"));
  EXPECT_EQ(split["worker_loads"].size(), 3U) << split;
  EXPECT_EQ(split["pairs"], 40 * 39 / 2);
  std::uint64_t of_workers = 0;
  for (const auto& pairs : split["worker_pairs"]) {
    of_workers += pairs.get<std::uint64_t>();
  }
  EXPECT_EQ(of_workers, 40U * 39 / 2);
  const auto ahead = json_of(
      post("/api/loadorder", R"({"items":20,"room":6,"prefetch":true})", "application/json"));
  EXPECT_EQ(ahead["spare"], 1) << ahead["order"];
  EXPECT_TRUE(ahead["steps"][1].contains("evict_first")) << ahead["steps"][1];
  EXPECT_EQ(ahead["order"]["order_bound"],
            json_of(post("/api/loadorder", R"({"items":20,"room":5})",
                         "application/json"))["lower_bound"]);
  const auto of_three = json_of(
      post("/api/loadorder", R"({"items":30,"room":6,"workers":3,"prefetch":true,"epochs":2})",
           "application/json"));
  EXPECT_EQ(of_three["makespan_bound"], of_three["order"]["makespan_bound"]);
  EXPECT_LT(of_three["makespan_bound"], of_three["order"]["order_makespan_bound"]);
  const auto searched =
      json_of(post("/api/loadorder", R"({"items":20,"room":6,"seconds":0.2})", "application/json"));
  EXPECT_EQ(searched["time_is_up"], false);
  EXPECT_LE(searched["loads"], json_of(post("/api/loadorder", R"({"items":20,"room":6})",
                                            "application/json"))["loads"]);
  EXPECT_EQ(
      post("/api/loadorder", R"({"items":20,"room":6,"seconds":4000})", "application/json").status,
      422);
  const auto some =
      json_of(post("/api/loadorder", R"({"items":10,"room":3,"pairs":[[0,1],[1,2],[8,9]]})",
                   "application/json"));
  EXPECT_EQ(some["loads"], 5) << some;
  EXPECT_EQ(some["pairs"], 3);
  const auto sized = json_of(post(
      "/api/loadorder", R"({"sizes":[[0,5],[1,7],[2,9],[3,4]],"memory":16})", "application/json"));
  EXPECT_EQ(sized["bytes"], sized["order"]["bytes_loaded"]) << sized;
  EXPECT_EQ(sized["bytes_bound"], sized["order"]["bytes_bound"]);
  EXPECT_GE(sized["bytes"], 25);
  EXPECT_EQ(sized["pairs"], 6);
  for (const std::string more : {"", R"(,"epochs":3)", R"(,"prefetch":true)"}) {
    const auto shared = json_of(
        post("/api/loadorder",
             R"({"sizes":[[0,5],[1,7],[2,9],[3,4],[4,6]],"memory":16,"workers":2)" + more + "}",
             "application/json"));
    EXPECT_EQ(shared["bytes"], shared["order"]["bytes_loaded"]) << shared;
    EXPECT_EQ(shared["bytes_bound"], shared["order"]["bytes_bound"]);
    EXPECT_EQ(shared["worker_bytes"], shared["order"]["worker_bytes"]);
    EXPECT_EQ(shared["makespan_bytes"], shared["order"]["makespan_bytes"]);
    EXPECT_GE(shared["makespan_bytes"], shared["makespan_bytes_bound"]);
  }
  for (const auto& [items, room, workers, epochs] :
       {std::array{24, 6, 2, 2}, std::array{24, 6, 3, 3}, std::array{40, 8, 5, 4}}) {
    const auto in_epochs =
        json_of(post("/api/loadorder",
                     fmt::format(R"({{"items":{},"room":{},"workers":{},"epochs":{}}})", items,
                                 room, workers, epochs),
                     "application/json"));
    EXPECT_EQ(in_epochs["pairs"], items * (items - 1) / 2 * epochs);
  }
}

// No item is at two workers at once, and what is counted is what the steps do.
TEST_F(Answers, LoadOrdersAreOfWorkersThatStepTogether) {
  for (const std::string more : {"", R"(,"epochs":2)"}) {
    for (const std::string what :
         {R"("items":24,"room":4)", R"("sizes":[3,4,5,2,6,3,2,4],"memory":12)"}) {
      const auto answer =
          json_of(post("/api/loadorder", "{" + what + more + R"(,"workers":2,"disjoint":true})",
                       "application/json"));
      const auto& order = answer["order"];
      const std::uint64_t items = order["items"];
      EXPECT_EQ(answer["pairs"], items * (items - 1) / 2 * order.value("epochs", 1U)) << answer;
      EXPECT_EQ(answer["step_count"], answer["steps"].size());
      EXPECT_EQ(answer["makespan"], order["makespan"]);
      EXPECT_GE(answer["makespan"], answer["makespan_bound"]);
      EXPECT_EQ(answer.contains("worker_bytes"), what.find("sizes") != std::string::npos);
      if (answer.contains("worker_bytes")) {
        EXPECT_EQ(answer["worker_bytes"], order["worker_bytes"]);
      }
      std::vector<std::uint64_t> loads(2);
      std::map<int, int> held_by;
      // A worker may take over what another one evicts in the same step.
      const auto& steps = answer["steps"];
      for (std::size_t i = 0; i < steps.size(); i += 2) {
        for (const auto& step : {steps[i], steps[i + 1]}) {
          for (const int item : step["evict"]) {
            EXPECT_EQ(held_by[item], step["worker"]) << step;
            held_by.erase(item);
          }
        }
        for (const auto& step : {steps[i], steps[i + 1]}) {
          for (const int item : step["load"]) {
            EXPECT_TRUE(held_by.emplace(item, step["worker"]).second) << step;
          }
          loads[step["worker"]] += step["load"].size();
        }
      }
      EXPECT_EQ(answer["worker_loads"], loads);
      EXPECT_EQ(answer["worker_pairs"], order["worker_pairs"]);
    }
  }
}

// Pairs are counted where they meet: on the accelerator.
TEST_F(Answers, LoadOrdersHaveTwoLevels) {
  for (const std::string more : {"", R"(,"workers":3)", R"(,"epochs":2)"}) {
    for (const std::string what :
         {R"("items":20,"room":8,"fast_room":3)",
          R"("sizes":[[0,5],[1,7],[2,9],[3,4],[4,6],[5,3]],"memory":22,"fast_memory":16)"}) {
      const auto answer =
          json_of(post("/api/loadorder", "{" + what + more + "}", "application/json"));
      const auto& order = answer["order"];
      EXPECT_GE(order["transfers"], order["transfer_bound"]) << answer;
      const std::uint64_t items = order["items"];
      EXPECT_EQ(answer["pairs"], items * (items - 1) / 2 * order.value("epochs", 1U));
      EXPECT_EQ(answer["pairs_done"].back(), answer["pairs"]);
      std::uint64_t transfers = 0;
      for (const auto& step : answer["steps"]) {
        transfers += step["fast_load"].size();
      }
      EXPECT_EQ(transfers, order["transfers"]);
    }
  }
}

TEST_F(Answers, AreGivenAgainWithoutABody) {
  const Reply first = get("/api/bounds?v=20&k=5&kind=linear");
  const std::string etag = first.header("etag");
  EXPECT_THAT(etag, StartsWith("W/\""));
  const Reply again = get("/api/bounds?v=20&k=5&kind=linear", {{"If-None-Match", etag}});
  EXPECT_EQ(again.status, 304);
  EXPECT_EQ(again.body, "");
  EXPECT_NE(get("/api/bounds?v=21&k=5&kind=linear").header("etag"), etag);
}

TEST_F(Answers, AreCompressedForWhoTakesIt) {
  const Reply plain = get("/api/table?k=3..5&v=5..12");
  const Reply packed = get("/api/table?k=3..5&v=5..12", {{"Accept-Encoding", "gzip, br"}});
  EXPECT_EQ(plain.header("content-encoding"), "");
  EXPECT_EQ(packed.header("content-encoding"), "gzip");
  EXPECT_LT(packed.body.size(), plain.body.size() / 2);
  EXPECT_TRUE(packed.body.starts_with("\x1f\x8b"));
}

}  // namespace
}  // namespace changeover::test::answers_test
