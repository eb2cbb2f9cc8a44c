// The executor against the same sums in memory, and against everything that can go wrong.
#include "changeover/loadorder/all_pairs.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "message_of.hpp"
#include "run_program.hpp"

namespace changeover::test::all_pairs_test {
namespace {

constexpr std::size_t item_bytes = 1000;  // not a multiple of anything

std::string content(std::size_t bytes) {
  std::string text(bytes, '\0');
  std::uint32_t state = 12345;
  for (char& c : text) {
    state = state * 1664525 + 1013904223;
    c = static_cast<char>(state >> 24);
  }
  return text;
}

std::uint64_t dot(std::span<const std::byte> a, std::span<const std::byte> b) {
  std::uint64_t sum = a.size() * 31 + b.size() * 31;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    sum += std::to_integer<std::uint64_t>(a[i]) * std::to_integer<std::uint64_t>(b[i]);
  }
  return sum;
}

using Results = std::map<std::pair<Element, Element>, std::uint64_t>;

Results in_memory(const std::string& data) {
  const auto item = [&](std::size_t i) {
    return std::as_bytes(std::span(data).subspan(
        i * item_bytes, std::min(item_bytes, data.size() - i * item_bytes)));
  };
  const std::size_t items = (data.size() + item_bytes - 1) / item_bytes;
  Results results;
  for (std::size_t i = 0; i < items; ++i) {
    for (std::size_t j = i; j < items; ++j) {
      results[{static_cast<Element>(i), static_cast<Element>(j)}] = dot(item(i), item(j));
    }
  }
  return results;
}

/// Collects results and refuses a pair that comes twice.
struct Collector {
  std::mutex mutex;
  Results results;
  bool repeated = false;

  PairCompute compute() {
    return [this](const PairWork& work) {
      const std::uint64_t value = dot(work.first.bytes, work.second.bytes);
      const std::lock_guard lock(mutex);
      repeated |= !results.emplace(std::pair(work.first.item, work.second.item), value).second;
    };
  }
};

TEST(AllPairs, GivesWhatIsComputedInMemoryForAnyThreadsAndReaders) {
  const TemporaryFolder folder;
  const std::string data = content(item_bytes * 24 + 137);  // 25 items, the last one short
  spit(folder.file("data"), data);
  const Results expected = in_memory(data);
  for (const bool bypass : {false, true}) {
    FileItems file(folder.file("data"), item_bytes, {.bypass_cache = bypass});
    ASSERT_EQ(file.item_count(), 25U);
    for (const std::uint64_t room : {2U, 5U, 25U, 40U}) {
      const LoadOrder order = plan_load_order(25, room);
      for (const unsigned threads : {1U, 3U}) {
        Collector collector;
        AllPairsOptions options;
        options.threads = threads;
        options.readers = threads;
        const AllPairsReport report = all_pairs(file, order, collector.compute(), options);
        EXPECT_TRUE(report.finished);
        EXPECT_FALSE(collector.repeated);
        EXPECT_EQ(collector.results, expected);
        EXPECT_EQ(report.loads, order.facts().loads);
        EXPECT_EQ(report.steps_done, order.facts().steps);
        EXPECT_EQ(report.pairs, 25U * 26U / 2);
        EXPECT_LE(report.most_in_memory, room);
        EXPECT_EQ(report.buffer_bytes, std::min<std::uint64_t>(room, 25) * file.buffer_bytes());
      }
    }
  }
}

TEST(AllPairs, OfSeveralProcessesIsThatOfOneEachPairOnce) {
  const TemporaryFolder folder;
  const std::string data = content(item_bytes * 30);
  spit(folder.file("data"), data);
  FileItems file(folder.file("data"), item_bytes);
  const LoadOrder order = plan_load_order(30, 6);
  for (const std::uint64_t of : {2U, 3U, 5U, 500U}) {
    Collector collector;  // shared: a pair of two processes would be a repetition
    for (std::uint64_t index = 0; index < of; ++index) {
      AllPairsOptions options;
      options.share = {index, of};
      EXPECT_TRUE(all_pairs(file, order, collector.compute(), options).finished);
    }
    EXPECT_FALSE(collector.repeated);
    EXPECT_EQ(collector.results, in_memory(data));
  }
}

TEST(AllPairs, ReadsAheadIntoSpareBuffers) {
  const TemporaryFolder folder;
  const std::string data = content(item_bytes * 30);
  spit(folder.file("data"), data);
  FileItems file(folder.file("data"), item_bytes);
  const PrefetchPlan plan = plan_prefetch(30, 6);
  ASSERT_EQ(plan.spare, 1U);
  for (const unsigned threads : {1U, 3U}) {
    Collector collector;
    AllPairsOptions options;
    options.threads = threads;
    options.read_ahead = plan.spare;
    const AllPairsReport report = all_pairs(file, plan.order, collector.compute(), options);
    EXPECT_TRUE(report.finished);
    EXPECT_FALSE(collector.repeated);
    EXPECT_EQ(collector.results, in_memory(data));
    EXPECT_EQ(report.most_in_memory, 6U);
    EXPECT_EQ(report.loads, plan.order.facts().loads);
  }
}

TEST(AllPairs, LoadsWithDesignsThatChangeTwoItemsAStep) {
  const TemporaryFolder folder;
  const std::string data = content(item_bytes * 16);
  spit(folder.file("data"), data);
  FileItems file(folder.file("data"), item_bytes);
  const LoadOrder order = plan_load_order(16, 8);
  ASSERT_GT(order.facts().loads, order.facts().steps + 7);  // several loads a step
  Collector collector;
  EXPECT_TRUE(all_pairs(file, order, collector.compute()).finished);
  EXPECT_FALSE(collector.repeated);
  EXPECT_EQ(collector.results, in_memory(data));
}

// Writes results of a step into a separate file before the step is recorded.
struct Durable {
  std::string folder;
  Collector collector;

