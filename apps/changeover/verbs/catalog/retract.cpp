// changeover catalog retract LABEL --why TEXT, changeover catalog alias WORD LABEL: what is said of
// entries that are there.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "request/catalog_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct RetractRequest {
  std::string label, why;
  CatalogRequest catalog;
  OutputRequest output;
};

struct AliasRequest {
  std::string word, label;
  bool remove = false;
  CatalogRequest catalog;
  OutputRequest output;
};

constexpr std::size_t longest_words = 2000;

void require_words(const std::string& what, const std::string& words) {
  if (words.empty() || words.size() > longest_words || !is_printable(words)) {
    throw UsageError{fmt::format("{}: it is empty or longer than a line; write 1 to {} bytes", what,
                                 longest_words)};
  }
}

// The whole label of what the words lead to.
std::string whole_label(const Catalog& catalog, const std::string& words) {
  const auto entry = catalog.find(words);
  if (!entry) {
    throw MissingResource(has_no_design(words) + left_out());
  }
  return entry->label();
}

Answer changed(std::string text, const OutputRequest& output) {
  Answer answer = text_answer(std::move(text), output);
  answer.done_before = catalog_was_changed;
  return answer;
}

Answer run_retract(const RetractRequest& request) {
  require_words("--why", request.why);
  Catalog& catalog = request.catalog.open_to_change(request.output);
  const std::string label = whole_label(catalog, request.label);
  catalog.retract(label, request.why);
  const std::string asked =
      label == request.label ? "" : fmt::format(" (found by {})", printable(request.label));
  return changed(fmt::format("retracted: {}{}\n", label, asked), request.output);
}

Answer run_alias(const AliasRequest& request) {
  require_words("WORD", request.word);
  Catalog& catalog = request.catalog.open_to_change(request.output);
  if (request.remove) {
    const std::string behind = catalog.remove_alias(request.word);
    return changed(
        fmt::format("{} leads to {} no more\n", printable(request.word), printable(behind)),
        request.output);
  }
  const std::string label = whole_label(catalog, request.label);
  catalog.alias(request.word, label);
  return changed(fmt::format("{} leads to {}\n", request.word, label), request.output);
}

}  // namespace

void add_catalog_retract(Program& program) {
  auto [verb, request] =
      program.add<RetractRequest>("catalog-retract", "mark a design as withdrawn", run_retract);
  verb.positional("LABEL", request.label, "of the design, or a beginning that only it has");
  verb.option("--why", request.why, "TEXT", "one line (needed)");
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text"});
  verb.examples(
      {"changeover catalog retract 20.5.2.linear.39.3fa9c1d2 --why 'printed with an error'",
       "it stays, is not used any more, and says why; also one that comes with the program"});
}

void add_catalog_alias(Program& program) {
  auto [verb, request] = program.add<AliasRequest>(
      "catalog-alias", "give a design of the catalog a second name", run_alias);
  verb.positional("WORD", request.word, "what is to lead there");
  verb.positional("LABEL", request.label, "of the design", false);
  verb.flag("--remove", request.remove, "take WORD out, whatever it leads to");
  verb.require([&asked = request] {
    if (asked.remove != asked.label.empty()) {
      throw UsageError{asked.remove ? "--remove takes WORD alone; leave LABEL out"
                                    : "LABEL is missing; name the design that WORD leads to"};
    }
  });
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text"});
  verb.examples({"changeover catalog alias example-7 20.5.2.linear.39.3fa9c1d2",
                 "changeover catalog alias --remove example-7"});
}

}  // namespace changeover::cli
