// The example that trains embeddings: the same bytes for the same seed, whichever worker runs and
// whatever
// kills it.
#include <filesystem>

#include "cases.hpp"

namespace changeover::test::train_embeddings_test {
namespace {

const std::string train = "$(dirname $all_pairs)/train_embeddings ";

double number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? -1 : std::stod(text.substr(at + words.size()));
}

TEST(TrainEmbeddings, LearnsAndGivesTheSameBytesForTheSameSeed) {
  const TemporaryFolder folder;
  ASSERT_EQ(run(train + "make edges 400 6000", folder.path()).code, 0);
  const Outcome first = run(train + "run edges a --parts 12 --journal ja", folder.path());
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_NE(first.out.find("one worker at a time"), std::string::npos) << first.out;
  const double before = number_after(first.out, "loss ");
  const double after = number_after(first.out, "before, loss ");
  EXPECT_GT(before, 0.6);
  EXPECT_LT(after, before - 0.02) << first.out;
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.versions")));
  ASSERT_EQ(run(train + "run edges b --parts 12 --journal jb", folder.path()).code, 0);
  EXPECT_TRUE(slurp(folder.file("a")) == slurp(folder.file("b")));
  ASSERT_EQ(run(train + "run edges c --parts 12 --journal jc --seed 2", folder.path()).code, 0);
  EXPECT_FALSE(slurp(folder.file("a")) == slurp(folder.file("c")));
}

TEST(TrainEmbeddings, KilledAtAnyMomentHasTheBytesOfARunWithoutACrash) {
  const TemporaryFolder folder;
  const std::string job = "--parts 16 --checkpoint 1 ";
  ASSERT_EQ(run(train + "make edges 2000 60000; " + train + "run edges right --journal jr " + job,
                folder.path())
                .code,
            0);
  const Outcome killed = run(
      "program=" + train +
          "; killed=0; for i in 1 2 3 4 5 6 7 8; do $program run edges hit --journal j " + job +
          "& child=$!; sleep 0.0$i; kill -9 $child 2>/dev/null && killed=$((killed + 1)); "
          "wait $child; done 2>/dev/null; echo killed $killed; exec $program run edges hit --journal j " +
          job,
      folder.path());
  EXPECT_EQ(killed.code, 0) << killed.err;
  EXPECT_GE(number_after(killed.out, "killed "), 1) << killed.out;
  EXPECT_TRUE(slurp(folder.file("right")) == slurp(folder.file("hit"))) << killed.out;
}

TEST(TrainEmbeddings, SaysInOneLineWhatIsWrong) {
  const TemporaryFolder folder;
  ASSERT_EQ(run(train + "make edges 100 500", folder.path()).code, 0);
  spit(folder.file("words"), "1 2\nthree four\n");
  spit(folder.file("short"), "abc");
  expect({{train + "run edges a", 2, "--journal FILE is required"},
          {train + "run edges a --journal j --parts 0", 2, "--parts 0: give a whole number"},
          {train + "run edges a --journal j --nonsense 3", 2, "'--nonsense' is not understood"},
          {train, 2, "usage"},
          {train + "run words a --journal j", 3, "words:2: two numbers"},
          {train + "run absent a --journal j", 4, "absent"},
          {train + "run edges short --journal j", 4, "short"}},
         folder);
  EXPECT_EQ(slurp(folder.file("short")), "abc");
}

}  // namespace
}  // namespace changeover::test::train_embeddings_test
