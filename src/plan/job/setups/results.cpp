#include "plan/job/setups/results.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/job.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

using ResultWords = std::vector<std::string>;

bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }
// U+00C0 to U+00FF without accents; × and ÷ become blanks.
constexpr std::string_view latin =
    "aaaaaaaceeeeiiiidnooooo ouuuuytsaaaaaaaceeeeiiiidnooooo ouuuuyty";

// Lower case without accents, wide forms as normal ones, signs as words, other punctuation as
// blanks.
std::string folded(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    const std::string_view bytes = text.substr(0, point.bytes);
    text.remove_prefix(point.bytes);
    char32_t c = point.value;
    const auto within = [&](char32_t first, char32_t last) { return c >= first && c <= last; };
    if (within(0xff01, 0xff5e)) {
      c -= 0xfee0;
    }
    if (within(0x300, 0x36f) || within(0xfe00, 0xfe0f)) {
      continue;  // an accent, or a variation selector
    }
    if (c == 0xd7 || within(0x2190, 0x2bff) || within(0x1f300, 0x1faff)) {
      result += " " + std::string(bytes) + " ";
    } else if (within(0xc0, 0xff)) {
      result += latin[c - 0xc0];
    } else if (within(0x80, 0xbf) || within(0x2000, 0x206f) || within(0x3000, 0x303f)) {
      result += within(0x2010, 0x2015) ? '-' : ' ';
    } else if (within('A', 'Z')) {
      result += static_cast<char>(c - 'A' + 'a');
    } else if (c < 0x80 && point.valid) {
      result += static_cast<char>(c);
    } else {
      result += bytes;
    }
  }
  return result;
}

// Splits at all characters but letters; initials at the beginning are one word: "n.i.O." is "nio".
ResultWords result_words_of(std::string_view text) {
  ResultWords words;
  bool within = false;
  for (const char c : text) {
    const bool part = is_small_letter(c) || (static_cast<unsigned char>(c) & 0x80U) != 0;
    if (part && !within) {
      words.emplace_back();
    }
    if (part) {
      words.back() += c;
    }
    within = part;
  }
  const auto initials =
      std::ranges::find_if(words, [](const std::string& word) { return word.size() != 1; });
  if (initials - words.begin() > 1) {
    std::string joined;
    std::for_each(words.begin(), initials, [&](const std::string& word) { joined += word; });
    words.erase(words.begin() + 1, initials);
    words.front() = joined;
  }
  return words;
}

// Whether these, with a blank before and after each, have the word.
bool is_one_of(const std::string& word, std::string_view all) {
  return all.find(" " + word + " ") != std::string_view::npos;
}

template <std::size_t N>
bool begins_with(const std::string& word, const std::array<std::string_view, N>& all) {
  return std::ranges::any_of(
      all, [&](std::string_view beginning) { return word.starts_with(beginning); });
}

// The words of English, German, French, Spanish, Italian, Portuguese, Dutch, Japanese, Chinese and
// Korean.
bool is_pass(const std::string& word) {
  constexpr auto others = std::to_array<std::string_view>(
      {"passiv", "passw", "passag", "passen", "passpo", "passth", "passba", "passat"});
  constexpr std::string_view all =
      " ok okay okey io success successful succeeded succeeds bestanden erfolg erfolgreich"
      " reussi reussie reussite succes conforme aprobado aprobada exito correcto correcta"
      " pasa superato superata riuscito riuscita successo aprovado aprovada sucesso geslaagd"
      " goedgekeurd 合格 良 良好 正常 成功 通过 通過 합격 통과 성공 정상 ✓ ✔ ✅ ☑ 👍 akzeptiert ";
  return (word.starts_with("pass") && !begins_with(word, others)) || is_one_of(word, all);
}

bool is_fail(const std::string& word) {
  constexpr auto others = std::to_array<std::string_view>(
      {"failover", "failsafe", "failback", "failproof", "failless"});
  constexpr std::string_view all =
      " nok ko ng nio error errors errored err crash crashed crashes hang hangs hung broken"
      " dead died defective timeout reject rejected fehler fehlgeschlagen fehlerhaft defekt"
      " durchgefallen kaputt ausfall ausgefallen echec echoue echouee erreur panne defaut"
      " fallo falla fallido fallida rechazado rechazada fallito fallita errore guasto"
      " respinto falha falhou erro reprovado reprovada gefaald mislukt fout afgekeurd ✗ ✘ ✕ ✖"
      " × ❌ 👎 nichtbestanden misslungen ";
  constexpr auto beginnings = std::to_array<std::string_view>(
      {"不合格", "不良", "不可", "失敗", "失败", "異常", "异常", "故障", "未通过", "未通過", "错误",
       "エラー", "불합격", "실패", "오류"});
  constexpr auto none = std::to_array<std::string_view>({"なし", "無", "无", "없"});
  const bool has_none = std::ranges::any_of(
      none, [&](std::string_view each) { return word.find(each) != std::string::npos; });
  return (word.starts_with("fail") && !begins_with(word, others)) || is_one_of(word, all) ||
         (begins_with(word, beginnings) && !has_none);
}