  void save(std::uint64_t step) {
    const std::lock_guard lock(collector.mutex);
    std::ofstream out(folder + "/step" + std::to_string(step));
    for (const auto& [pair, value] : collector.results) {
      out << pair.first << ' ' << pair.second << ' ' << value << '\n';
    }
    collector.results.clear();
  }

  [[nodiscard]] Results saved(std::uint64_t steps) const {
    Results results;
    for (std::uint64_t step = 1; step <= steps; ++step) {
      std::ifstream in(folder + "/step" + std::to_string(step));
      Element x = 0;
      Element y = 0;
      for (std::uint64_t value = 0; in >> x >> y >> value;) {
        EXPECT_TRUE(results.emplace(std::pair(x, y), value).second);
      }
    }
    return results;
  }
};

TEST(AllPairs, ResumesAfterKillAtTheLastStepThatIsRecorded) {
  const TemporaryFolder folder;
  const std::string data = content(item_bytes * 20);
  spit(folder.file("data"), data);
  const LoadOrder order = plan_load_order(20, 5);
  std::uint64_t resumed = 0;
  bool finished = false;
  int kills = 0;
  // Each child is killed after some pairs, in the middle of a step; the last one comes to the end.
  for (int round = 0; round < 20 && !finished; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      FileItems file(folder.file("data"), item_bytes);
      Durable durable{folder.path().string(), {}};
      const PairCompute collect = durable.collector.compute();
      std::atomic<int> left = 30;
      AllPairsOptions options;
      options.journal = folder.file("journal");
      options.on_step_done = [&](std::uint64_t step) { durable.save(step); };
      const AllPairsReport report = all_pairs(
          file, order,
          [&](const PairWork& work) {
            if (--left == 0) {
              ::kill(::getpid(), SIGKILL);
            }
            collect(work);
          },
          options);
      ::_exit(report.finished && report.steps_resumed > 0 ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) {
      ++kills;
      const std::string journal = slurp(folder.file("journal"));
      const auto recorded =
          static_cast<std::uint64_t>(std::count(journal.begin(), journal.end(), '\n') - 1);
      EXPECT_GT(recorded, resumed);
      resumed = recorded;
    } else {
      EXPECT_EQ(WEXITSTATUS(status), 0);
      finished = true;
    }
  }
  EXPECT_TRUE(finished);
  EXPECT_GE(kills, 3);
  const Durable durable{folder.path().string(), {}};
  EXPECT_EQ(durable.saved(order.facts().steps), in_memory(data));
}

TEST(AllPairs, TakesALineThatACrashCutOffForNotWrittenAndRefusesOtherJournals) {
  const TemporaryFolder folder;
  spit(folder.file("data"), content(item_bytes * 12));
  FileItems file(folder.file("data"), item_bytes);
  const LoadOrder order = plan_load_order(12, 4);
  AllPairsOptions options;
  options.journal = folder.file("journal");
  const PairCompute nothing = [](const PairWork&) {};
  EXPECT_EQ(all_pairs(file, order, nothing, options).pairs, 78U);
  // Everything is done: nothing is loaded.
  EXPECT_EQ(all_pairs(file, order, nothing, options).loads, 0U);
  std::string text = slurp(folder.file("journal"));
  text.resize(text.size() - 1);  // "step 2" of "step 21\n" must not count
  spit(folder.file("journal"), text);
  const AllPairsReport report = all_pairs(file, order, nothing, options);
  EXPECT_TRUE(report.finished);
  EXPECT_EQ(report.steps_resumed, 20U);
  EXPECT_EQ(report.loads, 4U);

  options.job = "something else";
  EXPECT_THROW(all_pairs(file, order, nothing, options), BadInput);
  options.job = "";
  EXPECT_THROW(all_pairs(file, plan_load_order(12, 5), nothing, options), BadInput);
  spit(folder.file("journal"), "precious\n");
  EXPECT_THROW(all_pairs(file, order, nothing, options), BadInput);
  EXPECT_EQ(slurp(folder.file("journal")), "precious\n");
  // What follows a line that is none of the journal's counts for nothing, and one line says so.
  spit(folder.file("journal"), text + "\nstep 99\n");
  const AllPairsReport edited = all_pairs(file, order, nothing, options);
  EXPECT_TRUE(edited.finished);
  EXPECT_EQ(edited.steps_resumed, 21U);
  EXPECT_NE(edited.note.find("line 23"), std::string::npos) << edited.note;
  options.journal = folder.file("no/such/folder");
  EXPECT_THROW(all_pairs(file, order, nothing, options), MissingResource);
}

TEST(AllPairs, NamesTheItemOfAFileThatBecomesShorterWhileItIsRead) {
  for (const bool bypass : {false, true}) {
    const TemporaryFolder folder;
    spit(folder.file("data"), content(item_bytes * 20));
    FileItems file(folder.file("data"), item_bytes, {.bypass_cache = bypass});
    const LoadOrder order = plan_load_order(20, 5);
    AllPairsOptions options;
    options.on_step_done = [&](std::uint64_t step) {
      if (step == 3) {
        std::filesystem::resize_file(folder.file("data"), item_bytes * 9 + 10);
      }
    };
    try {
      all_pairs(
          file, order, [](const PairWork&) {}, options);
      FAIL() << "a shorter file was read to its end";
    } catch (const BadInput& fault) {
      const std::string what = fault.what();
      EXPECT_NE(what.find("item "), std::string::npos) << what;
      EXPECT_NE(what.find(": the file has become shorter; start again"), std::string::npos) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos);
    }
  }
}

