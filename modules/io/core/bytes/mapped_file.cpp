#include "io/core/bytes/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "base/error.h"
#include "base/file_pages.h"

namespace bole::io {

MappedFile::MappedFile(const std::filesystem::path& path) {
  // Without O_NONBLOCK the opening of a pipe would wait for a writer, for ever. Files do not mind it.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0)
    throw bad_input("'" + path.string() + "' cannot be opened: " + std::strerror(errno),
                    "a file that exists and may be read");
  struct stat status {};
  const bool regular = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  const auto size = regular ? static_cast<std::size_t>(status.st_size) : 0;
  void* start = size > 0 ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0) : MAP_FAILED;
  const int reason = errno;
  ::close(file);
  if (!regular) throw bad_input("'" + path.string() + "' is not a file", "a file");
  if (size == 0) return;
  if (start == MAP_FAILED)
    throw failure("'" + path.string() + "' cannot be mapped into memory: " + std::strerror(reason));
  ::madvise(start, size, MADV_SEQUENTIAL);
  bytes_ = {static_cast<const std::uint8_t*>(start), size};
  know_file_pages(start, size);
}

MappedFile::~MappedFile() {
  if (bytes_.empty()) return;
  forget_file_pages(bytes_.data());
  ::munmap(const_cast<std::uint8_t*>(bytes_.data()), bytes_.size());
}

}  // namespace bole::io
