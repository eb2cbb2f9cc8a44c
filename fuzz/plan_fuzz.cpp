// Any bytes, read as each kind of list that an experimenter gives: an answer or one line, and what
// is written is read back.
#include "changeover/plan/job.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::plan_fuzz {
namespace {

void read_as_everything(const std::string& text, const Job& job) {
  const std::vector<std::string>& names = job.names;
  accepts([&] { (void)read_pairs(*input_from_text(text), names); });
  accepts([&] { (void)read_slots(*input_from_text(text)); });
  accepts([&] { (void)parse_slots(text); });
  accepts([&] { (void)read_priorities(*input_from_text(text), names); });
  accepts([&] {
    const std::vector<Amount> costs = read_change_costs(*input_from_text(text), names);
    must(costs.size() == names.size() * names.size(), "a table of costs is square");
  });
  accepts([&] {
    for (const Block& setup : read_setups(*input_from_text(text), names, job.at_once)) {
      must(setup.size() <= job.at_once, "a set-up has no more parts than fit");
      must(parse_parts(parts_text(setup, names), names) == setup, "parts are read as written");
    }
  });
  accepts([&] {
    Job first = job;
    first.first = read_first(*input_from_text(text), job);
    must(defects(first).empty(), "what is read as coming first can come first");
  });
  accepts([&] {
    const DoneList done = read_done(*input_from_text(text), names, job.at_once);
    Job left = job;
    std::vector<Block> whole;
    for (const Block& setup : done.setups()) {
      if (!setup.empty()) {
        whole.push_back(setup);
      }
    }
    mark_done(left, whole);
    must(left.needed.size() <= job.needed.size(), "tests that were made add no pairs");
  });
  accepts([&] {
    const Amount amount = parse_amount(text);
    must(parse_amount(to_string(amount)) == amount, "an amount is read as written");
  });
}

const Target target("plan", [](const std::string& text) {
  Job job = make_job(5, 3, parse_amount("1"), parse_amount("5"));
  read_as_everything(text, job);
  job.names = {"Pump A", "Valve, large", "2", "slot_1", "part"};
  read_as_everything(text, job);
  for (const Header header : {Header::guessed, Header::given, Header::none}) {
    accepts([&] {
      const PartList list = read_parts(*input_from_text(text), header);
      Block all;
      for (std::size_t x = 0; x < list.names.size(); ++x) {
        all.push_back(static_cast<Element>(x));
      }
      must(parse_parts(parts_text(all, list.names), list.names) == all,
           "names are read as written");
    });
  }
});

}  // namespace
}  // namespace changeover::fuzz::plan_fuzz
