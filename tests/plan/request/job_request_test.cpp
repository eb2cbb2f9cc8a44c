// Requests as documents: read back as they are, refused as they should be, and the same job
// whichever way a list comes.
#include "changeover/plan/job_request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "changeover/core/error.hpp"
#include "io/request/request_document.hpp"
#include "io/request/request_words.hpp"
#include "run_program.hpp"

namespace changeover::job_request_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusal(const std::string& json, const std::string& name = "") {
  try {
    static_cast<void>(checked_job(job_request(json, name), Door::document));
  } catch (const Error& fault) {
    return fault.what();
  }
  return "taken";
}

// A value for every key, whatever it means together with others.
JobRequest any_request(std::mt19937_64& random) {
  JobRequest request;
  const auto word = [&] {
    static const std::vector<std::string> words{"a",  "Pump, large", "\"q\"", "é", "7",
                                                "#x", " b ",         "=1",    "\n"};
    return words[random() % words.size()];
  };
  for (const auto& option : job_table().options) {
    if (random() % 2 == 0) {
      continue;
    }
    const OptionRecord& record = option.record;
    std::visit(
        [&](auto field) {
          auto& value = request.*field;
          using Value = std::remove_cvref_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, bool>) {
            value = true;
          } else if constexpr (std::is_same_v<Value, std::optional<std::uint64_t>>) {
            value = random();
          } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
            value = static_cast<double>(random() % 1000) / 7;
          } else if constexpr (std::is_same_v<Value, std::string>) {
            value = record.kind == ValueKind::amount ? "12.50"
                    : record.kind == ValueKind::word ? std::string(record.words.back())
                                                     : word();
          } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
            value = {word(), word()};
          } else {
            switch (random() % (record.shape == RowShape::document ? 2 : 3)) {
              case 0:
                value.file = "x.csv";
                break;
              case 1:
                value.text = word();
                break;
              default:
                value.rows.emplace();
                for (std::uint64_t i = random() % 4; i > 0; --i) {
                  ListRow row{{word(), word()}};
                  if (record.shape == RowShape::weights) {
                    row.fields.push_back("2.5");
                  } else if (record.shape == RowShape::parts || record.shape == RowShape::slots) {
                    row = {{word(), "12", "3"}};
                  } else if (record.shape == RowShape::benches) {
                    constexpr std::size_t columns = 11;
                    row.fields.resize(columns);
                  } else if (record.shape == RowShape::tests && random() % 2 == 0) {
                    row.result = word();
                  }
                  value.rows->push_back(row);
                }
            }
          }
        },
        option.field);
  }
  return request;
}

TEST(JobRequest, IsReadBackAsItWasWritten) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2'000; ++i) {
    const JobRequest request = any_request(random);
    const std::string json = to_json(request);
    ASSERT_EQ(job_request(json), request) << json;
    ASSERT_EQ(to_json(job_request(json)), json);
  }
}

TEST(JobRequest, EveryKeyAndFlagIsThereOnceAndEveryRuleKnowsItsKeys) {
  std::set<std::string_view> keys;
  std::set<std::string_view> flags;
  for (const auto& option : job_table().options) {
    EXPECT_TRUE(keys.insert(option.record.key).second) << option.record.key;
    EXPECT_TRUE(flags.insert(option.record.flags).second) << option.record.flags;
    EXPECT_FALSE(option.record.help.empty()) << option.record.key;
    EXPECT_EQ(option.record.kind == ValueKind::list, option.record.shape != RowShape::none);
    if (option.record.kind == ValueKind::amount || option.record.kind == ValueKind::seconds) {
      EXPECT_FALSE(option.record.unit.empty()) << option.record.key;
    }
    // Said by the record, once.
    EXPECT_EQ(option.record.help.find("default"), std::string_view::npos) << option.record.key;
  }
  for (const OptionRule& rule : job_table().rules) {
    for (const auto* const list : {&rule.keys, &rule.others, &rule.where}) {
      for (const std::string_view key : *list) {
        const OptionRecord& record = option_of(job_table(), key).record;
        EXPECT_TRUE(value_in(key).empty() || record.words.empty() ||
                    std::ranges::count(record.words, value_in(key)) == 1)
            << key;
      }
    }
  }
}

