#include "tool.h"

#include <limits>

#include "implementation.h"

namespace transformesh::tool {

Program::Program(std::string name, std::string synopsis, std::string summary)
    : implementation_(std::make_unique<Implementation>(
          Description{std::move(name), std::move(synopsis), std::move(summary), "", "", {}})) {}

Program::~Program() = default;

void Program::flag(const std::string& option, bool* value, const std::string& help) {
  implementation_->table.add(flag_option(option, value, help));
}

void Program::number(const std::string& option, double* value, double minimum, double maximum,
                     const std::string& help) {
  implementation_->table.add(number_option(option, value, minimum, maximum, help));
}

void Program::integer(const std::string& option, long* value, long minimum, long maximum,
                      const std::string& help) {
  implementation_->table.add(integer_option(option, value, minimum, maximum, help));
}

void Program::integer(const std::string& option, std::optional<long>* value, long minimum,
                      long maximum, const std::string& help) {
  implementation_->table.add(integer_option(option, value, minimum, maximum, help));
}

void Program::length(const std::string& option, Length* value, const std::string& help,
                     bool may_be_negative) {
  implementation_->table.add(length_option(option, value, help, may_be_negative));
}

void Program::length(const std::string& option, std::optional<Length>* value,
                     const std::string& help, bool may_be_negative) {
  implementation_->table.add(length_option(option, value, help, may_be_negative));
}

void Program::text(const std::string& option, std::string* value, const std::string& placeholder,
                   const std::string& help) {
  implementation_->table.add(text_option(option, value, placeholder, help));
}

void Program::choice(const std::string& option, std::string* value, std::vector<std::string> names,
                     const std::string& help) {
  implementation_->table.add(choice_option(option, value, std::move(names), help));
}

void Program::numbers(const std::string& option, std::vector<double>* value,
                      const std::string& placeholder, const std::string& help) {
  implementation_->table.add(numbers_option(option, value, placeholder, help));
}

void Program::words(std::vector<std::string>* values, const std::string& placeholder,
                    const std::string& help) {
  implementation_->words = values;
  implementation_->description.words = placeholder;
  implementation_->description.words_help = help;
}

void Program::seed(long* value) {
  integer("seed", value, 0, std::numeric_limits<long>::max(), "seed of the random numbers");
}

void Program::keep_out_of_provenance(const std::string& option) {
  if (Option* found = implementation_->table.find(option)) found->affects_result = false;
}

void Program::require(const std::string& option) { implementation_->required.push_back(option); }

void Program::print_only(const std::string* key) { implementation_->only_key = key; }

void Program::epilog(std::string text) {
  implementation_->description.epilogs.push_back(std::move(text));
}

}  // namespace transformesh::tool
