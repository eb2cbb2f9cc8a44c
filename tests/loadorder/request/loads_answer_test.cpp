// What the head of an answer says is what its steps do, whatever is asked; items in no listed pair
// are not loaded.
#include "loadorder/show/loads_answer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "changeover/core/error.hpp"
#include "pairs/pairs_support.hpp"

namespace changeover::loads_answer_test {
using test::random_pairs;
namespace {

using ::testing::HasSubstr;

/// A request and its answer; nothing if the options exclude each other.
std::unique_ptr<LoadsAnswer> answer(const LoadRequest& request,
                                    std::shared_ptr<const PairGraph> pairs = nullptr) {
  try {
    const CheckedLoads asked = checked_loads(request, Door::document, std::move(pairs));
    return std::make_unique<LoadsAnswer>(asked, LoadOrderOptions());
  } catch (const Error&) {
    return nullptr;
  }
}

/// The list of numbers in a line of JSON: "[7,8]".
std::string list_in(const std::string& head, const std::string& key) {
  const std::size_t at = head.find("\"" + key + "\":[");
  return at == std::string::npos
             ? ""
             : head.substr(head.find('[', at), head.find(']', at) + 1 - head.find('[', at));
}

/// Every combination of the options that say how steps compute.
template <typename Visit>
void each_combination(Visit&& visit) {
  for (unsigned bits = 0; bits < 1U << 8; ++bits) {
    const auto has = [&](unsigned bit) { return (bits >> bit & 1U) != 0; };
    LoadRequest request;
    request.room = 3;
    request.workers = 2;
    request.disjoint = has(0);
    request.new_pairs = has(1);
    request.ordered = has(2);
    request.self = has(3);
    request.spread = has(4);
    request.write_back = has(5);
    request.prefetch = has(6);
    request.first_holder = has(7);
    for (const std::uint64_t epochs : {1U, 2U}) {
      request.epochs = epochs;
      visit(request, fmt::format("{} {}", bits, epochs));
    }
  }
}

TEST(LoadsAnswer, WorkerPairsAreThoseOfTheSteps) {
  int counted = 0;
  each_combination([&](LoadRequest request, const std::string& what) {
    for (const std::uint64_t items : {6U, 9U}) {
      request.items = items;
      const auto loads = answer(request);
      if (loads == nullptr || !loads->shows_work()) {
        continue;
      }
      const std::string said = list_in(loads->head(), "worker_pairs");
      ASSERT_NE(said, "") << what;
      std::vector<std::uint64_t> pairs(2, 0);
      const auto steps = loads->steps(std::nullopt);
      for (Step step; steps->next(step);) {
        for (const auto* const computed : {&step.compute, &step.overlap}) {
          for (const auto& [x, y] : *computed) {
            pairs[static_cast<std::size_t>(step.worker)] += x < y ? 1U : 0U;
          }
        }
      }
      EXPECT_EQ(said, fmt::format("[{}]", fmt::join(pairs, ","))) << what << " " << items;
      ++counted;
    }
  });
  EXPECT_GT(counted, 100);
}

TEST(LoadsAnswer, ItemsInNoListedPairAreNotLoaded) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::uint64_t items = 8 + 3 * seed;
    const std::vector<ItemPair> pairs = random_pairs(items, 3 + seed % 5, seed);
    const auto graph = std::make_shared<const PairGraph>(items, pairs);
    each_combination([&](LoadRequest request, const std::string& what) {
      if (request.disjoint) {
        return;  // refused with lists
      }
      for (const std::uint64_t room : {std::uint64_t{4}, items}) {
        for (const std::uint64_t workers : {0U, 1U, 2U, 3U}) {
          request.room = room;
          request.workers = workers > 0 ? std::optional(workers) : std::nullopt;
          const auto loads = answer(request, graph);
          if (loads == nullptr) {
            continue;
          }
          const auto steps = loads->steps(std::nullopt);
          for (Step step; steps->next(step);) {
            for (const Element x : step.load) {
              ASSERT_TRUE(graph->is_needed(x)) << seed << " " << what << " " << workers;
            }
            for (const auto& [x, y] : step.compute) {
              ASSERT_TRUE(graph->is_needed(x) && graph->is_needed(y)) << seed << " " << what;
            }
          }
          ASSERT_EQ(loads->fault(), "") << seed << " " << what << " " << workers;
        }
      }
    });
  }
}

