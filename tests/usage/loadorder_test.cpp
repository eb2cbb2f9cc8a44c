// changeover loadorder from outside: the contract of its lines, its exit codes, its files.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include "cases.hpp"

namespace changeover::test::loadorder_test {
namespace {

// The numbers of the list that follows "name": in a line of JSON.
std::vector<unsigned> list_in(const std::string& line, const std::string& name) {
  const std::size_t start = line.find("\"" + name + "\":[");
  std::vector<unsigned> numbers;
  if (start == std::string::npos) {
    return numbers;
  }
  const std::size_t begin = line.find('[', start) + 1;
  std::istringstream list(line.substr(begin, line.find(']', begin) - begin));
  for (std::string number; std::getline(list, number, ',');) {
    numbers.push_back(static_cast<unsigned>(std::stoul(number)));
  }
  return numbers;
}

std::uint64_t number_in(const std::string& line, const std::string& name) {
  const std::size_t start = line.find("\"" + name + "\":");
  return start == std::string::npos ? 0 : std::stoull(line.substr(start + name.size() + 3));
}

TEST(LoadOrder, OfBillionsOfStepsBeginsAtOnce) {
  const TemporaryFolder folder;
  for (const char* how : {"--workers 3", "--prefetch", ""}) {
    const Outcome outcome =
        run(std::string("timeout 60 $changeover loadorder --items 65534 --room 4 --quiet ") + how +
                " | head -n 1",
            folder.path());
    EXPECT_EQ(outcome.out.find("65534 items, room for 4"), 0U) << how << outcome.out;
  }
}

TEST(LoadOrderVerb, SaysEachStepInALineOfJsonAndEveryPairMeets) {
  const TemporaryFolder folder;
  const Outcome outcome = run("$changeover loadorder --items 20 --room 5 --json", folder.path());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 2U);
  EXPECT_EQ(number_in(lines[0], "items"), 20U);
  EXPECT_EQ(number_in(lines[0], "room"), 5U);
  EXPECT_EQ(number_in(lines[0], "steps"), lines.size() - 1);
  EXPECT_EQ(number_in(lines[0], "lower_bound"), 50U);
  std::set<unsigned> memory;
  std::set<std::pair<unsigned, unsigned>> met;
  std::uint64_t loads = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_EQ(number_in(lines[i], "step"), i);
    for (const unsigned x : list_in(lines[i], "evict")) {
      EXPECT_EQ(memory.erase(x), 1U);
    }
    for (const unsigned x : list_in(lines[i], "load")) {
      EXPECT_TRUE(memory.insert(x).second);
      ++loads;
    }
    EXPECT_LE(memory.size(), 5U);
    for (const unsigned x : memory) {
      for (const unsigned y : memory) {
        if (x < y) {
          met.emplace(x, y);
        }
      }
    }
  }
  EXPECT_EQ(met.size(), 190U);
  EXPECT_EQ(loads, number_in(lines[0], "loads"));
}

TEST(LoadOrderVerb, WordsOfOneAndOfTheTrueMean) {
  const TemporaryFolder folder;
  spit(folder.file("pairs"), "0 0\n");
  expect({{"$changeover loadorder --items 6 --room 3 --workers 2 --disjoint --quiet | tail -n 20",
           0, "computes 9 of 15, 20.00 % over the mean 7.5\n"},
          {"$changeover loadorder --items 1 --room 2 --item-bytes 1 --quiet", 0,
           "1 byte is loaded\n"}},
         folder);
}

TEST(LoadOrderVerb, StartsAtOnceWithAMillionItems) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover loadorder --items 1000000 --room 1000 --json | head -n 1000", folder.path());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(lines_of(outcome.out).size(), 1000U);
}

TEST(LoadOrderVerb, NeedsNoMemoryForTheStepsOfAMillionItems) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer reserves terabytes of address space";
#endif
  const TemporaryFolder folder;
  // 500 MB of address space; the steps would take gigabytes.
  const Outcome outcome =
      run("ulimit -v 500000; $changeover loadorder --items 1000000 --room 1000 --format csv | "
          "head -n 3000000 | tail -n 1",
          folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("2999999,", 0), 0U) << outcome.out << outcome.err;
}

