#include "evolution/loop/loop_state.h"

#include <sstream>

#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {

LoopState::LoopState(const std::string& text) : restores_(true) {
  std::istringstream words(text);
  for (std::string name, number; words >> name >> number;) {
    const auto value = number_in<double>(number);
    if (!value)
      throw InputError(ErrorKind::bad_state,
                       "a state holds '" + number + "', which is not a number");
    values_[name] = *value;
  }
}

double LoopState::kept(const std::string& name) const {
  const auto found = values_.find(name);
  if (found != values_.end()) return found->second;
  throw InputError(ErrorKind::bad_state,
                   "the state of the run belongs to another program: it lacks '" + name + "'");
}

std::string LoopState::text() const {
  std::string text;
  for (const auto& [name, value] : values_)
    text += (text.empty() ? "" : " ") + name + ' ' + shortest_text(value);
  return text;
}

}  // namespace transformesh