TEST(LoadsAnswer, OneWorkersSpreadPairsAreReadFirst) {
  LoadRequest request;
  request.items = 12;
  request.room = 4;
  request.workers = 2;
  request.worker = 1;
  request.new_pairs = request.spread = true;
  const auto loads = answer(request);
  ASSERT_NE(loads, nullptr);
  EXPECT_THAT(loads->head(), HasSubstr("\"pairs_per_step\""));
}

TEST(LoadsAnswer, WithoutLoadsNoPairIsComputedWhileTheyRun) {
  LoadRequest request;
  request.items = 3;
  request.room = 4;
  request.prefetch = true;
  request.epochs = 3;
  const auto loads = answer(request);
  ASSERT_NE(loads, nullptr);
  EXPECT_THAT(loads->head(), HasSubstr("\"overlapped\":0"));
}

// The value of a key of the head, up to the next key; empty if it is not there.
std::string value_in(const std::string& head, const std::string& key) {
  const std::string start = "\"" + key + "\":";
  const std::size_t at = head.find(start);
  if (at == std::string::npos) {
    return "";
  }
  const std::size_t from = at + start.size();
  return head.substr(from, head.find(",\"", from) - from);
}

// An order for five places has the bound of five, and the whole room of six still has its own:
// orders for all six places are possible, only that loads wait there.
TEST(LoadsAnswer, APlaceKeptForWhatLoadsHasBoundsBesideThoseOfTheWholeRoom) {
  for (const std::uint64_t workers : {0U, 3U}) {
    for (const std::uint64_t epochs : {1U, 3U}) {
      LoadRequest request;
      request.items = 20;
      request.workers = workers > 0 ? std::optional(workers) : std::nullopt;
      request.epochs = epochs;
      const auto head_of = [&request](std::uint64_t room, bool prefetch) {
        request.room = room;
        request.prefetch = prefetch;
        return answer(request)->head();
      };
      const std::string ahead = head_of(6, true);
      const std::string whole = head_of(6, false);
      const std::string less = head_of(5, false);
      ASSERT_EQ(value_in(ahead, "order_room"), "5") << workers << " " << epochs;
      EXPECT_NE(value_in(less, "lower_bound"), value_in(whole, "lower_bound"));
      for (const std::string_view key : {"lower_bound", "makespan_bound"}) {
        for (const std::string_view what : {"", "_reason"}) {
          const std::string name = fmt::format("{}{}", key, what);
          const std::string kept = key == "lower_bound" ? fmt::format("order_bound{}", what)
                                                        : fmt::format("order_{}", name);
          EXPECT_EQ(value_in(ahead, name), value_in(whole, name)) << workers << " " << epochs;
          EXPECT_EQ(value_in(ahead, kept), value_in(less, name)) << workers << " " << epochs;
        }
      }
      EXPECT_EQ(value_in(whole, "order_bound"), "");
      request.items = 5;  // All fit: no place is kept.
      EXPECT_EQ(value_in(head_of(6, true), "order_bound"), "");
    }
  }
}

// What Marius reads of these pairs of partitions, or why it cannot.
std::string as_marius(const std::vector<ItemPair>& pairs, std::uint64_t partitions,
                      std::uint64_t room) {
  LoadRequest request;
  request.room = room;
  const auto loads = answer(request, std::make_shared<const PairGraph>(partitions, pairs));
  StringSink sink;
  try {
    loads->write("marius", sink);
  } catch (const BadInput& fault) {
    return fault.what();
  }
  return sink.text();
}

TEST(LoadsAnswer, MariusNeedsAllPartitions) {
  EXPECT_THAT(as_marius({{0, 1}, {1, 2}, {2, 4}}, 5, 3), HasSubstr("partition 3 is in no pair"));
}

