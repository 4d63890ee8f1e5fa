/// What a run of a loop leaves on disk while it goes on: its state (state.h), a CSV file with a row
/// for each iteration, and meshes as frames. All of an iteration is written before its state is, so
/// that a run that continues repeats what was not finished; the CSV file then loses the rows of
/// iterations that the state does not know.
///
/// Throws OutputError where something cannot be written. Deterministic but for times in rows.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tm/evolution/state.h"

namespace transformesh {

/// Empty names: not kept.
struct RecordOptions {
  std::string state;       ///< folder
  std::string settings;    ///< what determines the result: a run that continues must have the same
  bool resume = false;     ///< continue from the state where there is one
  bool restart = false;    ///< throw the state of an interrupted run away
  std::string frames;      ///< folder for frame-00000.ply and so on
  std::size_t every = 10;  ///< iterations from one frame to the next
  std::string csv;
  bool keep_state_at_end = false;  ///< the caller calls remove_state() once the result is safe
};

class Record {
 public:
  /// Looks for a state and changes nothing. Throws UsageError where the state is of a run with
  /// other settings, or of an interrupted one that is neither to be continued nor thrown away.
  explicit Record(RecordOptions options = {});

  /// The last iteration that was completed, earlier runs included.
  std::size_t iteration() const { return iteration_; }
  /// The state from which the run continues, if it does.
  const std::optional<SavedState>& resumed() const { return resumed_; }
  /// A further file of the state: kept from begin() on, found when the run continues.
  void add(const std::string& name, std::string bytes) {
    added_.emplace_back(name, std::move(bytes));
  }
  std::optional<std::string> find(const std::string& name) const;

  /// To be called once, before the first iteration, with the header of the CSV file and the values
  /// of iteration 0. Where the run continues, these are not looked at.
  void begin(const Document& document, const std::string& csv_header, const Values& values);
  void keep(const Document& document, std::size_t iteration, const std::string& row,
            const Values& values);
  /// The limit of iterations was reached: the state stays, and is not that of an interrupted run.
  void pause(const Document& document, std::size_t iteration, const Values& values);
  /// The loop has come to its end, or to nothing.
  void end();
  void remove_state() const;

 private:
  void keep_frame(const Document& document, std::size_t iteration) const;
  void save(const Document& document, const State& state) const;

  RecordOptions options_;
  std::optional<StateFolder> folder_;
  std::optional<SavedState> resumed_;
  std::size_t iteration_ = 0;
  std::vector<std::pair<std::string, std::string>> added_;
};

}  // namespace transformesh
