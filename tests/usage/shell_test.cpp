// What a shell user meets besides answers: the version, manual pages, completion.
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "cases.hpp"
#include "shell/roff.hpp"

namespace changeover::test::shell_test {
namespace {

const std::string root = std::filesystem::path(CHANGEOVER_TEST_DATA).parent_path().parent_path();

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '\t');) {
    fields.push_back(field);
  }
  return fields;
}

bool is_there(const std::string& program, const TemporaryFolder& folder) {
  return run("command -v " + program, folder.path()).code == 0;
}

// ---- The version -----------------------------------------------------------

TEST(Version, SaysWhatItWasBuiltWithAfterTheLineThatScriptsRead) {
  const TemporaryFolder folder;
  const Outcome outcome = run("$changeover --version", folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 10U);
  EXPECT_TRUE(std::regex_match(lines.front(), std::regex("changeover [0-9]+\\.[0-9]+\\.[0-9]+")))
      << lines.front();
  for (const std::string library : {"bliss", "CaDiCaL", "expat", "fmt", "libmicrohttpd",
                                    "libxlsxwriter", "libzip", "SQLite", "zlib"}) {
    EXPECT_TRUE(std::regex_search(outcome.out, std::regex("[ s] " + library + " [0-9a-z]")))
        << library << "\n"
        << outcome.out;
  }
}

TEST(Version, CountsTheDesignsThatComeWithTheProgram) {
  const TemporaryFolder folder;
  const Outcome outcome = run("$changeover --version --json", folder.path());
  const Outcome labels =
      run("cat '" + root + "'/catalog/*/*.jsonl | grep -o '\"label\":\"[^\"]*\"' | sort -u | wc -l",
          folder.path());
  const std::string designs = labels.out.substr(0, labels.out.find('\n'));
  EXPECT_NE(outcome.out.find("\"designs\":" + designs + ","), std::string::npos) << designs << "\n"
                                                                                 << outcome.out;
}

TEST(Version, LooksForTheProgramThatWritesPdfAndPng) {
  const TemporaryFolder folder;
  const std::string with =
      "mkdir -p tools; printf '#!/bin/sh\\n' >tools/rsvg-convert; chmod +x tools/rsvg-convert; "
      "PATH=$PWD/tools $changeover --version --json";
  EXPECT_NE(run(with, folder.path()).out.find("tools/rsvg-convert\""), std::string::npos);
  const std::string no_program =
      "mkdir -p none; touch none/rsvg-convert; PATH=$PWD/none $changeover --version";
  EXPECT_NE(run(no_program + " --json", folder.path()).out.find("\"rsvg_convert\":null"),
            std::string::npos);
  EXPECT_NE(run(no_program, folder.path()).out.find("librsvg2-bin"), std::string::npos);
}

TEST(Version, DoesNotLookAtTheUsersCatalog) {
  const TemporaryFolder folder;
  spit(folder.file("mine.db"), "my diary");
  expect({{"CHANGEOVER_CATALOG=mine.db $changeover --version", 0, "catalog"},
          {"$changeover --version --jso", 2, "after --version there is nothing but --json"},
          {"$changeover --version --json more", 2, "after --version there is nothing but --json"}},
         folder);
}

// ---- Manual pages ----------------------------------------------------------

TEST(Roff, KeepsMinusSignsAndHyphensApart) {
  using cli::roff_text;
  EXPECT_EQ(roff_text("a 1-factorization"), "a 1-factorization");
  EXPECT_EQ(roff_text("with --base-blocks or -m"), "with \\-\\-base\\-blocks or \\-m");
  EXPECT_EQ(roff_text("- is standard input"), "\\- is standard input");
  EXPECT_EQ(cli::roff_literal("a-b"), "a\\-b");
}

TEST(Roff, LetsNoTextBeTakenForAMacroOrAnEscape) {
  using cli::roff_text;
  EXPECT_EQ(roff_text(".SH is no heading"), "\\&.SH is no heading");
  EXPECT_EQ(roff_text("'quoted'"), "\\(aqquoted\\(aq");
  EXPECT_EQ(roff_text("a\\b"), "a\\eb");
  EXPECT_EQ(roff_text("~/x ^ ` \""), "\\(ti/x \\(ha \\(ga \\(dq");
  EXPECT_EQ(roff_text("b ≥ 3, ∞"), "b \\[u2265] 3, \\[u221E]");
  EXPECT_EQ(roff_text("𝔽"), "\\[u1D53D]");
}

