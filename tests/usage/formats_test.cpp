// The end of a file's name says its format, in every verb: what is written is read back, what
// cannot be is refused.
#include <gmock/gmock.h>

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "cases.hpp"
#include "written_files.hpp"

namespace changeover::test::formats_test {
namespace {

using testing::HasSubstr;

// What an ending promises.
struct Promise {
  std::set<std::string> formats;  // one of them is written
  std::function<bool(const std::string&)> kept;
};

bool is_plain(const std::string& text) {
  return !text.starts_with("PK") && !text.starts_with("{") && !text.starts_with("<") &&
         text.find('\0') == std::string::npos;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::map<std::string, Promise>& promises() {
  static const std::map<std::string, Promise> all{
      {".txt", {{"text", "table", "summary"}, is_plain}},
      {".json", {{"json"}, is_json}},
      {".jsonl", {{"jsonl", "catalog"}, is_json_lines}},
      {".csv", {{"csv"}, is_csv}},
      {".md",
       {{"markdown"}, [](const auto& text) { return text.starts_with("#") || has(text, "|---"); }}},
      {".html", {{"html"}, is_page}},
      {".xlsx", {{"xlsx"}, is_workbook}},
      {".svg",
       {{"svg"}, [](const auto& text) { return is_xml(text) && text.ends_with("</svg>\n"); }}},
      {".tex",
       {{"latex", "tikz"},
        [](const auto& text) { return has(text, "\\begin{") && has(text, "\\end{"); }}},
      {".pdf", {{"pdf"}, [](const auto& text) { return text.starts_with("%PDF-"); }}},
      {".png", {{"png"}, [](const auto& text) { return text.starts_with("\x89PNG"); }}},
      {".g", {{"gap"}, [](const auto& text) { return has(text, ":= ") && has(text, ";\n"); }}},
      {".sage", {{"sage"}, [](const auto& text) { return has(text, "IncidenceStructure"); }}},
      {".xml", {{"designtheory"}, is_xml}},
      {".bib", {{"bibtex"}, [](const auto& text) { return text.starts_with("@"); }}}};
  return all;
}

class Formats : public testing::Test {
 protected:
  Formats() {
    spit(folder.file("three.txt"), "0 1 2\n0 1 3\n0 2 3\n");
    const std::string added = run(typed("catalog add three.txt"), folder.path()).out;
    label = added.substr(added.find(' ') + 1, added.find(',') - added.find(' ') - 1);
    run(typed("catalog export --users -o theirs.jsonl"), folder.path());
  }

  // What each verb with --format is asked, quickly.
  const std::map<std::string, std::string> questions{
      {"design", "design 7 3"},
      {"verify", "verify three.txt"},
      {"bounds", "bounds 7 3"},
      {"explain", "explain 9 4"},
      {"dossier", "dossier 7 3"},
      {"search", "search 6 3 --time 200ms --quiet"},
      {"classify", "classify 6 3 8 --quiet"},
      {"same", "same three.txt three.txt"},
      {"table", "table --k 3..4 --v 5..8"},
      {"minima", "minima --v 6"},
      {"plan", "plan --items 6 -k 3 --test-cost 1 --change-cost 1 --steps 100 --quiet"},
      {"expand", "expand three.txt"},
      {"draw", "draw three.txt"},
      {"factorize", "factorize 6"},
      {"constructions", "constructions"},
      {"paper", "paper"},
      {"loadorder", "loadorder --items 6 --room 3"},
      {"catalog show", "catalog show 7 3"},
      {"catalog list", "catalog list --k 3 --v 7"},
      {"catalog history", "catalog history LABEL"},
      {"catalog cite", "catalog cite LABEL"},
      {"catalog completeness", "catalog completeness --k 3 --v 5..8"},
      {"catalog add", "catalog add three.txt"},
      {"catalog retract", "catalog retract LABEL --why x"},
      {"catalog alias", "catalog alias mine LABEL"},
      {"catalog export", "catalog export --users"},
      {"catalog import", "catalog import theirs.jsonl"},
      {"catalog verify", "catalog verify --users"},
      {"catalog diff", "catalog diff theirs.jsonl"},
      {"catalog improve", "catalog improve --time 200ms --quiet"},
      {"catalog submit", "catalog submit"},
      {"describe", "describe"}};

  std::string typed(std::string question) const {
    if (const std::size_t at = question.find("LABEL"); at != std::string::npos) {
      question.replace(at, std::string("LABEL").size(), label);
    }
    return "CHANGEOVER_CATALOG='" + folder.file("mine.db") + "' $changeover " + question;
  }

  TemporaryFolder folder;
  std::string label;  // of a design in that catalog
};

// The formats of each verb, as the program describes itself.
std::map<std::string, std::set<std::string>> described_formats() {
  std::map<std::string, std::set<std::string>> formats;
  const TemporaryFolder folder;
  const auto described = nlohmann::json::parse(run("$changeover describe", folder.path()).out);
  for (const auto& verb : described.at("verbs")) {
    for (const auto& option : verb.at("options")) {
      if (option.at("names").back() == "--format") {
        formats[verb.at("typed")] = option.at("words").get<std::set<std::string>>();
      }
    }
  }
  return formats;
}

TEST_F(Formats, AFileIsWhatItsNameSaysInEveryVerb) {
  const bool converts = run("rsvg-convert --version", folder.path()).code == 0;
  const auto formats = described_formats();
  ASSERT_GT(formats.size(), 20U);
  for (const auto& [verb, words] : formats) {
    ASSERT_TRUE(questions.contains(verb)) << verb << ": ask it something here";
    const std::string command = typed(questions.at(verb));
    bool refused = false;
    for (const auto& [ending, promise] : promises()) {
      const std::string name = "answer" + ending;
      const auto path = folder.path() / name;
      std::filesystem::remove(path);
      const bool can = std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return promise.formats.contains(word);
      });
      if (can ? !converts && (ending == ".pdf" || ending == ".png")
              : std::exchange(refused, true)) {
        continue;  // One ending that a verb does not write says how it refuses the others.
      }
      const Outcome outcome = run(command + " -o " + name, folder.path());
      if (!can) {
        EXPECT_EQ(outcome.code, 2) << verb << ending;
        EXPECT_THAT(outcome.err,
                    HasSubstr(name + ": unknown file extension '" + ending + "'; use ."))
            << verb;
        EXPECT_EQ(count(outcome.err, "\n"), 1U) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(path)) << verb << ending;
      } else if (std::filesystem::exists(path)) {
        EXPECT_TRUE(promise.kept(slurp(path))) << verb << ending << "\n"
                                               << slurp(path).substr(0, 300);
      } else {
        // Only where nothing is to be had, words go to standard output.
        EXPECT_EQ(outcome.code, 4) << command << " -o " << name << ": " << outcome.err;
        EXPECT_NE(outcome.out, "") << command;
        EXPECT_EQ(verb, "catalog submit");
      }
    }
  }
}

