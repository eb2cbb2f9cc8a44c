// Exit codes and the one clear line, as a table: what is documented is what happens.
#include "cases.hpp"

namespace changeover::test::exit_codes_test {
namespace {

void prepare(const TemporaryFolder& folder) {
  spit(folder.file("good.txt"),
       "# changeover design v=6 k=4 change=2 kind=circular\n0 1 2 3\n4 5 2 3\n4 5 0 1\n");
  spit(folder.file("labelled.txt"), "∞_s 0_l a b\nc d a b\nc d ∞_s 0_l\n");
  spit(folder.file("broken-link.txt"),
       "# changeover design v=6 k=3 kind=circular\n0 1 2\n0 3 4\n3 1 5\n1 2 4\n");
  spit(folder.file("missing-pair.txt"),
       "# changeover design v=6 k=4 change=2 kind=linear\n0 1 2 3\n4 5 2 3\n");
  spit(folder.file("fano.txt"), "0 1 3\n1 2 4\n2 3 5\n3 4 6\n4 5 0\n5 6 1\n6 0 2\n");
  spit(folder.file("empty.txt"), "");
  spit(folder.file("comments.txt"), "# nothing here\n\n");
  spit(folder.file("ragged.txt"), "0 1 2 3\n4 5 2\n");
  spit(folder.file("repeated.txt"), "0 1 2 3\n4 5 4 3\n");
  spit(folder.file("too-large.txt"), "# changeover design v=6 k=4\n0 1 2 3\n4 6 2 3\n");
  spit(folder.file("huge.txt"), "0 1 2 3\n4 99999999999999999999999999 2 3\n");
  spit(folder.file("junk.bin"), std::string("\x7f"
                                            "ELF\x01\x00\x02\xff\xfe\x00\x00",
                                            11));
  spit(folder.file("bad.json"),
       "{\"format\":\"changeover-design/1\",\"v\":6,\n\"blocks\":[[0,1,2,3],[4,5,2]]}");
  spit(folder.file("cut.json"), "{\"v\":6,\"k\":4,\"blocks\":[[0,1,2,3],");
  spit(folder.file("declared.txt"), "# changeover design v=70000 k=4\n0 1 2 3\n");
  spit(folder.file("k-over-v.txt"), "# changeover design v=3 k=4\n0 1 2 3\n");
  spit(folder.file("old.json"), "precious\n");
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      // 0: done, or valid
      {"$changeover --help", 0, "Exit codes"},
      {"$changeover --version", 0, "changeover 1."},
      {"$changeover design --help", 0, "Examples"},
      {"$changeover design 61 4 --circular", 0, "366 blocks"},
      {"$changeover design 61 4 --json", 0, "\"minimum\":\"proved\""},
      {"$changeover design 8 5 --leaving", 0, "∞_s"},
      {"$changeover design 9 5 --change 1", 0, "SCCD(9,5)"},
      {"$changeover design 7 3 --format csv", 0, "block,element_1"},
      {"$changeover design 7 3 --format latex", 0, "\\begin{tabular}"},
      {"$changeover design 105 9 --json | $changeover verify -", 0, "valid"},
      {"$changeover design 105 9 --format text | $checkdesign -", 0, "valid"},
      {"$changeover verify good.txt", 0, "tight"},
      {"$changeover verify labelled.txt --circular", 0, "tight"},
      {"$changeover verify good.txt --json", 0, "\"valid\":true"},
      {"$changeover bounds 20 5", 0, "b >="},
      {"$changeover bounds 4 2", 0, "impossible"},
      {"$changeover bounds 26 6 --change 1 --linear", 0,
       "  63 reported [Bean2026], blocks not held here\n"},
      {"$changeover bounds 26 6 --change 1 --linear --json", 0,
       "\"reported\":{\"blocks\":63,\"cites\":\"Bean2026\"}"},
      {"$changeover bounds 20 5 --linear --json", 0, "\"reported\":null"},
      {"$changeover explain 253 13", 0, "Theorem"},
      {"$changeover expand good.txt", 0, "DCCD(10,4)"},
      {"$changeover expand good.txt --count", 0, "1 expansion set"},
      {"$changeover design 15 5 --json | $changeover expand - --new-elements 4", 0,
       "25 blocks: economical"},
      {"$changeover design 13 4 --json | $changeover expand - -w 0", 0, "new element"},
      {"$changeover design 7 3 --circular --construction printed --json | $changeover expand -", 0,
       "by 1 new element"},
      {"$changeover explain 100 12", 0, "from"},
      {"$changeover explain 4096 5", 0, "DCCD(4096,5)"},
      {"$changeover explain 8000 4", 0, "not verified here"},
      {"$changeover explain 65546 6 -m 1 --circular", 0, "more than 65535 elements only"},
      {"$changeover explain 8000 4 --json", 0, "\"verdict\":null"},
      {"$changeover factorize 8", 0, "F_7: "},
      {"$changeover table --k 3..5 --v 5..12", 0, "mean of b / lower bound"},
      {"$changeover table --k 3 --v ..9 --linear --json", 0, "\"status\":\"minimum\""},
      {"$changeover table --k 3 --v 9 --change 18446744073709551614 --json", 0, "\"impossible\""},
      {"$changeover table --k 4 --v 12 --anew --json", 0, "\"status\":\"minimum\""},
      {"$changeover constructions", 0, "cyclic-paper"},
      {"$changeover paper", 0, "5 refuted, 1 vacuous, 4 not checkable"},
      {"$changeover paper --json", 0, "\"format\":\"changeover-paper/3\""},
      {"$changeover completion bash", 0, "complete -F"},
      // 1: the claim was refuted
      {"$changeover verify broken-link.txt", 1, "the circle closes"},
      {"$changeover verify missing-pair.txt", 1, "in no block"},
      {"$changeover verify huge.txt", 1, "{0,99999999999999999999999999}"},  // a label
      {"$changeover verify good.txt --change 1", 1, "INVALID"},
      {"$checkdesign broken-link.txt", 1, "invalid"},
      // 2: usage
      {"$changeover", 2, "VERB"},
      {"$changeover ''", 2, "there is no verb ''"},
      {"$changeover design 8 5 -o ''", 2, "it is empty"},
      {"$changeover same good.txt good.txt -o good.txt", 2, "is the same file as A"},
      {"$changeover expand good.txt -o good.txt", 2, "is the same file as the design"},
      {"$changeover minima --data - --time 1s", 2, "--data -: rows are read and written"},
      {"$changeover design -5 4", 2, "V: '-5' is below 0; give a whole number, 0 or more"},
      {"$changeover design 61 4 --change 5", 2, "change = 5"},
      {"$changeover verify good.txt --strength 9", 2, "--strength 9 is out of range"},
      {"$changeover table --v x", 2, "whole numbers"},
      {"$changeover completion csh", 2, "'csh' is not one of bash|zsh|fish"},
      // 2: options that mean nothing where they stand
      {"$changeover verify good.txt --circular --linear", 2, "--circular and --linear exclude"},
      {"$changeover same good.txt good.txt --circular --linear", 2,
       "--circular and --linear exclude"},
      {"$changeover table --circular --linear", 2, "--circular and --linear exclude"},
      {"$changeover search 9 4 --circular --linear", 2, "--circular and --linear exclude"},
      {"$changeover search 20 5 --json --format csv", 2, "--json and --format csv exclude"},
      {"$changeover design 9 4 --leaving --format csv", 2,
       "--leaving has no meaning with --format csv"},
      {"$changeover search 9 4 --leaving --json", 2, "--leaving has no meaning with --format json"},
      {"$changeover explain 9 4 --construction nonsense", 2, "no construction is called"},
      {"$changeover plan - -k 3 --test-cost 1 --never -", 2,
       "cannot both come from standard input"},
      {"$changeover search 9 4 --exact --tight", 2, "--tight is for --base-blocks"},
      {"$changeover search --order fano.txt --tight", 2, "--tight is for --base-blocks"},
      {"$changeover search 9 4 --fixed-points 0", 2, "--fixed-points F is for --base-blocks"},
      {"$changeover search 9 4 --base-blocks --proof p", 2, "--proof DIR is for --exact"},
      {"$changeover search 9 4 --base-blocks --checkpoint s", 2,
       "--checkpoint FILE has no meaning"},
      {"$changeover search --order fano.txt --checkpoint s", 2, "--checkpoint FILE has no meaning"},
      {"$changeover search --repair fano.txt --checkpoint s", 2,
       "--checkpoint FILE has no meaning"},
      {"$changeover search --extend fano.txt --checkpoint s", 2,
       "--checkpoint FILE has no meaning"},
      {"$changeover search 9 4 --exact --seed 3", 2, "--seed N has no meaning with --exact"},
      {"$changeover search --order fano.txt --blocks 3", 2,
       "--blocks B has no meaning with --order"},
      {"$changeover search --repair fano.txt -b 3", 2, "--blocks B has no meaning with --repair;"},
      {"$changeover search --order fano.txt -t 3", 2, "--strength T has no meaning with --order"},
      {"$changeover search --order fano.txt --format svg", 2, "--order without --change has no"},
      {"$changeover search --repair fano.txt --strength 4294967298", 2, "is out of range"},
      {"$changeover expand good.txt --list 2 --set 1", 2, "--set N has no meaning with --list"},
      {"$changeover expand good.txt --count -w 1", 2, "--new-elements W has no meaning with"},
      {"$changeover expand good.txt --partial --factorization circle", 2,
       "--factorization circle|doubled has no meaning with"},
      {"$changeover expand good.txt --set 1 -w 1", 2,
       "--set and --new-elements exclude each other"},
      {"$changeover expand good.txt --list 2 --format csv", 2, "has no meaning with --format csv"},
      {"$changeover minima --threads 2", 2, "minima has no option --threads"},
      // 3: bad input
      {"$changeover verify empty.txt", 3, "empty.txt:1:1"},
      {"$changeover verify comments.txt", 3, "comments.txt:3:1: no blocks"},
      {"$changeover verify ragged.txt", 3, "ragged.txt:2"},
      {"$changeover verify repeated.txt", 3, "repeated.txt:2:5"},
      {"$changeover verify too-large.txt", 3, "too-large.txt:3:3"},
      {"$changeover verify junk.bin", 3, "junk.bin:1"},
      {"$changeover verify bad.json", 3, "bad.json:2"},
      {"$changeover verify cut.json", 3, "cut.json:1"},
      {"$changeover verify declared.txt", 3, "65535"},
      {"$changeover verify k-over-v.txt", 3, "k-over-v.txt"},
      {"$changeover design 61 4 | $changeover verify -", 3, "--format text"},
      {"head -c 100000000 /dev/zero | tr '\\0' 7 | $changeover verify -", 3, ":1:1"},
      {"$changeover expand missing-pair.txt", 3, "not a valid"},
      {"$checkdesign ragged.txt", 3, "ragged.txt:2"},
      // 4: nothing serves, or something is missing
      {"$changeover design 200 5 --change 5", 4, "No construction"},
      {"$changeover design 4 2", 4, "No circular DCCD(4,2) exists"},
      {"$changeover explain 4 2", 4, "No circular DCCD(4,2) exists"},
      {"$changeover explain 4 2 --json", 4, "\"served\":false"},
      {"$changeover design 20 5 --construction cyclic", 4, "cyclic does not serve"},
      {"$changeover design 61 4 --construction doubling", 4, "doubling"},
      {"$changeover verify nowhere.txt", 4, "nowhere.txt"},
      {"$changeover verify .", 4, "directory"},
      {"$changeover design 61 4 -o nowhere/out.txt", 4, "nowhere"},
      {"$changeover design 61 4 >/dev/full", 4, "No space left"},
      {"$changeover --help >/dev/full", 4, "No space left"},
      {"$changeover design 20 3 --change 3 --json | $changeover expand -", 4,
       "no new elements can"},
      // the verbs that search
      {"$changeover search --order fano.txt --quiet", 10, "15 elements introduced"},
      {"$changeover search 9 5 --linear --exact --quiet", 10, "The minimum is 6 blocks"},
      {"$changeover search 8 4 -m 1 --quiet", 10, "minimum"},
      {"$changeover search 16 4 --base-blocks --tight --quiet", 10, "tight"},
      {"$changeover search --order fano.txt -m 2 --circular --quiet", 10, "tight"},
      {"$changeover search 4 2 --quiet", 20, "No linear DCCD(4,2) exists"},
      {"$changeover search 4 2 --json --quiet", 20, "\"found\":false"},
      {"$changeover search 8 5 --blocks 3 --quiet", 20, "with 3 blocks"},
      {"$changeover search 9 5 --linear --exact --blocks 5 --quiet", 20, "none; "},
      {"$changeover search --order fano.txt -m 1", 20, "No linear order"},
      {"$changeover search 30 5 --exact --time 1s --quiet", 30, "at least 64"},
      {"$changeover search 70 8 --linear --blocks 185 --time 100ms --quiet", 30, "time limit"},
      {"$changeover classify 12 5 19 -m 1 --time 100ms --quiet", 30, "NOT ALL"},
      {"$changeover classify 9 4 -m 1 --circular --quiet", 0, "16 standard forms"},
      {"$changeover same good.txt good.txt", 0, "the same: "},
      {"$changeover same good.txt missing-pair.txt", 1, "not the same"},
      {"$changeover minima", 0, "Minima"},
      {"$changeover plan --items 9 --at-once 3 --test-cost 1 --change-cost 5 --quiet", 0,
       "cost 117"},
      {"$changeover loadorder --items 8 --room 4 --quiet", 0, "loads"},
      {"$changeover search 20 5 --strength 9", 2, "--strength 9 is out of range"},
      {"$changeover search 4 9", 2, "k = 9 exceeds v = 4"},
      {"$changeover classify 9 4 9 --circular --linear", 2, "--circular and --linear exclude"},
      {"$changeover classify 9 4 9 --time soon", 2, "--time 'soon' is not a duration"},
      {"$changeover minima --strength 9", 2, "--strength 9 is out of range"},
      {"$changeover plan --items 9 --at-once 3 --test-cost -1 --change-cost 1", 2, "negative"},
      {"$changeover loadorder --items 10 --room 1", 2, "--room 1: no two items could meet"},
      {"$changeover same good.txt nowhere.txt", 4, "nowhere.txt"},
      {"ln -s loop loop; $changeover minima --data loop", 4, "loop: "},
      {"$changeover search --order ragged.txt", 3, "ragged.txt:2:6: block 2 has 3 elements"},
      {"$changeover plan ragged.json --at-once 3 --test-cost 1 --change-cost 1", 4, "ragged.json"},
      {"$changeover search 9 4 --checkpoint nowhere/x --time 1s --quiet", 4, "nowhere"},
      {"$changeover search 30 6 -o nowhere/out.txt", 4, "nowhere"},
      {"$changeover search 9 5 --linear --exact --proof /dev/null/x --quiet", 4, "/dev/null"},
  };
  return all;
}

TEST(ExitCodes, AreThoseOfTheTable) {
  const TemporaryFolder folder;
  prepare(folder);
  expect(cases(), folder);
}

TEST(Output, LeavesTheOldFileIntactAfterAnyFailure) {
  const TemporaryFolder folder;
  prepare(folder);
  // The input is read before the output is touched, and a full disk strikes only the temporary
  // file.
  EXPECT_EQ(run("$changeover expand ragged.txt -o old.json", folder.path()).code, 3);
  EXPECT_EQ(slurp(folder.file("old.json")), "precious\n");
  EXPECT_EQ(run("$changeover design 4 2 -o old.json", folder.path()).code, 4);
  EXPECT_EQ(slurp(folder.file("old.json")), "precious\n");
  EXPECT_EQ(
      run("trap '' XFSZ; ulimit -f 8; $changeover design 253 13 --json -o old.json", folder.path())
          .code,
      4);
  EXPECT_EQ(slurp(folder.file("old.json")), "precious\n");
  EXPECT_EQ(run("ls -A | grep -c tmp", folder.path()).out, "0\n");
  EXPECT_EQ(run("$changeover design 253 13 --json -o old.json", folder.path()).code, 0);
  EXPECT_EQ(run("$changeover verify old.json", folder.path()).code, 0);
}

TEST(Output, ALongDesignWithoutACertificateIsVerifiedWhileItIsWritten) {
  const TemporaryFolder folder;
  const Outcome first = run("$changeover design 65534 4 --format text | head -n 2", folder.path());
  EXPECT_NE(first.out.find("verified while it is written"), std::string::npos) << first.out;
  EXPECT_NE(first.out.find("v=65534 k=4"), std::string::npos) << first.out;
  const Outcome whole =
      run("$changeover design 7500 4 --format text > streamed && tail -n 1 streamed && "
          "$changeover design 7500 4 --format text -o filed && "
          "sed '1d;$d' streamed | cmp - filed",
          folder.path());
  EXPECT_EQ(whole.code, 0) << whole.out;
  EXPECT_NE(whole.out.find("# verified: every block read"), std::string::npos) << whole.out;
}

TEST(Output, EndsQuietlyWhenItsReaderDoes) {
  const TemporaryFolder folder;
  const Outcome outcome = run("$changeover design 253 13 --format text | head -n 1", folder.path());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out.rfind("# changeover design v=253", 0), 0U);
}

TEST(Output, HasNoColourUnlessATerminalAsksForIt) {
  const TemporaryFolder folder;
  EXPECT_EQ(run("$changeover design 7 3", folder.path()).out.find('\x1b'), std::string::npos);
  // A machine without devpts, such as a bare root folder, opens no pseudo-terminal.
  if (run("script -qec true /dev/null", folder.path()).code != 0) {
    GTEST_SKIP() << "script (util-linux) is missing or cannot open a pseudo-terminal here";
  }
  const std::string script = "TERM=xterm script -qec \"$changeover design 7 3\" /dev/null";
  EXPECT_NE(run("unset NO_COLOR; " + script, folder.path()).out.find('\x1b'), std::string::npos);
  EXPECT_EQ(run("export NO_COLOR=1; " + script, folder.path()).out.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace changeover::test::exit_codes_test
