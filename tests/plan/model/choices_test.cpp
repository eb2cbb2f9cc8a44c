// What makes tests of models against all of their rows.
#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/plan/run_plan.hpp"
#include "plan/job/choices.hpp"
#include "plan/search/choices/choice_lists.hpp"
#include "random_models.hpp"

namespace changeover::choices_test {
namespace {

bool any_shows(const Model& model, const std::vector<Block>& tests, Element x, Element y) {
  return std::any_of(tests.begin(), tests.end(),
                     [&](const Block& test) { return test::shows(model, test, x, y); });
}

TEST(Choices, CompiledRulesSayWhatTheRulesSay) {
  std::size_t good = 0;
  std::size_t bad = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const std::string text = test::random_model_text(seed, 4, 4);
    const Model model = test::model_of(text);
    const Job job = job_of(model, parse_amount("1"), parse_amount("1"));
    const ChoiceJob choices(job);
    for (const Block& row : test::all_choices(model)) {
      const bool expected = follows(model, row);
      ++(expected ? good : bad);
      ASSERT_EQ(choices.allows(row), expected) << text;
      if (!expected) {
        continue;
      }
      // The same a value at a time.
      for (std::size_t p = 0; p < row.size(); ++p) {
        for (const Element x : choices.values(p)) {
          Block other = row;
          other[p] = x;
          ASSERT_EQ(choices.allows(row, x), follows(model, other)) << text;
        }
      }
    }
  }
  EXPECT_GT(good, 4000U);
  EXPECT_GT(bad, 3000U);
}

TEST(Choices, TheFormulaSaysIt) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const std::string text = test::random_model_text(seed, 4, 3);
    const Model model = test::model_of(text);
    const Job job = job_of(model, parse_amount("1"), parse_amount("1"));
    ChoiceSolver solver(job);
    for (const Block& row : test::all_choices(model)) {
      const auto completed = solver.completed(row, {});
      ASSERT_EQ(completed.has_value(), follows(model, row)) << text;
      if (completed) {
        EXPECT_EQ(*completed, row);
      }
    }
  }
}

TEST(Choices, WhatCannotMeetIsFoundExactly) {
  std::size_t apart = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const std::string text = test::random_model_text(seed, 4, 4);
    const Model model = test::model_of(text);
    const std::vector<Block> tests = test::all_tests(model);
    const Job job = job_of(model, parse_amount("1"), parse_amount("1"));
    const PairSet none = cannot_meet(job);
    for (Element y = 0; y < job.parts(); ++y) {
      for (Element x = 0; x < y; ++x) {
        if (job.needed.contains(x, y)) {
          ASSERT_EQ(none.contains(x, y), !any_shows(model, tests, x, y)) << text;
          apart += none.contains(x, y) ? 1U : 0U;
        } else {  // of one parameter, or out of range both
          EXPECT_FALSE(any_shows(model, tests, x, y)) << text;
        }
      }
    }
  }
  EXPECT_GT(apart, 200U);
}

TEST(Choices, TriplesThatCannotMeetAreFoundExactly) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::string text = test::random_model_text(seed, 4, 3);
    const Model model = test::model_of(text);
    if (model.parameters.size() < 3) {
      continue;
    }
    const std::vector<Block> tests = test::all_tests(model);
    Job job = job_of(model, parse_amount("1"), parse_amount("1"));
    (void)need_triples(job);
    std::vector<Triple> expected;
    for (Element z = 0; z < job.parts(); ++z) {
      for (Element y = 0; y < z; ++y) {
        for (Element x = 0; x < y; ++x) {
          const bool meets = std::any_of(tests.begin(), tests.end(), [&](const Block& test) {
            const auto has = [&](Element e) {
              return std::find(test.begin(), test.end(), e) != test.end();
            };
            const bool hidden = std::any_of(test.begin(), test.end(), [&](Element e) {
              return model.value(e).negative && e != x && e != y && e != z;
            });
            return has(x) && has(y) && has(z) && !hidden;
          });
          if (meets) {
            expected.push_back({x, y, z});
          }
        }
      }
    }
    std::vector<Triple> found = job.triples;
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected) << text;
  }
}

