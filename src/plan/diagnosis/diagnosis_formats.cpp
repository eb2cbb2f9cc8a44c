// Writes a diagnosis, for people and for programs.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <ranges>

#include "changeover/plan/diagnosis.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "plan/sheet/places.hpp"
#include "plan/sheet/sheet_document.hpp"
#include "plan/sheet/sheet_words.hpp"
#include "plan/sheet/step_table.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_suspects = 12;  // suspects, one per line
constexpr std::size_t most_in_a_line = 6;  // explanations
constexpr std::size_t most_in_json = 100;

std::string kind_and_words(const Job& job, const Suspect& suspect) {
  return fmt::format("{} {}", suspect.other ? "pair" : "part", in_words(suspect, job.names));
}

// "part Pump", or for several "Pump, and Motor with Belt".
std::string words_of(const Job& job, const Explanation& explanation) {
  if (explanation.size() == 1) {
    return kind_and_words(job, explanation.front());
  }
  return joined(explanation, ", and ",
                [&](const Suspect& suspect) { return in_words(suspect, job.names); });
}

// Parts first.
std::string some_of(const Job& job, std::vector<Explanation> explanations) {
  std::ranges::stable_partition(explanations,
                                [](const Explanation& each) { return !each.front().other; });
  std::string words;
  for (std::size_t i = 0; i < std::min(explanations.size(), most_in_a_line); ++i) {
    words += (i == 0 ? "" : "; ") + words_of(job, explanations[i]);
  }
  return explanations.size() > most_in_a_line
             ? fmt::format("{}; and {} more", words, explanations.size() - most_in_a_line)
             : words;
}

// The explanations that remain after a result.
std::string what_is_left(const Job& job, const std::vector<Explanation>& explanations, bool all) {
  const std::string at_least = all ? "" : "at least ";
  switch (explanations.size()) {
    case 0:
      return "none of these explains it, and more faults are looked for";
    case 1:
      return fmt::format("it is {}{}", words_of(job, explanations.front()),
                         all ? "" : ", or something that is not listed");
    default:
      return fmt::format("{}{} are left: {}", at_least, explanations.size(),
                         some_of(job, explanations));
  }
}

// Why this test was chosen.
std::string why_next(const Job& job, const Diagnosis& found) {
  const NextTest& next = *found.next;
  if (next.proves) {
    return fmt::format("one explanation is left; in this test nothing may be at fault but {}",
                       kind_and_words(job, *next.proves));
  }
  const std::size_t all = found.explanations.size();
  const std::size_t ruled_out = std::min(next.if_it_fails.size(), next.if_it_passes.size());
  return fmt::format(
      "it fails under {} of the {}, so either result rules out at least {}; no other test that was "
      "looked at rules out more for its cost",
      next.if_it_fails.size(), count_of(all, "explanation"), ruled_out);
}

std::string if_it_fails(const Job& job, const Diagnosis& found) {
  const NextTest& next = *found.next;
  return next.proves ? fmt::format("{} is at fault", kind_and_words(job, *next.proves))
                     : what_is_left(job, next.if_it_fails, found.all_explanations);
}

std::string if_it_passes(const Job& job, const Diagnosis& found) {
  const NextTest& next = *found.next;
  return next.proves ? fmt::format("{} is not at fault, and something else is",
                                   kind_and_words(job, *next.proves))
                     : what_is_left(job, next.if_it_passes, found.all_explanations);
}

// Results that no fault explains.
void add_contradictions(const Job& job, const Diagnosis& found, std::vector<std::string>& lines) {
  if (found.contradictions.empty()) {
    return;
  }
  lines.emplace_back(
      "Results contradict each other: a fault comes and goes, or a result is wrong.");
  for (const auto& [failed, passed] : found.contradictions) {
    const std::string what = joined(names_of(job, failed));
    lines.push_back(
        passed.empty()
            ? fmt::format("  {} failed, though all its parts and pairs passed elsewhere: three "
                          "parts together may be at fault; run it again",
                          what)
        : failed.size() == passed.size()
            ? fmt::format("  {} failed and passed; run it again", what)
            : fmt::format("  {} failed, and passed as part of {}; run both again", what,
                          joined(names_of(job, passed))));
  }
}

