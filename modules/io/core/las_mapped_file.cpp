#include "io/core/las_mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/error.h"

namespace bole::las {

MappedFile::MappedFile(const std::filesystem::path& path) {
  const std::string name = "'" + path.string() + "'";
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw bad_input(name + " cannot be opened: " + std::strerror(errno), "a file that may be read");
  struct stat status {};
  const bool regular = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  void* start = MAP_FAILED;
  if (regular && status.st_size > 0) start = ::mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ, MAP_PRIVATE, file, 0);
  const int reason = errno;
  ::close(file);
  if (!regular) throw bad_input(name + " is not a regular file", "a file");
  if (status.st_size == 0) return;
  if (start == MAP_FAILED) throw failure(name + " cannot be mapped into memory: " + std::strerror(reason));
  ::madvise(start, static_cast<std::size_t>(status.st_size), MADV_SEQUENTIAL);
  bytes_ = {static_cast<const std::uint8_t*>(start), static_cast<std::size_t>(status.st_size)};
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::uint8_t*>(bytes_.data()), bytes_.size());
}

}  // namespace bole::las
