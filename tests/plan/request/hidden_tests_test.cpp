// Done tests with values out of range that the model has no more, against a checker that looks at
// one pair of one test at a time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "changeover/plan/model.hpp"
#include "message_of.hpp"
#include "request/workbook/planned_workbook.hpp"
#include "run_workbooks.hpp"

namespace changeover::hidden_tests_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Value = std::pair<std::string, std::string>;  // a parameter and its value, "~" in front
using Pair = std::set<Value>;
using Tested = std::vector<Value>;

struct Parameter {
  std::string name;
  std::vector<std::string> values;
};
using Parameters = std::vector<Parameter>;

bool is_out(const Value& value) { return value.second.starts_with('~'); }

bool has(const Parameters& model, const Value& value) {
  return std::ranges::any_of(model, [&](const Parameter& parameter) {
    return parameter.name == value.first &&
           std::ranges::find(parameter.values, value.second) != parameter.values.end();
  });
}

std::string text_of(const Parameters& model) {
  std::string text;
  for (const Parameter& parameter : model) {
    text += parameter.name + ": ";
    for (std::size_t i = 0; i < parameter.values.size(); ++i) {
      text += (i == 0 ? "" : ", ") + parameter.values[i];
    }
    text += "\n";
  }
  return text;
}

// What a test without rules can have, but for what the tests that passed have shown for sure.
std::set<Pair> by_definition(const Parameters& now, const std::vector<Tested>& passed) {
  std::set<Pair> needed;
  for (const Parameter& one : now) {
    for (const Parameter& other : now) {
      for (const std::string& x : one.values) {
        for (const std::string& y : other.values) {
          const Value a{one.name, x};
          const Value b{other.name, y};
          if (one.name < other.name && !(is_out(a) && is_out(b))) {
            needed.insert({a, b});
          }
        }
      }
    }
  }
  for (const Tested& test : passed) {
    for (const Value& a : test) {
      for (const Value& b : test) {
        const bool is_seen = std::ranges::all_of(test, [&](const Value& other) {
          return !is_out(other) || ((other == a || other == b) && has(now, other));
        });
        if (is_seen && a.first != b.first) {
          needed.erase({a, b});
        }
      }
    }
  }
  return needed;
}

std::set<Pair> needed_by(const Job& job) {
  std::set<Pair> needed;
  const auto value = [&](Element x) {
    const ModelValue& found = job.model->value(x);
    return Value{job.model->parameters[job.model->parameter_of(x)].name, found.label};
  };
  job.needed.for_each(~std::uint64_t{0}, [&](Element x, Element y) {
    needed.insert({value(x), value(y)});
  });
  return needed;
}

class HiddenTests : public test::PlannedWorkbook {
 protected:
  HiddenTests() {
    request.test_cost = "6";
    request.change_cost = "2";
    request.steps = 50;
  }

  void read(const std::string& model, const std::string& done) {
    request.model.text = model;
    request.done.text = done;
    asked = *checked_job(request, Door::document);
  }

  std::mt19937 random{29};

  Parameters some_model() {
    Parameters model;
    for (std::size_t p = 0; p < 3 + random() % 2; ++p) {
      Parameter& parameter = model.emplace_back();
      parameter.name = std::string(1, static_cast<char>('A' + p));
      for (std::size_t i = 0; i < 2 + random() % 3; ++i) {
        parameter.values.push_back((i > 1 && random() % 2 == 0 ? "~" : "") + parameter.name +
                                   std::to_string(i));
      }
    }
    return model;
  }

  std::vector<Tested> some_tests(const Parameters& model) {
    std::vector<Tested> tests(1 + random() % 8);
    for (Tested& test : tests) {
      for (const Parameter& parameter : model) {
        test.emplace_back(parameter.name, parameter.values[random() % parameter.values.size()]);
      }
    }
    return tests;
  }

  // Changes a model as its author may: a parameter or a value is gone, or is in range now. What
  // --without takes out is gone of the second, and its name is given.
  std::string change(Parameters& now, std::size_t way) {
    const std::size_t p = random() % now.size();
    if (way == 0) {
      now.erase(now.begin() + static_cast<std::ptrdiff_t>(p));
      return "";
    }
    std::vector<std::string>& values = now[p].values;
    std::string last = values.back();
    if (way == 1 && last.starts_with('~')) {
      values.back().erase(0, 1);
    } else if (way > 1) {
      values.pop_back();
    }
    return way == 3 ? now[p].name + ": " + last : "";
  }
};