void add_explanations(const Job& job, const Diagnosis& found, std::vector<std::string>& lines) {
  const std::size_t count = found.explanations.size();
  if (found.looked_at) {
    lines.push_back(fmt::format(
        "{} faults at least, or a result is wrong: one test that failed is looked at by itself, "
        "{}.",
        found.at_least, joined(names_of(job, *found.looked_at))));
    lines.push_back(fmt::format("One of its {} is at fault:", count_of(count, "suspect")));
  } else if (count == 1) {
    lines.push_back(fmt::format("{} faults together explain all results, and no other {} do:",
                                found.at_least, found.at_least));
  } else {
    lines.push_back(fmt::format(
        "{} all results. There are {} faults at least; {}{} of so many do together:",
        found.at_least == 2 ? "No part and no pair alone explains"
                            : fmt::format("No {} faults together explain", found.at_least - 1),
        found.at_least, found.all_explanations ? "" : "more than ", count_of(count, "set")));
  }
  for (std::size_t i = 0; i < std::min(count, most_suspects); ++i) {
    lines.push_back("  " + words_of(job, found.explanations[i]));
  }
  if (count > most_suspects) {
    lines.push_back(fmt::format("  and {} more", count - most_suspects));
  }
}

// The conclusions from the results, one per line; many suspects are in a table instead.
std::vector<std::string> what_is_suspect(const Job& job, const Diagnosis& found) {
  const std::string all = found.unread == 0 ? "all results" : "all results that are understood";
  if (found.failed == 0) {
    return {found.unread == 0 ? "No test failed: nothing is suspect."
                              : "No test failed as far as results are understood; one that is not "
                                "may be a failure."};
  }
  std::vector<std::string> lines;
  add_contradictions(job, found, lines);
  const std::size_t suspects = found.suspects.size();
  if (suspects > most_suspects) {
    lines.push_back(
        fmt::format("One fault may explain {}, one of the {} suspects below.", all, suspects));
    return lines;
  }
  if (suspects > 0) {
    lines.push_back(suspects == 1
                        ? fmt::format("One fault alone explains {}{}:", all,
                                      found.faults.empty() ? "" : ", and is proven")
                        : fmt::format("One fault may explain {}, one of these {}:", all, suspects));
    for (const Suspect& suspect : found.suspects) {
      lines.push_back("  " + kind_and_words(job, suspect));
    }
    return lines;
  }
  if (!found.explanations.empty()) {
    add_explanations(job, found, lines);
  }
  if (!found.faults.empty()) {
    lines.push_back("Proven to be at fault: " + joined(found.faults, [&](const Suspect& fault) {
                      return in_words(fault, job.names);
                    }));
  }
  return lines;
}

// The next test in words, or why there is none.
std::vector<std::string> what_is_next(const Job& job, const Diagnosis& found) {
  if (found.next) {
    return {"Next test: " + why_next(job, found) + ".",
            "  If it fails, " + if_it_fails(job, found) + ".",
            "  If it passes, " + if_it_passes(job, found) + ".",
            fmt::format("  Run it, add its result to the tests that were done, and ask again{}.",
                        found.least_tests > 1
                            ? fmt::format("; it may take {} tests, and no way to ask is sure to "
                                          "take fewer",
                                          found.least_tests)
                            : "")};
  }
  if (found.failed == 0) {
    return {};
  }
  const bool all_proven = found.explanations.size() == 1 && found.faults.size() == found.at_least;
  return {all_proven ? "Nothing is left to find out: replace what is at fault, or name it in the "
                       "forbidden pairs."
                     : "No test that can be mounted tells more."};
}

