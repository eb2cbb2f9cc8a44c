// Designs of other programs through the verbs.
#include <gtest/gtest.h>

#include "cases.hpp"

namespace changeover::test::other_formats_test {
namespace {

const std::string covering = "1 2 3\n1 4 5\n1 6 7\n2 4 6\n2 5 7\n3 4 7\n3 5 6\n";

TEST(OtherFormats, ADesignComesBack) {
  const TemporaryFolder folder;
  for (const std::string format : {"gap", "sage", "designtheory"}) {
    const std::string file = "d." + format;
    expect({{"$changeover design 7 3 --circular --format " + format + " -o " + file +
                 " && $changeover verify " + file,
             0, "valid: circular DCCD(7,3) with 7 blocks"},
            {"$changeover design 7 3 --circular --format text -o t && $changeover same t " + file,
             0, "same"},
            {"$changeover search --order " + file + " -m 2 --circular --quiet --format " + format,
             10, format == "designtheory" ? "v=\"7\"" : "(7, [\n"}},
           folder);
  }
  expect({{"$changeover design 7 3 --circular --format ljcr -o d.txt && $changeover verify d.txt",
           0, "valid: linear DCCD(7,3) with 7 blocks"}},
         folder);
}

// Through GAP itself, where it is installed; with its package DESIGN or, without it, a function of
// that name.
TEST(OtherFormats, GapReadsAndWrites) {
  const TemporaryFolder folder;
  if (run("echo 'QUIT;' | gap -q", folder.path()).code != 0) {
    GTEST_SKIP() << "GAP is not installed here (gap-core, gap-design): its reading was left out";
  }
  spit(folder.file("again.g"), R"(if LoadPackage("design") = fail then
  BlockDesign := function(v, blocks) return rec(v := v, blocks := Set(blocks)); end;
fi;
Read("ours.g");
PrintTo("theirs.g", "D := BlockDesign(", D.v, ", ", D.blocks, ");\n");
QUIT;
)");
  const struct {
    const char *design, *order;
  } cases[] = {{"7 3 --change 2 --circular", "-m 2 --circular"},
               {"5 3 --change 1 --linear", "-m 1 --linear"}};
  for (const auto& [design, order] : cases) {
    const std::string words = design;
    const Outcome ours =
        run("$changeover design " + words + " --format gap -o ours.g && gap -q < again.g",
            folder.path());
    ASSERT_EQ(ours.code, 0) << ours.err;
    // The same blocks; their order is GAP's, so that they are put into order again.
    const auto blocks = [&](const std::string& file) {
      const Outcome found = run("tr -d ' \\n' < " + file +
                                    " | sed 's/.*BlockDesign(//' | grep -oE '\\[[0-9,]+\\]' | sort",
                                folder.path());
      EXPECT_NE(found.out, "");
      return found.out;
    };
    EXPECT_EQ(blocks("ours.g"), blocks("theirs.g")) << words;
    expect({{std::string("$changeover search --order theirs.g ") + order + " --quiet --format gap",
             10, "BlockDesign("}},
           folder);
  }
}

TEST(OtherFormats, ACoveringIsOrderedAndExtended) {
  const TemporaryFolder folder;
  spit(folder.file("fano.txt"), covering);
  spit(folder.file("fano.g"),
       "BlockDesign(7, [[1,2,3],[1,4,5],[1,6,7],[2,4,6],[2,5,7],[3,4,7],[3,5,6]]);\n");
  spit(folder.file("bad.g"), "BlockDesign(7, [[1,2,3],[1,4,8]]);\n");
  spit(folder.file("page.html"), "<html></html>\n");
  expect({{"$changeover search --order fano.txt -m 2 --quiet --format gap", 10, "BlockDesign(7, ["},
          {"$changeover search --order fano.g -m 2 --quiet --format ljcr", 10, "1 "},
          {"$changeover search --order fano.g -m 1 --quiet", 20, "No linear order"},
          {"$changeover verify bad.g", 3, "bad.g:1:30: 8 is not a point"},
          {"$changeover verify page.html", 3, "page.html:1:1: the file begins with 'html'"}},
         folder);
}

}  // namespace
}  // namespace changeover::test::other_formats_test