PlanAnswer answer_in(double seconds, const JobRequest& request) {
  RunControl control({.time = std::chrono::duration<double>(seconds)});
  return answer_to(checked_job(request, Door::document), control);
}

TEST(JobRequest, AnswersSayThatALimitStoppedThem) {
  const std::string note =
      "the time limit stopped the search; with more time the plan may be better";
  const JobRequest one{.items = 14, .at_once = 4, .test_cost = "1", .change_cost = "5"};
  JobRequest benches = one;
  benches.benches.number = 2;
  JobRequest ratios = one;
  ratios.what_if = true;
  for (const JobRequest& request : {one, benches, ratios}) {
    PlanAnswer cut = answer_in(0, request);
    EXPECT_EQ(cut.why_stopped(), WhyStopped::time_limit);
    EXPECT_THAT(cut.notes, ::testing::ElementsAre(note));
    const std::string json = written(checked_job(request, Door::document), cut, "json");
    EXPECT_THAT(json, HasSubstr("\"why_stopped\":\"time limit\""));
    EXPECT_THAT(json, HasSubstr(note));
    // A time that was asked for is used up as it should be.
    JobRequest timed = request;
    timed.seconds = 0;
    cut = answer_in(0, timed);
    EXPECT_EQ(cut.why_stopped(), WhyStopped::time_limit);
    EXPECT_EQ(cut.notes.empty(), !request.what_if);
    JobRequest small = request;
    small.items = 6;
    small.at_once = 3;
    small.steps = 300;
    const PlanAnswer whole = answer_in(3600, small);
    EXPECT_NE(whole.why_stopped(), WhyStopped::time_limit);
    EXPECT_THAT(whole.notes, ::testing::IsEmpty());
  }
}

// Every rule alone refuses each of its keys, and nothing where its condition is not met, at both
// doors, in the words of the door.
TEST(JobRequest, RulesHold) {
  const auto set = [](JobRequest& request, std::string_view key) {
    const std::string value(value_in(key));
    std::visit(
        [&](auto field) {
          auto& kept = request.*field;
          using Value = std::remove_cvref_t<decltype(kept)>;
          if constexpr (std::is_same_v<Value, bool>) {
            kept = true;
          } else if constexpr (std::is_same_v<Value, std::string>) {
            kept = value.empty() ? "1" : value;
          } else if constexpr (std::is_same_v<Value, RequestList>) {
            kept.text = "x";
          } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
            kept = {"1"};
          } else {
            kept = value.empty() ? 1 : std::stoul(value);
          }
        },
        option_of(job_table(), key).field);
  };
  const auto said = [](const OptionRule& rule, const JobRequest& request, Door door) {
    const RequestTable<JobRequest> alone{
        job_table().format, job_table().options, {rule}, job_table().times};
    try {
      check_rules(alone, request, RequestWords(alone, request, door));
      return std::string();
    } catch (const BadOption& fault) {
      return std::string(fault.what());
    }
  };
  using Says = OptionRule::Says;
  for (const OptionRule& rule : job_table().rules) {
    const bool wants = rule.says == Says::only_with || rule.says == Says::needs;
    for (const std::string_view key :
         rule.keys.empty() ? std::vector<std::string_view>{""} : rule.keys) {
      for (const std::string_view other : rule.says == Says::exclude ? rule.keys : rule.others) {
        if (key == other) {
          continue;
        }
        JobRequest good;
        JobRequest bad;
        for (JobRequest* const request : {&good, &bad}) {
          for (const std::string_view each : {key, rule.where.empty() ? "" : rule.where.front()}) {
            if (!each.empty()) {
              set(*request, each);
            }
          }
        }
        set(wants ? good : bad, other);
        for (const Door door : {Door::document, Door::command_line}) {
          const std::string line = said(rule, bad, door);
          EXPECT_FALSE(line.empty()) << key << ' ' << other;
          EXPECT_EQ(line.find_first_of("{}"), std::string::npos) << line;
          EXPECT_EQ(line.find("--") == std::string::npos, door == Door::document) << line;
          EXPECT_EQ(said(rule, good, door), "") << key << ' ' << other;
          if (!rule.where.empty()) {
            JobRequest elsewhere = bad;
            std::visit([&](auto field) { elsewhere.*field = {}; },
                       option_of(job_table(), rule.where.front()).field);
            EXPECT_EQ(said(rule, elsewhere, door), "") << key << ' ' << other;
          }
        }
      }
    }
  }
}