// For many suspects: a row for each part, with the parts that it may not work with.
Table suspects_by_part(const Job& job, const Diagnosis& found) {
  struct OfPart {
    bool alone = false;
    std::vector<std::string> with;
  };
  std::map<Element, OfPart> parts;
  for (const Suspect& suspect : found.suspects) {
    suspect.other ? parts[suspect.one].with.push_back(job.names[*suspect.other])
                  : void(parts[suspect.one].alone = true);
  }
  using Rows = std::vector<std::pair<Element, OfPart>>;
  const auto rows = std::make_shared<const Rows>(parts.begin(), parts.end());
  const Job* const of = &job;
  return {
      .rows = rows->size(),
      .columns = {
          {"part", [rows, of](std::size_t i) { return TableCell(of->names[(*rows)[i].first]); }},
          {"alone",
           [rows](std::size_t i) {
             return TableCell(std::string((*rows)[i].second.alone ? "perhaps" : ""));
           }},
          {"or with one of",
           [rows](std::size_t i) { return TableCell((*rows)[i].second.with); },
           {.kind = ColumnKind::list}}}};
}

// The next test as a run sheet, on the bench for which it was chosen; in a workbook the planned
// steps follow it.
struct NextSheet {
  Job job;
  RunSheet sheet = {};
  RunSheet with_rest = {};

  NextSheet(const Job& of, const std::optional<NextTest>& next, const std::vector<Block>& rest)
      : job(of) {
    job.first.clear();
    std::vector<Block> setups;
    if (next) {
      set_start(*next);
      setups.push_back(next->setup);
      sheet = run_sheet(job, setups);
    }
    std::ranges::copy_if(rest, std::back_inserter(setups),
                         [](const Block& setup) { return !setup.empty(); });
    with_rest = run_sheet(job, setups);
  }

 private:
  void set_start(const NextTest& next) {
    Block start = next.take_out;
    std::ranges::copy_if(next.setup, std::back_inserter(start), [&](Element x) {
      return std::ranges::find(next.put_in, x) == next.put_in.end();
    });
    std::ranges::sort(start);
    Block said = job.start;
    std::ranges::sort(said);
    if (said != start) {
      job.start = start;
      job.places.clear();
    }
  }
};

void write(JsonWriter& json, const Job& job, const Suspect& suspect) {
  json.begin_array().value(job.names[suspect.one]);
  if (suspect.other) {
    json.value(job.names[*suspect.other]);
  }
  json.end_array();
}

void write(JsonWriter& json, const Job& job, const std::vector<Suspect>& suspects) {
  json.list(suspects, [&](const Suspect& suspect) { write(json, job, suspect); });
}

void write(JsonWriter& json, const Job& job, const std::vector<Explanation>& explanations) {
  json.list(explanations | std::views::take(most_in_json),
            [&](const Explanation& each) { write(json, job, each); });
}

void write_left(JsonWriter& json, const Job& job, const std::vector<Explanation>& explanations) {
  json.begin_object().key("left").value(explanations.size()).key("explanations");
  write(json, job, explanations);
  json.end_object();
}

void write_next(JsonWriter& json, const Job& job, const Diagnosis& found) {
  if (!found.next) {
    json.null();
    return;
  }
  const NextTest& next = *found.next;
  const NextSheet on_bench(job, next, {});
  json.begin_object().key("set_up").value(names_of(job, next.setup));
  json.key("take_out").value(names_of(job, next.take_out));
  json.key("put_in").value(names_of(job, next.put_in));
  const PlacedSheets places = placed({{&on_bench.job, &on_bench.sheet}});
  auto part = places.sheets.front().steps.front().begin();
  json.objects("places", places.places, [&](const MountedPlace& place) {
    json.key("number").value(place.number).key("part");
    *part ? json.value(job.names[**part]) : json.null();
    ++part;
  });
  json.key("cost").raw(Money(job)(next.cost)).key("proves");
  next.proves ? write(json, job, *next.proves) : void(json.null());
  json.key("why").value(why_next(job, found)).key("if_it_fails");
  write_left(json, job, next.if_it_fails);
  json.key("if_it_passes");
  write_left(json, job, next.if_it_passes);
  json.end_object();
}

}  // namespace

