#include "serve/plans/run_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/json_events.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {
namespace {

constexpr std::string_view run_format = "changeover-run/1";
constexpr std::size_t most_letters = 200;  // of a name, a result or a title
constexpr std::size_t most_in_notes = 2'000;

std::string text_within(JsonBody& body, const std::string& name, std::size_t most) {
  std::string text = body.text(name).value_or("");
  if (text.size() > most) {
    throw Refusal{422, fmt::format("{}: more than {} bytes; shorten it", name, most)};
  }
  return text;
}

// What a file needs, and a body may leave out.
void require_all(JsonBody& body, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (body.find(name) == nullptr) {
      throw Refusal{422, name + " is missing; add it"};
    }
  }
}

std::uint64_t revision_in(JsonBody& body, const std::string& name, std::uint64_t most) {
  const std::uint64_t revision = body.needed_number(name);
  if (revision == 0 || revision > most) {
    throw Refusal{422, fmt::format("{}: write 1 to {}", name, most)};
  }
  return revision;
}

// Where the sheet is in the text of a run. Nothing is built of it: it may be all but the whole
// text.
class SheetFinder final : public JsonHandler {
 public:
  void on(const JsonEvent& event) override {
    switch (event.type) {
      case JsonEvent::Type::key:
        is_next_ = depth_ == 1 && event.text == "sheet";
        return;
      case JsonEvent::Type::begin_object:
      case JsonEvent::Type::begin_array:
        if (is_next_ && event.type == JsonEvent::Type::begin_object) {
          if (end_ != 0) {
            throw BadInput("sheet: it is there twice");
          }
          is_within_ = true;
          begin_ = event.offset;
        }
        ++depth_;
        break;
      case JsonEvent::Type::end_object:
      case JsonEvent::Type::end_array:
        --depth_;
        if (is_within_ && depth_ == 1) {
          is_within_ = false;
          end_ = event.offset + 1;
        }
        break;
      default:
        break;
    }
    is_next_ = false;
  }

  [[nodiscard]] std::size_t begin() const { return begin_; }
  /// Equal to begin() if there is none.
  [[nodiscard]] std::size_t end() const { return end_; }

 private:
  std::size_t depth_ = 0;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool is_next_ = false;
  bool is_within_ = false;
};

KeptRun whole_run(JsonBody& body, const std::string& id) {
  require_all(body, {"format", "id", "title", "changed", "sheet", "results"});
  if (body.text("format") != run_format) {
    throw Refusal{422, fmt::format("format: write {}", run_format)};
  }
  KeptRun run{.id = short_text(body, "id"), .title = short_text(body, "title")};
  if (run.id != id) {
    throw Refusal{422, "id: it is that of another run, not that in the name of the file"};
  }
  run.revision = revision_in(body, "revision", most_revisions);
  run.sheet_revision = revision_in(body, "sheet_revision", run.revision);
  run.changed = short_text(body, "changed");
  run.tests = body.needed_number("tests");
  read_sheet(body, run);
  body.finish();
  return run;
}

}  // namespace

std::uint64_t KeptRun::done() const {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(results, [](const RunResult& each) { return !each.result.empty(); }));
}

std::string short_text(JsonBody& body, const std::string& name) {
  return text_within(body, name, most_letters);
}

RunResult result_in(JsonBody& body) {
  RunResult result{.test = short_text(body, "test"),
                   .result = short_text(body, "result"),
                   .notes = text_within(body, "notes", most_in_notes),
                   .by = short_text(body, "by")};
  if (result.test.empty()) {
    throw Refusal{422, "test: write which test of the sheet it is"};
  }
  return result;
}

void require_test(const std::string& test, std::uint64_t tests) {
  const std::string_view all = test;
  const std::string_view number = all.substr(all.rfind(' ') + 1);  // of all if there is no blank
  const auto said = parsed<std::uint64_t>(number);
  const std::string_view bench = all.substr(0, all.size() - number.size());
  const bool is_bare = bench.starts_with(' ') || bench.ends_with("  ");
  if (!said || *said == 0 || *said > tests || number.front() == '0' || is_bare) {
    throw Refusal{422,
                  fmt::format("test: {} is not on the sheet, which has {}; write the number of a "
                              "test in its list",
                              shown(test), count_of(tests, "test"))};
  }
}

namespace {

// Where the sheet of the explorer's page, or a plan on it, has its tests: not more are told of.
void require_tests_of(const JsonNode& sheet, std::uint64_t tests) {
  using Way = std::pair<std::string_view, std::string_view>;
  for (const auto& [key, list] : {Way{"outcome", "tests"}, Way{"plan", "steps"}}) {
    const JsonNode* const part = sheet.find(key);
    const JsonNode* const found = part != nullptr && part->is_object() ? part->find(list) : nullptr;
    if (found != nullptr && found->is_array() && tests > found->members.size()) {
      throw Refusal{422, fmt::format("tests: {}, but the sheet has {}; write how many it has",
                                     tests, found->members.size())};
    }
  }
}

}  // namespace

void read_sheet(JsonBody& body, KeptRun& run) {
  const JsonNode* const sheet = body.find("sheet");
  if (sheet == nullptr || !sheet->is_object()) {
    throw Refusal{422, "sheet: write an object"};
  }
  require_tests_of(*sheet, run.tests);
  run.sheet = json_text(*sheet);
  if (const JsonNode* const results = body.find("results")) {
    if (!results->is_array() || results->members.size() > run.tests) {
      throw Refusal{422, "results: write a list with at most one result per test"};
    }
    for (const auto& [key, each] : results->members) {
      JsonBody one(each);
      run.results.push_back(result_in(one));
      run.results.back().at = short_text(one, "at");
      one.finish();
    }
  }
}

void write_head(JsonWriter& json, const KeptRun& run) {
  json.key("id").value(run.id).key("title").value(run.title);
  json.key("revision").value(run.revision).key("sheet_revision").value(run.sheet_revision);
  json.key("changed").value(run.changed).key("tests").value(run.tests);
}

std::string run_json(const KeptRun& run) {
  JsonWriter json;
  json.begin_object().key("format").value(run_format);
  write_head(json, run);
  json.key("sheet").raw(run.sheet);
  json.objects("results", run.results, [&](const RunResult& each) {
    json.key("test").value(each.test).key("result").value(each.result);
    json.key("notes").value(each.notes).key("by").value(each.by).key("at").value(each.at);
  });
  return json.end_object().take() + "\n";
}

KeptRun run_in(const std::string& text, const std::string& id) {
  try {
    const std::string name = "<text>";
    SheetFinder sheet;
    parse_json({.text = text, .name = name}, sheet);
    const bool has_sheet = sheet.end() != 0;
    std::string rest = text;
    rest.replace(sheet.begin(), sheet.end() - sheet.begin(), has_sheet ? "{}" : "");
    JsonBody body(rest);
    KeptRun run = whole_run(body, id);
    run.sheet = text.substr(sheet.begin(), sheet.end() - sheet.begin());
    return run;
  } catch (const Refusal& refusal) {
    throw BadInput(refusal.message);
  } catch (const BadInput& fault) {
    // Its place stands behind the name of the text.
    const std::string_view why = fault.what();
    constexpr std::string_view name = "<text>:";
    throw BadInput(why.starts_with(name) ? "at " + std::string(why.substr(name.size()))
                                         : std::string(why));
  }
}

}  // namespace changeover::serve