TEST(JobRequest, TheSameJobByFileTextAndRows) {
  const test::TemporaryFolder folder;
  const auto file = [&](const std::string& name, const std::string& text) {
    test::spit(folder.file(name), text);
    return folder.file(name);
  };
  const std::string parts =
      "name,cost,slot\nXeon,3,CPU\nEpyc,2.5,CPU\nd1,1,disk\nd2,1,disk\nd3,1,disk\n";
  const std::string never = "d1,d2\n";
  const std::string weights = "Xeon,d1,5\n";
  const std::string slots = "CPU,1,1\ndisk,1,2\n";
  const std::string first = "Xeon,d1,d3\n";
  const auto common = [](const std::string& lists) {
    return R"({"at_once":3,"test_cost":1,)" + lists + "}";
  };
  const auto quoted = [](std::string text) {
    std::string all = "\"";
    for (const char c : text) {
      all += c == '\n' ? std::string("\\n") : std::string(1, c);
    }
    return all + "\"";
  };
  const auto both = [&](auto&& as) {
    return common("\"parts\":" + as("parts.csv", parts) + ",\"never\":" + as("never.csv", never) +
                  ",\"weights\":" + as("weights.csv", weights) +
                  ",\"slots\":" + as("slots.csv", slots) + ",\"first\":" + as("first.csv", first));
  };
  const std::vector<std::string> three{
      both([&](const std::string& name, const std::string& text) {
        return "{\"file\":" + quoted(file(name, text)) + "}";
      }),
      both([&](const std::string&, const std::string& text) {
        return "{\"text\":" + quoted(text) + "}";
      }),
      common(
          R"("parts":[{"name":"Xeon","cost":3,"slot":"CPU"},{"name":"Epyc","cost":"2.5","slot":"CPU"},)"
          R"({"name":"d1","cost":1,"slot":"disk"},{"name":"d2","cost":1,"slot":"disk"},{"name":"d3","cost":1,"slot":"disk"}],)"
          R"("never":[["d1","d2"]],"weights":[["Xeon","d1",5]],)"
          R"("slots":[{"name":"CPU","least":1,"most":1},{"name":"disk","least":1,"most":2}],"first":[["Xeon","d1","d3"]])")};
  std::vector<CheckedJobRequest> asked;
  for (const std::string& json : three) {
    asked.push_back(checked_job(job_request(json), Door::document));
  }
  for (const CheckedJobRequest& each : asked) {
    const Job& job = *each->job;
    const Job& one = *asked.front()->job;
    EXPECT_EQ(job.names, one.names);
    EXPECT_EQ(job.change_costs, one.change_costs);
    EXPECT_EQ(job.slot_of, one.slot_of);
    EXPECT_EQ(job.first, one.first);
    EXPECT_EQ(job.needed.size(), one.needed.size());
    EXPECT_TRUE(job.never.contains(2, 3));
    EXPECT_EQ(job.weights(0, 2), parse_amount("5"));
  }
}

