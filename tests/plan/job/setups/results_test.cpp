// What people write as the result of a test.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover::results_test {
namespace {

void expect_all(const std::vector<std::string>& texts, TestResult wanted) {
  for (const std::string& text : texts) {
    EXPECT_EQ(static_cast<int>(result_of(text)), static_cast<int>(wanted)) << text;
  }
}

TEST(Results, AWordThatBeginsWithFailIsAFailureWhateverFollows) {
  expect_all({"fail", "FAIL", "Failed", "FAILED - hang", "fail: leak", "failure", "Failures",
              "failing since noon", "fails", "(failed)", "** FAIL **", "\"failed\"", "FAIL!",
              "fail_timeout", "fail2", "failed once, passed later", "ＦＡＩＬ"},
             TestResult::fail);
}

TEST(Results, AWordThatBeginsWithPassIsAPassUnlessItIsTakenBack) {
  expect_all({"pass", "PASSED", "Pass (2nd try)", "passes", "passing", "passt", "passed: 12.5 V"},
             TestResult::pass);
  expect_all({"pass?", "passed, then hung", "pass but slow", "passed, 1 failed", "pass/fail",
              "passe pas", "ok until noon", "ok?"},
             TestResult::unread);
}

TEST(Results, OtherWordsAndSignsCount) {
  expect_all({"ok", "OK", "O.K.", "okay", "p", "yes", "good", "success", "✓", "✔", "✅", "☑"},
             TestResult::pass);
  expect_all({"nok",      "ko",      "NG",   "f",    "no",     "bad",          "error",
              "Error 17", "crashed", "hang", "hung", "not ok", "did not pass", "not good",
              "✗",        "✘",       "✕",    "×",    "❌",      "✗ leak"},
             TestResult::fail);
}

TEST(Results, OtherLanguagesCount) {
  expect_all({"bestanden", "i.O.", "i. O.", "iO", "erfolgreich", "réussi", "RÉUSSI", "conforme",
              "aprobado", "éxito", "pasa", "superato", "aprovado", "geslaagd", "合格", "成功",
              "通过", "합격", "re\u0301ussi"},
             TestResult::pass);
  expect_all({"nicht bestanden", "n.i.O.", "niO",          "Fehler 3", "fehlgeschlagen",
              "défaut",          "ÉCHEC",  "non conforme", "fallo",    "Falló en frío",
              "fallito",         "errore", "falhou",       "mislukt",  "不合格",
              "不合格（漏れ）",  "失敗",   "エラー",       "失败",     "실패"},
             TestResult::fail);
}

TEST(Results, FalseFriendsAreNotUnderstood) {
  expect_all({"failover",
              "failsafe",
              "fail-safe",
              "error-free",
              "fehlerfrei",
              "Fehler frei",
              "no error",
              "no fault found",
              "kein Fehler",
              "not failed",
              "passive",
              "password lost",
              "Passagier",
              "x",
              "X",
              "o",
              "○",
              "☒",
              "12.5",
              "0",
              "1",
              "-5",
              "3 failed",
              "0 errors",
              "smelled of smoke",
              "hot",
              "yes, but",
              "no idea",
              "?",
              "!ok",
              "合格せず",
              "失敗なし",
              "open",
              "done, I think",
              "\xff"},
             TestResult::unread);
}

TEST(Results, ATestThatWasNotRunSaysNothingAndOneThatWasDoneSaysThat) {
  expect_all({"skipped",      "SKIP",           "blocked",    "blocked: no power",
              "n/a",          "N.A.",           "-",          "–",
              "--",           "not run",        "not tested", "untested",
              "pending",      "todo",           "to do",      "aborted",
              "übersprungen", "nicht getestet", "bloqué",     "non testé",
              "omitido",      "未実施",         "スキップ"},
             TestResult::not_run);
  expect_all({"done", "Tested", "erledigt", "fait", "hecho", "済"}, TestResult::done);
  expect_all({"", " ", "\u3000"}, TestResult::none);
}

}  // namespace
}  // namespace changeover::results_test