TEST(LoadOrderVerb, GivesDisjointWorkersThatNeverHoldOneItemTwice) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover loadorder --items 24 --room 5 --workers 3 --disjoint --new-pairs --json",
          folder.path());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  EXPECT_EQ(3 * number_in(lines[0], "steps"), lines.size() - 1);
  EXPECT_EQ(list_in(lines[0], "worker_loads").size(), 3U);
  std::vector<std::set<unsigned>> memory(3);
  std::uint64_t loads = 0;
  for (std::size_t i = 1; i < lines.size(); i += 3) {
    std::set<unsigned> all;
    std::size_t held = 0;
    for (std::size_t w = 0; w < 3; ++w) {
      EXPECT_EQ(number_in(lines[i + w], "worker"), w);
      EXPECT_EQ(number_in(lines[i + w], "step"), (i + 2) / 3);
      for (const unsigned x : list_in(lines[i + w], "evict")) {
        EXPECT_EQ(memory[w].erase(x), 1U);
      }
      for (const unsigned x : list_in(lines[i + w], "load")) {
        EXPECT_TRUE(memory[w].insert(x).second);
        ++loads;
      }
      EXPECT_LE(memory[w].size(), 5U);
      all.insert(memory[w].begin(), memory[w].end());
      held += memory[w].size();
    }
    EXPECT_EQ(all.size(), held) << lines[i];
  }
  EXPECT_EQ(loads, number_in(lines[0], "loads"));
}

TEST(LoadOrderVerb, TellsWorkersAndPrefetchApart) {
  const TemporaryFolder folder;
  const Outcome workers =
      run("$changeover loadorder --items 64 --room 16 --workers 4 --json", folder.path());
  ASSERT_EQ(workers.code, 0) << workers.err;
  const std::vector<std::string> lines = lines_of(workers.out);
  EXPECT_EQ(list_in(lines[0], "worker_loads").size(), 4U);
  EXPECT_GE(number_in(lines[0], "makespan"), number_in(lines[0], "makespan_bound"));
  EXPECT_NE(lines.back().find("\"worker\":3"), std::string::npos);
  const Outcome prefetch =
      run("$changeover loadorder --items 16 --room 5 --prefetch --json", folder.path());
  ASSERT_EQ(prefetch.code, 0) << prefetch.err;
  EXPECT_EQ(number_in(prefetch.out, "pairs"), 120U);
  EXPECT_NE(prefetch.out.find("\"compute\":[["), std::string::npos);
}

// An order as JSON: its first line, and those of its steps.
struct Said {
  std::string head;
  std::vector<std::string> steps;
};

Said said_by(const std::string& command, const TemporaryFolder& folder) {
  const Outcome all = run(command, folder.path());
  EXPECT_EQ(all.code, 0) << all.err;
  std::vector<std::string> lines = lines_of(all.out);
  lines.resize(std::max<std::size_t>(1, lines.size()));
  return {lines[0], {lines.begin() + 1, lines.end()}};
}

std::vector<std::string> steps_of(std::uint64_t worker, const std::vector<std::string>& all) {
  std::vector<std::string> own;
  std::ranges::copy_if(all, std::back_inserter(own), [&](const std::string& line) {
    return number_in(line, "worker") == worker;
  });
  return own;
}

// What a task of a job array reads is what stands in the lines of all workers.
TEST(LoadOrderVerb, AWorkerReadsItsOwnSteps) {
  const TemporaryFolder folder;
  for (const char* how :
       {"--items 64 --room 16 --workers 4", "--items 64 --room 32 --workers 7 --new-pairs",
        "--items 64 --room 16 --workers 3 --first-holder --new-pairs",
        "--items 20 --against 24 --room 9 --workers 4"}) {
    const std::string command = std::string("$changeover loadorder --json ") + how;
    const auto [head, lines] = said_by(command, folder);
    std::uint64_t pairs = 0;
    std::uint64_t most = 0;
    const std::vector<unsigned> said = list_in(head, "worker_pairs");
    for (std::size_t w = 0; w < said.size(); ++w) {
      pairs += said[w];
      most = std::max<std::uint64_t>(most, said[w]);
      const auto [own_head, own] = said_by(command + " --worker " + std::to_string(w), folder);
      EXPECT_EQ(number_in(own_head, "worker"), w);
      for (const char* key : {"loads", "makespan", "makespan_bound"}) {
        EXPECT_EQ(number_in(own_head, key), number_in(head, key)) << how << ' ' << key;
      }
      EXPECT_EQ(own, steps_of(w, lines)) << how;
    }
    EXPECT_GT(pairs, 0U) << how;
    EXPECT_GE(most, number_in(head, "pairs_per_worker_bound"));
    EXPECT_EQ(most, number_in(head.substr(head.find("pairs_per_worker")), "max"));
  }
}

