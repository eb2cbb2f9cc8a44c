#include "plan/job/setups/hidden_tests.hpp"

#include <fmt/format.h>

#include "changeover/plan/model.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "plan/job/choices.hpp"

namespace changeover {
namespace {

// Whether a value is written with the sign of those out of range, also behind its parameter.
bool has_the_sign(const std::string& text) {
  const std::size_t sign = text.find('~');
  if (sign == std::string::npos) {
    return false;
  }
  const std::size_t before = text.substr(0, sign).find_last_not_of(' ');
  return before == std::string::npos || text[before] == ':' || text[before] == '=';
}

}  // namespace

void keep_if_hiding(const PartFinder& finder, const std::string& text, std::optional<Element> part,
                    DoneRow& test) {
  if (finder.model() != nullptr && has_the_sign(text) &&
      !(part && finder.model()->model().value(*part).negative)) {
    test.hidden_by = text;
  }
}

bool HiddenTests::take(const Job& job, const DoneRow& test) {
  if (!test.hidden_by.empty()) {
    tests_.add([&] {
      return fmt::format("the test in row {} had {}, which is no value out of range any more",
                         test.line, shown(test.hidden_by));
    });
    return true;
  }
  if (!has_two_out_of_range(job, test.setup)) {
    return false;
  }
  tests_.add([&] {
    Block both = test.setup;
    std::erase_if(both, [&](Element x) { return !job.model->value(x).negative; });
    return fmt::format("the test in row {} had more than one value out of range, {}", test.line,
                       joined(both, [&](Element x) { return shown(job.names[x]); }));
  });
  return true;
}

std::string HiddenTests::said(const std::string& name) const {
  if (!tests_) {
    return "";
  }
  const bool is_one = tests_.count() == 1;
  return fmt::format(
      "{}: {}; an error may have hidden {} pairs, so they do not count, and a diagnosis leaves {} "
      "out",
      name, tests_.said("other test"), is_one ? "its" : "their", is_one ? "it" : "them");
}

}  // namespace changeover