TableDocument table_document(const DiagnosisDocument& document) {
  const Job& job = *document.job;
  const Diagnosis& found = *document.found;
  TableDocument made{
      .title = fmt::format(
          "Diagnosis of {}: {} passed, {} failed{}",
          count_of(found.passed + found.failed + found.unread, "test"), found.passed, found.failed,
          found.unread == 0 ? "" : fmt::format(", {} not understood", found.unread)),
      .style = style_of(job),
      .overview = "Diagnosis"};
  std::vector<std::string> lines = what_is_suspect(job, found);
  for (const UnreadResult& each : found.first_unread) {
    lines.push_back(fmt::format("{}: the result {} is not understood; write pass or fail",
                                each.place, shown(each.text)));
  }
  if (found.first_unread.size() < found.unread) {
    lines.push_back(fmt::format("… and {} more", found.unread - found.first_unread.size()));
  }
  for (std::string& line : what_is_next(job, found)) {
    lines.push_back(std::move(line));
  }
  for (const std::string& note : found.notes) {
    lines.push_back("note: " + note);
  }
  set_lines(made, std::move(lines));
  const Money money(job);
  const auto sheet = std::make_shared<const NextSheet>(job, found.next, document.rest);
  made.sections.push_back(
      {.table = document.benches == nullptr
                    ? kept_with(step_table({{&sheet->job, &sheet->with_rest}}, money, {}), sheet)
                    : bench_step_table({.job = document.of_benches, .plan = document.benches}),
       .in = in_workbook,
       .sheet = "Run sheet"});
  if (found.next) {
    made.sections.push_back(
        {.heading = fmt::format("Next test, {}", cost_words(job, money, found.next->cost)),
         .table = kept_with(step_table({{&sheet->job, &sheet->sheet}}, money, {}), sheet),
         .in = for_people | in_csv});
  }
  // Also called without a table: it makes the sheet with the lines.
  const bool many = found.suspects.size() > most_suspects;
  made.sections.push_back({.heading = many ? "Suspects" : "",
                           .table = many ? suspects_by_part(job, found) : Table{},
                           .in = many ? everywhere & ~in_csv : in_workbook});
  add_what_goes_on(made, document.of_benches == nullptr ? job : *document.of_benches, money,
                   document.done, document.question, document.list);
  return made;
}

std::string json_of(const DiagnosisDocument& document) {
  const Job& job = *document.job;
  const Diagnosis& found = *document.found;
  JsonWriter json;
  json.begin_object().key("format").value("changeover-diagnosis/1");
  json.key("passed").value(found.passed).key("failed").value(found.failed);
  json.key("unread").value(found.unread);
  json.objects("first_unread", found.first_unread, [&](const UnreadResult& each) {
    json.key("place").value(each.place).key("result").value(each.text);
  });
  json.key("notes").value(found.notes).key("faults");
  write(json, job, found.faults);
  json.key("suspects");
  write(json, job, found.suspects);
  json.key("at_least").value(found.at_least);
  json.key("explanations_known").value(found.explanations.size());
  json.key("all_explanations").value(found.all_explanations).key("explanations");
  write(json, job, found.explanations);
  json.key("looked_at");
  found.looked_at ? json.value(names_of(job, *found.looked_at)) : json.null();
  json.objects("contradictions", found.contradictions, [&](const auto& each) {
    const auto& [failed, passed] = each;
    json.key("failed").value(names_of(job, failed)).key("passed");
    passed.empty() ? json.null() : json.value(names_of(job, passed));
  });
  json.key("next");
  write_next(json, job, found);
  json.key("least_tests").value(found.least_tests).end_object();
  return json.take() + "\n";
}

}  // namespace changeover