TEST(Choices, ListsCountAsTheRefereeDoes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::string text = test::random_model_text(seed, 4, 4);
    const Model model = test::model_of(text);
    const std::vector<Block> tests = test::all_tests(model);
    Random random(seed, 9);
    const auto below = [&](std::size_t limit) {
      return random.below(static_cast<std::uint32_t>(limit));
    };
    Job job = job_of(model, parse_amount("3"), parse_amount("1"));
    for (Amount& cost : job.change_costs) {
      cost = Amount{(1 + below(5)) * 1'000'000};
    }
    drop_needed(job, cannot_meet(job));
    if (seed % 3 == 0) {
      job.start = tests[below(tests.size())];
    }
    if (seed % 4 == 0) {
      for (Element out = 0; out < job.parts(); ++out) {
        for (Element in = 0; in < job.parts(); ++in) {
          job.replace_costs.push_back(Amount{(1 + below(7)) * 1'000'000});
        }
      }
    }
    if (seed % 5 == 0 && model.parameters.size() > 2) {
      (void)need_triples(job);
    }
    const ChoiceJob choices(job);
    ChoiceList list(choices, {tests[below(tests.size())], tests[below(tests.size())]});
    const auto agrees = [&] {
      const RunSheet sheet = run_sheet(job, list.setups());
      EXPECT_EQ(list.cost() * static_cast<std::int64_t>(choices.weights().unit),
                static_cast<std::int64_t>(sheet.cost.millionths))
          << text;
      EXPECT_EQ(list.missing(), job.triples.empty() ? sheet.pairs_needed - sheet.pairs_tested
                                                    : sheet.triples_needed - sheet.triples_tested)
          << text;
    };
    agrees();
    for (unsigned i = 0; i < 60; ++i) {
      const std::int64_t cost = list.cost();
      const auto missing = static_cast<std::int64_t>(list.missing());
      std::optional<Rise> rise;
      switch (below(5)) {
        case 0: {
          const std::size_t at = below(list.size() + 1);
          const Block& row = tests[below(tests.size())];
          rise = list.rise_of_insert(at, row);
          list.insert(at, row);
          break;
        }
        case 1:
          if (list.size() > 1) {
            const std::size_t at = below(list.size());
            rise = list.rise_of_erase(at);
            list.erase(at);
          }
          break;
        case 2: {
          const Cell cell{below(list.size()), below(model.parameters.size())};
          const std::vector<Element>& values = choices.values(cell.slot);
          const Element x = values[below(values.size())];
          if (choices.allows(list.row(cell.at), x) && list.row(cell.at)[cell.slot] != x) {
            rise = list.rise_of_set(cell, x);
            list.set(cell, x);
          }
          break;
        }
        case 3: {
          const std::size_t first = below(list.size());
          const std::size_t last = first + below(list.size() - first);
          const std::size_t to = below(list.size() + 1);
          if (to < first || to > last + 1) {
            const bool turned = random.one_in_two();
            rise = Rise{list.rise_of_move({first, last}, to, turned), 0};
            list.move({first, last}, to, turned);
          }
          break;
        }
        default: {
          const std::size_t first = below(list.size());
          const std::size_t last = first + below(list.size() - first);
          rise = Rise{list.rise_of_reverse({first, last}), 0};
          list.reverse({first, last});
        }
      }
      if (rise) {
        EXPECT_EQ(list.cost() - cost, rise->cost) << text;
        EXPECT_EQ(static_cast<std::int64_t>(list.missing()) - missing, rise->uncovered) << text;
      }
      agrees();
    }
  }
}

}  // namespace
}  // namespace changeover::choices_test
