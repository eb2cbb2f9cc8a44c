#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "cases.hpp"

namespace changeover::test::serve_test {
namespace {

TEST(Serve, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  spit(folder.file("bad.txt"), "0 1 2\n0 1\n");
  spit(folder.file("good.txt"), "0 1 2 3\n4 5 2 3\n");
  std::filesystem::create_directory(folder.path() / "pages");
  spit(folder.file("pages/index.html"), "<html><head></head></html>");
  std::filesystem::create_directory(folder.path() / "full");
  spit(folder.file("full/mine"), "mine");
  expect({{"$changeover serve --port x", 2, "--port"},
          {"$changeover serve --host 203.0.113.7", 4, "cannot listen on 203.0.113.7:0"},
          {"$changeover serve missing.txt", 4, "missing.txt"},
          {"$changeover serve good.txt bad.txt", 3, "bad.txt:2:"},
          {"$changeover serve --assets missing", 4, "--assets missing: there is no such folder"},
          {"$changeover serve --export x --port 80", 2, "has no meaning with --export"},
          {"$changeover serve --assets pages --export x --k 4..3", 2, "the range is empty"},
          {"$changeover serve --assets pages --export x --v 5..5000", 2, "v = 1000"},
          {"mkdir here && cd here && $changeover serve --assets ../pages --export .", 4,
           "--export .: you are in this folder"},
          {"$changeover serve --assets pages --export none/such/x", 4, "cannot make a folder"},
          {"$changeover serve --assets full --export x", 4, "without pages"},
          {"$changeover serve --help", 0, "--no-write"}},
         folder);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "x"));
  EXPECT_EQ(slurp(folder.path() / "full" / "mine"), "mine");
}

TEST(Serve, PrintsItsAddressAndEndsWhenAsked) {
  const TemporaryFolder folder;
  for (const char* const signal : {"INT", "TERM"}) {
    const Outcome outcome =
        run(std::string("rm -f out; $changeover serve good.txt >out 2>err & p=$!\n"
                        "for i in $(seq 600); do [ -s out ] && break; sleep 0.1; done\n"
                        "$changeover serve --port $(sed 's/.*:\\([0-9]*\\).*/\\1/' out)\n"
                        "echo taken $?; kill -") +
                signal + " $p; wait $p; echo ended $?; cat out err",
            (spit(folder.file("good.txt"), "0 1 2 3\n4 5 2 3\n"), folder.path()));
    EXPECT_NE(outcome.err.find("another program listens there"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find("taken 4\nended 0\nhttp://127.0.0.1:"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(count(outcome.out, "\n"), 3U) << outcome.out;
  }
}

TEST(Serve, ExportsWhatItWouldAnswer) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "pages");
  spit(folder.file("pages/index.html"), "<html><head></head></html>");
  const std::string site = "$changeover serve --assets pages --export site --k 3..4 --v 3..8 -m 2";
  expect({{site, 0, "30 cells"}, {site, 0, "30 cells"}}, folder);
  const std::filesystem::path data = folder.path() / "site" / "data";
  EXPECT_NE(slurp(folder.file("site/index.html")).find("<meta name=\"changeover-data\""),
            std::string::npos);
  EXPECT_NE(slurp(data / "config.json").find("\"static\":true"), std::string::npos);
  for (const char* const kind : {"circular", "linear"}) {
    const std::string name = std::string("2.") + kind;
    const auto unpacked = [&](const std::string& file) {
      return run("gzip -dc " + (data / file).string(), folder.path()).out;
    };
    EXPECT_NE(unpacked("atlas/" + name + ".json.gz").find("\"k_from\":3,\"k_to\":4"),
              std::string::npos);
    EXPECT_NE(unpacked("groups/" + name + ".json.gz").find("\"order\":["), std::string::npos);
    EXPECT_TRUE(unpacked("cell/" + name + ".4.json.gz").starts_with("{\"4\":{"));
    EXPECT_TRUE(unpacked("design/" + name + ".4.gz").starts_with("[{\"label\":\""));
  }
  // Without an address nothing names whole addresses.
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "site" / "sitemap.xml"));
  expect({{site + " --address example.org", 2, "write where the site will be"},
          {site + " --address 'https://example.org/?a'", 2, "write where the site will be"},
          {site + " --address http://:80/", 2, "write where the site will be"},
          {site + " --address http://::1/", 2, "write where the site will be"},
          {site + " --address 'http://[::1'", 2, "write where the site will be"},
          {site + " --address 'http://[x]:80/'", 2, "write where the site will be"},
          {site + " --address 'http://e.org/[::1]'", 2, "write where the site will be"},
          {site + " --address http://e.org:0/", 2, "a port is a number from 1 to 65535"},
          {site + " --address http://e.org:080/", 2, "a port is a number from 1 to 65535"},
          {site + " --address http://e.org:", 2, "a port is a number from 1 to 65535"},
          {site + " --address 'http://[::1]:x/'", 2, "a port is a number from 1 to 65535"},
          {site + " --sources ftp://example.org", 2, "write where the program can be got"},
          {site + " --address https://example.org/designs --sources https://example.org/src", 0,
           "designs"}},
         folder);
  EXPECT_NE(slurp(data / "config.json").find("\"sources\":\"https://example.org/src\""),
            std::string::npos);
  EXPECT_NE(slurp(folder.file("site/robots.txt"))
                .find("Sitemap: https://example.org/designs/sitemap.xml"),
            std::string::npos);
  EXPECT_NE(slurp(folder.file("site/feed.xml")).find("<feed "), std::string::npos);
  expect({{site, 0, "designs"}}, folder);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "site" / "feed.xml"));
  EXPECT_EQ(run("ls -d site.new-*", folder.path()).out, "");
  // No process is left in a folder that was deleted.
  expect(
      {{"cd site/data && $changeover serve --assets ../../pages --export ..", 4,
        "--export ..: you are in this folder"},
       {"cd site && $changeover serve --assets ../pages --export ../site", 4, "--export ../site"}},
      folder);
  // A file that a user put beside it is not deleted.
  spit(folder.file("site/CNAME"), "designs.example");
  expect({{site, 4, "CNAME is not of the earlier export"}}, folder);
  EXPECT_EQ(slurp(folder.file("site/CNAME")), "designs.example");
}