TEST_F(Formats, AnEndingThatSaysNothingNeedsAFormatAndNoEndingHasTheDefault) {
  for (const auto& [verb, words] : described_formats()) {
    const std::string command = typed(questions.at(verb));
    const Outcome refused = run(command + " -o answer.dat", folder.path());
    EXPECT_EQ(refused.code, 2) << verb;
    EXPECT_THAT(refused.err, HasSubstr("answer.dat: unknown file extension '.dat'; use .")) << verb;
    EXPECT_THAT(refused.err, HasSubstr("or add --format")) << verb;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "answer.dat")) << verb;
  }
  expect({{"$changeover bounds 7 3 --json -o a.dat && cat a.dat", 0, "{\"v\":7"},
          {"$changeover bounds 7 3 -o answer && cat answer", 0, "b >= 7"},
          {"$changeover bounds 7 3 -o tmp.Qc5EWmNB1x && cat tmp.Qc5EWmNB1x", 0, "b >= 7"},
          {"$changeover bounds 7 3 -o sheet.2026 && cat sheet.2026", 0, "b >= 7"},
          {"$changeover bounds 7 3 -o -", 0, "b >= 7"},
          {"$changeover bounds 7 3 -o A.JSON && cat A.JSON", 0, "{\"v\":7"}},
         folder);
}

