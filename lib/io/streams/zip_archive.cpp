#include "io/streams/zip_archive.h"

#include <minizip/unzip.h>
#include <minizip/zip.h>

#include <algorithm>
#include <limits>
#include <new>

namespace transformesh {

/// A file in memory for minizip: reads from `given`, or writes to `written`.
struct ArchiveInMemory {
  std::string_view given;
  std::string written;
  bool is_written = false;
  std::size_t place = 0;

  std::size_t size() const { return is_written ? written.size() : given.size(); }
};

namespace {

ArchiveInMemory& memory_file(voidpf stream) { return *static_cast<ArchiveInMemory*>(stream); }

voidpf open_memory(voidpf file, const void* /*name*/, int /*mode*/) { return file; }

uLong read_memory(voidpf /*opaque*/, voidpf stream, void* to, uLong size) {
  ArchiveInMemory& file = memory_file(stream);
  const std::string_view bytes = file.is_written ? file.written : file.given;
  const std::string_view part = bytes.substr(std::min(file.place, bytes.size()), size);
  part.copy(static_cast<char*>(to), part.size());
  file.place += part.size();
  return part.size();
}

uLong write_memory(voidpf /*opaque*/, voidpf stream, const void* from, uLong size) {
  ArchiveInMemory& file = memory_file(stream);
  file.written.resize(std::max(file.written.size(), file.place + size));
  std::copy_n(static_cast<const char*>(from), size, file.written.data() + file.place);
  file.place += size;
  return size;
}

ZPOS64_T place_in_memory(voidpf /*opaque*/, voidpf stream) { return memory_file(stream).place; }

long seek_memory(voidpf /*opaque*/, voidpf stream, ZPOS64_T offset, int origin) {
  ArchiveInMemory& file = memory_file(stream);
  const std::size_t base = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                           : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.place
                                                              : file.size();
  if (offset > file.size() - std::min(base, file.size())) return -1;
  file.place = base + offset;
  return 0;
}

int close_memory(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }
int no_error(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }

zlib_filefunc64_def functions_for(ArchiveInMemory& file) {
  return {open_memory, read_memory,  write_memory, place_in_memory,
          seek_memory, close_memory, no_error,     &file};
}

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\3\4"); }

// --- Reading -------------------------------------------------------------------------------------

struct ZipReader::State {
  ArchiveInMemory memory;
  unzFile file = nullptr;
};

ZipReader::ZipReader(const Source& source, ExpansionBudget& budget)
    : source_(source), budget_(budget), state_(std::make_unique<State>()) {
  state_->memory.given = source.bytes;
  zlib_filefunc64_def functions = functions_for(state_->memory);
  state_->file = unzOpen2_64("", &functions);
  if (state_->file == nullptr)
    source_.fail("the ZIP archive has no list of its files at the end: it is cut off or damaged");
}

ZipReader::~ZipReader() {
  if (state_->file != nullptr) unzClose(state_->file);
}

std::optional<std::string> ZipReader::read(const std::string& name) const {
  constexpr int ignoring_case = 2;          // value of minizip for a search that ignores case
  constexpr std::size_t block = 1U << 16U;  // bytes; affects time only
  if (unzLocateFile(state_->file, name.c_str(), ignoring_case) != UNZ_OK) return std::nullopt;
  const auto fail = [&](const char* what) {
    source_.fail(in_quotes(name) + " in the archive " + what);
  };
  unz_file_info64 info{};
  unzGetCurrentFileInfo64(state_->file, &info, nullptr, 0, nullptr, 0, nullptr, 0);
  budget_.spend(info.uncompressed_size);
  if ((info.flag & 1U) != 0) fail("is encrypted");
  if (unzOpenCurrentFile(state_->file) != UNZ_OK)
    fail("is damaged, or compressed by a method other than Deflate");
  std::string bytes;
  int count = 1;
  while (count > 0) {
    const std::size_t size = bytes.size();
    bytes.resize(size + block);
    count = unzReadCurrentFile(state_->file, bytes.data() + size, block);
    bytes.resize(size + static_cast<std::size_t>(std::max(count, 0)));
  }
  const bool is_whole = bytes.size() == info.uncompressed_size;
  if (unzCloseCurrentFile(state_->file) != UNZ_OK || count < 0 || !is_whole) fail("is damaged");
  return bytes;
}

// --- Writing -------------------------------------------------------------------------------------

struct ZipWriter::State {
  ArchiveInMemory memory;
  zipFile file = nullptr;
};

ZipWriter::ZipWriter() : state_(std::make_unique<State>()) {
  state_->memory.is_written = true;
  zlib_filefunc64_def functions = functions_for(state_->memory);
  state_->file = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
  if (state_->file == nullptr) throw std::bad_alloc();
}

ZipWriter::~ZipWriter() {
  if (state_->file != nullptr) zipClose(state_->file, nullptr);
}

void ZipWriter::add(const std::string& name, std::string_view bytes) {
  zip_fileinfo info{};
  info.tmz_date.tm_year = 1980;
  info.tmz_date.tm_mday = 1;
  const int is_large = bytes.size() >= std::numeric_limits<std::uint32_t>::max() ? 1 : 0;
  if (zipOpenNewFileInZip64(state_->file, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr,
                            Z_DEFLATED, Z_DEFAULT_COMPRESSION, is_large) != ZIP_OK)
    throw std::bad_alloc();
  // Bytes written by one call, because minizip counts bytes in 32 bits.
  constexpr std::size_t block = std::size_t{1} << 30U;
  for (std::size_t at = 0; at < bytes.size(); at += block) {
    const std::string_view part = bytes.substr(at, block);
    zipWriteInFileInZip(state_->file, part.data(), static_cast<unsigned>(part.size()));
  }
  zipCloseFileInZip(state_->file);
}

std::string ZipWriter::finish() {
  zipClose(state_->file, nullptr);
  state_->file = nullptr;
  return std::move(state_->memory.written);
}

}  // namespace transformesh
