#include "changeover/io/output.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::output_file_test {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
 protected:
  OutputFileTest() : folder_(fs::temp_directory_path() / ("output_file_" + unique_name())) {
    fs::create_directories(folder_);
  }
  ~OutputFileTest() override { fs::remove_all(folder_); }

  static std::string unique_name() {
    return std::to_string(getpid()) + "_" +
           testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string contents(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static void fill(const std::string& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
  }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static mode_t permissions(const std::string& file) {
    struct stat status = {};
    EXPECT_EQ(stat(file.c_str(), &status), 0);
    return status.st_mode & 07777;
  }
  static std::string refusal(const std::string& file, const std::string& text = "x") {
    return message_of<MissingResource>([&] {
      OutputFile output(file);
      output.write(text);
      output.commit();
    });
  }

  fs::path folder_;
};

TEST_F(OutputFileTest, ANewFileAppearsAtCommitWithTheUsualPermissions) {
  const mode_t mask = umask(027);
  {
    OutputFile file(path("new"));
    file.write("hello ");
    file.write("world\n");
    file.flush();
    EXPECT_FALSE(fs::exists(path("new")));
    file.commit();
  }
  umask(mask);
  EXPECT_EQ(contents(path("new")), "hello world\n");
  EXPECT_EQ(permissions(path("new")), 0640);
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFileTest, AFileThatGetsTheNumberOfAClosedStandardOutputIsNotIt) {
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("changeover-test-stdout-" + std::to_string(::getpid())))
                               .string();
  const int kept = ::dup(STDOUT_FILENO);
  ASSERT_GE(kept, 0);
  ::close(STDOUT_FILENO);
  bool is_standard = true;
  std::string until_commit;
  {
    const OutputFile file(path);
    is_standard = file.is_standard_output();
    until_commit = file.path_until_commit();
  }
  ::dup2(kept, STDOUT_FILENO);
  ::close(kept);
  EXPECT_FALSE(is_standard);
  EXPECT_NE(until_commit, "");
}

TEST_F(OutputFileTest, WithoutCommitTheOldFileStaysAndNothingIsLeftOver) {
  fill(path("old"), "precious");
  {
    OutputFile file(path("old"));
    file.write(std::string(1 << 20, 'x'));
    EXPECT_EQ(files(), 2U);
  }
  EXPECT_EQ(contents(path("old")), "precious");
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFileTest, AReplacedFileKeepsItsPermissions) {
  fill(path("old"), "before");
  fs::permissions(path("old"), fs::perms(0604));
  OutputFile file(path("old"));
  file.write("after");
  file.commit();
  EXPECT_EQ(contents(path("old")), "after");
  EXPECT_EQ(permissions(path("old")), 0604U);
}

TEST_F(OutputFileTest, ASymbolicLinkStaysAndItsTargetIsReplaced) {
  fs::create_directory(path("elsewhere"));
  fill(path("elsewhere/target"), "before");
  fs::create_symlink("elsewhere/target", path("first"));
  fs::create_symlink("first", path("link"));
  OutputFile file(path("link"));
  file.write("after");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(contents(path("elsewhere/target")), "after");
}

TEST_F(OutputFileTest, ADanglingLinkGetsItsTarget) {
  fs::create_symlink("absent", path("link"));
  OutputFile file(path("link"));
  file.write("x");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(contents(path("absent")), "x");
}

TEST_F(OutputFileTest, LinksInACircleAreRefused) {
  fs::create_symlink("b", path("a"));
  fs::create_symlink("a", path("b"));
  EXPECT_NE(refusal(path("a")).find("symbolic links"), std::string::npos) << refusal(path("a"));
}

TEST_F(OutputFileTest, AVeryLongNameWorks) {
  const std::string name(255, 'n');
  EXPECT_EQ(refusal(path(name), "x"), "");
  EXPECT_EQ(contents(path(name)), "x");
}