TEST(Serve, ExportsClearWhatAKilledOneLeft) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "pages");
  spit(folder.file("pages/index.html"), "<html><head></head></html>");
  const std::string killed =
      "$changeover serve --assets pages --export site --k 3..8 --v 4..200 -m 2 >/dev/null 2>&1 & "
      "p=$!; while [ ! -e \"$(echo site.new-*)\"/data/config.json ] && kill -0 $p; do sleep 0.01; done; "
      "kill -KILL $p; wait $p; ls -d site.new-* | wc -l";
  ASSERT_EQ(run(killed, folder.path()).out, "1\n");
  const auto make = [&](const std::string& name, const std::string& file) {
    std::filesystem::create_directory(folder.path() / name);
    spit(folder.path() / name / file, "precious");
  };
  const std::string marker = ".changeover-unfinished";
  make("site.new-mine12", "mine");  // what no export makes
  make("site.new-both12", "mine");  // with a file of a user
  spit(folder.path() / "site.new-both12" / marker, "");
  make("site.new-index1", "index.html");  // no export begins like that
  make("site.new-short", marker);         // not named as ours
  make("other.new-abcdef", marker);       // of another place
  make("site.new-locked", marker);        // being made
  make("elsewhere", marker);
  make("site.new-second", ".changeover-explorer");  // a site that a user keeps
  spit(folder.path() / "site.new-second" / "index.html", "precious");
  make("site.new-folder", ".changeover-explorer");
  std::filesystem::create_directory(folder.path() / "site.new-folder" / marker);
  std::filesystem::create_directory_symlink("elsewhere", folder.path() / "site.new-symbol");
  spit(folder.path() / "site.new-file12", "precious");
  std::filesystem::create_directory(folder.path() / "site.new-empty1");  // killed before it began
  const int held = ::open(folder.file("site.new-locked").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0);
  const std::string small = "$changeover serve --assets pages --export site --k 3 --v 5..7 -m 2";
  expect({{small, 0, "files"}}, folder);
  ::close(held);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.insert(entry.path().filename().string());
  }
  EXPECT_EQ(names, (std::set<std::string>{"elsewhere", "other.new-abcdef", "pages", "site",
                                          "site.new-both12", "site.new-file12", "site.new-folder",
                                          "site.new-index1", "site.new-locked", "site.new-mine12",
                                          "site.new-second", "site.new-short", "site.new-symbol"}));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "site" / marker));
  expect({{small, 0, "files"}}, folder);  // The old site goes away with its folder.
  EXPECT_EQ(run("ls -d site.new-* | wc -l", folder.path()).out, "8\n");  // nor is any locked now
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "elsewhere" / marker));
}

}  // namespace
}  // namespace changeover::test::serve_test
