#include "report/flight/video.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "base/error.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace bole::report {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds between_looks{50};

pid_t start_program(const std::vector<std::string>& arguments, const fs::path& messages) {
  std::vector<char*> argv;
  for (const auto& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t pid = 0;
  const int failed = posix_spawn(&pid, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) throw failure("ffmpeg cannot be started (" + arguments[0] + ")", "a program that runs");
  return pid;
}

// The exit status; that of a killed program is not 0.
int wait_for(pid_t pid, const Run& run) {
  int status = 0;
  while (::waitpid(pid, &status, WNOHANG) == 0) {
    if (run.cancelled()) {
      ::kill(pid, SIGKILL);
      ::waitpid(pid, &status, 0);
      break;
    }
    std::this_thread::sleep_for(between_looks);
  }
  return status;
}

}  // namespace

fs::path program_in_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    fs::path program = fs::path(folder) / name;
    if (!folder.empty() && ::access(program.c_str(), X_OK) == 0 && fs::is_regular_file(program)) return program;
  }
  return {};
}

void write_video(const fs::path& ffmpeg, const fs::path& frames, double frame_rate, const fs::path& video,
                 const Run& run) {
  const auto messages = fs::path(video).replace_extension(".ffmpeg.log"),
             unfinished = fs::path(video).replace_extension(".unfinished.mp4");
  const std::vector<std::string> arguments{ffmpeg.string(),
                                           "-y",
                                           "-v",
                                           "error",
                                           "-framerate",
                                           fmt::format("{:g}", frame_rate),
                                           "-i",
                                           (frames / "frame_%05d.png").string(),
                                           "-vf",
                                           "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                           "-c:v",
                                           "libx264",
                                           "-crf",
                                           "20",
                                           "-pix_fmt",
                                           "yuv420p",
                                           "-movflags",
                                           "+faststart",
                                           unfinished.string()};
  const int status = wait_for(start_program(arguments, messages), run);
  std::ostringstream said;
  said << std::ifstream(messages).rdbuf();
  fs::remove(messages);
  std::error_code none;
  if (status != 0) fs::remove(unfinished, none);
  run.check_cancel();
  if (status != 0)
    throw failure("ffmpeg wrote no video: " + said.str(), "an ffmpeg with libx264",
                  "The frames are in " + frames.string());
  fs::rename(unfinished, video);
}

}  // namespace bole::report