// All pages, in the folder "man".
std::map<std::string, std::string> written_pages(const TemporaryFolder& folder) {
  EXPECT_EQ(run("$changeover manual --into man", folder.path()).code, 0);
  std::map<std::string, std::string> pages;
  for (const auto& each : std::filesystem::directory_iterator(folder.path() / "man")) {
    pages[each.path().filename().string()] = slurp(each.path());
  }
  return pages;
}

TEST(Manual, HasAPageForEachVerbWithEachOptionOfIt) {
  const TemporaryFolder folder;
  const auto pages = written_pages(folder);
  std::set<std::string> verbs;
  std::size_t options = 0;
  for (const std::string& line :
       lines_of(run("$changeover describe --format text", folder.path()).out)) {
    const std::vector<std::string> fields = fields_of(line);
    ASSERT_GE(fields.size(), 4U) << line;
    verbs.insert(fields[0]);
    const auto page = pages.find("changeover-" + fields[0] + ".1");
    ASSERT_NE(page, pages.end()) << fields[0];
    std::istringstream names(fields[2]);
    for (std::string name; std::getline(names, name, ',');) {
      const std::string shown =
          fields[1] == "option" ? cli::roff_bold(name) : cli::roff_italic(name);
      EXPECT_NE(page->second.find(shown), std::string::npos) << line;
      ++options;
    }
  }
  EXPECT_GT(options, 300U);
  EXPECT_TRUE(pages.contains("changeover-catalog.1"));
  EXPECT_TRUE(pages.contains("changeover.1"));
  EXPECT_LE(verbs.size() + 2, pages.size());
  for (const auto& [name, text] : pages) {
    for (const char* heading :
         {"NAME", "SYNOPSIS", "DESCRIPTION", "EXIT STATUS", "ENVIRONMENT", "FILES", "SEE ALSO"}) {
      EXPECT_NE(text.find(std::string("\n.SH ") + heading + "\n"), std::string::npos)
          << name << " " << heading;
    }
  }
}

TEST(Manual, HasNoLineThatOnlyLooksLikeAMacro) {
  const TemporaryFolder folder;
  const std::regex macro("\\.(\\\\\".*|TH .*|S[HS] .*|TP|PP|B .*|BR .*|BI .*|I .*|IR .*|nf|fi|br)");
  for (const auto& [name, text] : written_pages(folder)) {
    for (const std::string& line : lines_of(text)) {
      EXPECT_FALSE(line.starts_with('\'')) << name << ": " << line;
      EXPECT_TRUE(!line.starts_with('.') || std::regex_match(line, macro)) << name << ": " << line;
    }
  }
}

TEST(Manual, PassesTheLintOfMandocAndReadsAsMeant) {
  const TemporaryFolder folder;
  if (!is_there("mandoc", folder)) {
    GTEST_SKIP() << "mandoc is missing here";
  }
  ASSERT_FALSE(written_pages(folder).empty());
  const Outcome lint =
      run("mandoc -T lint -W warning man/*.1 '" + root + "/apps/checkdesign/checkdesign.1'",
          folder.path());
  EXPECT_EQ(lint.code, 0) << lint.out;
  EXPECT_EQ(lint.out + lint.err, "");
  const std::string page =
      run("mandoc -T ascii -O width=200 man/changeover-search.1 | col -b", folder.path()).out;
  for (const char* shown :
       {"-m, --change M", "(default: half of the machine's)", "--base-blocks",
        "One of table, text, json", "changeover search 8 5 --blocks 9 --exact --proof proofs",
        "--tight, --cycle and --fixed-points", "~/.local/share/changeover/catalog.db"}) {
    EXPECT_NE(page.find(shown), std::string::npos) << shown << "\n" << page;
  }
}

TEST(Manual, OfTheCheckerHasEachOptionOfItsHelp) {
  const TemporaryFolder folder;
  const std::string page = slurp(root + "/apps/checkdesign/checkdesign.1");
  const std::string help = run("$checkdesign --help", folder.path()).out;
  const std::regex option("(^|[ [])(-[a-z]|--[a-z]+)");
  std::set<std::string> names;
  for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at) {
    names.insert((*at)[2]);
  }
  EXPECT_EQ(names.size(), 9U);
  for (const std::string& name : names) {
    EXPECT_NE(page.find(cli::roff_literal(name)), std::string::npos) << name;
  }
}