TEST(AllPairs, EndsWithWhatTheSourceOrTheComputationThrows) {
  CallbackItems broken(9, 16, [](Element item, std::span<std::byte>) -> std::size_t {
    if (item == 7) {
      throw MissingResource("item 7 cannot be read: Input/output error");
    }
    return 16;
  });
  const LoadOrder order = plan_load_order(9, 4);
  EXPECT_THROW(all_pairs(broken, order, [](const PairWork&) {}), MissingResource);
  CallbackItems fine(9, 16, [](Element, std::span<std::byte>) -> std::size_t { return 16; });
  AllPairsOptions options;
  options.threads = 4;
  EXPECT_THROW(all_pairs(
                   fine, order,
                   [](const PairWork& work) {
                     if (work.first.item == 3) {
                       throw std::runtime_error("no");
                     }
                   },
                   options),
               std::runtime_error);
  CallbackItems longer(9, 16, [](Element, std::span<std::byte>) -> std::size_t { return 1 << 20; });
  EXPECT_REFUSAL(all_pairs(longer, order, [](const PairWork&) {}), BadInput,
                 "were promised to be enough; promise more");
}

TEST(AllPairs, StopsWhenItIsCancelledAndSaysSo) {
  CallbackItems items(40, 16, [](Element, std::span<std::byte>) -> std::size_t { return 16; });
  const LoadOrder order = plan_load_order(40, 5);
  std::atomic<bool> cancelled = false;
  std::atomic<int> pairs = 0;
  AllPairsOptions options;
  options.threads = 2;
  options.cancelled = &cancelled;
  std::uint64_t told = 0;
  options.on_progress = [&](const AllPairsProgress& progress) {
    EXPECT_EQ(progress.step, ++told);
    EXPECT_EQ(progress.steps, order.facts().steps);
  };
  const AllPairsReport report = all_pairs(
      items, order,
      [&](const PairWork&) {
        if (++pairs == 100) {
          cancelled = true;
        }
      },
      options);
  EXPECT_FALSE(report.finished);
  EXPECT_EQ(report.steps_done, told);
  EXPECT_LT(report.steps_done, report.steps);
  EXPECT_LE(pairs, 102);
}

