/// The variables of a loop that must survive an interruption: numbers with names, stored exactly. A
/// loop lists its variables in one function, which both stores and restores them:
///
///     void remember(LoopState& loop_state) override { loop_state("best", best_)("idle", idle_); }
#pragma once

#include <map>
#include <string>

namespace transformesh {

class LoopState {
 public:
  /// Creates a state that stores variables: loop_state(name, variable) saves the variable's value.
  LoopState() = default;
  /// Creates a state that restores variables from a result of text(): loop_state(name, variable)
  /// sets the variable. Throws InputError for any other text.
  explicit LoopState(const std::string& text);

  /// Stores or restores a number, a bool or an enumerator, depending on the constructor. The name
  /// must be one word. Throws InputError if the name is not found when restoring.
  template <typename Number>
  LoopState& operator()(const std::string& name, Number& value) {
    if (restores_) {
      value = static_cast<Number>(kept(name));
    } else {
      values_[name] = static_cast<double>(value);
    }
    return *this;
  }

  /// Returns all names and values in one line, such as "best 0.5 idle 3".
  std::string text() const;

 private:
  double kept(const std::string& name) const;

  bool restores_ = false;
  std::map<std::string, double> values_;
};

}  // namespace transformesh
