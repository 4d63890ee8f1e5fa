#include "tm/evolution/memory.h"

#include <charconv>
#include <sstream>

#include "tm/support/error.h"
#include "tm/support/length.h"

namespace transformesh {
namespace {

double number_of(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && rest == end) return value;
  throw InputError("a state holds '" + text + "', which is no number; begin anew with --restart");
}

}  // namespace

Memory::Memory(const std::string& text) : restores_(true) {
  std::istringstream words(text);
  for (std::string name, number; words >> name >> number;) values_[name] = number_of(number);
}

double Memory::kept(const std::string& name) const {
  const auto found = values_.find(name);
  if (found != values_.end()) return found->second;
  throw InputError("the state of the run is that of another loop, as it holds no '" + name +
                   "'; begin anew with --restart");
}

std::string Memory::text() const {
  std::string text;
  for (const auto& [name, value] : values_)
    text += (text.empty() ? "" : " ") + name + ' ' + shortest_text(value);
  return text;
}

}  // namespace transformesh
