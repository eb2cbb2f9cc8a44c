// What a diagnosis says, for people and for programs.
#include <fmt/format.h>

#include "changeover/plan/diagnosis.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "io/write/json_writer.hpp"
#include "plan/sheet/sheet_document.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {
namespace {

std::vector<std::string> words_of(const Job& job, const std::vector<Suspect>& suspects) {
  std::vector<std::string> cell;
  for (const Suspect& suspect : suspects) {
    cell.push_back(in_words(suspect, job.names));
  }
  return cell;
}

std::string results(const std::vector<bool>& after) {
  std::string text;
  for (const bool failed : after) {
    text += std::string(text.empty() ? "" : ", ") + (failed ? "fail" : "pass");
  }
  return text.empty() ? "now" : text;
}

void write(JsonWriter& json, const Job& job, const Suspect& suspect) {
  json.begin_array().value(job.names[suspect.one]);
  if (suspect.other) {
    json.value(job.names[*suspect.other]);
  }
  json.end_array();
}

void write(JsonWriter& json, const Job& job, const std::vector<Suspect>& suspects) {
  json.begin_array();
  for (const Suspect& suspect : suspects) {
    write(json, job, suspect);
  }
  json.end_array();
}

// What the results leave, a line each.
std::vector<std::string> what_is_suspect(const Job& job, const Diagnosis& found) {
  const std::string all = found.unread == 0 ? "all results" : "all results that are understood";
  if (found.failed == 0) {
    return {found.unread == 0 ? "No test failed: nothing is suspect."
                              : "No test failed as far as results are understood; one that is not "
                                "may be a failure."};
  }
  std::vector<std::string> lines;
  if (!found.suspects.empty()) {
    lines.push_back(found.suspects.size() == 1
                        ? fmt::format("One fault alone explains {}:", all)
                        : fmt::format("One fault may explain {}, one of these {}:", all,
                                      found.suspects.size()));
    for (const Suspect& suspect : found.suspects) {
      lines.push_back(
          fmt::format("  {} {}", suspect.other ? "pair" : "part", in_words(suspect, job.names)));
    }
    return lines;
  }
  if (!found.contradictions.empty()) {
    lines.emplace_back(
        "Results contradict each other: a fault comes and goes, or a result is wrong.");
    for (const auto& [failed, passed] : found.contradictions) {
      const std::string what = joined(names_of(job, failed));
      lines.push_back(failed.size() == passed.size()
                          ? fmt::format("  {} failed and passed", what)
                          : fmt::format("  {} failed, and passed as part of {}", what,
                                        joined(names_of(job, passed))));
    }
    return lines;
  }
  lines.push_back(
      fmt::format("No part and no pair alone explains {}: there are two faults at least.", all));
  lines.emplace_back(
      found.two.empty()
          ? "Nor do two parts or pairs: there are three at least, or a result is wrong."
          : "Two that do together:");
  for (const auto& [one, other] : found.two) {
    lines.push_back(
        fmt::format("  {}, and {}", in_words(one, job.names), in_words(other, job.names)));
  }
  return lines;
}

Table next_tests(const Job& job, const std::vector<NextTest>& tests) {
  const auto list = [&](std::string head, auto words) {
    return TableColumn{std::move(head),
                       [&tests, words](std::size_t i) { return TableCell(words(tests[i])); },
                       {.kind = ColumnKind::list}};
  };
  return {.rows = tests.size(),
          .columns = {
              list("after", [](const NextTest& test) { return results(test.after); }),
              list("take out", [&](const NextTest& test) { return names_of(job, test.take_out); }),
              list("put in", [&](const NextTest& test) { return names_of(job, test.put_in); }),
              list("set-up", [&](const NextTest& test) { return names_of(job, test.setup); }),
              {"cost",
               [&tests, money = Money(job)](std::size_t i) { return money(tests[i].cost); },
               {.kind = ColumnKind::cost}},
              list("if it fails",
                   [&](const NextTest& test) { return words_of(job, test.if_it_fails); }),
              list("if it passes",
                   [&](const NextTest& test) { return words_of(job, test.if_it_passes); })}};
}

}  // namespace

TableDocument table_document(const Job& job, const Diagnosis& found) {
  TableDocument made{
      .headline = fmt::format(
          "Diagnosis of {}: {} passed, {} failed{}",
          count_of(found.passed + found.failed + found.unread, "test"), found.passed, found.failed,
          found.unread == 0 ? "" : fmt::format(", {} not understood", found.unread)),
      .lines = what_is_suspect(job, found)};
  for (const UnreadResult& each : found.first_unread) {
    made.lines.push_back(fmt::format("{}: the result {} is not understood; write pass or fail",
                                     each.place, shown(each.text)));
  }
  if (found.unread > found.first_unread.size()) {
    made.lines.push_back(fmt::format("and {} more", found.unread - found.first_unread.size()));
  }
  for (const std::string& note : found.notes) {
    made.lines.push_back("note: " + note);
  }
  if (!found.tests.empty()) {
    made.sections.push_back(
        {.heading = fmt::format("Tests that tell them apart, for at most {} in all",
                                Money(job)(found.most_cost)),
         .table = next_tests(job, found.tests)});
  } else if (found.suspects.size() > 1) {
    made.lines.emplace_back("No test can tell them apart.");
  }
  return made;
}

std::string json_of(const Job& job, const Diagnosis& found) {
  const Money money(job);
  JsonWriter json;
  json.begin_object().key("format").value("changeover-diagnosis/1");
  json.key("passed").value(found.passed).key("failed").value(found.failed);
  json.key("unread").value(found.unread).key("first_unread").begin_array();
  for (const UnreadResult& each : found.first_unread) {
    json.begin_object().key("place").value(each.place).key("result").value(each.text).end_object();
  }
  json.end_array().key("notes").begin_array();
  for (const std::string& note : found.notes) {
    json.value(note);
  }
  json.end_array().key("suspects");
  write(json, job, found.suspects);
  json.key("two").begin_array();
  for (const auto& [one, other] : found.two) {
    write(json, job, std::vector<Suspect>{one, other});
  }
  json.end_array().key("contradictions").begin_array();
  for (const auto& [failed, passed] : found.contradictions) {
    json.begin_object().key("failed").value(names_of(job, failed));
    json.key("passed").value(names_of(job, passed)).end_object();
  }
  json.end_array().key("tests").begin_array();
  for (const NextTest& test : found.tests) {
    json.begin_object().key("after").begin_array();
    for (const bool failed : test.after) {
      json.value(failed ? "fail" : "pass");
    }
    json.end_array().key("set_up").value(names_of(job, test.setup));
    json.key("take_out").value(names_of(job, test.take_out));
    json.key("put_in").value(names_of(job, test.put_in));
    json.key("cost").raw(money(test.cost)).key("if_it_fails");
    write(json, job, test.if_it_fails);
    json.key("if_it_passes");
    write(json, job, test.if_it_passes);
    json.end_object();
  }
  json.end_array().key("most_cost").raw(money(found.most_cost)).end_object();
  return json.take() + "\n";
}

}  // namespace changeover
