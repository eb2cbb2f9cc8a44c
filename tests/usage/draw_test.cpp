// The verb draw from outside: whose pictures, in which form, and what it refuses.
#include <gtest/gtest.h>

#include <map>

#include "cases.hpp"
#include "written_files.hpp"

namespace changeover::test::draw_test {
namespace {

class Draw : public testing::Test {
 protected:
  void SetUp() override {
    spit(folder.file("good.txt"),
         "# changeover design v=6 k=4 change=2 kind=circular\n0 1 2 3\n4 5 2 3\n4 5 0 1\n");
    spit(folder.file("bad.txt"),
         "# changeover design v=6 k=4 change=2 kind=linear\n∞_s <b> c d\ne f c d\ne f ∞_s d\n");
    spit(folder.file("ragged.txt"), "0 1 2 3\n4 5 2\n");
    spit(folder.file("old.dat"), "precious\n");
  }
  const TemporaryFolder folder;
};

TEST_F(Draw, EveryPictureIsAnswered) {
  expect({{"$changeover draw good.txt", 0, "<title>good.txt: circular DCCD(6,4), 3 blocks</title>"},
          {"$changeover draw - <good.txt", 0, "standard input"},
          {"$changeover draw bad.txt", 0, "INVALID: 1 wrong step, "},
          {"$changeover draw bad.txt --picture coverage", 0, "class=\"uncovered\""},
          {"$changeover draw good.txt --expansion-sets", 0, "class=\"caret\""},
          {"$changeover draw 8 5 --expansion-sets", 0, "it has no expansion set"},
          {"$changeover draw good.txt --picture stays --colour ordinal --order given", 0,
           "class=\"stay\""},
          {"$changeover draw 11 4 --picture circle", 0, "1 base block over Z_11"},
          {"$changeover draw 20 5", 0, "class=\"block\""},
          {"$changeover draw 9 5 -m 1 --linear --theme dark", 0, "class=\"changeover dark\""},
          {"$changeover draw 253 13 --from 100 --to 110", 0, "blocks 100 to 110"},
          {"$changeover draw 253 13 --picture recipe", 0, "class=\"node\""},
          {"$changeover draw 61.4.2.circular --picture stays", 0, "366 blocks"},
          {"$changeover draw 26.4.2.circular.65", 0, "26.4.2.circular.65."},
          {"$changeover draw 8 --picture factorization", 0, "1-factorization of K_8"},
          {"$changeover draw --picture heatmap --k 3..4 --v 5..9", 0, "data-v=\"9\" data-k=\"4\""},
          {"$changeover draw --picture heatmap --k 3..4 --v 5..9 --measure status --circular", 0,
           "circular double-change covering designs"},
          {"$changeover draw good.txt --format tikz", 0, "\\begin{tikzpicture}"},
          {"$changeover draw good.txt -o good.tex && cat good.tex", 0, "\\end{tikzpicture}"},
          {"$changeover draw good.txt -o good.svg && cat good.svg", 0, "</svg>"},
          {"$changeover draw 4 2", 4, "No circular DCCD(4,2) exists"}},
         folder);
}

TEST_F(Draw, ItIsWellFormedAndHasNoStyleOfItsOwn) {
  for (const std::string what :
       {"bad.txt", "bad.txt --picture stays", "bad.txt --picture coverage",
        "bad.txt --picture circle", "8 5 --leaving", "253 13 --picture recipe",
        "--picture heatmap --k 3..5 --v 5..20"}) {
    for (const std::string theme : {"light", "dark"}) {
      const Outcome outcome = run("$changeover draw " + what + " --theme " + theme, folder.path());
      EXPECT_EQ(outcome.code, 0) << what;
      EXPECT_TRUE(is_xml(outcome.out)) << what;
      EXPECT_EQ(outcome.out.find("style"), std::string::npos) << what;
    }
  }
}

TEST_F(Draw, WhatItCannotDoIsSaidInOneLine) {
  expect(
      {{"$changeover draw 20", 2, "V needs K"},
       {"$changeover draw x 5", 2, "'x' is neither a label nor a number V"},
       {"$changeover draw 5 61", 2, "k = 61 exceeds v = 5"},
       {"$changeover draw good.txt --picture photo", 2, "'photo' is not one of"},
       {"$changeover draw good.txt --picture circle --order given", 2, "--order has no meaning"},
       {"$changeover draw good.txt --picture recipe --from 2", 2, "--from has no meaning"},
       {"$changeover draw --picture heatmap --v ..5000", 2, "--v ..5000: a table goes"},
       {"$changeover draw 7 --picture factorization", 2, "K_7 has no 1-factorization"},
       {"$changeover draw good.txt --picture circle --to 4", 2, "--to 4: there are only 3 blocks"},
       {"$changeover draw good.txt -o x.xyz", 2,
        "x.xyz: unknown file extension '.xyz'; use .svg, .tex, .pdf or .png, or add --format"},
       {"$changeover draw good.txt -o 20.5.2.linear", 2, "unknown file extension '.linear'"},
       {"$changeover draw good.txt --format svg -o good.txt", 2, "is the same file as the design"},
       {"$changeover draw ragged.txt", 3, "ragged.txt:2"},
       {"$changeover draw .", 4, "directory"},
       {"$changeover draw good.txt -o nowhere/x.svg", 4, "nowhere"},
       {"$changeover draw 300 5 --format tikz", 2, "draw a part"},
       {"PATH=/nowhere $changeover draw good.txt --format pdf", 4, "librsvg2-bin"},
       {"PATH=/nowhere $changeover draw good.txt -o old.dat --format png", 4, "librsvg2-bin"}},
      folder);
  EXPECT_EQ(slurp(folder.file("old.dat")), "precious\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "x.xyz"));
}

TEST_F(Draw, TheEndingSaysTheFormatInAnyLetters) {
  EXPECT_EQ(run("$changeover draw good.txt -o a.TEX", folder.path()).code, 0);
  EXPECT_NE(slurp(folder.file("a.TEX")).find("tikzpicture"), std::string::npos);
  EXPECT_EQ(run("$changeover draw good.txt -o picture", folder.path()).code, 0);
  EXPECT_TRUE(is_xml(slurp(folder.file("picture"))));
  EXPECT_EQ(run("$changeover draw good.txt --format svg -o a.xyz", folder.path()).code, 0);
  EXPECT_TRUE(is_xml(slurp(folder.file("a.xyz"))));
}

TEST_F(Draw, WhatTheConverterWritesIsNoPictureBeforeItWasLookedAt) {
  std::filesystem::create_directory(folder.path() / "tools");
  for (const std::string format : {"png", "pdf"}) {
    for (const auto& [does, words] : std::map<std::string, std::string>{
             {"echo done", "rsvg-convert wrote 5 bytes that are not a whole " + format},
             {"printf '\\211PNG\\r\\n\\032\\n'; printf '%%PDF-1.7\\n'",
              "bytes that are not a whole " + format},
             {"printf '%%PDF-1.7\\n'", "rsvg-convert wrote 9 bytes that are not a whole " + format},
             {"exit 0", "it says nothing"},
             {"kill -9 $$", "it says nothing"},
             {"head -c 100000 /dev/zero >&2; exit 1", "could not write"}}) {
      spit(folder.path() / "tools" / "rsvg-convert", "#!/bin/sh\n" + does + "\n");
      const Outcome outcome =
          run("chmod +x tools/rsvg-convert; PATH=$PWD/tools:$PATH "
              "$changeover draw good.txt -o old.dat --format " +
                  format,
              folder.path());
      EXPECT_EQ(outcome.code, 4) << outcome.err;
      EXPECT_NE(outcome.err.find(words), std::string::npos) << does << ": " << outcome.err;
      EXPECT_LT(outcome.err.size(), 2000U) << does;
      EXPECT_EQ(slurp(folder.file("old.dat")), "precious\n");
    }
  }
}

TEST_F(Draw, PdfAndPngComeFromTheConverter) {
  if (run("rsvg-convert --version", folder.path()).code != 0) {
    GTEST_SKIP() << "rsvg-convert (librsvg2-bin) is missing";
  }
  EXPECT_EQ(run("$changeover draw good.txt -o a.pdf", folder.path()).code, 0);
  EXPECT_TRUE(slurp(folder.file("a.pdf")).starts_with("%PDF-"));
  EXPECT_EQ(run("$changeover draw good.txt --theme dark -o a.png", folder.path()).code, 0);
  EXPECT_TRUE(slurp(folder.file("a.png")).starts_with("\x89PNG"));
  EXPECT_EQ(run("$changeover draw good.txt --format png | head -c 4", folder.path()).out,
            "\x89PNG");
}

}  // namespace
}  // namespace changeover::test::draw_test
