// SPDX-License-Identifier: MIT-0
/// @file
/// Reads the logs of frames that other programs write.
#pragma once
#include <filesystem>
#include <vector>

namespace frames {

/// How long each frame of a log took, one after the other [s].
///
/// What wrote the log is known by the row that names its columns: `MsBetweenPresents`, `FrameTime`
/// or `MsBetweenAppStart` of PresentMon, 1 and 2, and of CapFrameX's CSV; `frametime` beside `fps`
/// of MangoHud, which by its version counts milliseconds or microseconds. A file that begins with a
/// brace is CapFrameX's JSON, and a column of numbers without a name is in seconds.
///
/// @param file  the log
/// @throws std::runtime_error  one line that says what is wrong, and in which row
std::vector<double> read_log(const std::filesystem::path& file);

}  // namespace frames