TEST_F(HiddenTests, CountForNothingThatMayHaveBeenHidden) {
  std::size_t hidden = 0;
  for (std::size_t round = 0; round < 400; ++round) {
    const Parameters before = some_model();
    const std::vector<Tested> tests = some_tests(before);
    Parameters now = before;
    const std::string without = change(now, round % 5);
    std::string done;
    for (const Parameter& parameter : before) {
      done += parameter.name + ",";
    }
    done += "result\n";
    std::vector<Tested> passed;
    for (const Tested& test : tests) {
      for (const Value& value : test) {
        done += value.second + ",";
      }
      const bool passes = random() % 4 != 0;
      done += passes ? "pass\n" : "fail\n";
      if (passes) {
        passed.push_back(test);
      }
    }
    request.without = without.empty() ? std::vector<std::string>() : std::vector{without};
    read(text_of(without.empty() ? now : before), done);
    EXPECT_EQ(needed_by(*asked.job), by_definition(now, passed)) << text_of(before) << "\n"
                                                                 << text_of(now) << "\n"
                                                                 << without << "\n"
                                                                 << done;
    EXPECT_EQ(asked.job->tests_done, tests.size());
    for (const std::string& note : asked.notes) {
      hidden += note.find("an error may have hidden") == std::string::npos ? 0U : 1U;
    }
  }
  EXPECT_GT(hidden, 100U) << "or nothing was tried";
}

TEST_F(HiddenTests, OfAWorkbookToo) {
  request.model.text = "A: 1, 2, ~-1\nB: x, y\nC: p, q\n";
  const std::string bytes =
      test::filled_in(planned(), std::vector<std::string>(30, "pass"), "Run sheet");
  std::vector<Tested> passed;
  for (const RunStep& step : answer.plan->sheet.steps) {
    Tested& test = passed.emplace_back();
    for (const Element x : step.setup) {
      test.emplace_back(std::string(1, static_cast<char>('A' + asked.job->model->parameter_of(x))),
                        asked.job->model->value(x).label);
    }
  }
  ASSERT_TRUE(std::ranges::any_of(
      passed, [](const Tested& test) { return std::ranges::any_of(test, is_out); }));
  std::string next;
  for (const std::string model : {"B: x, y\nC: p, q\n", "A: 1, 2\nB: x, y\nC: p, q\n", ""}) {
    JobRequest more;
    Parameters now{{"A", {"1", "2"}}, {"B", {"x", "y"}}, {"C", {"p", "q"}}};
    if (model.empty()) {
      more.without = {"~-1"};
    } else {
      more.model.text = model;
      now.erase(now.begin(), now.begin() + (model[0] == 'B' ? 1 : 0));
    }
    next = planned(test::opened(bytes, more));
    EXPECT_EQ(needed_by(*asked.job), by_definition(now, passed)) << model;
    // Also from what its sheet of done tests keeps.
    static_cast<void>(planned(test::opened(next)));
    EXPECT_EQ(needed_by(*asked.job), by_definition(now, passed)) << model;
    EXPECT_THAT(asked.notes, Contains(HasSubstr("had '~-1', which is no value out of range any")));
  }
}

TEST_F(HiddenTests, AreNamedOnce) {
  read("A: 1, 2\nB: x, y\nC: p, q\n", "A,B,C,result\n~-1,x,p,pass\n~-1,y,q,pass\n1,x,q,pass\n");
  EXPECT_EQ(asked.job->needed.size(), 9U);
  EXPECT_THAT(asked.notes,
              Contains("done: the test in row 2 had '~-1', which is no value out of range any "
                       "more, as in 1 other test; an error may have hidden their pairs, so they do "
                       "not count, and a diagnosis leaves them out"));
  read("A: 1, 2, ~a\nB: x, y, ~b\nC: p, q\n", "A,B,C,result\n~a,~b,p,pass\n");
  EXPECT_EQ(asked.job->needed.size(), 20U);
  EXPECT_THAT(asked.notes, Contains(HasSubstr("row 2 had more than one value out of range, '~a', "
                                              "'~b'; an error may have hidden its pairs")));
  EXPECT_TRUE(asked.results.empty());
  // A name of a parts list may begin with the sign.
  request.model = {};
  request.parts.text = "~a,1\nb,1\nc,1\n";
  request.at_once = 2;
  request.done.text = "slot_1,slot_2,result\n~a,b,pass\n~gone,c,pass\n";
  asked = *checked_job(request, Door::document);
  EXPECT_EQ(asked.job->needed.size(), 2U);
  EXPECT_THAT(asked.notes, Not(Contains(HasSubstr("may have hidden"))));
}