// Of schedules that say more, too: they are read whole, and the first line is that of all workers.
TEST(LoadOrderVerb, AWorkerReadsItsOwnStepsOfAnySchedule) {
  const TemporaryFolder folder;
  for (const char* how :
       {"--items 24 --room 4 --workers 3 --disjoint",
        "--items 24 --room 4 --workers 3 --disjoint --write-back --ordered --self",
        "--items 40 --room 12 --workers 3 --prefetch",
        "--items 30 --against 12 --room 8 --workers 2 --prefetch",
        "--items 40 --room 12 --workers 3 --fast-room 4 --item-bytes 8",
        "--items 40 --room 12 --workers 3 --fast-room 4 --new-pairs --shuffle --seed 5"}) {
    const std::string command = std::string("$changeover loadorder --json ") + how;
    const auto [head, lines] = said_by(command, folder);
    std::size_t steps = 0;
    for (unsigned w = 0; w < number_in(head, "workers"); ++w) {
      auto [own_head, own] = said_by(command + " --worker " + std::to_string(w), folder);
      const std::string key = ",\"worker\":" + std::to_string(w);
      ASSERT_NE(own_head.find(key), std::string::npos) << own_head;
      own_head.erase(own_head.find(key), key.size());
      EXPECT_EQ(own_head, head) << how;
      EXPECT_EQ(own, steps_of(w, lines)) << how;
      steps += own.size();
    }
    EXPECT_EQ(steps, lines.size()) << how;
    EXPECT_GT(steps, 0U);
  }
}

TEST(LoadOrderVerb, BeginsAtAnyStep) {
  const TemporaryFolder folder;
  for (const char* size : {"--items 40 --room 9", "--items 100000 --room 20000"}) {
    const std::string command = std::string("$changeover loadorder --json ") + size;
    const Outcome all = run(command + " | head -n 61", folder.path());
    const Outcome later = run(command + " --from-step 50 | head -n 12", folder.path());
    ASSERT_EQ(later.code, 0) << later.err;
    const std::vector<std::string> lines = lines_of(all.out);
    const std::vector<std::string> rest = lines_of(later.out);
    std::set<unsigned> memory;
    for (std::size_t i = 1; i <= 50; ++i) {
      for (const unsigned x : list_in(lines[i], "evict")) {
        memory.erase(x);
      }
      const std::vector<unsigned> load = list_in(lines[i], "load");
      memory.insert(load.begin(), load.end());
    }
    const std::vector<unsigned> first = list_in(rest[1], "load");
    EXPECT_EQ(std::set<unsigned>(first.begin(), first.end()), memory);
    EXPECT_EQ(number_in(rest[0], "from_step"), 50U);
    EXPECT_EQ(number_in(rest[1], "step"), 50U);
    for (std::size_t i = 2; i < 12; ++i) {
      EXPECT_EQ(rest[i], lines[49 + i]);
    }
  }
}

