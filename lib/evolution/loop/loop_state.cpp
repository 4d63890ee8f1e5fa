#include "evolution/loop/loop_state.h"

#include <sstream>

#include "support/error.h"
#include "support/number.h"

namespace transformesh {

LoopState::LoopState(const std::string& text) : restores_(true) {
  std::istringstream words(text);
  for (std::string name, number; words >> name >> number;) {
    const auto value = number_in<double>(number);
    if (!value)
      throw InputError("a state holds '" + number +
                       "', which is no number; begin anew with --restart");
    values_[name] = *value;
  }
}

double LoopState::kept(const std::string& name) const {
  const auto found = values_.find(name);
  if (found != values_.end()) return found->second;
  throw InputError("the state of the run is that of another loop, as it holds no '" + name +
                   "'; begin anew with --restart");
}

std::string LoopState::text() const {
  std::string text;
  for (const auto& [name, value] : values_)
    text += (text.empty() ? "" : " ") + name + ' ' + shortest_text(value);
  return text;
}

}  // namespace transformesh
