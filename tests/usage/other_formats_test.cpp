// Designs of other programs through the verbs.
#include <gtest/gtest.h>

#include "cases.hpp"

namespace changeover::test {
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
          {"$changeover verify bad.g", 3, "bad.g:1:30: 8 is no point"},
          {"$changeover verify page.html", 3, "page.html:1:1: an XML file of 'html'"}},
         folder);
}

}  // namespace
}  // namespace changeover::test
