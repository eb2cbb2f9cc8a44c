// Searches: begun, watched, stopped, kept.
#include <gmock/gmock.h>

#include <mutex>

#include "changeover/catalog/entry.hpp"
#include "changeover/io/input.hpp"
#include "changeover/verify/verdict.hpp"
#include "served.hpp"

namespace changeover::test::searches_test {
namespace {

using ::testing::HasSubstr;

nlohmann::json search(const OwnServer& own, int id) {
  return json_of(get(own.port(), "/api/search?id=" + std::to_string(id)));
}

bool ends(const OwnServer& own, int id) {
  return eventually([&] { return search(own, id)["state"] != "running"; });
}

TEST(Searches, FindVerifyAndKeep) {
  const OwnServer own;
  const Reply begun = act(own, "/api/search",
                          R"({"v":9,"k":4,"change":2,"kind":"circular","seconds":60,"seed":3})");
  ASSERT_EQ(begun.status, 200) << begun.body;
  EXPECT_EQ(json_of(begun)["id"], 1);
  ASSERT_TRUE(ends(own, 1));
  const auto job = search(own, 1);
  EXPECT_EQ(job["state"], "done") << job;
  EXPECT_EQ(job["best"], job["lower_bound"]);
  EXPECT_GE(job["points"].size(), 1U);
  const Reply reply = get(own.port(), "/api/design?job=1");
  const Design design = read_design(input_from_text(reply.body));
  EXPECT_TRUE(verify(design).valid());
  EXPECT_EQ(json_of(reply)["label"], nullptr);
  const auto kept = json_of(act(own, "/api/search/keep?id=1"));
  EXPECT_EQ(kept["already"], false) << kept;
  const auto label = parse_design_label(kept["label"].get<std::string>());
  ASSERT_TRUE(label);
  EXPECT_EQ(label->b, design.block_count());
  EXPECT_TRUE(own.catalog.find(kept["label"].get<std::string>()));
  EXPECT_EQ(json_of(act(own, "/api/search/keep?id=1"))["already"], true);
  EXPECT_EQ(json_of(get(own.port(), "/api/design?job=1"))["label"], kept["label"]);
  EXPECT_EQ(json_of(get(own.port(), "/api/about"))["catalog"]["designs"], 1);
}

TEST(Searches, StopAndTellOfIt) {
  const OwnServer own;
  Connection listener(own.port());
  listener.send(request_text(own.port(), "GET", "/api/events"));
  ASSERT_TRUE(listener.read_until("event: hello"));
  ASSERT_EQ(act(own, "/api/search", R"({"v":30,"k":6,"seconds":3600})").status, 200);
  ASSERT_TRUE(listener.read_until("\"state\":\"running\""));
  EXPECT_EQ(get(own.port(), "/api/design?job=1").status, 404);
  EXPECT_EQ(act(own, "/api/search/keep?id=1").status, 404);
  ASSERT_EQ(act(own, "/api/search/stop?id=1").status, 200);
  EXPECT_TRUE(listener.read_until("\"state\":\"stopped\""));
  EXPECT_EQ(search(own, 1)["state"], "stopped");
  EXPECT_EQ(get(own.port(), "/api/design?job=1").status, 200);
}

TEST(Searches, GoAboutItInEachWay) {
  const OwnServer own;
  const auto begun = [&](const std::string& more) {
    const Reply reply = act(own, "/api/search", R"({"v":9,"k":4,"seconds":60)" + more + "}");
    EXPECT_EQ(reply.status, 200) << reply.body;
    const int id = json_of(reply)["id"];
    EXPECT_TRUE(ends(own, id));
    return search(own, id);
  };
  const auto exact = begun(R"(,"change":1,"kind":"circular","way":"exact")");
  EXPECT_EQ(exact["way"], "exact");
  EXPECT_EQ(exact["best"], 12) << exact;
  EXPECT_EQ(exact["lower_bound"], 12) << exact;
  const auto developed = begun(R"(,"change":1,"kind":"circular","way":"base-blocks","blocks":18)");
  EXPECT_EQ(developed["state"], "done") << developed;
  const auto locked = begun(
      R"(,"change":1,"kind":"linear","way":"locked","first":[0,1,2],"expansion_set":true,"blocks":16)");
  ASSERT_FALSE(locked["best"].is_null()) << locked;
  const auto design = json_of(get(own.port(), "/api/design?job=3"));
  for (const int x : {0, 1, 2}) {
    EXPECT_THAT(design["blocks"][0], ::testing::Contains(x));
  }
  EXPECT_THAT(design["recipe"]["provenance"].get<std::string>(),
              HasSubstr("--first 0,1,2 --expansion-set"));
  const auto wanted =
      begun(R"(,"change":1,"kind":"linear","way":"exact","first":[0,1,2],"anew":true)");
  EXPECT_EQ(wanted["best"], 12) << wanted;
  EXPECT_EQ(wanted["message"], "no design that begins with {0,1,2} has fewer blocks");
  const auto proved = json_of(get(own.port(), "/api/design?job=4"));
  for (const int x : {0, 1, 2}) {
    EXPECT_THAT(proved["blocks"][0], ::testing::Contains(x));
  }
  EXPECT_THAT(proved["recipe"]["provenance"].get<std::string>(),
              HasSubstr("--exact --first 0,1,2 --anew"));
  const auto triples = begun(R"(,"change":1,"kind":"linear","strength":3,"blocks":40)");
  EXPECT_EQ(triples["strength"], 3) << triples;
}

// What an exact search has decided is seen while it goes on, and what it came to is no riddle.
TEST(Searches, ShowWhatWasDecided) {
  const OwnServer own;
  ASSERT_EQ(
      act(own, "/api/search", R"({"v":9,"k":5,"kind":"linear","seconds":60,"way":"exact"})").status,
      200);
  ASSERT_TRUE(ends(own, 1));
  const auto job = search(own, 1);
  EXPECT_EQ(job["lower_bound"], 6) << job;
  EXPECT_EQ(job["start_best"], 6) << job;
  EXPECT_EQ(job["message"],
            "minimum: as many blocks as the lower bound; 5 blocks: none, by a checked DRAT proof");
  ASSERT_EQ(job["decisions"].size(), 1U) << job;
  EXPECT_EQ(job["decisions"][0]["blocks"], 5);
  EXPECT_EQ(job["decisions"][0]["outcome"], "none");
  EXPECT_EQ(job["unit"], "kB of proof");
  EXPECT_EQ(job["points"].front()["lower_bound"], 5) << job;
  EXPECT_EQ(job["points"].back()["lower_bound"], 6) << job;
  // One that goes on says which number it decides, and what was known before.
  ASSERT_EQ(act(own, "/api/search", R"({"v":15,"k":6,"kind":"linear","seconds":600,"way":"exact"})")
                .status,
            200);
  ASSERT_TRUE(eventually([&] { return !search(own, 2)["decisions"].empty(); }));
  const auto running = search(own, 2);
  EXPECT_EQ(running["decisions"][0]["outcome"], "running") << running;
  EXPECT_EQ(running["decisions"][0]["blocks"], running["lower_bound"]);
  EXPECT_FALSE(running["best"].is_null()) << running;
  EXPECT_EQ(act(own, "/api/search/stop?id=2").status, 200);
  ASSERT_TRUE(ends(own, 2));
  EXPECT_EQ(search(own, 2)["decisions"][0]["outcome"], "unknown");
}

TEST(Searches, AreLimited) {
  const OwnServer own;
  const std::string long_one = R"({"v":30,"k":6,"seconds":3600})";
  EXPECT_EQ(act(own, "/api/search", long_one).status, 200);
  EXPECT_EQ(act(own, "/api/search", long_one).status, 200);
  const Reply third = act(own, "/api/search", long_one);
  EXPECT_EQ(third.status, 429);
  EXPECT_THAT(message_of(third), HasSubstr(", as many as may; wait for one to end, or stop it"));
  EXPECT_EQ(act(own, "/api/search/stop?id=2").status, 200);
  EXPECT_TRUE(ends(own, 2));
  EXPECT_EQ(act(own, "/api/search", long_one).status, 200);
  EXPECT_EQ(json_of(get(own.port(), "/api/search")).size(), 3U);
}

TEST(Searches, ThatHaveNoDesignYetSaySo) {
  const OwnServer own;
  const std::string hopeless = R"({"v":100,"k":8,"seconds":3600})";
  const std::string id =
      std::to_string(asked(own, "/api/search", nlohmann::json::parse(hopeless))["id"].get<int>());
  EXPECT_EQ(message_of(get(own.port(), "/api/design?job=" + id)),
            "search " + id + " has no design yet; stop it to see the best");
}

TEST(Searches, RefuseWhatCannotBe) {
  const OwnServer own;
  for (const auto& [body, status, says] :
       {std::tuple{R"({"v":4,"k":2,"kind":"circular"})", 400, "exists"},
        std::tuple{R"({"v":4,"k":9})", 400, ""},
        std::tuple{R"({"v":20,"k":5,"kind":"round"})", 422, "kind"},
        std::tuple{R"({"v":20,"k":5,"seconds":0})", 422, "seconds"},
        std::tuple{R"({"v":20,"k":5,"threads":100000})", 422, "threads"},
        std::tuple{R"({"v":20,"k":5,"way":"guess"})", 422, "\"local\", \"exact\""},
        std::tuple{R"({"v":20,"k":5,"way":"locked"})", 422, "needs first, last or"},
        std::tuple{R"({"v":20,"k":5,"first":[0]})", 422, "give one of these ways"},
        std::tuple{R"({"v":20,"k":5,"anew":true})", 422, "anew is for"},
        std::tuple{R"({"v":20,"k":5,"way":"exact","first":[0,0]})", 422,
                   "can have what you ask for"},
        std::tuple{R"({"v":20,"k":5,"way":"locked","first":[0,0]})", 422,
                   "can have what you ask for"},
        std::tuple{R"({"v":20,"k":5,"way":"locked","first":[-1]})", 422, "is not an element"},
        std::tuple{R"({"v":20,"k":5,"way":"locked","last":[0,{"b":[1.50,null],"a":""}]})", 422,
                   R"(last: '{"b":[1.50,null],"a":""}' is not an element)"},
        std::tuple{R"({"v":20,"k":5,"k":6})", 422, "is given twice"},
        std::tuple{R"({"v":20,"k":5,"seconds":"9"})", 422, "seconds: write a number of seconds"},
        std::tuple{R"({"v":20,"k":5,"way":"exact","blocks":3})", 422, "finds the minimum"},
        std::tuple{R"({"v":20,"k":5,"strength":9})", 422, "strength"},
        std::tuple{R"({"v":20,"k":5,"blocks":0})", 422, "at least one block"},
        std::tuple{R"({"v":20})", 422, "k is missing"},
        std::tuple{R"({"v":20,"k":5,"x":1})", 422, "unknown key 'x'"}}) {
    const Reply reply = act(own, "/api/search", body);
    EXPECT_EQ(reply.status, status) << body << reply.body;
    EXPECT_THAT(message_of(reply), HasSubstr(says));
  }
  EXPECT_EQ(act(own, "/api/search/stop?id=9").status, 404);
  EXPECT_EQ(act(own, "/api/search/stop").status, 400);
}

TEST(Searches, AreNotBegunWithoutLeave) {
  serve::ExplorerSettings settings;
  settings.may_write = false;
  const OwnServer own(std::move(settings));
  EXPECT_EQ(json_of(get(own.port(), "/api/about"))["write"], false);
  const Reply search = act(own, "/api/search", R"({"v":20,"k":5})");
  EXPECT_EQ(search.status, 403);
  EXPECT_EQ(message_of(search),
            "the server was started with --no-write: it searches nothing and keeps nothing");
  EXPECT_EQ(act(own, "/api/catalog/add", "0 1 2\n").status, 403);
}

TEST(CatalogAdd, TellsADamagedCatalogFromABodyThatIsNoDesign) {
  const OwnServer own;
  spit(own.folder.file("mine.db"), "my diary, and no catalog of designs at all");
  const Reply reply = act(own, "/api/catalog/add?kind=circular", "0 1 2 3\n4 5 2 3\n4 5 0 1\n");
  EXPECT_EQ(reply.status, 503) << reply.body;
  EXPECT_THAT(message_of(reply), HasSubstr("mine.db: damaged, or not a catalog"));
  EXPECT_EQ(act(own, "/api/catalog/add?kind=circular", "0 1 2\n4 5\n").status, 422);
  EXPECT_EQ(slurp(own.folder.file("mine.db")), "my diary, and no catalog of designs at all");
}

TEST(CatalogAdd, TakesDesignsAndNothingElse) {
  const OwnServer own;
  const std::string design = "0 1 2 3\n4 5 2 3\n4 5 0 1\n";
  const auto added = json_of(act(own, "/api/catalog/add?kind=circular", design));
  EXPECT_EQ(added["already"], false) << added;
  EXPECT_THAT(added["label"].get<std::string>(), HasSubstr("6.4.2.circular.3."));
  EXPECT_EQ(json_of(act(own, "/api/catalog/add?kind=circular", design))["already"], true);
  // The same by other names of elements.
  EXPECT_EQ(
      json_of(act(own, "/api/catalog/add?kind=circular", "3 1 2 0\n4 5 2 0\n4 5 3 1\n"))["label"],
      added["label"]);
  const Reply none = act(own, "/api/catalog/add?kind=circular", "0 1 2 3\n4 5 2 3\n4 5 0 2\n");
  EXPECT_EQ(none.status, 422);
  EXPECT_THAT(message_of(none), HasSubstr("it is not a change covering design: "));
  const std::string label = added["label"];
  EXPECT_EQ(json_of(get(own.port(), "/api/design?label=" + label))["label"], label);
  // What was answered before is not given again.
  EXPECT_EQ(json_of(get(own.port(), "/api/cell?v=6&k=4&kind=circular"))["designs"].size(), 1U);
}

TEST(Files, AreShownAsTheyAre) {
  serve::ExplorerSettings settings;
  settings.files.push_back({"mine.txt", read_design(input_from_text("a b c d\ne f c d\ne f a b\n"),
                                                    {.kind = Kind::circular})});
  settings.files.push_back(
      {"broken.txt", read_design(input_from_text("0 1 2 3\n4 5 2 3\n4 5 0 2\n"))});
  const OwnServer own(std::move(settings));
  const auto about = json_of(get(own.port(), "/api/about"));
  EXPECT_EQ(about["files"][0]["name"], "mine.txt");
  EXPECT_EQ(about["files"][1]["index"], 2);
  const auto mine = json_of(get(own.port(), "/api/design?file=1"));
  EXPECT_EQ(mine["verdict"]["valid"], true);
  EXPECT_EQ(mine["labels"], nlohmann::json::parse(R"(["a","b","c","d","e","f"])"));
  EXPECT_EQ(json_of(get(own.port(), "/api/design?file=2"))["verdict"]["valid"], false);
  EXPECT_EQ(get(own.port(), "/api/draw?file=2&picture=stays").status, 200);
  EXPECT_EQ(get(own.port(), "/api/design?file=3").status, 404);
}

TEST(Log, HasALineARequestAndNoToken) {
  std::mutex mutex;
  std::string lines;
  serve::ExplorerSettings settings;
  settings.log = [&](const std::string& line) {
    const std::scoped_lock lock(mutex);
    lines += line + "\n";
  };
  const OwnServer own(std::move(settings));
  EXPECT_EQ(get(own.port(), "/?token=" + own.server->token()).status, 200);
  EXPECT_EQ(get(own.port(), "/api/cell?v=1%0a2").status, 400);
  const std::scoped_lock lock(mutex);
  EXPECT_EQ(lines, "GET / 200\nGET /api/cell?v=1%0a2 400\n");
  EXPECT_THAT(own.server->address(), HasSubstr("/?token=" + own.server->token()));
}

}  // namespace
}  // namespace changeover::test::searches_test