TEST(Manual, SaysWhichPageThereIsNot) {
  const TemporaryFolder folder;
  spit(folder.file("file"), "");
  expect({{"$changeover manual", 0, ".TH CHANGEOVER 1"},
          {"$changeover manual design", 0, "changeover\\-design \\- "},
          {"$changeover manual catalog show", 0, ".TH CHANGEOVER\\-CATALOG\\-SHOW 1"},
          {"$changeover manual catalog", 0, ".TH CHANGEOVER\\-CATALOG 1"},
          {"$changeover manual catalog history", 0, "\nv.k.m.kind, as 20.5.2.linear"},
          {"$changeover manual design", 0, "\nUse this construction only."},
          {"$changeover manual same", 0, ".B 1\nNot the same.\n"},
          {"$changeover same --help", 0, "Exit codes: 0 the same; 1 not the same"},
          {"$changeover manual design --into man", 2, "exclude each other"}},
         folder);
}

// ---- Completion ------------------------------------------------------------

struct Offer {
  std::string words;
  std::vector<std::string> offered;
};

// What each shell is to offer, in order of the alphabet.
const std::vector<Offer>& offers() {
  static const std::vector<Offer> all{
      {"changeover de", {"describe", "design"}},
      {"changeover catalog s", {"show", "submit"}},
      {"changeover completion ", {"bash", "fish", "zsh"}},
      {"changeover design 7 3 --format l", {"latex", "ljcr"}},
      {"changeover design 7 3 -f l", {"latex", "ljcr"}},
      {"changeover verify --st", {"--strength"}},
      {"changeover verify go", {"good.txt"}},
      {"changeover catalog add go", {"good.txt"}},
      {"changeover search --order go", {"good.txt"}},
      {"changeover search --proof go", {"goods"}},
      {"changeover design 7 3 --change go", {}},
      {"changeover catalog show go", {}},
      {"changeover design 7 3 go", {}},
      {"changeover catalog add --who go", {}},
      {"changeover --version --", {"--json"}},
  };
  return all;
}

void prepare(const TemporaryFolder& folder) {
  spit(folder.file("good.txt"), "");
  std::filesystem::create_directory(folder.path() / "goods");
  EXPECT_EQ(
      run("for shell in bash zsh fish; do $changeover completion $shell -o script.$shell; done",
          folder.path())
          .code,
      0);
}

// Folders are where files are, too.
void expect_offered(const Offer& offer, std::vector<std::string> offered) {
  const bool of_files = std::ranges::find(offer.offered, "good.txt") != offer.offered.end();
  for (std::string& each : offered) {
    each = each.ends_with('/') ? each.substr(0, each.size() - 1) : each;
  }
  std::erase_if(offered, [&](const std::string& each) { return of_files && each == "goods"; });
  std::ranges::sort(offered);
  offered.erase(std::unique(offered.begin(), offered.end()), offered.end());
  EXPECT_EQ(offered, offer.offered) << offer.words;
}

TEST(Manual, APageHasTheExitCodesOfItsVerbOnly) {
  const TemporaryFolder folder;
  const auto codes = [&folder](const std::string& verb) {
    const std::string page = run("$changeover manual " + verb, folder.path()).out;
    const std::size_t begin = page.find(".SH EXIT STATUS");
    const std::string part = page.substr(begin, page.find(".SH", begin + 1) - begin);
    std::vector<std::string> found;
    for (std::size_t at = part.find("\n.B "); at != std::string::npos;
         at = part.find("\n.B ", at + 1)) {
      found.push_back(part.substr(at + 4, part.find('\n', at + 4) - at - 4));
    }
    return found;
  };
  EXPECT_EQ(codes("bounds"), (std::vector<std::string>{"0", "2", "3", "4", "5"}));
  EXPECT_EQ(codes("search"), (std::vector<std::string>{"2", "3", "4", "5", "10", "20", "30"}));
  EXPECT_EQ(codes("catalog verify"),
            (std::vector<std::string>{"0", "1", "2", "3", "4", "5", "30"}));
  EXPECT_EQ(codes("catalog"), codes(""));  // all of them: a page on several verbs
  EXPECT_EQ(codes("catalog").size(), 9U);
}