TEST(LoadOrderVerb, SpreadsWhatPairsCost) {
  const TemporaryFolder folder;
  std::string costs = "# first,second,cost\n";
  for (int i = 1; i < 24; ++i) {
    costs += "0," + std::to_string(i) + ",40\n";
  }
  spit(folder.file("costs.csv"), costs);
  spit(folder.file("edges"), "a b\nb c\nc d\nd a\n");
  spit(folder.file("named"), "a b 5\n");
  spit(folder.file("twice"), "0 1 5\n1 0 5\n");
  spit(folder.file("negative"), "0 1 -5\n");
  spit(folder.file("short"), "0 1 2\n0 2\n");
  spit(folder.file("unit"), "0 1 5s\n");
  spit(folder.file("endless"), "0 1 1e999\n2 3 4\n");
  spit(folder.file("huge"), "0 1 1e100\n2 3 1e308\n");
  spit(folder.file("word"), "a b dear\nb c 2\n");
  spit(folder.file("header"), "one other cost\na b 2\n");
  const std::string command = "$changeover loadorder --items 24 --room 8 --workers 3 ";
  const Outcome spread = run(command + "--pair-cost costs.csv --json", folder.path());
  ASSERT_EQ(spread.code, 0) << spread.err;
  const std::string head = lines_of(spread.out)[0];
  const std::string cost = head.substr(head.find("cost_per_worker"));
  EXPECT_LT(number_in(cost, "max"), 1.1 * static_cast<double>(number_in(cost, "mean")) + 41);
  EXPECT_EQ(list_in(head, "worker_costs").size(), 3U);
  for (const Case& each : std::vector<Case>{
           {"--pair-cost costs.csv", 0, "over the mean"},
           {"--pair-cost twice", 3, "twice:2:1: the pair of '1' and '0' has a cost already"},
           {"--pair-cost negative", 3,
            "negative:1:5: '-5' is not a cost; give a number, 0 or more"},
           {"--pair-cost short", 3, "the cost of the pair is missing; write two items"},
           {"--pair-cost unit", 3, "unit:1:5: '5s' is not a cost"},
           {"--pair-cost endless", 3, "endless:1:5: '1e999' is not a cost"},
           {"--pair-cost huge", 3, "huge:2:5: '1e308' is too much for a cost; give 1e+100 at most"},
           {"--pair-cost absent", 4, "absent: cannot read"},
           {"--pair-cost costs.csv --first-holder", 2, "exclude each other"},
           {"--pair-cost costs.csv --disjoint", 2, "--disjoint"},
           {"--balance --first-holder", 2, "exclude each other"},
           {"--worker 3", 2, "give 0 to 2"},
           {"--from-step 3", 2, "--from-step N has no meaning with --workers; leave it out"},
           {"--verify-beside", 0, "every step is read while it is written"},
           {"--verify-beside --new-pairs", 0, "every step is read while it is written"},
           {"--verify-beside --worker 1", 0, "the steps of worker 1 are read while"}}) {
    expect({{command + each.command, each.code, each.says}}, folder);
  }
  expect(
      {{"$changeover loadorder --pairs edges --room 2 --workers 2 --pair-cost named", 0, "cost"},
       {"$changeover loadorder --pairs edges --room 2 --workers 2 --pair-cost twice", 3,
        "'0' is not in the listed pairs"},
       {"$changeover loadorder --pairs edges --room 2 --workers 2 --pair-cost word", 3,
        "word:1:5: 'dear' is not a cost"},
       {"$changeover loadorder --pairs edges --room 2 --workers 2 --pair-cost header 2>said", 0,
        "cost"},
       {"cat said", 0, "header:1:1: the first row was read as names of columns: one, other, cost"},
       {"$changeover loadorder --items 9 --room 4 --pair-cost named", 2, "--workers"},
       {"$changeover loadorder --items 9 --room 4 --worker 0", 2, "--workers"}},
      folder);
}

