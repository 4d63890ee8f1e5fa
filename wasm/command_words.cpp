/// Splits command lines as Boost.ProgramOptions does, which Emscripten has no archive of.
/// tests/lib/tools/command_words_test.cpp compares both.
#include "frame/command_words.h"

#include <algorithm>
#include <cstddef>

#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

[[noreturn]] void throw_missing(const std::string& name) {
  throw UsageError("--" + name + " needs a value");
}

class Splitter {
 public:
  Splitter(const std::vector<std::string>& arguments, const OptionSet& options)
      : arguments_(arguments), options_(options) {}

  std::vector<CommandWord> split() {
    while (next_ < arguments_.size()) take(arguments_[next_++]);
    return std::move(words_);
  }

 private:
  void take(const std::string& word) {
    if (word == "--") return take_rest();
    if (word.starts_with("--")) return take_long(word);
    if (word.size() > 1 && word[0] == '-') return take_short(word);
    words_.push_back({nullptr, word});
  }

  void take_rest() {
    for (; next_ < arguments_.size(); ++next_) words_.push_back({nullptr, arguments_[next_]});
  }

  void take_long(const std::string& word) {
    const std::size_t end = word.find('=');
    const std::string name = word.substr(2, end == std::string::npos ? end : end - 2);
    if (end + 1 == word.size()) throw_missing(name);
    if (name.empty()) return words_.push_back({nullptr, word.substr(end + 1)});
    const Option* option = with_name(name);
    if (option == nullptr) return words_.push_back({nullptr, word, true});
    if (end == std::string::npos) return take_value(*option);
    if (option->is_flag()) throw UsageError("--" + name + " takes no value");
    words_.push_back({option, word.substr(end + 1)});
  }

  // Letters of flags, then perhaps an option whose value is the rest of the word.
  void take_short(const std::string& word) {
    for (std::size_t i = 1; i < word.size(); ++i) {
      const Option* option = with_letter(word[i]);
      if (option == nullptr) return words_.push_back({nullptr, word, true});
      if (!option->is_flag() && i + 1 < word.size())
        return words_.push_back({option, word.substr(i + 1)});
      take_value(*option);
    }
  }

  void take_value(const Option& option) {
    if (option.is_flag()) return words_.push_back({&option, ""});
    if (next_ == arguments_.size() || is_option(arguments_[next_])) throw_missing(option.name());
    words_.push_back({&option, arguments_[next_++]});
  }

  // `--output -q` and `--output --name=`: the value was forgotten.
  bool is_option(const std::string& word) const {
    if (word.starts_with("--")) return word.find('=') + 1 == word.size();
    return word.size() == 2 && word[0] == '-' && with_letter(word[1]) != nullptr;
  }

  const Option* with_name(const std::string& name) const {
    const auto at = std::find_if(options_.begin(), options_.end(),
                                 [&](const Option& option) { return option.name() == name; });
    return at == options_.end() ? nullptr : &*at;
  }

  const Option* with_letter(char letter) const {
    const std::string ending{',', letter};
    const auto at = std::find_if(options_.begin(), options_.end(), [&](const Option& option) {
      return option.names.ends_with(ending);
    });
    return at == options_.end() ? nullptr : &*at;
  }

  const std::vector<std::string>& arguments_;
  const OptionSet& options_;
  std::size_t next_ = 0;
  std::vector<CommandWord> words_;
};

}  // namespace

std::vector<CommandWord> split_command(const std::vector<std::string>& arguments,
                                       const OptionSet& options) {
  return Splitter(arguments, options).split();
}

}  // namespace transformesh::tool
