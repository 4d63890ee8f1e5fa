/// What a run of a loop leaves on disk while it goes on: its state, a CSV file with a row for each
/// iteration, one with a row for each event, and meshes as frames. The state is a folder with the
/// last mesh, whose comments hold the settings of the run and what its loop remembers, and files
/// that the loop adds. Each of these is replaced at once and all of an iteration is written before
/// its state is, so that a run may be killed at any moment: one that continues repeats what was not
/// finished, to the same bytes, and the CSV files lose the rows of iterations that the state does
/// not know.
///
/// Columns and coordinates are kept exactly as long as they are rounded as written (mesh_io.h).
/// Throws OutputError where something cannot be written. Deterministic but for times in rows.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evolution/loop/folder_lock.h"
#include "evolution/loop/loop_state.h"
#include "io/streams/line_file.h"
#include "transformesh/document.h"
#include "transformesh/loop.h"

namespace transformesh {

struct SavedState {
  Document document;
  std::string settings;  ///< in one line
  std::size_t iteration = 0;
  bool is_paused = false;  ///< stopped by its limit of iterations, not interrupted
  LoopState loop_state;
};

class Record {
 public:
  /// Looks for a state and changes nothing but that its folder is locked, if so wanted. Throws
  /// UsageError where the state is of a run with other settings, or of an interrupted one that is
  /// neither to be continued nor thrown away; InputError where what is there is no state;
  /// OutputError where another process has it.
  explicit Record(RecordOptions options = {});

  bool has_state() const { return !options_.state.empty(); }
  bool has_events() const { return !options_.events.empty(); }
  /// The last iteration that was completed, earlier runs included.
  std::size_t iteration() const { return iteration_; }
  /// The state from which the run continues, if it does.
  const std::optional<SavedState>& resumed() const { return resumed_; }
  /// A further file of the state: kept from begin() on, found when the run continues.
  void add(const std::string& name, std::string bytes) {
    added_.emplace_back(name, std::move(bytes));
  }
  std::optional<std::string> find(const std::string& name) const;

  /// Of a run that begins: throws away what is there of an earlier one, which begin() does as well.
  void forget_earlier_state() const;

  /// To be called once, before the first iteration, with the header of the CSV file and the memory
  /// of iteration 0. Where the run continues, the document and the memory are not looked at.
  void begin(const Document& document, const std::string& csv_header, const LoopState& loop_state);
  void keep(const Document& document, std::size_t iteration, const std::string& row,
            const LoopState& loop_state, const std::vector<std::string>& event_rows = {});
  /// The limit of iterations was reached: the state stays, and is not that of an interrupted run.
  void pause(const Document& document, const LoopState& loop_state) const {
    save(document, iteration_, loop_state, true);
  }
  /// The loop has come to its end.
  void end() const {
    if (!options_.keep_state_at_end) remove_state();
  }
  void remove_state() const { transformesh::remove_state(options_.state); }

 private:
  std::shared_ptr<const LineFile> opened(const std::string& path, const std::string& header) const;
  void keep_frame(const Document& document, std::size_t iteration) const;
  void save(const Document& document, std::size_t iteration, LoopState loop_state,
            bool is_paused = false) const;

  RecordOptions options_;
  std::shared_ptr<const FolderLock> lock_;
  std::optional<SavedState> resumed_;
  std::shared_ptr<const LineFile> rows_, event_rows_;
  std::size_t iteration_ = 0;
  std::vector<std::pair<std::string, std::string>> added_;
};

}  // namespace transformesh
