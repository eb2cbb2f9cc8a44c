// changeover search at its limits: stopped, without room for its checkpoint, asked for what cannot
// be.
#include <chrono>

#include "cases.hpp"

namespace changeover::test::search_limits_test {
namespace {

TEST(SearchLimits, CtrlCEndsTheSearchForAFirstDesign) {
  const TemporaryFolder folder;
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome =
      run("$changeover search 240 6 -t 4 --time 10m --quiet >answer & pid=$!; "
          "until (($(cut -d ' ' -f 14 /proc/$pid/stat) >= 10)); do sleep 0.02; done; "
          "kill -INT $pid; wait $pid; code=$?; cat answer; exit $code",
          folder.path());
  EXPECT_EQ(outcome.code, 30) << outcome.err;
  EXPECT_EQ(count(outcome.out, "\n"), 1U) << outcome.out;
  EXPECT_NE(outcome.out.find("stopped (interrupted)"), std::string::npos) << outcome.out;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST(SearchLimits, CtrlCEndsAnAnswerThatItsReaderDoesNotRead) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("mkfifo pipe; exec 3<>pipe; $changeover search 300 4 --time 100ms --quiet -f text >pipe "
          "3<&- & pid=$!; until now=$(cut -d ' ' -f 14 /proc/$pid/stat); ((now > 0)) && "
          "[[ $now == \"$before\" ]]; do before=$now; sleep 1; done; "
          "kill -INT $pid; for i in {1..100}; do kill -0 $pid || break; sleep 0.1; done; "
          "kill -KILL $pid; wait $pid; exit $?",
          folder.path());
  EXPECT_EQ(outcome.code, 130) << outcome.err;
}

TEST(SearchLimits, WhatIsTooLargeToSearchIsShownAsItIsKnown) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover search 4200 600 --time 10s --quiet -f text -o known.txt; code=$?; "
          "$changeover verify known.txt >/dev/null && exit $code",
          folder.path());
  EXPECT_EQ(outcome.code, 30) << outcome.err;
  EXPECT_NE(outcome.err.find("no search was made"), std::string::npos) << outcome.err;
  EXPECT_EQ(count(outcome.err, "\n"), 1U);
}

TEST(SearchLimits, TheAnswerDoesNotReplaceTheCheckpoint) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      run("$changeover search 30 5 --time 200ms --checkpoint state --quiet >/dev/null; "
          "cp state before; ln -s state link; ln state hard; ln -s fresh dangling; [ -s state ]",
          folder.path())
          .code,
      0);
  for (const std::string files :
       {"--checkpoint state -o state", "--checkpoint state -o ./state",
        "--checkpoint state -o link", "--checkpoint link -o state", "--checkpoint state -o hard",
        "--checkpoint state -o state.lock", "--checkpoint fresh -o ./fresh",
        "--checkpoint dangling -o fresh"}) {
    const Outcome outcome = run("$changeover search 30 5 --time 200ms --quiet " + files +
                                    "; code=$?; cmp state before && "
                                    "exit $code",
                                folder.path());
    EXPECT_EQ(outcome.code, 2) << files << outcome.err;
    EXPECT_EQ(count(outcome.err, "\n"), 1U) << files << outcome.err;
  }
}

TEST(SearchLimits, ASecondSearchWithTheSameCheckpointIsRefused) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover search 40 6 --time 10m --threads 1 --checkpoint state --quiet >/dev/null & "
          "pid=$!; for i in $(seq 1200); do [[ -s state ]] && break; sleep 0.05; done; "
          "$changeover search 40 6 --time 1s --checkpoint state --quiet; code=$?; "
          "kill -9 $pid; wait $pid 2>/dev/null; [[ -e state.lock ]] || exit 99; "
          "$changeover search 40 6 --time 200ms --threads 1 --checkpoint state --quiet -o o.txt "
          ">/dev/null; [[ $? == 30 || $? == 10 ]] || exit 98; [[ -e state.lock ]] && exit 97; exit "
          "$code",
          folder.path());
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_EQ(count(outcome.err, "\n"), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("another process"), std::string::npos) << outcome.err;
}

TEST(SearchLimits, AFolderOfTheCheckpointThatGoesAwayDoesNotTakeTheDesignAlong) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("mkdir inner; $changeover search 40 6 --time 10m --threads 1 --checkpoint inner/state "
          "--quiet -f text -o found.txt & pid=$!; "
          "for i in $(seq 1200); do [[ -s inner/state ]] && break; sleep 0.05; done; "
          // At once: nothing can be written to it while its files are removed one after another.
          "mv inner gone; rm -r gone; kill -INT $pid; wait $pid; code=$?; "
          "$changeover verify found.txt >/dev/null && exit $code",
          folder.path());
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_EQ(count(outcome.err, "\n"), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("inner/state"), std::string::npos) << outcome.err;
}