TEST_F(OutputFileTest, LargeAndSmallPiecesArriveInOrder) {
  std::string expected;
  OutputFile file(path("pieces"));
  for (std::size_t size : {10U, 70'000U, 3U, 65'536U, 65'535U, 1U, 300'000U, 0U, 5U}) {
    const std::string piece(size, static_cast<char>('a' + size % 26));
    expected += piece;
    file.write(piece);
  }
  file.commit();
  EXPECT_EQ(contents(path("pieces")), expected);
}

TEST_F(OutputFileTest, FaultsAreOneLineWithPathReasonAndRemedy) {
  EXPECT_EQ(refusal(path("absent/file")),
            path("absent/file") +
                ": cannot write: No such file or directory; make the directory "
                "first, or check how the path is spelt");
  EXPECT_EQ(refusal(folder_.string()),
            folder_.string() + ": cannot write: Is a directory; name a file in it");
  EXPECT_NE(refusal(path("absent/")), "");
  fill(path("file"), "");
  EXPECT_NE(refusal(path("file/below")).find("Not a directory"), std::string::npos);
  EXPECT_NE(refusal(path(std::string(300, 'n'))).find("too long"), std::string::npos);
}

TEST_F(OutputFileTest, AReadOnlyFileIsNotReplaced) {
  if (geteuid() == 0) {
    GTEST_SKIP() << "root may write everything";
  }
  fill(path("old"), "precious");
  fs::permissions(path("old"), fs::perms(0444));
  EXPECT_NE(refusal(path("old")).find("Permission denied"), std::string::npos);
  EXPECT_EQ(contents(path("old")), "precious");
}