TEST(LoadOrderVerb, HasTheExitCodesThatAreDocumented) {
  const TemporaryFolder folder;
  spit(folder.file("old"), "precious\n");
  spit(folder.file("edges"), "0 1\n1 2\n0 2\n2 3\n");
  spit(folder.file("named.csv"), "left,right\n");
  spit(folder.file("sizes"), "5\n4\n3\n2\n");
  spit(folder.file("formula.txt"), "=1 @x\n");
  spit(folder.file("photos.csv"), "\"cam 0/x.JPG\",\"c, \"\"d\"\"\"\n");
  for (const Case& each : std::vector<Case>{
           {"--items 64 --room 16", 0, "over the lower bound 144"},
           {"--items 12 --room 4", 0, "the fewest possible"},
           {"--items 4 --room 9", 0, "4 loads, the fewest possible, in 1 step"},
           {"--items 1 --room 2", 0, "1 load, the fewest possible, in 1 step"},
           {"--items 9 --room 4 --format csv", 0, "step,load,evict"},
           {"--items 9 --room 4 --workers 2", 0, "worker 1 step"},
           {"--items 9 --room 4 --prefetch", 0, "compute"},
           {"--items 20 --room 6 --prefetch", 0, "no order for 5 has fewer than 50 loads"},
           {"--items 20 --room 6 --prefetch", 0, "bound with room for 5: "},
           {"--items 30 --room 6 --prefetch --workers 3", 0, "with 5 some worker has at least "},
           {"--items 9 --room 4 --workers 2 --disjoint", 0, "no item at two of them"},
           {"--items 9 --room 4 --workers 1 --disjoint --format csv", 0, "worker,step,load,evict"},
           {"--items 16 --room 4 --workers 2 --disjoint --time 100ms --quiet", 0,
            "all evict, wait"},
           {"--items 9 --room 4 --workers 2 --disjoint --new-pairs --ordered --self --json", 0,
            "81 pairs computed, each once"},
           {"--items 7 --room 4 --workers 2 --disjoint", 0, "no item at two of them"},
           {"--items 3 --room 4 --workers 2 --disjoint", 0, "no item at two of them"},
           {"--items 400 --room 4 --workers 201 --disjoint", 0, "no item at two of them"},
           {"--items 70000 --room 4 --workers 2 --disjoint", 2, "at most 65535"},
           {"--items 9 --room 4 --write-back", 0, "no change is lost"},
           {"--items 24 --room 6 --write-back --json", 0, "\"store_bound\":"},
           {"--items 24 --room 6 --write-back --format csv", 0, "step,load,evict,store"},
           {"--pairs edges --room 3 --write-back --new-pairs", 0, "; store 0"},
           {"--items 24 --room 6 --workers 2 --disjoint --write-back", 0, "all store and evict"},
           {"--items 24 --room 6 --workers 2 --disjoint --write-back --json", 0, "\"stores\":"},
           {"--items 24 --room 6 --workers 2 --disjoint --write-back --format csv", 0,
            "worker,step,load,evict,store"},
           {"--items 24 --room 6 --workers 2 --write-back", 2, "add --disjoint"},
           {"--items 24 --room 6 --prefetch --write-back", 0,
            "while items load; no change is lost"},
           {"--items 24 --room 6 --prefetch --write-back --json", 0, "\"store\":["},
           {"--items 24 --room 6 --prefetch --ordered --self", 0, "all 576 pairs computed once"},
           {"--items 24 --room 6 --prefetch --workers 2 --disjoint", 2, "--prefetch"},
           {"--items 24 --room 6 --prefetch --workers 2 --write-back", 2, "add --disjoint"},
           {"--items 24 --room 6 --prefetch --workers 2 --format csv", 0,
            "worker,step,load,evict_first,evict_late,before,compute"},
           {"--pairs edges --room 3 --prefetch --workers 2 --json", 0, "\"overlapped\":"},
           {"--items 40 --room 12 --fast-room 4 --write-back", 0, "no change is lost"},
           {"--items 40 --room 12 --fast-room 4 --write-back --format csv", 0,
            "step,fast_evict,evict,store,load,fast_load"},
           {"--items 40 --room 12 --fast-room 4 --new-pairs --ordered --self", 0,
            "1600 pairs computed on the accelerator"},
           {"--items 40 --room 12 --fast-room 4", 0,
            "pairs computed on the accelerator, each once"},
           {"--items 40 --room 12 --fast-room 4 --item-bytes 1000 --json", 0, "\"bytes_loaded\":"},
           {"--items 4 --room 12 --fast-room 4", 0, "4 transfers, the fewest possible"},
           {"--items 40 --room 12 --fast-room 4 --new-pairs --format csv", 0,
            "step,fast_evict,evict,load,fast_load,new_pairs"},
           {"--items 40 --room 12 --fast-room 13", 2, "give 2 to 12"},
           {"--items 40 --room 12 --fast-room 1", 2, "give 2 to 12"},
           {"--items 70000 --room 12 --fast-room 4", 2, "at most 65535"},
           {"--items 40 --room 12 --fast-room 4 --item-bytes 0", 2, "--item-bytes 0"},
           {"--items 40 --room 12 --item-bytes 9", 0, "756 bytes are loaded"},
           {"--items 40 --room 12 --fast-room 4 --workers 2", 0, "for 2 workers, the busiest has"},
           {"--items 40 --room 12 --fast-room 4 --workers 2 --json", 0, "\"worker\":1,\"step\":1"},
           {"--items 40 --room 12 --fast-room 4 --workers 2 --write-back", 2, "add --disjoint"},
           {"--items 40 --room 12 --fast-room 4 --prefetch", 0, "start in a step before the item"},
           {"--items 40 --room 12 --fast-room 4 --prefetch --workers 2 --json", 0,
            "\"loads_ahead\":"},
           {"--items 20 --room 8 --fast-room 4 --prefetch --epochs 2 --write-back", 0,
            "no change is lost"},
           {"--items 20 --room 8 --fast-room 4 --time 0.1s", 0, "to the accelerator:"},
           {"--sizes sizes --memory 12 --fast-memory 9 --prefetch", 0, "start to load"},
           {"--sizes sizes --memory 12 --fast-memory 9 --workers 2 --disjoint --write-back", 0,
            "to the accelerators, with 9 bytes: "},
           {"--sizes sizes --memory 12 --fast-memory 9", 0,
            "4 items, 12 bytes of memory and 9 on the accelerator: "},
           {"--sizes sizes --memory 12 --fast-memory 9 --new-pairs --epochs 2 --json", 0,
            "every step read: bytes at both levels, 12 pairs computed on the accelerator"},
           {"--sizes sizes --memory 12 --fast-memory 9 --write-back --format csv", 0,
            "step,fast_evict,evict,store,load,fast_load"},
           {"--sizes sizes --memory 1M --fast-memory 1K", 0, "14 bytes in 4 transfers, the fewest"},
           {"--sizes sizes --memory 12 --fast-memory 1K", 2, "of --memory 12 give 2 to 12"},
           {"--items 9 --room 4 --disjoint", 2, "--disjoint is for --workers"},
           {"--items 9 --room 4 --against 5 --workers 2 --disjoint", 0, "9 items with 5 others"},
           {"--items 13 --room 5 --time 200ms --quiet --threads 1 --seed 3", 0, "loads"},
           {"--pairs edges --room 3", 0, "4 loads, the fewest possible, in 2 steps"},
           {"--pairs edges --room 3 --json", 0, "\"wanted_pairs\":4"},
           {"--pairs named.csv --room 2", 0, "load left right"},
           {"--pairs formula.txt --room 2 --format csv", 0, "1,'=1 @x,"},
           {"--pairs photos.csv --room 2", 0, "load \"cam 0/x.JPG\" \"c, \"\"d\"\"\"\n"},
           {"--pairs photos.csv --room 2 --new-pairs", 0, "\"cam 0/x.JPG\"|\"c, \"\"d\"\"\"\n"},
           {"--pairs photos.csv --room 2 --json", 0, "[\"cam 0/x.JPG\",\"c, \\\"d\\\"\"]"},
           {"--pairs photos.csv --room 2 --format csv", 0,
            "\n1,\"\"\"cam 0/x.JPG\"\" \"\"c, \"\"\"\"d\"\"\"\"\"\"\","},
           {"--pairs photos.csv:Cams --room 2", 3, "photos.csv: not a workbook"},
           {"--pairs named.csv --room 2 --json", 0, "\"load\":[\"left\",\"right\"]"},
           {"--pairs edges --room 3 --prefetch", 0, "all 4 pairs computed once"},
           {"--pairs edges --room 3 --workers 2", 0, "worker 1 step"},
           {"--pairs edges --room 3 --time 100ms --quiet", 0, "4 loads"},
           {"--pairs - --room 3 < edges", 0, "4 listed pairs, room for 3"},
           {"--pairs edges --room 3 --items 9", 0, "each of 4 items is loaded"},
           {"--items 12 --against 12 --room 4", 0, "57 loads, 11.76 % over"},
           {"--items 12 --against 12 --room 4 --format csv", 0, "step,load,evict"},
           {"--items 1024 --done-items 1000 --room 64", 0, "1024 loads, the fewest"},
           {"--items 90000 --against 9 --room 20 --json", 0, "64 items are followed"},
           {"--items 24 --room 6 --new-pairs", 0, "276 pairs computed, each once"},
           {"--items 24 --room 6 --new-pairs --ordered --self", 0, "576 pairs computed"},
           {"--items 24 --room 6 --new-pairs --format csv", 0, "step,load,evict,new_pairs"},
           {"--items 9 --room 4 --new-pairs --self --json", 0, "\"new_pairs\":[[0,0],["},
           {"--items 24 --room 6 --new-pairs --shuffle --seed 3", 0, "new pairs"},
           {"--items 9 --room 4 --new-pairs --workers 2 --json", 0, "\"new_pairs\":[["},
           {"--pairs named.csv --room 2 --new-pairs --ordered", 0, "right|left"},
           {"--items 9 --room 4 --self", 2,
            "--self is for --new-pairs, --write-back or --prefetch; give one of them, too"},
           {"--items 1024 --room 512 --workers 16", 0,
            "groups: The 34 groups, of at most 31 items, are the numbers modulo 34"},
           {"--items 1024 --room 512 --workers 16", 0, "every step read, all 523776 pairs met\n"},
           {"--items 1024 --room 512 --workers 16 --json", 0,
            "\"verified\":\"every step read, all 523776 pairs met\""},
           {"--items 100000 --room 50000 --workers 3 --json | head -n 1", 0,
            "\"verified\":\"structure: all steps of 2 items a group read, all 15 pairs"},
           {"--items 9 --room 4 --new-pairs --prefetch", 2, "exclude each other"},
           {"--pairs edges", 2, "--room C is required"},
           {"--pairs edges --room 1", 2, "at least 2"},
           {"--pairs edges --against 4 --room 3", 2, "exclude each other"},
           {"--items 4 --against 0 --room 3", 2, "--against 0: give at least 1"},
           {"--items 4 --done-items 4 --room 3", 2, "and none new"},
           {"--items 99999999 --against 4 --room 3", 2, "at most 10000000"},
           {"--items 9999999 --against 2 --room 3", 2, "are 10000001 items together; at most"},
           {"--items 9 --room 10000001", 2, "--room 10000001: give at most 10000000"},
           {"--items 1 --against 1 --room 10000000 --workers 2", 0, "1 item with 1 other, room"},
           {"--items 9000000 --room 8000000 --new-pairs", 4, "a step of --new-pairs with --room"},
           {"--items 4 --against 4 --room 3 --time 1s", 2, "--time"},
           {"--pairs edges --room 3 -o edges", 2, "the same file as --pairs"},
           {"--items 4 --room 2 --workers 2 --pair-cost edges -o edges", 2,
            "the same file as --pair-cost"},
           {"--pairs edges --room 3 --items 3", 3,
            "edges:4:3: item 3 does not exist; items are 0 to 2"},
           {"--pairs old --room 3", 3, "old:1:1: one item stands alone"},
           {"--pairs absent --room 3", 4, "absent: cannot read"},
           {"--items 0 --room 4", 2, "at least 1 item"},
           {"--items 9 --room 1", 2, "at least 2"},
           {"--items 9 --room 0", 2, "at least 2"},
           {"--items 9 --room 4 --workers 0", 2, "at least 1 worker"},
           {"--items 9 --room 4 --workers 99999999", 2, "65536"},
           {"--items 9 --room 4 --workers 2 --prefetch", 0, "while items load"},
           {"--items 9 --room 4 --json --format csv", 2, "--json and --format csv exclude"},
           {"--items 9 --room 4 --threads 2", 2, "--threads N is for --time"},
           {"--items 9 --room 4 --memory 1G", 2, "--memory SIZE is for --time"},
           {"--items 9", 2, "--items P and --room C are required"},
           {"--items x --room 4", 2, "whole number"},
           {"--items 99999999999 --room 4", 2, "at most"},
           {"--items 9 --room 4 --time soon", 2, "duration"},
           {"--items 9 --room 4 -o no/such/folder/x", 4, "no/such/folder/x"},
           {"--items 999999 --room 100000 -o /dev/full", 4, "/dev/full"}}) {
    expect({{"$changeover loadorder " + each.command, each.code, each.says}}, folder);
  }
  EXPECT_EQ(run("$changeover loadorder --items 64 --room 16 -o old", folder.path()).code, 0);
  EXPECT_EQ(slurp(folder.file("old")).rfind("64 items, room for 16", 0), 0U);
}

}  // namespace
}  // namespace changeover::test::loadorder_test