TEST(Completion, OfBashOffersWhatFits) {
  const TemporaryFolder folder;
  prepare(folder);
  EXPECT_EQ(run("bash -n script.bash", folder.path()).err, "");
  for (const Offer& offer : offers()) {
    const Outcome outcome = run(
        "source script.bash; COMP_WORDS=(" + offer.words +
            (offer.words.ends_with(' ') ? "''" : "") +
            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _changeover; printf '%s\\n' \"${COMPREPLY[@]}\"",
        folder.path());
    std::vector<std::string> offered = lines_of(outcome.out);
    std::erase(offered, "");
    EXPECT_EQ(outcome.err, "");
    expect_offered(offer, offered);
  }
}

TEST(Completion, OfBashReadsAnEqualsSignAndBlanksInNames) {
  const TemporaryFolder folder;
  prepare(folder);
  spit(folder.file("two words.txt"), "");
  const Outcome outcome = run(
      "source script.bash; COMP_WORDS=(changeover design 7 3 --format = l); COMP_CWORD=6; _changeover; "
      "echo ${COMPREPLY[@]}; COMP_WORDS=(changeover design 7 3 --format =); COMP_CWORD=5; _changeover; "
      "echo ${#COMPREPLY[@]}; COMP_WORDS=(changeover verify two); COMP_CWORD=2; _changeover; "
      "printf '%s\\n' \"${COMPREPLY[@]}\"",
      folder.path());
  EXPECT_EQ(outcome.out, "latex ljcr\n11\ntwo words.txt\n") << outcome.err;
}

TEST(Completion, OfFishOffersWhatFitsWithWordsForIt) {
  const TemporaryFolder folder;
  if (!is_there("fish", folder)) {
    GTEST_SKIP() << "fish is missing here";
  }
  prepare(folder);
  const std::string fish =
      "HOME=$PWD XDG_CONFIG_HOME=$PWD/x XDG_DATA_HOME=$PWD/x fish --no-config ";
  EXPECT_EQ(run(fish + "--no-execute script.fish", folder.path()).err, "");
  for (const Offer& offer : offers()) {
    const Outcome outcome =
        run(fish + "-c \"source script.fish; complete -C '" + offer.words + "'\"", folder.path());
    EXPECT_EQ(outcome.err, "");
    std::vector<std::string> offered;
    for (const std::string& line : lines_of(outcome.out)) {
      offered.push_back(line.substr(0, line.find('\t')));
    }
    expect_offered(offer, offered);
  }
  EXPECT_NE(
      run(fish + "-c \"source script.fish; complete -C 'changeover search --me'\"", folder.path())
          .out.find("half of the machine's"),
      std::string::npos);
}

// One offer in `every`: each starts a zsh with all of its completion.
void expect_offers_of_zsh(std::size_t every) {
  const TemporaryFolder folder;
  if (!is_there("zsh", folder)) {
    GTEST_SKIP() << "zsh is missing here";
  }
  prepare(folder);
  EXPECT_EQ(run("zsh -n script.zsh", folder.path()).err, "");
  const std::string capture = "HOME=$PWD TMPPREFIX=$PWD/said timeout 60 zsh -f '" +
                              std::string(CHANGEOVER_TEST_DATA) + "/shell/capture.zsh' ";
  for (std::size_t i = 0; i < offers().size(); i += every) {
    const Offer& offer = offers()[i];
    const Outcome outcome = run(capture + "$PWD/script.zsh '" + offer.words + "'", folder.path());
    if (outcome.code == 77) {
      GTEST_SKIP() << "zsh gets no pseudo-terminal here";
    }
    std::vector<std::string> offered;
    for (const std::string& line : lines_of(outcome.out)) {
      offered.push_back(line.substr(0, line.find('|')));
    }
    expect_offered(offer, offered);
    for (const auto& [words, said] : std::map<std::string, std::string>{
             {"changeover de", "-- build the best known design, and verify it"},
             {"changeover verify --st", "-- every T elements must meet (2, 3 or 4)"}}) {
      EXPECT_TRUE(offer.words != words || outcome.out.find(said) != std::string::npos)
          << outcome.out;
    }
  }
}

TEST(Completion, OfZshOffersWhatFitsWithWordsForIt) { expect_offers_of_zsh(5); }
TEST(SlowCompletion, OfZshOffersWhatFitsWithWordsForIt) { expect_offers_of_zsh(1); }

}  // namespace
}  // namespace changeover::test::shell_test
