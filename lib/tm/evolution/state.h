/// The state of a run on disk, from which it continues to the same bytes: a folder with the last
/// mesh, which also holds, as comments, the settings of the run and what its loop has to remember;
/// and files that the loop adds. Each save replaces one file at once, so a run may be killed at any
/// moment. Columns and coordinates are kept exactly as long as they are rounded as written
/// (mesh_io.h).
///
/// Throws OutputError where the folder or a file cannot be written, InputError where what is there
/// is no state.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "tm/io/document.h"

namespace transformesh {

/// What a loop remembers between two iterations, by name: words without spaces.
using Values = std::map<std::string, double>;
double value_or(const Values& values, const std::string& key, double otherwise);

struct State {
  std::string settings;  ///< in one line
  std::size_t iteration = 0;
  bool is_paused = false;  ///< stopped by its limit of iterations, not interrupted
  Values values;
};

struct SavedState : State {
  Document document;
};

class StateFolder {
 public:
  explicit StateFolder(std::string path) : path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  /// Nothing where no state was saved.
  std::optional<SavedState> load() const;
  /// Makes the folder where it is missing.
  void save(const Document& document, const State& state) const;

  void add(const std::string& name, const std::string& bytes) const;
  std::optional<std::string> find(const std::string& name) const;

  /// Removes the folder and its files, which are all the run's own.
  void remove() const;

 private:
  std::string file(const std::string& name) const { return path_ + '/' + name; }

  std::string path_;
};

/// "a 1 b 0.5", and back. Throws InputError for anything else.
std::string text_of(const Values& values);
Values values_of(const std::string& text);

/// The settings as one line of a comment.
std::string one_line(std::string text);

}  // namespace transformesh
