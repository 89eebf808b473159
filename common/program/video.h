// motion.mp4: the film of motion.png for programs that play videos, made by ffmpeg.
#pragma once
#include <filesystem>
#include <string>

// Makes motion.mp4 of the directory from its motion.png. Returns why it could not, for example because ffmpeg is
// not installed; "" if the video is there.
std::string make_video(const std::filesystem::path& directory);

// The command that makes it, for a shell.
std::string video_command(const std::filesystem::path& directory);