TEST(JobRequest, SaysWhatIsWrongAndWhere) {
  const std::string base = R"({"at_once":3,"test_cost":1,"change_cost":1,)";
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"([1])", "give an object of JSON"},
      {R"({"a":1,"a":2})", "is given twice"},
      {R"({"format":"changeover-job/9"})", "format: write changeover-job/1"},
      {base + R"("parts":9,"colour":1})", "unknown key 'colour'"},
      {base + R"("parts":9,"parts":8})", "twice"},
      {base + R"("parts":9,"items":8})", "parts means the same"},
      {base + R"("parts":-1})", "parts: write a whole number"},
      {base + R"("parts":["a",{"name":"b","price":3}]})", "parts[1]: write \"name\" or"},
      {base + R"("parts":["a",{"name":"b","cost":"x"}]})", "parts[1]: "},
      {base + R"("parts":["a","b\u0007"]})", "parts[1]: control byte"},
      {base + R"("parts":["a","a"]})", "parts[1]: a second part is called 'a'"},
      {base + R"("parts":["a","b","c"],"pairs":[["a","b"],["a","d"]]})",
       "pairs[1]: there is no part 'd'"},
      {base + R"("parts":["a","b","c"],"pairs":[["part","name"]]})",
       "pairs[0]: there is no part 'part'"},
      {base + R"("parts":["a","b","c"],"pairs":["ab"]})", "pairs[0]: write [a,b]"},
      {base + R"("parts":["a","b","c"],"pairs":{"files":"x"}})", "{\"file\":…}"},
      {base + R"("parts":["a","b","c"],"pairs":{"file":"no such.csv"}})", "no such.csv"},
      {base + R"("parts":["a","b","c"],"first":[[]]})", "first[0]: write [a,b,…]"},
      {base + R"("parts":["a","b","c"],"done":[["a","x"]]})", "done: there is no part 'x'"},
      {base + R"("parts":["a","b","c"],"done":[{"parts":["a"],"when":1}]})", "done[0]: write"},
      {base + R"("parts":["a","b","c"],"slots":[{"least":1}]})", "slots[0]: write {\"name\""},
      {base + R"("parts":9,"objective":"time"})", "objective: write one of makespan, cost"},
      {base + R"("parts":9,"benches":2,"shuffle":3})", "shuffle has no meaning with benches"},
      {base + R"("parts":9,"seconds":-1})", "seconds: write a number of seconds"},
      {base + R"("parts":9,"what_if":1})", "what_if: write true or false"},
      {base + R"("parts":9,"title":"a\u202eb"})", "title: "},
      {R"({"parts":9,"at_once":3,"change_cost":1})", "give test_cost"},
      {R"({"parts":9,"at_once":3,"test_cost":1})", "give change_cost"},
      {R"({"parts":9,"at_once":18446744073709551616,"test_cost":1,"change_cost":1})",
       "at_once: write a whole number"},
  };
  for (const auto& [json, says] : cases) {
    EXPECT_THAT(refusal(json), HasSubstr(says)) << json;
    EXPECT_EQ(refusal(json).find('\n'), std::string::npos) << json;
  }
  EXPECT_THAT(refusal("{\"parts\":9,\n \"at_once\":true}", "job.json"),
              StartsWith("job.json:2:12: at_once: write a whole number"));
}

TEST(JobRequest, FaultsOfADocumentHaveTheirPlace) {
  const std::string costs = "\"test_cost\":1,\"change_cost\":1";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"{" + costs + ",\n\"parts\":7}", "2:9: parts needs at_once; give it, too"},
      {"{" + costs + ",\"parts\":7,\n\"at_once\":1}", "2:11: at_once 1: no pair can meet"},
      {"{" + costs + "}", "1:1: parts is missing"},
      {"{\"parts\":7,\"at_once\":3}", "1:1: give test_cost, what it costs to run one test"},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\n\"strength\":4}", "2:12: strength 4: give 2"},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\n\"budget\":\"x\"}", "2:10: budget: "},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\n\"first_day\":\"May\",\"benches\":2}",
       "2:13: first_day: "},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\n\"mounted\":[\"x\"]}", "2:11: mounted: "},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\"compact\":true,\n\"what_if\":true}",
       "1:64: compact has no meaning with what_if"},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\"done\":[[1,2]],\n\"done_first\":2}",
       "2:14: done_first 2: done has only 1 set-up"},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\"pairs\":[[1,2],\n[1,9]]}", "2:1: pairs[1]: "},
      {"{" + costs + ",\"at_once\":2,\"parts\":[\"a\",\n\"b\",\n \"a\"]}", "3:2: parts[2]: "},
      {"{" + costs + ",\"at_once\":2,\n\"parts\":{\"text\":\"a\\n\"}}",
       "2:9: parts: one part is listed"},
      {"{" + costs + ",\"at_once\":2,\"parts\":{\"text\":\"a\\nb\\na\\n\"}}", "1:52: parts:3:1: "},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\n\"benches\":[\"x\",\n{\"name\":\"x\"}]}",
       "2:11: benches: two benches are called x"},
      {"{" + costs + ",\"parts\":7,\"at_once\":3,\n\"threads\":0}",
       "2:11: threads 0 is out of range"},
  };
  for (const auto& [json, says] : cases) {
    EXPECT_THAT(refusal(json, "job.json"), StartsWith("job.json:" + says)) << json;
    EXPECT_EQ(refusal(json, "job.json").find('\n'), std::string::npos);
    try {
      static_cast<void>(checked_job(job_request(json, "job.json"), Door::command_line));
    } catch (const BadOption& fault) {
      ADD_FAILURE() << fault.what();
    } catch (const BadInput& fault) {
      EXPECT_THAT(fault.what(), StartsWith("job.json:" + says));
    }
  }
}

