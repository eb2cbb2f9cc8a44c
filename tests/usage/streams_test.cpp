// Streams that are closed, full or gone, and answers whose place went away: no result is lost for
// it.
#include <gtest/gtest.h>

#include <string>

#include "run_program.hpp"

namespace changeover::test::streams_test {
namespace {

constexpr const char* search = "$changeover search 41 6 --time 1s --threads 1 ";

// A search in the background that writes its answer to `place`. Once it is under way, its
// checkpoint is there; then `meanwhile` happens, and `signal` ends it.
std::string searching(const std::string& place, const std::string& meanwhile,
                      const std::string& signal) {
  return "$changeover search 41 6 --time 10m --threads 1 --quiet --format text --checkpoint state -o " +
         place + " & pid=$!; for i in $(seq 1200); do [[ -s state ]] && break; sleep 0.05; done; " +
         meanwhile + "kill -" + signal + " $pid; wait $pid; ";
}

bool is_valid(const TemporaryFolder& folder, const std::string& name) {
  return run("$changeover verify " + name, folder.path()).code == 0;
}

TEST(Streams, AProgressLineThatCannotBeWrittenIsNoReasonToLoseADesign) {
  const TemporaryFolder folder;
  for (const char* stream : {"2>/dev/full", "2>&-"}) {
    const int code =
        run(search + std::string("--format text -o x.txt ") + stream, folder.path()).code;
    EXPECT_TRUE(code == 10 || code == 30) << stream << " " << code;
    EXPECT_TRUE(is_valid(folder, "x.txt")) << stream;
    std::filesystem::remove(folder.file("x.txt"));
  }
  // A reader of stderr that left.
  run(search + std::string("--format text -o x.txt 2>&1 >/dev/null | true"), folder.path());
  EXPECT_TRUE(is_valid(folder, "x.txt"));
}

TEST(Streams, AFullStandardOutputIsSaidAndTheAnswerOfASearchIsKept) {
  const TemporaryFolder folder;
  const Outcome plain = run("$changeover design 8 5 >/dev/full", folder.path());
  EXPECT_EQ(plain.code, 4);
  EXPECT_NE(plain.err.find("<stdout>"), std::string::npos) << plain.err;
  const Outcome outcome =
      run(search + std::string("--quiet --format text >/dev/full"), folder.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.err.find("./changeover-answer"), std::string::npos) << outcome.err;
  EXPECT_TRUE(is_valid(folder, "changeover-answer"));
}

TEST(Streams, AClosedStandardOutputIsNotTakenForAFile) {
  const TemporaryFolder folder;
  const Outcome outcome = run("$changeover design 8 5 >&-", folder.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.err.find("<stdout>: cannot write"), std::string::npos) << outcome.err;
  const Outcome proofs =
      run("$changeover search 8 5 --blocks 4 --exact --proof proofs --threads 1 --quiet >&-",
          folder.path());
  EXPECT_EQ(proofs.code, 4);
  EXPECT_NE(proofs.err.find("<stdout>: cannot write"), std::string::npos) << proofs.err;
  EXPECT_EQ(run("$changeover verify - <&-", folder.path()).code, 4);
}

TEST(Streams, AFolderThatGoesAwayWhileASearchRunsCostsNothing) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("mkdir gone; " + searching("gone/mine.txt", "rmdir gone; ", "INT") + "exit $?",
          folder.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.err.find("gone/mine.txt: cannot write"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("./mine.txt"), std::string::npos) << outcome.err;
  EXPECT_TRUE(is_valid(folder, "mine.txt"));
}

TEST(Streams, AnAnswerElsewhereReplacesNothing) {
  const TemporaryFolder folder;
  spit(folder.file("mine.txt"), "precious\n");
  const Outcome outcome =
      run("mkdir gone; " + searching("gone/mine.txt", "rmdir gone; ", "INT") + "exit $?",
          folder.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(slurp(folder.file("mine.txt")), "precious\n");
  EXPECT_TRUE(is_valid(folder, "mine.txt.1"));
}

TEST(Streams, AReaderThatLeftWhereThatIsIgnoredDoesNotTakeTheAnswerAlong) {
  const TemporaryFolder folder;
  run("trap '' PIPE; " + std::string(search) + "--quiet --format text | true", folder.path());
  EXPECT_TRUE(is_valid(folder, "changeover-answer"));
}

TEST(Streams, WhereNothingCanBeWrittenTheLossIsSaid) {
  if (::getuid() == 0) {
    GTEST_SKIP() << "nothing is read-only to root";
  }
  const TemporaryFolder folder;
  const Outcome outcome =
      run("mkdir full; chmod 555 . full; " + std::string(search) +
              "--quiet --format text >/dev/full; code=$?; chmod 755 .; exit $code",
          folder.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.err.find("the answer is lost"), std::string::npos) << outcome.err;
}

TEST(Streams, ALimitOnTheSizeOfFilesIsNoCrash) {
  const TemporaryFolder folder;
  spit(folder.file("old.json"), "precious\n");
  const Outcome outcome =
      run("ulimit -f 8; $changeover design 253 13 --json -o old.json", folder.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.err.find("ulimit -f"), std::string::npos) << outcome.err;
  EXPECT_EQ(slurp(folder.file("old.json")), "precious\n");
  EXPECT_EQ(run("ls -A | wc -l", folder.path()).out, "1\n");
}

TEST(Streams, ATerminalThatGoesAwayEndsTheSearchWithItsAnswer) {
  const TemporaryFolder folder;
  const Outcome outcome = run(searching("x.txt", "", "HUP") + "echo $?", folder.path());
  EXPECT_TRUE(outcome.out == "30\n" || outcome.out == "10\n") << outcome.out;
  EXPECT_TRUE(is_valid(folder, "x.txt"));
}

TEST(Streams, WhatIsShownOfStrangeWordsCannotCommandATerminal) {
  const TemporaryFolder folder;
  for (const char* word : {"$'a\\e[2Jb'", "$'a\\rb'", "$'a\\x9bb'", "$'a\\xffb'", "$'a\\nb'"}) {
    const Outcome outcome = run(std::string("$changeover verify ") + word, folder.path());
    EXPECT_EQ(outcome.code, 4) << word;
    for (const char c : outcome.err.substr(0, outcome.err.size() - 1)) {
      EXPECT_TRUE(c >= ' ' && c < 127) << word << " " << outcome.err;
    }
  }
}

TEST(Streams, AWordOfAHundredThousandLettersIsNotRepeatedWhole) {
  const TemporaryFolder folder;
  const Outcome outcome = run("$changeover design 9 5 -f $(printf 'x%050000d' 7)", folder.path());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_LT(outcome.err.size(), 2000U);
}

TEST(Usage, GuessesWhatAMisspeltWordMeant) {
  const TemporaryFolder folder;
  EXPECT_NE(run("$changeover desing 10 4", folder.path()).err.find("did you mean design?"),
            std::string::npos);
  EXPECT_NE(run("$changeover design --foo", folder.path()).err.find("design has no option --foo"),
            std::string::npos);
  EXPECT_NE(
      run("$changeover design 9 5 --circlar", folder.path()).err.find("did you mean --circular?"),
      std::string::npos);
  // Values that look like options are none.
  EXPECT_EQ(run("$changeover design 8 5 -m2 --format=text -o -", folder.path()).code, 0);
}

TEST(Usage, DescribesEveryVerbAndOptionForPrograms) {
  const TemporaryFolder folder;
  const Outcome outcome = run("$changeover describe --format text", folder.path());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.out.find("design\targument\tV\tnumber\t\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("search\toption\t-m,--change\tnumber\t\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("search\toption\t--time\tduration\t\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("design\toption\t--circular\tflag\t\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("\twords\ttext|json\n"), std::string::npos);
  EXPECT_NE(run("$changeover describe", folder.path()).out.find("\"verbs\":[{\"name\":\"design\""),
            std::string::npos);
}

}  // namespace
}  // namespace changeover::test::streams_test