TEST(LoadsAnswer, MariusFindsItsBufferFullInEveryState) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::uint64_t partitions = 5 + seed % 7;
    std::vector<ItemPair> pairs = random_pairs(partitions, 1 + seed % 5, seed);
    for (Element x = 0; x + 1 < partitions; x += 2) {
      pairs.emplace_back(x, x + 1);  // so that each is in a pair
    }
    pairs.emplace_back(0, static_cast<Element>(partitions - 1));
    for (const std::uint64_t room : {2U, 3U, 4U}) {
      const std::string text = as_marius(pairs, partitions, room);
      const std::size_t begin = text.find("\"buffer_states\":[[");
      ASSERT_NE(begin, std::string::npos) << text;
      const std::string states = text.substr(begin, text.find("]]", begin) + 1 - begin);
      const auto ends = std::count(states.begin(), states.end(), ']');
      const auto commas = std::count(states.begin(), states.end(), ',');
      // A state has room - 1 commas in it, and one stands between two states.
      EXPECT_EQ(commas, ends * static_cast<std::ptrdiff_t>(room) - 1) << seed << " " << text;
    }
  }
}

// The list that COLMAP reads, or why there is none.
std::string as_colmap(const LoadRequest& request, std::shared_ptr<const PairGraph> pairs = {}) {
  const auto loads = answer(request, std::move(pairs));
  StringSink sink;
  try {
    loads->write("colmap", sink);
  } catch (const BadInput& fault) {
    return fault.what();
  }
  return sink.text();
}

TEST(LoadsAnswer, ColmapReadsEachPairOnceInBlocksThatFit) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::uint64_t items = 4 + seed % 9;
    std::vector<std::string> names;
    for (std::uint64_t x = 0; x < items; ++x) {
      names.push_back("image" + std::to_string(x) + ".jpg");
    }
    const std::vector<ItemPair> pairs = random_pairs(items, 1 + seed % 5, seed);
    const auto graph = std::make_shared<const PairGraph>(items, pairs, names);
    for (const std::uint64_t workers : {0U, 2U}) {
      LoadRequest request;
      request.room = 2 + seed % 4;
      request.workers = workers > 0 ? std::optional(workers) : std::nullopt;
      std::istringstream lines(as_colmap(request, graph));
      std::multiset<std::string> listed;
      std::set<std::string> block;
      for (std::string line; std::getline(lines, line);) {
        if (line.empty()) {
          EXPECT_FALSE(block.empty());
          block.clear();
          continue;
        }
        const std::size_t blank = line.find(' ');
        block.insert(line.substr(0, blank));
        block.insert(line.substr(blank + 1));
        EXPECT_LE(block.size(), *request.room);
        listed.insert(line);
      }
      std::multiset<std::string> wanted;
      for (Element x = 0; x < items; ++x) {
        for (const Element y : graph->partners(x)) {
          if (x < y) {
            wanted.insert(names[x] + " " + names[y]);
          }
        }
      }
      EXPECT_EQ(listed, wanted) << seed << " " << workers;
    }
  }
}

// What leaves late keeps its bytes while the next items load.
TEST(LoadsAnswer, MostBytesAreThoseWhileItemsLoad) {
  bool some_leave_late = false;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    std::vector<std::uint64_t> bytes;
    std::string sizes;
    for (std::uint64_t x = 0; x < 10; ++x) {
      bytes.push_back(1 + (seed * 37 + x * x * 11) % 40);
      sizes += fmt::format("{}{}", x > 0 ? "," : "", bytes.back());
    }
    const LoadRequest request = load_request(
        fmt::format(R"({{"items":10,"done_items":{},"memory":100,"prefetch":true,"sizes":[{}]}})",
                    4 + seed % 6, sizes));
    const CheckedLoads asked = checked_loads(request, Door::document);
    const LoadsAnswer loads(asked, LoadOrderOptions());
    std::uint64_t held = 0, most = 0;
    const auto steps = loads.steps(std::nullopt);
    for (Step step; steps->next(step);) {
      const auto sum = [&](std::size_t begin, std::size_t end) {
        std::uint64_t all = 0;
        for (std::size_t i = begin; i < end; ++i) {
          all += bytes[step.evict[i]];
        }
        return all;
      };
      const std::size_t first = step.evict.size() - static_cast<std::size_t>(step.late);
      held -= sum(0, first);
      for (const Element x : step.load) {
        held += bytes[x];
      }
      most = std::max(most, held);
      held -= sum(first, step.evict.size());
      some_leave_late = some_leave_late || step.late > 0;
    }
    EXPECT_THAT(loads.head(), HasSubstr(fmt::format("\"most_bytes\":{},", most))) << seed;
  }
  EXPECT_TRUE(some_leave_late);
}