bool is_not_run(const std::string& word) {
  constexpr std::string_view all =
      " skip skipped block blocked untested pending todo tbd postponed deferred abort aborted"
      " cancelled canceled ubersprungen blockiert ungetestet ausstehend abgebrochen"
      " verschoben ignore bloque saute reporte annule omitido omitida saltado bloqueado"
      " pendiente pendente cancelado saltato bloccato sospeso ignorado pulado overgeslagen"
      " geblokkeerd スキップ 保留 跳过 건너뜀 ";
  constexpr auto beginnings =
      std::to_array<std::string_view>({"未実施", "未実行", "未試験", "未执行", "未测试", "阻塞"});
  return is_one_of(word, all) || begins_with(word, beginnings);
}

// The result if it is only this word.
TestResult of_one_word(const std::string& word) {
  constexpr std::string_view pass =
      " p yes good true wahr vrai verdadero vero verdadeiro waar ja oui si sim bon bien gut goed"
      " bom buono ";
  constexpr std::string_view fail =
      " f no bad false falsch faux falso onwaar nein non nee nao mal mauvais schlecht ";
  constexpr std::string_view done =
      " done ran tested complete completed finished executed erledigt getestet fertig fait"
      " faite termine hecho terminado fatto feito gedaan 済 済み 完了 完成 ";
  return is_one_of(word, pass)   ? TestResult::pass
         : is_one_of(word, fail) ? TestResult::fail
         : is_one_of(word, done) ? TestResult::done
         : word == "na"          ? TestResult::not_run
                                 : TestResult::unread;
}

bool negates(const std::string& word) {
  constexpr std::string_view all = " not no non nicht pas ne niet nao didn doesn ";
  return is_one_of(word, all);
}

// "not ok", "not run", "nicht bestanden"; "no error" may mean success or introduce a failure.
TestResult of_negated(const ResultWords& words) {
  constexpr std::string_view was_run =
      " run tested done executed performed started applicable getestet durchgefuhrt"
      " ausgefuhrt gelaufen teste execute realise probado ejecutado eseguito testado"
      " executado uitgevoerd ";
  for (std::size_t i = 1; i < std::min<std::size_t>(words.size(), 3); ++i) {
    if (is_pass(words[i]) || words[i] == "good" || words[i] == "valid") {
      return TestResult::fail;
    }
    if (is_one_of(words[i], was_run)) {
      return TestResult::not_run;
    }
  }
  return TestResult::unread;
}

// Whether the words after a success qualify it.
bool takes_back(const ResultWords& words, std::string_view text) {
  constexpr std::string_view hedges =
      " but until till then except aber bis dann ausser mais sauf puis pero hasta salvo poi"
      " maar hardly almost ";
  return text.find('?') != std::string_view::npos || (words.size() > 1 && negates(words[1])) ||
         std::any_of(words.begin() + 1, words.end(), [&](const std::string& word) {
           return is_one_of(word, hedges) || is_fail(word);
         });
}

// "error-free", "fail safe": no failures.
bool is_of_no_failure(const ResultWords& words) {
  constexpr std::string_view second = " free frei safe over proof less ";
  return words.size() > 1 && is_one_of(words[1], second);
}

}  // namespace

TestResult result_of(std::string_view result) {
  const std::string text = folded(result);
  if (text.find_first_not_of(' ') == std::string::npos) {
    return TestResult::none;
  }
  if (text.find_first_not_of(" -") == std::string::npos) {
    return TestResult::not_run;
  }
  const std::size_t first = text.find_first_not_of(" \"'([{<*#.:;=>|/\\_");
  if (first == std::string::npos || is_digit(text[first])) {
    return TestResult::unread;  // a measurement, the number of a fault, "0 errors"
  }
  ResultWords words = result_words_of(text);
  if (words.size() > 1 && (words.front() == "did" || words.front() == "does")) {
    words.erase(words.begin());
  }
  if (words.empty() || text[first] == '!' || text[first] == '-' || text[first] == '+') {
    return TestResult::unread;
  }
  if (words.size() > 1 && negates(words.front())) {
    return of_negated(words);
  }
  if (is_pass(words.front())) {
    return takes_back(words, text) ? TestResult::unread : TestResult::pass;
  }
  if (is_fail(words.front())) {
    return is_of_no_failure(words) ? TestResult::unread : TestResult::fail;
  }
  if (is_not_run(words.front()) || (words.size() == 2 && words[0] == "to" && words[1] == "do")) {
    return TestResult::not_run;
  }
  const bool alone = words.size() == 1 && text.find('?') == std::string::npos &&
                     std::ranges::none_of(text, is_digit);
  return alone ? of_one_word(words.front()) : TestResult::unread;
}

bool was_run(std::string_view result) {
  const TestResult said = result_of(result);
  return said != TestResult::none && said != TestResult::not_run;
}

}  // namespace changeover