TEST(AllPairs, KeepsToItsMemory) {
  std::atomic<int> under_way = 0;
  CallbackItems items(50, 64, [&](Element item, std::span<std::byte> buffer) -> std::size_t {
    ++under_way;
    std::memset(buffer.data(), static_cast<int>(item), 64);
    return 64;
  });
  const LoadOrder order = plan_load_order(50, 7);
  AllPairsOptions options;
  options.threads = 3;
  options.readers = 3;
  options.memory_bytes = 7 * 64;
  std::atomic<bool> wrong = false;
  const AllPairsReport report = all_pairs(
      items, order,
      [&](const PairWork& work) {
        // A buffer that was given to another item too early would show it.
        for (const ItemView& view : {work.first, work.second}) {
          for (const std::byte b : view.bytes) {
            if (b != static_cast<std::byte>(view.item)) {
              wrong = true;
            }
          }
        }
      },
      options);
  EXPECT_FALSE(wrong);
  EXPECT_EQ(report.most_in_memory, 7U);
  EXPECT_EQ(report.buffer_bytes, 7U * 64U);
  EXPECT_EQ(report.loads, order.facts().loads);
  EXPECT_EQ(static_cast<std::uint64_t>(under_way), order.facts().loads);
  options.memory_bytes = 7 * 64 - 1;
  EXPECT_REFUSAL(all_pairs(
                     items, order, [](const PairWork&) {}, options),
                 BadInput,
                 "room for 7 items takes 448 bytes, but 447 are allowed; plan for room 6");
}