TEST_F(OutputFileTest, AFullDiskIsNoticed) {
  if (!fs::exists("/dev/full")) {
    GTEST_SKIP() << "no /dev/full";
  }
  EXPECT_EQ(refusal("/dev/full", "x"),
            "/dev/full: cannot write: No space left on device; free some "
            "space or write elsewhere");
  EXPECT_NE(refusal("/dev/full", std::string(1 << 20, 'x')), "");
  EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST_F(OutputFileTest, WhatIsNoRegularFileIsWrittenDirectly) {
  EXPECT_EQ(refusal("/dev/null"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));

  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_EQ(refusal(path("pipe"), "through"), "");
  char buffer[16] = {};
  EXPECT_EQ(read(reader, buffer, sizeof buffer), 7);
  EXPECT_STREQ(buffer, "through");
  close(reader);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

// Runs `action` in another process and returns how that ended, as waitpid() says it.
template <typename Action>
int ending_of(Action&& action) {
  const pid_t child = fork();
  if (child == 0) {
    action();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST_F(OutputFileTest, StandardOutputIsWrittenAndItsFaultsAreNoticed) {
  const int status = ending_of([&] {
    dup2(open(path("out").c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    OutputFile file("-");
    file.write("to stdout\n");
    file.commit();
    dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO);
    const bool first = refusal("-").starts_with("<stdout>: cannot write: No space left");
    _exit(file.is_standard_output() && first && !refusal("").empty() ? 0 : 1);
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(contents(path("out")), "to stdout\n");
}

// Limits the size of files for this process, as `ulimit -f` does.
void limit_files_to(rlim_t bytes) {
  signal(SIGXFSZ, SIG_IGN);
  rlimit limit{.rlim_cur = bytes, .rlim_max = bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
}

TEST_F(OutputFileTest, ALimitOnFileSizesIsSaidAndTheOldFileIsIntact) {
  for (const std::size_t size : {2000U, 300'000U}) {  // noticed by commit(), and by write()
    fill(path("old"), "precious");
    const int status = ending_of([&] {
      limit_files_to(1000);
      const std::string line = refusal(path("old"), std::string(size, 'x'));
      _exit(line.find("File too large; raise the limit") != std::string::npos ? 0 : 1);
    });
    EXPECT_EQ(status, 0);
    EXPECT_EQ(contents(path("old")), "precious");
    EXPECT_EQ(files(), 1U);
  }
}

TEST_F(OutputFileTest, CommitAfterAFailedWriteThrowsAgainAndPutsNothingInPlace) {
  fill(path("old"), "precious");
  const int status = ending_of([&] {
    signal(SIGXFSZ, SIG_IGN);
    rlimit limit = {};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit before = limit;
    limit.rlim_cur = 100'000;
    setrlimit(RLIMIT_FSIZE, &limit);
    OutputFile file(path("old"));
    int faults = 0;
    const auto attempt = [&](auto action) {
      try {
        action();
      } catch (const MissingResource&) {
        ++faults;
      }
    };
    attempt([&] { file.write(std::string(300'000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &before);
    attempt([&] { file.write("little"); });
    attempt([&] { file.flush(); });
    attempt([&] { file.commit(); });
    _exit(faults == 4 ? 0 : 1);
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(contents(path("old")), "precious");
}

TEST_F(OutputFileTest, AFolderThatIsRemovedMeanwhileIsMissing) {
  fs::create_directory(path("folder"));
  OutputFile file(path("folder/file"));
  file.write("x");
  fs::remove_all(path("folder"));
  EXPECT_THROW(file.commit(), MissingResource);
  EXPECT_EQ(files(), 0U);
}

TEST_F(OutputFileTest, ATargetThatBecameAFolderIsNotReplaced) {
  OutputFile file(path("target"));
  file.write("x");
  fs::create_directories(path("target/inside"));
  EXPECT_THROW(file.commit(), MissingResource);
  EXPECT_TRUE(fs::is_directory(path("target/inside")));
}

TEST_F(OutputFileTest, AReaderThatWentAwayIsAFaultOfItsOwn) {
  const int status = ending_of([] {
    signal(SIGPIPE, SIG_IGN);
    int ends[2] = {};
    if (pipe(ends) != 0) {
      _exit(2);
    }
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    try {
      OutputFile file("-");
      file.write("x");
      file.commit();
    } catch (const ReaderGone& fault) {
      _exit(std::string(fault.what()).find("program that reads it") != std::string::npos ? 0 : 1);
    }
    _exit(1);
  });
  EXPECT_EQ(status, 0);
}

TEST_F(OutputFileTest, AStreamThatWouldNotWaitIsWaitedFor) {
  int ends[2] = {};
  ASSERT_EQ(pipe2(ends, O_NONBLOCK), 0);
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    dup2(ends[1], STDOUT_FILENO);
    _exit(refusal("-", std::string(1 << 20, 'x')).empty() ? 0 : 1);
  }
  close(ends[1]);
  fcntl(ends[0], F_SETFL, 0);
  std::size_t got = 0;
  char buffer[4096];
  for (ssize_t count = 0; (count = read(ends[0], buffer, sizeof buffer)) > 0;) {
    got += static_cast<std::size_t>(count);
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(got, std::size_t{1} << 20);
}

TEST_F(OutputFileTest, ASignalRemovesTheTemporaryAndEndsTheProcess) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    fill(path("old"), "precious");
    const int status = ending_of([&] {
      ::signal(signal, SIG_DFL);  // the parent process may ignore it
      remove_unfinished_outputs_on_signals();
      OutputFile done(path("done"));
      done.commit();
      OutputFile file(path("old"));
      file.write(std::string(1 << 20, 'x'));
      raise(signal);
    });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_EQ(contents(path("old")), "precious");
    EXPECT_TRUE(fs::exists(path("done")));
    EXPECT_EQ(files(), 2U);
  }
}

TEST_F(OutputFileTest, AHandlerOfOthersIsLeftAlone) {
  const int status = ending_of([&] {
    signal(SIGINT, SIG_IGN);
    remove_unfinished_outputs_on_signals();
    OutputFile file(path("new"));
    raise(SIGINT);
    file.write("x");
    file.commit();
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(contents(path("new")), "x");
}

}  // namespace
}  // namespace changeover::output_file_test