TEST(SearchLimits, EachOfSeveralProcessesHasItsCheckpoint) {
#ifdef __SANITIZE_THREAD__  // Four processes need so long to begin.
  const std::string time = " --time 40s";
#else
  const std::string time = " --time 2s";
#endif
  const TemporaryFolder folder;
  if (!have_mpirun(folder)) {
    GTEST_SKIP() << "mpirun is not installed, or starts nothing here";
  }
  const std::string search =
      mpirun + "-n 4 $changeover search 40 6 --checkpoint state --quiet -f text -o found.txt" +
      time + "; ";
  const Outcome outcome = run(search + "code=$?; ls; ls | grep -c lock; exit $code", folder.path());
  EXPECT_TRUE(outcome.code == 30 || outcome.code == 10) << outcome.err;
  for (const std::string name : {"state", "state.1", "state.2", "state.3"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name << outcome.out;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "state.3.lock"));
  const Outcome again = run(search, folder.path());
  EXPECT_TRUE(again.code == 30 || again.code == 10) << again.err;
  EXPECT_EQ(
      run(mpirun + "-n 4 $changeover search 40 6 --checkpoint state -o state.2 --quiet" + time +
              "; "
              "head -c 22 state.2 | grep -q changeover-checkpoint",
          folder.path())
          .code,
      0);
}

// Words never replace a file of designs; the JSON document goes where it was to go, whatever it
// says.
TEST(SearchLimits, ThatThereIsNoDesignIsAnAnswerInEveryForm) {
  const TemporaryFolder folder;
  spit(folder.path() / "list.txt", "0 1 2\n3 4 5\n0 3 1\n");
  spit(folder.path() / "six.txt", "0 1 2 3 4 5\n0 1 2 3 6 7\n");
  for (const auto& [command, code, says] : std::vector<Case>{
           {"search 4 2 --quiet", 20, "{\"found\":false,"},
           {"search 8 5 --blocks 3 --quiet", 20, "{\"found\":false,"},
           {"search 4 2 --base-blocks --quiet", 20, "{\"found\":false,"},
           {"search 9 4 --base-blocks --cycle 7 --quiet", 30, "{\"found\":false,"},
           {"search --order list.txt -m 1 --quiet", 20, "{\"found\":false,"},
           {"search 240 6 -t 4 --time 0 --quiet", 30, "{\"found\":false,"},
           {"search 240 6 -t 4 -m 2 --repair six.txt --time 0 --quiet", 30, "{\"found\":false,"},
           {"search 240 6 -t 4 -m 2 --extend six.txt --time 0 --quiet", 30, "{\"found\":false,"},
           {"search 4 2 --exact --quiet", 20, "\"impossible\":"},
           {"search 8 5 --blocks 3 --exact --quiet", 20, "\"upper_bound\":null"},
           {"search 60 5 --exact --time 0 --quiet", 30, "\"upper_bound\":null"},
           {"design 4 2", 4, "{\"served\":false,"},
           {"design 200 5 --change 5", 4, "{\"served\":false,"},
           {"explain 9 4 --construction doubling", 4, "{\"served\":false,"}}) {
    expect({{"$changeover " + command + " -o a.txt; code=$?; [[ -e a.txt ]] && exit 99; exit $code",
             code, " "},
            {"rm -f a.json; $changeover " + command +
                 " --json -o a.json >out; code=$?; "
                 "[[ -s out ]] && exit 99; cat a.json; exit $code",
             code, says}},
           folder);
  }
}

TEST(SearchLimits, AnyNumberIsTakenOrRefused) {
  const TemporaryFolder folder;
  for (const std::string number :
       {"0", "1", "2147483648", "4294967296", "9223372036854775807", "9223372036854775809",
        "18446744073709551614", "18446744073709551615"}) {
    for (const std::string option :
         {"--base-blocks --fixed-points ", "--base-blocks --cycle ", "--base-blocks --blocks ",
          "--threads ", "--seed ", "--strength ", "--change ", "--blocks "}) {
      const Outcome outcome =
          run("timeout 20 $changeover search 8 4 --time 100ms --quiet -f text " + option + number,
              folder.path());
      const bool documented = outcome.code == 2 || outcome.code == 4 || outcome.code == 10 ||
                              outcome.code == 20 || outcome.code == 30;
      EXPECT_TRUE(documented) << option << number << ": " << outcome.code << outcome.err;
      EXPECT_LE(count(outcome.err, "\n"), 1U) << option << number << outcome.err;
    }
  }
}

}  // namespace
}  // namespace changeover::test::search_limits_test
