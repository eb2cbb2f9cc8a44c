// Load requests as documents: read back as they are, refused as they should be, and the same pairs
// whichever way they come.
#include "changeover/loadorder/load_request.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "changeover/core/error.hpp"
#include "io/request/request_document.hpp"
#include "run_program.hpp"

namespace changeover::load_request_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusal(const std::string& json, Door door = Door::document) {
  try {
    static_cast<void>(checked_loads(load_request(json), door));
  } catch (const Error& fault) {
    return fault.what();
  }
  return "taken";
}

TEST(LoadRequest, IsReadBackAsItWasWritten) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1'000; ++i) {
    LoadRequest request;
    for (const auto& option : load_table().options) {
      if (random() % 2 == 0) {
        continue;
      }
      std::visit(
          [&](auto field) {
            auto& value = request.*field;
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, RequestList>) {
              value.rows = option.record.shape == RowShape::weights
                               ? std::vector<ListRow>{{{"0", "7", "2.5"}}, {{"a,b", "c", "0"}}}
                               : std::vector<ListRow>{{{"0", "7"}}, {{"a,b", "c"}}};
            } else if constexpr (std::is_same_v<Value, bool>) {
              value = true;
            } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
              value = static_cast<double>(random() % 100) / 3;
            } else if constexpr (std::is_same_v<Value, std::optional<std::uint64_t>>) {
              value = random();
            }
          },
          option.field);
    }
    ASSERT_EQ(load_request(to_json(request)), request) << to_json(request);
  }
}

TEST(LoadRequest, ThePairsAreTheSameByFileTextAndRows) {
  const test::TemporaryFolder folder;
  test::spit(folder.file("pairs.csv"), "a,b\n\"c d\",a\n");
  const std::string by_file = R"({"room":2,"pairs":{"file":")" + folder.file("pairs.csv") + "\"}}";
  const std::string by_text = R"({"room":2,"pairs":{"text":"a,b\n\"c d\",a\n"}})";
  const std::string by_rows = R"({"room":2,"pairs":[["a","b"],["c d","a"]]})";
  for (const std::string& json : {by_file, by_text, by_rows}) {
    const CheckedLoads loads = checked_loads(load_request(json), Door::document);
    ASSERT_NE(loads.wanted().graph(), nullptr);
    EXPECT_EQ(loads.items(), 3U) << json;
    EXPECT_EQ(loads.wanted().count(), 2U) << json;
    EXPECT_EQ(loads.wanted().graph()->names(), (std::vector<std::string>{"a", "b", "c d"})) << json;
  }
  const CheckedLoads numbers =
      checked_loads(load_request(R"({"items":9,"room":2,"pairs":[[0,8],[1,2]]})"), Door::document);
  EXPECT_EQ(numbers.items(), 9U);
  EXPECT_TRUE(numbers.wanted().contains(0, 8));
}

TEST(LoadRequest, GroupsAndCostsAreTheSameByFileTextAndRows) {
  const test::TemporaryFolder folder;
  test::spit(folder.file("groups.csv"), "a,b,\"c d\"\nc,a\ne\n");
  for (const std::string& json :
       {R"({"room":2,"groups":{"file":")" + folder.file("groups.csv") + "\"}}",
        std::string(R"({"room":2,"groups":{"text":"a,b,\"c d\"\nc,a\ne\n"}})"),
        std::string(R"({"room":2,"groups":[["a","b","c d"],["c","a"],["e"]]})")}) {
    const CheckedLoads loads = checked_loads(load_request(json), Door::document);
    EXPECT_EQ(loads.wanted().count(), 4U) << json;
    EXPECT_EQ(loads.wanted().graph()->names(),
              (std::vector<std::string>{"a", "b", "c d", "c", "e"}));
    EXPECT_FALSE(loads.wanted().needs(4));
  }
  for (const std::string json :
       {R"({"room":2,"workers":2,"pairs":{"text":"a,b,3\nb,c,0.5\n"}})",
        R"({"room":2,"workers":2,"pairs":[["a","b",3],["b","c","0.5"]]})"}) {
    const CheckedLoads loads = checked_loads(load_request(json), Door::document);
    ASSERT_TRUE(loads.pair_cost()) << json;
    EXPECT_EQ(loads.pair_cost()(0, 1), 3);
    EXPECT_EQ(loads.pair_cost()(1, 2), 0.5);
  }
}

