#include "cli/spelling.hpp"

#include <cstddef>

#include "core/spelling.hpp"

namespace changeover::cli {

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const auto nearest = nearest_word(word, known);
  return nearest ? ", did you mean " + *nearest + "?" : std::string();
}

std::string with_help(const std::string& message, const std::string& verb) {
  return message + (message.ends_with('?') ? " see changeover" : "; see changeover") + verb +
         " --help";
}

std::string as_typed(std::string name) {
  if (const std::size_t hyphen = name.find('-'); hyphen != std::string::npos) {
    name[hyphen] = ' ';
  }
  return name;
}

}  // namespace changeover::cli