TEST(LoadsAnswer, AWorkerWithoutWorkHasItsPlaceInEachList) {
  const LoadRequest request = load_request(
      R"({"items":6,"done_items":5,"workers":3,"disjoint":true,"memory":2,"sizes":[1,1,1,1,1,1]})");
  const CheckedLoads asked = checked_loads(request, Door::document);
  const std::string head = LoadsAnswer(asked, LoadOrderOptions()).head();
  for (const char* key : {"worker_loads", "worker_bytes", "worker_pairs"}) {
    const std::string list = list_in(head, key);
    EXPECT_EQ(std::count(list.begin(), list.end(), ','), 2) << key << " " << head;
  }
}

TEST(LoadsAnswer, ColmapIsGivenNoPairTwiceAndNoNameThatItCannotRead) {
  LoadRequest request;
  request.items = 70'000;
  request.room = 30'000;
  EXPECT_THAT(as_colmap(request), HasSubstr("at most 65535 items"));
  request.items = 7;
  request.room = 3;
  request.epochs = 2;
  EXPECT_THAT(as_colmap(request), HasSubstr("each pair once"));
  request.epochs = {};
  for (const char* name : {"a b", "a\tb", "a\nb", "#a"}) {
    EXPECT_THAT(
        as_colmap(request, std::make_shared<const PairGraph>(2, std::vector<ItemPair>{{0, 1}},
                                                             std::vector<std::string>{name, "c"})),
        HasSubstr("rename the image"))
        << name;
  }
}

TEST(LoadsAnswer, FormatsRefuseWhatTheyHaveNoPlaceForAtEachDoor) {
  LoadRequest request;
  request.items = 9;
  request.room = 3;
  const auto fault = [&](Door door, const std::string& format) {
    const CheckedLoads asked = checked_loads(request, door);
    try {
      check_format(asked, format);
    } catch (const BadInput& refused) {
      StringSink sink;
      EXPECT_THROW(LoadsAnswer(asked, {}).write(format, sink), BadInput);
      return std::string(refused.what());
    }
    StringSink sink;
    LoadsAnswer(asked, {}).write(format, sink);
    return std::string(sink.text().empty() ? "nothing" : "");
  };
  request.write_back = true;
  request.verify_beside = false;
  EXPECT_EQ(fault(Door::command_line, "marius"), "");
  EXPECT_EQ(fault(Door::command_line, "colmap"), "");
  request.write_back = false;
  request.verify_beside = true;
  EXPECT_EQ(fault(Door::python, "marius"), "");
  request.verify_beside = false;
  request.new_pairs = true;
  request.self = true;
  EXPECT_EQ(fault(Door::command_line, "colmap"),
            "a list for COLMAP has each pair once; leave out --self");
  EXPECT_EQ(fault(Door::document, "colmap"),
            "a list for COLMAP has each pair once; leave out self");
  EXPECT_EQ(fault(Door::python, "colmap"),
            "a list for COLMAP has each pair once; leave out with_self");
  request.workers = 2;
  EXPECT_EQ(fault(Door::command_line, "marius"),
            "Marius has one buffer, and its order from the first step; leave out --workers");
}

// Only where pairs are written as a|b would a name with a bar be two.
TEST(LoadsAnswer, ANameMayHaveABarWherePairsAreNotWritten) {
  const auto graph = [] {
    return std::make_shared<const PairGraph>(2, std::vector<ItemPair>{{0, 1}},
                                             std::vector<std::string>{"a|b", "c"});
  };
  LoadRequest request;
  request.room = 2;
  const auto written = [&](const std::string& format) {
    StringSink sink;
    answer(request, graph())->write(format, sink);
    return sink.text();
  };
  EXPECT_EQ(written("csv"), "step,load,evict\n1,a|b c,\n");
  EXPECT_EQ(written("colmap"), "a|b c\n");
  request.new_pairs = true;
  EXPECT_THAT(written("jsonl"), HasSubstr(R"("new_pairs":[["a|b","c"]])"));
  EXPECT_THROW(written("csv"), BadInput);
  EXPECT_THROW(written("text"), BadInput);
  request.new_pairs = false;
  request.prefetch = true;
  EXPECT_THROW(written("csv"), BadInput);
}

}  // namespace
}  // namespace changeover::loads_answer_test
