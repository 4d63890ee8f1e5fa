/// The variables that a loop keeps from one iteration to the next: numbers by name, exactly. A loop
/// names its variables in one place, which both keeps and restores them:
///
///     void remember(LoopState& loop_state) override { loop_state("best", best_)("idle", idle_); }
#pragma once

#include <map>
#include <string>

namespace transformesh {

class LoopState {
 public:
  /// Keeps what is named.
  LoopState() = default;
  /// Restores what is named, from what text() returned. Throws InputError for anything else.
  explicit LoopState(const std::string& text);

  /// A number, a count, a truth or an enumerator; the name is a word. Throws InputError where it is
  /// to be restored and was not kept.
  template <typename Number>
  LoopState& operator()(const std::string& name, Number& value) {
    if (restores_) {
      value = static_cast<Number>(kept(name));
    } else {
      values_[name] = static_cast<double>(value);
    }
    return *this;
  }

  /// In one line: "best 0.5 idle 3".
  std::string text() const;

 private:
  double kept(const std::string& name) const;

  bool restores_ = false;
  std::map<std::string, double> values_;
};

}  // namespace transformesh