TEST(JobRequest, ABadByteNeverBecomesAnotherFault) {
  std::mt19937_64 random(3);
  const std::string good =
      R"({"format":"changeover-job/1","parts":["a",{"name":"b","cost":2}],"at_once":2,"test_cost":1.5,"change_cost":"2","done":[["a","b"],{"parts":["a"],"result":"ok"}]})";
  for (int i = 0; i < 20'000; ++i) {
    std::string bad = good;
    for (int j = 0; j < 1 + static_cast<int>(random() % 3); ++j) {
      bad[random() % bad.size()] = static_cast<char>(random());
    }
    try {
      static_cast<void>(checked_job(job_request(bad), Door::document));
    } catch (const BadInput&) {
    } catch (const ImpossibleParameters&) {
    } catch (const MissingResource&) {
    }
  }
}

TEST(JobRequest, DoneTestsCountAsTheyAreSent) {
  const auto asked = checked_job(
      job_request(
          R"({"parts":["slot_1","result","step","take_out"],"at_once":2,"test_cost":1,"change_cost":1,)"
          R"("done":[["slot_1","result"],{"parts":["slot_1","step"],"result":"FAILED"},{"parts":["result","step"],"result":"skipped"}]})"),
      Door::document);
  EXPECT_EQ(asked->done.size(), 2U);
  EXPECT_EQ(asked->job->met_only_in_failed, 1U);
  EXPECT_EQ(asked->job->needed.size(), 5U);
  EXPECT_EQ(asked->job->tests_done, 2U);
}

// Every row was once held against all pairs and all other rows, which took minutes. The clock is
// the number of questions that the work asks (run/control.hpp), so the test depends on no machine's
// speed: one for each row, and some for a plan that is there with 10'000.
TEST(JobRequest, ALongListOfTestsIsTakenRowByRow) {
  constexpr std::uint64_t count = 300'000;
  std::string rows = "slot_1,slot_2,slot_3,slot_4,slot_5,result\n";
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t first = i * 7 % 900;
    const std::uint64_t step = 1 + i / 900 % 24;
    for (std::uint64_t j = 0; j < 5; ++j) {
      rows += std::to_string(1 + first + j * step) + ",";
    }
    rows += i < 100 ? "pass\n" : i < 200 ? "fail\n" : "\n";
  }
  JobRequest request{.items = 1000, .at_once = 5, .test_cost = "1", .change_cost = "1"};
  request.done.text = std::move(rows);
  RunControl whole({.threads = 1});
  RunControl control(whole, Questions{count + 50'000});
  const RunScope scope(control);
  const CheckedJobRequest asked = checked_job(request, Door::document);
  EXPECT_EQ(asked->done.size(), 200U);
  EXPECT_EQ(asked->rest.size(), count - 200);
  const PlanAnswer answer = answer_to(asked, control);
  ASSERT_TRUE(answer.plan);
  EXPECT_TRUE(answer.plan->sheet.does_the_job());
  EXPECT_EQ(asked->job->tests_done, 200U);
}

// A row without a result was done; one whose result is empty was not, where another has one, as on
// a run sheet.
TEST(JobRequest, ATestWithAnEmptyResultWasNotRun) {
  const auto tests_done = [](const std::string& rows) {
    return checked_job(
               job_request(R"({"items":6,"at_once":2,"test_cost":1,"change_cost":1,"done":[)" +
                           rows + "]}"),
               Door::document)
        ->job->tests_done;
  };
  const std::string passed = R"({"parts":["1","2"],"result":"pass"})";
  EXPECT_EQ(tests_done(passed + R"(,["3","4"])"), 2U);
  EXPECT_EQ(tests_done(passed + R"(,{"parts":["3","4"]})"), 2U);
  for (const std::string empty : {R"("")", "null"}) {
    const std::string row = R"({"parts":["3","4"],"result":)" + empty + "}";
    EXPECT_EQ(tests_done(passed + "," + row), 1U);
    EXPECT_EQ(tests_done(R"(["1","2"],)" + row), 1U);
    EXPECT_EQ(tests_done(row), 1U);  // a list without results is of tests that were done
  }
}

}  // namespace
}  // namespace changeover::job_request_test
