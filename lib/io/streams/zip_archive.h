/// ZIP archives in memory, by minizip. Reference: PKWARE APPNOTE 6.3 (ISO/IEC 21320-1).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/streams/expand.h"
#include "io/streams/source.h"

namespace transformesh {

/// True if the bytes start with the signature of ZIP.
bool is_zip(std::string_view bytes);

class ZipReader {
 public:
  /// Opens an archive. Throws InputError if the bytes have no directory of files.
  ZipReader(const Source& source, ExpansionBudget& budget);
  ~ZipReader();
  ZipReader(const ZipReader&) = delete;
  ZipReader& operator=(const ZipReader&) = delete;

  /// Returns the bytes of a file. Returns nothing if there is no such file. Names are
  /// case-insensitive. Throws InputError for damaged data, and if the files add up to more than the
  /// ExpansionBudget.
  std::optional<std::string> read(const std::string& name) const;

 private:
  struct State;
  const Source& source_;
  ExpansionBudget& budget_;
  std::unique_ptr<State> state_;
};

class ZipWriter {
 public:
  ZipWriter();
  ~ZipWriter();
  ZipWriter(const ZipWriter&) = delete;
  ZipWriter& operator=(const ZipWriter&) = delete;

  /// Appends a compressed file. Its date is 1980, so that the same files give the same bytes.
  void add(const std::string& name, std::string_view bytes);
  /// Ends the archive and returns its bytes.
  std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace transformesh
