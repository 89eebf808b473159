#include "program/video.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "text/text.h"

namespace {

// H.264 with yuv420p, which browsers play. It needs an even width and height, so an odd row or column is cut off.
// "file:" makes a name that begins with "-" or has a colon the name of a file.
std::vector<std::string> words_of_command(const std::filesystem::path& png,
                                          const std::filesystem::path& mp4) {
  return {"ffmpeg",
          "-v",
          "error",
          "-nostdin",
          "-y",
          "-f",
          "apng",
          "-i",
          "file:" + png.string(),
          "-vf",
          "crop=trunc(iw/2)*2:trunc(ih/2)*2",
          "-c:v",
          "libx264",
          "-pix_fmt",
          "yuv420p",
          "-movflags",
          "faststart",
          "-f",
          "mp4",
          "file:" + mp4.string()};
}

// The status of waitpid, or −1 with errno.
int run(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  errno = posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ);
  if (errno != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) == -1)
    if (errno != EINTR) return -1;
  return status;
}

// Why there is no result; "" if there is one.
std::string failure(int status) {
  if (status == 0) return "";
  if (status == -1 && errno == ENOENT) return "ffmpeg is not installed";
  if (status == -1) return std::string("ffmpeg does not start: ") + std::strerror(errno);
  return WIFEXITED(status) ? text("ffmpeg ended with exit code %d", WEXITSTATUS(status))
                           : text("ffmpeg was ended by signal %d", WTERMSIG(status));
}

}  // namespace

std::string make_video(const std::filesystem::path& directory) {
  const std::filesystem::path part = directory / "motion.mp4.part";
  const std::string reason = failure(run(words_of_command(directory / "motion.png", part)));
  std::error_code error;
  if (!reason.empty()) {
    std::filesystem::remove(part, error);
    return reason;
  }
  std::filesystem::rename(part, directory / "motion.mp4", error);
  return error ? error.message() : "";
}

std::string video_command(const std::filesystem::path& directory) {
  std::vector<std::string> words;
  for (const std::string& word :
       words_of_command(directory / "motion.png", directory / "motion.mp4"))
    words.push_back(shell_word(word));
  return joined(words, " ");
}