TEST(LoadRequest, TakesATimeForTwoSetsAndNewItemsWhereASearchIsOfUse) {
  for (const char* const others : {"\"against\":5", "\"done_items\":4"}) {
    for (const char* const rest :
         {"\"room\":4,\"fast_room\":2", "\"room\":2,\"workers\":2,\"disjoint\":true",
          "\"room\":4,\"fast_room\":3,\"workers\":2"}) {
      const std::string json = fmt::format(R"({{"items":9,"seconds":1,{},{}}})", others, rest);
      EXPECT_NO_THROW(static_cast<void>(checked_loads(load_request(json), Door::command_line)))
          << json;
    }
  }
  EXPECT_NO_THROW(static_cast<void>(checked_loads(
      load_request(
          R"({"items":2,"against":2,"seconds":1,"sizes":[3,4,2,1],"memory":9,"fast_memory":8})"),
      Door::command_line)));
}

TEST(LoadRequest, SaysWhatIsWrongInTheWordsOfTheDoor) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"({})", "items and room are required"},
      {R"({"pairs":[[0,1]]})", "room is required"},
      {R"({"items":0,"room":2})", "items 0: give at least 1 item"},
      {R"({"items":9,"room":1})", "room 1: no two items could meet"},
      {R"({"items":9,"room":3,"workers":0})", "workers 0: give at least 1 worker"},
      {R"({"items":9,"room":3,"disjoint":true})", "disjoint is for workers; give both"},
      {R"({"items":9,"room":3,"fast_room":4})", "fast_room 4: of room 3 give 2 to 3"},
      {R"({"items":9,"room":3,"done_items":9})",
       "done_items 9: all 9 items would be done, and none new"},
      {R"({"items":9,"room":3,"against":2,"pairs":[[0,1]]})", "exclude each other"},
      {R"({"items":9,"room":3,"against":2,"seconds":1})",
       "seconds with against is for disjoint, fast_room or sizes"},
      {R"({"items":9,"room":3,"ordered":true})",
       "ordered is for new_pairs, write_back or prefetch"},
      {R"({"items":9,"room":3,"write_back":true,"workers":2})",
       "two workers would change one item"},
      {R"({"items":10000000,"room":3,"against":2})", "together; at most 10000000"},
      {R"({"items":9,"room":3,"pairs":[[0,9]]})", "pairs"},
      {R"({"items":9,"room":3,"pairs":[[0]]})", "pairs[0]: write [a,b]"},
      {R"({"sizes":[[0]],"memory":9})", "sizes[0]: write [item,bytes]"},
      {R"({"items":9,"room":3,"groups":[[]]})", "groups[0]: write [a,b,…]"},
      {R"({"items":9,"room":3,"groups":[[0]]})", "no pair is in a group"},
      {R"({"items":9,"room":3,"groups":[[0,1]],"done_items":3})", "exclude each other"},
      {R"({"room":3,"pairs":[[0,1,5]]})", "a third column, what a pair costs, is for workers"},
      {R"({"room":3,"pairs":[[0,1,5]],"workers":2,"first_holder":true})",
       "; with first_holder no third column says what a pair costs"},
      {R"({"room":3,"pairs":[[0,1,5]],"workers":2,"pair_cost":[[0,1,2]]})",
       "; with pair_cost no third column says what a pair costs"},
      {R"({"items":9,"room":3,"pairs":[]})", "pair"},
      {R"({"items":9,"room":"3"})", "room: write a whole number"},
      {R"({"items":9,"rooms":3})", "unknown key 'rooms'"},
  };
  for (const auto& [json, says] : cases) {
    EXPECT_THAT(refusal(json), HasSubstr(says)) << json;
    EXPECT_EQ(refusal(json).find('\n'), std::string::npos) << json;
  }
  EXPECT_THAT(refusal(R"({"items":9,"room":3,"fast_room":4})", Door::command_line),
              HasSubstr("--fast-room 4: of --room 3 give 2 to 3"));
}