TEST_F(HiddenTests, AreNotThoseWithARemarkOfThatSign) {
  request.diagnose = true;
  request.steps.reset();
  for (const std::string own : {"Duration", "Remark"}) {
    read("A: 1, 2\nB: x, y\nC: u, v\n", "step,A,B,C,result," + own +
                                            "\n1,1,x,u,pass,~5 min\n2,1,y,v,pass,~5 min\n"
                                            "3,2,x,v,fail,~6 min\n4,2,y,u,fail,~ok\n");
    EXPECT_EQ(asked.results.size(), 4U);
    EXPECT_EQ(asked.job->needed.size(), 6U);
    EXPECT_THAT(asked.notes, Not(Contains(HasSubstr("may have hidden"))));
  }
}

TEST_F(HiddenTests, AreNamedIfADiagnosisHasNoOthers) {
  request.diagnose = true;
  request.steps.reset();
  request.model.text = "A: 1, 2\nB: x, y\nC: u, v\n";
  const auto why = [&](const std::string& done) {
    request.done.text = done;
    return message_of([&] { static_cast<void>(planned()); });
  };
  EXPECT_EQ(
      why("step,A,B,C,result\n1,~-1,x,u,pass\n2,~-1,y,v,fail\n"),
      "done: the test in row 2 had '~-1', which is no value out of range any more, as in 1 "
      "other test; an error may have hidden their pairs, so they do not count, and a diagnosis "
      "leaves them out; no other result says pass or fail: run more tests, and fill in theirs");
  EXPECT_EQ(
      why("step,A,B,C,D,result\n1,1,x,u,7,fail\n"),
      "done: 1 test failed with a part that is gone, which may be to blame: a diagnosis leaves "
      "it out; no other result says pass or fail: run more tests, and fill in theirs");
}

// A failure may be that of the value that is gone.
TEST_F(HiddenTests, AValueOfAParameterThatIsGoneMayBeToBlame) {
  const std::string done =
      "step,A,B,C,result\n1,1,x,p,fail\n2,1,y,q,fail\n3,2,y,p,pass\n4,2,x,q,pass\n5,,x,p,fail\n";
  request.diagnose = true;
  request.steps.reset();
  read("B: x, y\nC: p, q\n", done);
  EXPECT_THAT(asked.notes, Contains(HasSubstr("2 tests failed with a part that is gone, which may "
                                              "be to blame: a diagnosis leaves them out")));
  EXPECT_EQ(asked.results.size(), 3U);
  EXPECT_EQ(std::ranges::count_if(asked.results, &TestedSetup::failed), 1);
  read("A: 1, 2\nB: x, y\nC: p, q\n", done);
  EXPECT_EQ(asked.results.size(), 5U);
}

// The numbers of its places differ by sheet.
TEST_F(HiddenTests, WhatParametersHadCountsWhenTheyComeBack) {
  const std::string a = "Alpha: 1, 2, 3\n";
  const std::string b = "Bravo: x, y, z\n";
  const std::string c = "Carton: p, q, r\nDepth: s, t, u\n";
  const Parameters all{{"Alpha", {"1", "2", "3"}},
                       {"Bravo", {"x", "y", "z"}},
                       {"Carton", {"p", "q", "r"}},
                       {"Depth", {"s", "t", "u"}}};
  std::vector<Tested> passed;
  request.model.text = a + b + c;
  std::string bytes = planned();
  for (const std::string& model : {b + c, c, a + c, b + c, a + b + c, b + a + c}) {
    for (std::size_t i = 0; i < std::min<std::size_t>(2, answer.plan->sheet.steps.size()); ++i) {
      Tested& test = passed.emplace_back();
      for (const Element x : answer.plan->sheet.steps[i].setup) {
        const Model& of = *asked.job->model;
        test.emplace_back(of.parameters[of.parameter_of(x)].name, of.value(x).label);
      }
    }
    bytes = test::filled_in(bytes, {"pass", "pass"});
    JobRequest more;
    more.model.text = model;
    bytes = planned(test::opened(bytes, more));
    Parameters now = all;
    std::erase_if(now, [&](const Parameter& each) {
      return model.find(each.name + ":") == std::string::npos;
    });
    EXPECT_EQ(needed_by(*asked.job), by_definition(now, passed)) << model;
    EXPECT_EQ(asked.job->tests_done, passed.size());
  }
}

// With another head, results are those of the column that has them.
TEST_F(HiddenTests, AParameterHeadedLikeResultsHasNone) {
  read("OS: a, b, c\nC: p, q\n",
       "OS,slot_3 Outcome,C,Ergebnis\na,ok,p,pass\nb,bad,p,fail\nc,ok,q,\n");
  EXPECT_EQ(needed_by(*asked.job), by_definition({{"OS", {"a", "b", "c"}}, {"C", {"p", "q"}}},
                                                 {{{"OS", "a"}, {"C", "p"}}}));
}

}  // namespace
}  // namespace changeover::hidden_tests_test
