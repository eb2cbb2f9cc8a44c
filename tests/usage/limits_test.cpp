// docs/limits.md: each row at its limit and one beyond it.
#include <functional>

#include "cases.hpp"
#include "limits_table.hpp"

namespace changeover::test::limits_test {
namespace {

struct Limit {
  std::string command;                             ///< N in it is the number
  std::function<std::string(std::uint64_t)> file;  ///< the content of `it` for that number
  int at = 0;  ///< the exit code at the limit; if it is 3, for another reason than the limit
};

std::string many(std::uint64_t n, char c) { return std::string(static_cast<std::size_t>(n), c); }

std::string repeated(std::uint64_t n, const std::string& text) {
  std::string all;
  for (std::uint64_t i = 0; i < n; ++i) {
    all += text;
  }
  return all;
}

std::string numbers(std::uint64_t n) {
  std::string lines;
  for (std::uint64_t i = 1; i <= n; ++i) {
    lines += std::to_string(i) + "\n";
  }
  return lines;
}

std::string literal(const std::string& also = "") {
  return R"("recipe":{"construction":"literal","v":4,"k":3,"change":1,"kind":"linear","arguments":{},)"
         R"("inputs":[],"blocks":[[0,1,3],[0,1,2],[0,3,2]]},)"
         R"("sha256":"2fc52240fda6e0e7a8c8a6f700e8a8a64293b51a347461e16f4d08bb6fbd59d9")" +
         also;
}

// A catalog of one design, of that label and number of blocks.
std::string catalog(const std::string& cell, std::uint64_t b, const std::string& rest) {
  const std::string blocks = std::to_string(b);
  return "{\"format\":\"changeover-catalog/1\"}\n{\"label\":\"" + cell + ".linear." + blocks +
         ".2fc52240\",\"b\":" + blocks + ",\"lower_bound\":3,\"reason\":\"counting\"," + rest +
         "}\n";
}

// Blocks that are not needed are dropped, again and again: there are none.
std::string recipe_of(std::uint64_t v, std::uint64_t depth) {
  const std::string of = ",\"v\":" + std::to_string(v) +
                         R"(,"k":3,"change":1,"kind":"linear","arguments":{},"inputs":[)";
  return repeated(depth - 1, R"({"construction":"drop")" + of) + R"({"construction":"literal")" +
         of + R"(],"blocks":[[0,1,3],[0,1,2],[0,3,2]]})" + repeated(depth - 1, "]}");
}

std::string with_recipe(const std::string& cell, std::uint64_t b, const std::string& recipe) {
  return catalog(
      cell, b,
      "\"recipe\":" + recipe +
          R"(,"sha256":"2fc52240fda6e0e7a8c8a6f700e8a8a64293b51a347461e16f4d08bb6fbd59d9")");
}

const std::string import =
    "rm -f mine.db*; CHANGEOVER_CATALOG=mine.db $changeover catalog import it --quiet";
const std::string plan =
    "$changeover plan it --at-once 3 --test-cost 1 --change-cost 1 --time 100ms";

const std::string model =
    "$changeover plan --model it --objective tests --steps 1 --quiet --threads 1";

const std::map<std::string, Limit>& limits() {
  static const std::map<std::string, Limit> all{
      {"elements",
       {"$changeover verify it",
        [](std::uint64_t n) {
          return "# changeover design v=" + std::to_string(n) + " k=2 change=1\n0 1\n1 2\n";
        },
        1}},
      {"element-name",
       {"$changeover verify it", [](std::uint64_t n) { return many(n, 'a') + " b\nb c\n"; }, 1}},
      {"json-depth",
       {"$changeover verify it",
        [](std::uint64_t n) {
          return "{\"v\":3,\"k\":2,\"x\":" + many(n - 1, '[') + many(n - 1, ']') +
                 ",\"blocks\":[[0,1],[1,2],[0,2]]}";
        },
        0}},
      {"xml-depth",
       {"$changeover verify it",
        [](std::uint64_t n) {
          return "<list_of_designs>" + repeated(n - 1, "<a>") + repeated(n - 1, "</a>") +
                 "</list_of_designs>";
        },
        3}},
      {"strength", {"$changeover bounds 20 6 --strength N", {}, 0}},
      {"most-elements", {"$changeover bounds N 4294967295", {}, 0}},
      {"parts", {plan, numbers, 0}},
      {"parts-of-triples",
       {"$changeover plan --items N --at-once 4 --strength 3 --test-cost 1 --change-cost 1 --time 100ms "
        "--quiet",
        {},
        0}},
      {"part-name", {plan, [](std::uint64_t n) { return many(n, 'a') + "\nb\n"; }, 0}},
      {"model-values",
       {model,
        [](std::uint64_t n) {
          std::string text = "A: a, b\nB: 1";
          for (std::uint64_t i = 2; i + 2 <= n; ++i) {
            text += ", " + std::to_string(i);
          }
          return text + "\n";
        },
        0}},
      {"model-conditions",
       {model, [](std::uint64_t n) { return "A: a, b\nB: c, d\n" + repeated(n, "[A]<[B];\n"); },
        0}},
      {"model-brackets",
       {model,
        [](std::uint64_t n) {
          return "A: a, b\nB: c, d\n" + many(n - 1, '(') + "[A]<[B]" + many(n - 1, ')') + ";\n";
        },
        0}},
      {"list-line", {plan, [](std::uint64_t n) { return "#" + many(n - 1, 'a') + "\na\nb\n"; }, 0}},
      {"workbook-bytes",
       {plan, [](std::uint64_t n) { return "PK\x03\x04" + many(n - 4, '\0'); }, 3}},
      {"minima-bytes",
       {"$changeover minima --data it", [](std::uint64_t n) { return many(n, 'a'); }, 3}},
      {"items", {"echo 0 1 >pair; $changeover loadorder --pairs pair --room 2 --items N", {}, 0}},
      {"workers", {"$changeover loadorder --items 100 --room 8 --workers N", {}, 0}},
      {"item-name",
       {"$changeover loadorder --pairs it --room 2",
        [](std::uint64_t n) { return many(n, 'a') + " b\n"; }, 0}},
      {"pair-line",
       {"$changeover loadorder --pairs it --room 2",
        [](std::uint64_t n) { return "a b\n" + many(n, ' ') + "\n"; }, 0}},
      {"base-blocks",
       {"$changeover search N 3 --base-blocks --circular --time 100ms --quiet", {}, 30}},
      {"catalog-line",
       {import,
        [](std::uint64_t n) {
          const std::string text = catalog("4.3.1", 3, literal());
          const std::size_t first = text.find('\n') + 1;
          const std::size_t bytes = text.size() - first - 1;
          return text.substr(0, text.size() - 2) + many(n - bytes, ' ') + "}\n";
        },
        0}},
      {"catalog-text",
       {import,
        [](std::uint64_t n) {
          return catalog("4.3.1", 3, literal(",\"note\":\"" + many(n, 'n') + "\""));
        },
        0}},
      {"citations",
       {import,
        [](std::uint64_t n) {
          std::string keys = "\"a\"";
          for (std::uint64_t i = 1; i < n; ++i) {
            keys += ",\"a" + std::to_string(i) + "\"";
          }
          return catalog("4.3.1", 3, literal(",\"cites\":[" + keys + "]"));
        },
        0}},
      {"import-elements",
       {import,
        [](std::uint64_t n) { return with_recipe(std::to_string(n) + ".3.1", 3, recipe_of(n, 1)); },
        3}},
      {"import-blocks",
       {import, [](std::uint64_t n) { return with_recipe("4.3.1", n, recipe_of(4, 1)); }, 3}},
      {"recipe-depth",
       {import, [](std::uint64_t n) { return with_recipe("4.3.1", 3, recipe_of(4, n)); }, 0}},
  };
  return all;
}

std::string said_of(const Outcome& outcome) {
  std::string line = outcome.err;
  line.erase(line.find_last_not_of('\n') + 1);
  return line;
}

std::map<std::string, LimitRow> rows() {
  return limit_rows(std::string(CHANGEOVER_TEST_DATA) + "/../../docs/limits.md",
                    "Files and arguments");
}

Outcome tried(const Limit& limit, std::uint64_t number, const TemporaryFolder& folder) {
  std::string command = limit.command;
  if (limit.file) {
    spit(folder.path() / "it", limit.file(number));
  } else {
    command.replace(command.find(" N") + 1, 1, std::to_string(number));
  }
  return run(command, folder.path());
}

TEST(LimitsPage, HasWhatIsTriedAndNothingElse) {
  for (const auto& [name, row] : rows()) {
    EXPECT_TRUE(limits().contains(name)) << name << " is on the page and not tried";
  }
  EXPECT_EQ(rows().size(), limits().size());
}

class Limits : public testing::TestWithParam<std::string> {};

TEST_P(Limits, HoldsAtItAndOneBeyond) {
  const Limit& limit = limits().at(GetParam());
  const auto page = rows();
  ASSERT_TRUE(page.contains(GetParam())) << "not on the page";
  const LimitRow& row = page.at(GetParam());
  const TemporaryFolder folder;
  const Outcome at = tried(limit, row.limit, folder);
  EXPECT_EQ(at.code, limit.at) << at.err;
  EXPECT_NE(said_of(at), row.line) << "refused at its limit";
  const Outcome beyond = tried(limit, row.limit + 1, folder);
  EXPECT_EQ(beyond.code, row.code);
  EXPECT_EQ(said_of(beyond), row.line);
  EXPECT_EQ(beyond.out, "");
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& [name, limit] : limits()) {
    all.push_back(name);
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Of, Limits, testing::ValuesIn(names()), [](const auto& each) {
  std::string name = each.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace changeover::test::limits_test