TEST(LoadRequest, FaultsOfADocumentHaveTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"{\n \"items\": \"x\"}", "2:11: items: write a whole number"},
      {"{\"items\":9,\n\"rooms\":3}", "2:9: unknown key 'rooms'; the keys are "},
      {"{\"items\":9,\n\"room\":1}", "2:8: room 1: no two items could meet"},
      {"{\"items\":9,\n\"room\":3,\n \"epochs\": 0}", "3:12: epochs 0: give 1 to "},
      {"{\"items\":9,\"room\":3,\n\"disjoint\":true}", "2:12: disjoint is for workers; give both"},
      {"{\"items\":9,\"room\":3,\"against\":2,\n\"done_items\":2}",
       "1:31: pairs, groups, against and done_items exclude each other; give one of them"},
      {"{\"items\":9,\"room\":3,\"workers\":2,\n\"worker\":2}", "2:10: worker 2: of workers 2 "},
      {"\n {\"items\":9}", "2:2: items and room are required"},
      {"{\"room\":3,\"pairs\":[[0,1],\n [1,9],[2,3]],\"items\":9}", "2:2: pairs[1]: "},
      {"{\"room\":3,\"groups\":{\"text\":\"a,b\\n\\\"c\\n\"}}", "1:20: groups:2:1: "},
      {"{\"items\":9,\"room\":3,\n\"threads\":0,\"seconds\":1}", "2:11: threads 0 is out of range"},
  };
  for (const auto& [json, says] : cases) {
    for (const Door door : {Door::document, Door::command_line}) {
      try {
        static_cast<void>(checked_loads(load_request(json, "job.json"), door));
        ADD_FAILURE() << json;
      } catch (const BadOption& fault) {
        ADD_FAILURE() << fault.what();
      } catch (const BadInput& fault) {
        EXPECT_THAT(fault.what(), StartsWith("job.json:" + says)) << json;
      }
    }
  }
}

// What the command line gives is called as there, and is not at fault in the document.
TEST(LoadRequest, AKeyOfTheCommandLineHasNoPlaceInTheDocument) {
  const auto fault = [](LoadRequest typed, const std::string& json) -> std::string {
    complete(load_table(), typed, load_request(json, "job.json"));
    try {
      check_options(typed, Door::command_line);
    } catch (const BadOption& option) {
      return option.what();
    } catch (const BadInput& document) {
      return document.what();
    }
    return "taken";
  };
  EXPECT_EQ(fault({.room = 1}, R"({"items":9,"room":3})"),
            "--room 1: no two items could meet; give room for at least 2");
  EXPECT_EQ(fault({.prefetch = true}, R"({"items":9,"room":3,"workers":2,"disjoint":true})"),
            "job.json:1:44: disjoint has no meaning with --prefetch; leave it out");
  EXPECT_EQ(fault({.disjoint = true}, R"({"items":9,"room":3})"),
            "--disjoint is for workers; give both");
  EXPECT_EQ(fault({.workers = 2, .worker = 5}, R"({"items":9,"room":3,"workers":8})"),
            "--worker 5: of --workers 2 give 0 to 1");
  EXPECT_EQ(fault({.room = 4}, R"({"items":9,"room":1})"), "taken");
}

TEST(LoadRequest, ABadByteNeverBecomesAnotherFault) {
  std::mt19937_64 random(3);
  const std::string good =
      R"({"format":"changeover-load-request/1","items":12,"room":4,"pairs":[[0,1],["a","b"]],"workers":2,"seconds":1.5})";
  for (int i = 0; i < 20'000; ++i) {
    std::string bad = good;
    for (int j = 0; j < 1 + static_cast<int>(random() % 3); ++j) {
      bad[random() % bad.size()] = static_cast<char>(random());
    }
    try {
      static_cast<void>(checked_loads(load_request(bad), Door::document));
    } catch (const BadInput&) {
    } catch (const ImpossibleParameters&) {
    } catch (const MissingResource&) {
    }
  }
}

// A file may begin with names of columns; rows of a document are all meant.
TEST(LoadRequest, RowsOfADocumentAreNotTakenForTitles) {
  const auto pairs = [](const std::string& document) {
    return checked_loads(load_request(document), Door::document).wanted().count();
  };
  EXPECT_EQ(pairs(R"({"room":3,"pairs":[["a","b"],[0,1],[1,2]]})"), 3U);
  EXPECT_EQ(pairs(R"({"room":3,"pairs":{"text":"a b\n0 1\n1 2\n"}})"), 2U);
  EXPECT_EQ(pairs(R"({"room":3,"groups":[["a","b"],[0,1,2]]})"), 4U);
  EXPECT_EQ(pairs(R"({"room":3,"groups":[["a b","c"],["d"]]})"), 1U);
  EXPECT_THROW(pairs(R"({"room":3,"workers":2,"pairs":[["a","b","cost"],[0,1,2]]})"), BadInput);
  EXPECT_THROW(pairs(R"({"room":3,"items":4,"workers":2,"pair_cost":[["a","b","cost"]]})"),
               BadInput);
  EXPECT_THROW(pairs(R"({"memory":3,"sizes":[["item","bytes"],[0,1],[1,2]]})"), BadInput);
}

}  // namespace
}  // namespace changeover::load_request_test