TEST(AllPairs, LeavesBytesThatOthersKeepAsTheyAre) {
  CallbackItems items(30, 64, [](Element item, std::span<std::byte> buffer) -> std::size_t {
    std::memset(buffer.data(), static_cast<int>(item), 64);
    return 64;
  });
  const auto whole = [](const ItemView& view) {
    return std::ranges::all_of(view.bytes,
                               [&](std::byte b) { return b == static_cast<std::byte>(view.item); });
  };
  std::vector<std::pair<ItemView, std::shared_ptr<const std::byte>>> held;
  std::vector<std::jthread> readers;  // nothing but the share tells the executor of their end
  std::atomic<bool> wrong = false;
  const LoadOrder order = plan_load_order(30, 4);
  const AllPairsReport report = all_pairs(items, order, [&](const PairWork& work) {
    if (work.step % 5 == 0) {
      held.emplace_back(work.second, work.second.keep());
    } else if (work.step % 5 == 1 && readers.size() < 50) {
      readers.emplace_back([&, view = work.second, share = work.second.keep()]() mutable {
        if (!whole(view)) {
          wrong = true;
        }
        share.reset();
      });
    }
  });
  readers.clear();
  EXPECT_FALSE(wrong);
  EXPECT_EQ(report.loads, order.facts().loads);
  EXPECT_GT(held.size(), 4U * 10U);  // far more than there is room for
  for (const auto& [view, share] : held) {
    EXPECT_TRUE(whole(view)) << view.item;
  }
}

TEST(AllPairs, RefusesOrdersThatAreNoneOrForOtherItems) {
  CallbackItems items(6, 16, [](Element, std::span<std::byte>) -> std::size_t { return 16; });
  const PairCompute nothing = [](const PairWork&) {};
  EXPECT_REFUSAL(all_pairs(items, plan_load_order(7, 3), nothing), BadInput,
                 "a function has 6 items, but the order is for 7; make an order for that number");
  AllPairsOptions options;
  options.share = {2, 2};
  EXPECT_THROW(all_pairs(items, plan_load_order(6, 3), nothing, options), BadInput);
  // The blocks of a design for which a pair is missing.
  auto broken = std::make_shared<Design>(Parameters{.v = 6, .k = 4, .change = 2},
                                         std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}});
  EXPECT_REFUSAL(all_pairs(items, load_order_of(broken, "", ""), nothing), BadInput,
                 "this is not a load order of 6 items with room for 4: {0,4}");
}

TEST(FileItems, SaysWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  spit(folder.file("empty"), "");
  spit(folder.file("short"), "abc");
  EXPECT_THROW(FileItems(folder.file("absent"), 10), MissingResource);
  EXPECT_THROW(FileItems(folder.file("empty"), 10), BadInput);
  EXPECT_THROW(FileItems(folder.path().string(), 10), BadInput);
  EXPECT_THROW(FileItems(folder.file("short"), 0), BadInput);
  EXPECT_THROW(FileItems(folder.file("short"), 2, {.header_bytes = 3}), BadInput);
  FileItems file(folder.file("short"), 2, {.header_bytes = 1});
  EXPECT_EQ(file.item_count(), 1U);
  EXPECT_EQ(file.access(), "cached");
  EXPECT_THROW(static_cast<void>(room_for(file, 10)), BadInput);
  EXPECT_EQ(room_for(file, 5 * file.buffer_bytes()), 5U);
}

TEST(FileItems, ReadsTheSameWithAndWithoutThePageCache) {
  const TemporaryFolder folder;
  const std::string data = content(100'000);
  spit(folder.file("data"), data);
  for (const std::uint64_t bytes : {1U, 1000U, 4096U, 10'000U, 200'000U}) {
    for (const std::uint64_t header : {0U, 17U, 4096U}) {
      for (const bool bypass : {false, true}) {
        FileItems file(folder.file("data"), bytes, {header, bypass});
        std::unique_ptr<std::byte, void (*)(void*)> buffer(
            static_cast<std::byte*>(std::aligned_alloc(buffer_alignment, file.buffer_bytes())),
            std::free);
        const std::uint64_t count = file.item_count();
        for (std::uint64_t i = 0; i < count; i += std::max<std::uint64_t>(1, count / 20)) {
          const auto item = file.read(static_cast<Element>(i), {buffer.get(), file.buffer_bytes()});
          const std::string expected = data.substr(header + i * bytes, bytes);
          ASSERT_EQ(item.size(), expected.size());
          EXPECT_EQ(std::memcmp(item.data(), expected.data(), expected.size()), 0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace changeover::test::all_pairs_test
