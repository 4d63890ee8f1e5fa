/// Records a run of a loop on disk: its state, a CSV file with a row per iteration, a CSV file with
/// a row per event, and meshes as frames. The state is a folder with the last mesh and with files
/// that the loop adds. Comments of the mesh hold the settings of the run and the LoopState.
///
/// Files are replaced atomically, and the state of an iteration is written after its other files.
/// Therefore a run may be killed at any time. A continued run repeats the unfinished iteration,
/// with the same bytes, and removes CSV rows of iterations after the recorded state.
///
/// Columns and coordinates are restored exactly if they are rounded as written (mesh_io.h). Throws
/// OutputError if a file cannot be written. Deterministic, except for times in rows.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evolution/loop/folder_lock.h"
#include "evolution/loop/loop_state.h"
#include "io/streams/line_file.h"
#include "transformesh/document.h"
#include "transformesh/loop.h"

namespace transformesh {

/// Beginning of the names of frames, before the number of the iteration.
inline constexpr std::string_view frame_prefix = "frame-";

struct SavedState {
  Document document;
  /// One line of text with the options of the run, to recognize a run with other options.
  std::string settings;
  std::size_t iteration = 0;
  /// True if the run reached its limit of iterations, so that it was not interrupted.
  bool is_paused = false;
  LoopState loop_state;
};

class Record {
 public:
  /// Looks for a recorded state, and locks its folder if `options` require this. Throws UsageError
  /// if the run is to be continued, but the state has other settings. Throws UsageError if the
  /// state is of an interrupted run and the options neither continue nor discard it. Throws
  /// InputError if the files are not a recorded state, and OutputError if another process holds the
  /// lock.
  explicit Record(RecordOptions options = {});

  bool has_state() const { return !options_.state.empty(); }
  bool has_events() const { return !options_.events.empty(); }
  /// Returns the number of completed iterations, including those before the run was continued.
  std::size_t iteration() const { return iteration_; }
  /// Returns the recorded state from which the run continues. Empty if the run starts from the
  /// beginning.
  const std::optional<SavedState>& resumed() const { return resumed_; }
  /// Adds a file to the recorded state. begin() writes the file. If the run is continued, find()
  /// returns its bytes.
  void add(const std::string& name, std::string bytes) {
    added_.emplace_back(name, std::move(bytes));
  }
  std::optional<std::string> find(const std::string& name) const;

  /// Removes the recorded state of an earlier run, unless that run is continued. begin() does this,
  /// too.
  void forget_earlier_state() const;

  /// Call once, before the first iteration. `csv_header` is the header of the CSV file, and
  /// `loop_state` has the variables before iteration 1. If the run is continued, `document` and
  /// `loop_state` are ignored.
  void begin(const Document& document, const std::string& csv_header, const LoopState& loop_state);
  /// Records a completed iteration: its state, its CSV row and its event rows.
  void keep(const Document& document, std::size_t iteration, const std::string& row,
            const LoopState& loop_state, const std::vector<std::string>& event_rows = {});
  /// Call if the limit of iterations is reached. The state remains on disk and is marked as not
  /// interrupted.
  void pause(const Document& document, const LoopState& loop_state) const {
    save(document, iteration_, loop_state, true);
  }
  /// Call if the loop has ended. Removes the state from disk, unless the options keep it.
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
