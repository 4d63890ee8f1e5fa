#include "tm/evolution/record.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "tm/io/atomic_file.h"
#include "tm/io/mesh_io.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

[[noreturn]] void throw_not_written(const std::string& path) {
  throw OutputError("cannot write '" + path + "': " + std::strerror(errno));
}

// Whole lines only: a line is one write.
void append_line(const std::string& path, const std::string& line, int flags) {
  const std::string bytes = line + '\n';
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
  if (file < 0) throw_not_written(path);
  const bool is_written = write(file, bytes.data(), bytes.size()) == std::ssize(bytes);
  const int reason = errno;
  const bool is_closed = close(file) == 0;
  if (!is_written) errno = reason;
  if (!is_written || !is_closed) throw_not_written(path);
}

// The header, and the rows of iterations up to the last one.
std::string rows_until(std::ifstream& csv, std::size_t last) {
  std::string kept;
  for (std::string line; std::getline(csv, line);) {
    if (kept.empty() || std::strtoull(line.c_str(), nullptr, 10) <= last) kept += line + '\n';
  }
  return kept;
}

void resume_csv(const std::string& path, const std::string& header, std::size_t last) {
  std::ifstream csv(path);
  const std::string rows = csv ? rows_until(csv, last) : std::string();
  if (rows.empty()) return append_line(path, header, O_TRUNC);
  write_file(path, rows);
}

std::string frame_name(std::size_t iteration) {
  const std::string digits = std::to_string(iteration);
  return "frame-" + std::string(5 - std::min<std::size_t>(digits.size(), 5), '0') + digits + ".ply";
}

void refuse_other_settings(const SavedState& state, const RecordOptions& options) {
  if (state.settings == options.settings) return;
  throw UsageError("'" + options.state + "' is of a run with other settings (" + state.settings +
                   "); leave out --resume");
}

void refuse_interrupted(const SavedState& state, const RecordOptions& options) {
  if (state.is_paused || options.restart) return;
  throw UsageError("'" + options.state +
                   "' is the state of an interrupted run: continue it with --resume, or throw it "
                   "away with --restart");
}

}  // namespace

Record::Record(RecordOptions options) : options_(std::move(options)) {
  options_.settings = one_line(options_.settings);
  if (options_.state.empty()) return;
  folder_.emplace(options_.state);
  std::optional<SavedState> state = folder_->load();
  if (!state) return;
  if (options_.resume) {
    refuse_other_settings(*state, options_);
    resumed_ = std::move(state);
    iteration_ = resumed_->iteration;
  } else {
    refuse_interrupted(*state, options_);
  }
}

std::optional<std::string> Record::find(const std::string& name) const {
  return resumed_ ? folder_->find(name) : std::nullopt;
}

void Record::save(const Document& document, const State& state) const {
  if (folder_) folder_->save(document, state);
}

void Record::begin(const Document& document, const std::string& csv_header, const Values& values) {
  if (resumed_) {
    if (!options_.csv.empty()) resume_csv(options_.csv, csv_header, resumed_->iteration);
    return;
  }
  if (folder_) {
    folder_->remove();
    for (const auto& [name, bytes] : std::exchange(added_, {})) folder_->add(name, bytes);
  }
  if (!options_.csv.empty()) append_line(options_.csv, csv_header, O_TRUNC);
  keep_frame(document, 0);
  save(document, {options_.settings, 0, false, values});
}

void Record::keep(const Document& document, std::size_t iteration, const std::string& row,
                  const Values& values) {
  if (!options_.csv.empty()) append_line(options_.csv, row, O_APPEND);
  keep_frame(document, iteration);
  save(document, {options_.settings, iteration, false, values});
  iteration_ = iteration;
}

void Record::pause(const Document& document, std::size_t iteration, const Values& values) {
  save(document, {options_.settings, iteration, true, values});
}

void Record::end() {
  if (!options_.keep_state_at_end) remove_state();
}

void Record::remove_state() const {
  if (folder_) folder_->remove();
}

void Record::keep_frame(const Document& document, std::size_t iteration) const {
  if (options_.frames.empty() || iteration % options_.every != 0) return;
  std::error_code error;
  std::filesystem::create_directories(options_.frames, error);
  if (error) {
    throw OutputError("cannot make the folder '" + options_.frames + "': " + error.message());
  }
  write_file(options_.frames + '/' + frame_name(iteration), write_mesh(document).bytes);
}

}  // namespace transformesh
