// What callers of the library are told, and no request reaches: requests are checked before.
#include <gmock/gmock.h>

#include <functional>
#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/job_request.hpp"
#include "changeover/plan/model.hpp"
#include "changeover/plan/run_plan.hpp"
#include "message_of.hpp"
#include "plan/job/prices.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover::refusals_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

TEST(Refusals, SayWhatIsWrongWithACall) {
  const Job job = make_job(6, 3, Amount{1}, Amount{1});
  Job triples = job;
  triples.triples = {{0, 1, 2}};
  Job any = job;
  const auto costs = input_from_text("1,2\n");
  struct Case {
    std::function<void()> call;
    std::string words;
  };
  for (const auto& [call, words] :
       std::vector<Case>{{[&] {
                            (void)diagnose(job, {{{}, true}});
                          },
                          "a test that was done has no parts; name the parts of its set-up"},
                         {[&] { refuse_triples(triples, "a diagnosis"); },
                          "a diagnosis does not support triples; leave one of them out"},
                         {[&] { (void)read_value_costs(*costs, any); },
                          "costs of values are for a job of a model"},
                         {[] {
                            JobRequest both{.items = 6};
                            both.parts.text = "a\nb\n";
                            check_options(both, Door::document);
                          },
                          "give either parts or items, not both"},
                         {[] { (void)job_of(Model{}, Amount{1}, Amount{1}); },
                          "a model needs at least two parameters; add one"}}) {
    EXPECT_EQ(message_of<Error>(call), words);
  }
  EXPECT_EQ(setup_defect(job, {}), "no part is mounted; remove the set-up or complete it");
  EXPECT_THAT(bench_defects(job, {{.name = "a\nb"}}), Contains(HasSubstr("the name of bench 1: ")));
}

}  // namespace
}  // namespace changeover::refusals_test
