// What a diagnosis says, for people and for programs.
#include <fmt/format.h>

#include "changeover/plan/diagnosis.hpp"
#include "io/scan/place.hpp"
#include "io/write/json_writer.hpp"
#include "plan/sheet/layout.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {
namespace {

Cell words_of(const Job& job, const std::vector<Suspect>& suspects) {
  Cell cell;
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

std::string what_is_suspect(const Job& job, const Diagnosis& found) {
  const std::string all = found.unread == 0 ? "all results" : "all results that are understood";
  if (found.failed == 0 && found.unread > 0) {
    return "No test failed as far as results are understood; one that is not may be a failure.\n";
  }
  if (found.failed == 0) {
    return "No test failed: nothing is suspect.\n";
  }
  if (!found.suspects.empty()) {
    std::string text = found.suspects.size() == 1
                           ? fmt::format("One fault alone explains {}:\n", all)
                           : fmt::format("One fault may explain {}, one of these {}:\n", all,
                                         found.suspects.size());
    for (const Suspect& suspect : found.suspects) {
      text +=
          fmt::format("  {} {}\n", suspect.other ? "pair" : "part", in_words(suspect, job.names));
    }
    return text;
  }
  std::string contradictions;
  for (const auto& [failed, passed] : found.contradictions) {
    const std::string what = joined(names_of(job, failed));
    contradictions += failed.size() == passed.size()
                          ? fmt::format("  {} failed and passed\n", what)
                          : fmt::format("  {} failed, and passed as part of {}\n", what,
                                        joined(names_of(job, passed)));
  }
  if (!contradictions.empty()) {
    return "Results contradict each other: a fault comes and goes, or a result is wrong.\n" +
           contradictions;
  }
  std::string text =
      fmt::format("No part and no pair alone explains {}: there are two faults at least.\n", all);
  if (found.two.empty()) {
    return text + "Nor do two parts or pairs: there are three at least, or a result is wrong.\n";
  }
  text += "Two that do together:\n";
  for (const auto& [one, other] : found.two) {
    text += fmt::format("  {}, and {}\n", in_words(one, job.names), in_words(other, job.names));
  }
  return text;
}

}  // namespace

std::string diagnosis_as_table(const Job& job, const Diagnosis& found, std::size_t width) {
  const Money money(job);
  std::string text =
      fmt::format("Diagnosis of {}: {} passed, {} failed{}\n",
                  count_of(found.passed + found.failed + found.unread, "test"), found.passed,
                  found.failed,
                  found.unread == 0 ? "" : fmt::format(", {} not understood", found.unread)) +
      what_is_suspect(job, found);
  for (const UnreadResult& each : found.first_unread) {
    text += fmt::format("{}: the result {} is not understood; write pass or fail\n", each.place,
                        shown(each.text));
  }
  if (found.unread > found.first_unread.size()) {
    text += fmt::format("and {} more\n", found.unread - found.first_unread.size());
  }
  for (const std::string& note : found.notes) {
    text += "note: " + note + "\n";
  }
  if (found.tests.empty()) {
    return found.suspects.size() < 2 ? text : text + "No test can tell them apart.\n";
  }
  text +=
      fmt::format("\nTests that tell them apart, for at most {} in all\n", money(found.most_cost));
  std::vector<std::vector<Cell>> rows;
  rows.reserve(found.tests.size());
  for (const NextTest& test : found.tests) {
    rows.push_back({{results(test.after)},
                    names_of(job, test.take_out),
                    names_of(job, test.put_in),
                    names_of(job, test.setup),
                    {money(test.cost)},
                    words_of(job, test.if_it_fails),
                    words_of(job, test.if_it_passes)});
  }
  return text + laid_out({{"after"},
                          {"take out"},
                          {"put in"},
                          {"set-up"},
                          {"cost", true},
                          {"if it fails"},
                          {"if it passes"}},
                         rows, width);
}

std::string diagnosis_as_json(const Job& job, const Diagnosis& found) {
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
