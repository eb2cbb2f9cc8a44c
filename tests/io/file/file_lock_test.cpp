#include "io/file/file_lock.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "changeover/core/error.hpp"
#include "changeover/io/output.hpp"
#include "message_of.hpp"

namespace changeover::file_lock_test {
namespace {

namespace fs = std::filesystem;

class FileLockTest : public testing::Test {
 protected:
  FileLockTest() { fs::create_directory(folder_); }
  ~FileLockTest() override { fs::remove_all(folder_); }

  // What taking the lock of a file says; "" if it can be had.
  std::string refusal(const fs::path& path) const {
    return message_of<Error>([&] { const FileLock lock(path.string()); });
  }
  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  static std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }

  fs::path folder_ = fs::temp_directory_path() / ("changeover-lock-" + std::to_string(getpid()));
  fs::path file_ = folder_ / "mine.csv";
  fs::path lock_file_ = folder_ / "mine.csv.lock";
};

TEST_F(FileLockTest, OneAtATimeAndTheLockFileGoesAwayWithIt) {
  {
    const FileLock lock(file_.string());
    EXPECT_TRUE(fs::exists(lock_file_));
    EXPECT_NE(refusal(file_).find("another process is using it"), std::string::npos);
    EXPECT_EQ(refusal(folder_ / "other.csv"), "");
  }
  EXPECT_FALSE(fs::exists(lock_file_));
  EXPECT_EQ(refusal(file_), "");
}

TEST_F(FileLockTest, ALinkHasTheLockOfWhatItNames) {
  write(file_, "v\n");
  fs::create_symlink(file_, folder_ / "link.csv");
  const FileLock lock((folder_ / "link.csv").string());
  EXPECT_TRUE(fs::exists(lock_file_));
  EXPECT_NE(refusal(file_), "");
}

TEST_F(FileLockTest, AProcessThatEndsWithoutAWordLeavesNoLock) {
  const pid_t child = fork();
  if (child == 0) {
    const FileLock lock(file_.string());
    _exit(0);  // as if killed: nothing is cleaned up
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
  ASSERT_TRUE(fs::exists(lock_file_));
  EXPECT_EQ(refusal(file_), "");
  EXPECT_FALSE(fs::exists(lock_file_));
}

TEST_F(FileLockTest, ASignalRemovesTheLock) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t child = fork();
    if (child == 0) {
      ::signal(signal, SIG_DFL);  // the parent process may ignore it
      remove_unfinished_outputs_on_signals();
      const FileLock lock(file_.string());
      ::raise(signal);
      _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_FALSE(fs::exists(lock_file_));
  }
}

TEST_F(FileLockTest, AFileOfSomebodysIsLeftAlone) {
  write(lock_file_, "my notes\n");
  EXPECT_NE(refusal(file_).find("not a lock file"), std::string::npos);
  EXPECT_EQ(content(lock_file_), "my notes\n");
}

TEST_F(FileLockTest, AnEmptyFileServesAndStays) {
  write(lock_file_, "");
  const int other = ::open(lock_file_.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  EXPECT_NE(refusal(file_), "");
  ::close(other);
  EXPECT_EQ(refusal(file_), "");
  EXPECT_EQ(content(lock_file_), "");
  EXPECT_TRUE(fs::exists(lock_file_));
}

}  // namespace
}  // namespace changeover::file_lock_test