TEST_F(Formats, AFormatThatContradictsTheEndingIsRefused) {
  const std::string plan = "$changeover plan --items 6 -k 3 --test-cost 1 --change-cost 1 ";
  expect(
      {{plan + "--format csv -o a.xlsx", 2,
        "a.xlsx: --format csv contradicts the file extension '.xlsx'; use .csv"},
       {plan + "--json -o a.csv", 2, "--json contradicts the file extension '.csv'; use .json"},
       {plan + "--format xlsx -o a.txt", 2, "contradicts the file extension '.txt'; use .xlsx"},
       {plan + "--what-if -o a.xlsx", 2, "--what-if has no meaning with a file named .xlsx"},
       {plan + "--compact -o a.csv", 2, "--compact has no meaning with a file named .csv"},
       {"$changeover design 7 3 --format tikz -o a.tex && cat a.tex", 0, "tikzpicture"},
       {"$changeover design 7 3 --format csv -o a.txt && cat a.txt", 0, "element_1"},
       {"$changeover loadorder --items 6 --room 3 --json -o a.json && cat a.json", 0,
        "{\"format\":\"changeover-loads/1\",\"items\":6"},
       {"$changeover loadorder --items 6 --room 3 -o b.json", 2,
        "unknown file extension '.json'; use .txt, .jsonl or .csv"},
       {"$changeover manual design -o a.json", 2, "unknown file extension '.json'; use .1, .man"},
       {"$changeover completion bash -o a.json", 2, "unknown file extension '.json'; use .bash"}},
      folder);
}

TEST_F(Formats, WhatASearchFoundIsNotLostNorInAFileOfAnotherFormat) {
  std::string blocks;
  for (int without = 0; without < 3; ++without) {
    for (int x = 0; x <= 1000; ++x) {
      blocks += x == without ? "" : std::to_string(x) + " ";
    }
    blocks += "\n";
  }
  spit(folder.file("large.txt"), blocks);
  const Outcome outcome =
      run("$changeover search --repair large.txt -m 1 -o a.svg --quiet", folder.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("a picture has at most 1000 points"));
  EXPECT_THAT(outcome.err, HasSubstr("; the design was written as text to a.svg.txt\n"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.svg"));
  EXPECT_EQ(run("$changeover verify a.svg.txt", folder.path()).code, 0);
  expect({{"$changeover search 1200 4 -o a.svg", 2, "a picture has at most 1000 points"}}, folder);
}

TEST_F(Formats, SeveralBenchesAreWrittenLikeOne) {
  const std::string plan =
      typed("plan --items 9 -k 3 --test-cost 1 --change-cost 5 --steps 100 --quiet");
  for (const std::string ending : {".txt", ".json", ".csv", ".md", ".html", ".xlsx"}) {
    const Outcome outcome = run(plan + " --benches 3 -o week" + ending, folder.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(promises().at(ending).kept(slurp(folder.path() / ("week" + ending)))) << ending;
  }
  EXPECT_EQ(run(plan + " --benches 3 --format xlsx", folder.path()).out,
            slurp(folder.path() / "week.xlsx"));
  for (const std::string bench : {"1", "2", "3"}) {
    const Outcome rest = run(plan + " --done 'week.xlsx:Bench " + bench + "'", folder.path());
    EXPECT_EQ(rest.code, 0) << rest.err;
    EXPECT_THAT(rest.out, HasSubstr("tests done"));
  }
  EXPECT_EQ(
      run("$changeover plan week.xlsx:Parts -k 3 --test-cost 1 --steps 100", folder.path()).code,
      0);
}

}  // namespace
}  // namespace changeover::test::formats_test
