// SPDX-License-Identifier: MIT-0
#include "kit/compiler.h"

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <system_error>

#include "kit/ask.h"
#include "report/files.h"

namespace grade {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream rest(text);
  for (std::string part; std::getline(rest, part, at);) parts.push_back(part);
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n");
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(" \n") - begin + 1);
}

/// The folders in which it looks for headers, as `-v` names them between two lines.
std::vector<std::string> header_folders(const std::string& compiler) {
  const std::string said = ask({compiler, "-E", "-v", "-x", "c++", "/dev/null"}).err;
  const std::string from = "#include <...> search starts here:\n", to = "End of search list.";
  const std::size_t begin = said.find(from), end = said.find(to);
  if (begin == said.npos || end == said.npos) return {};
  return split(said.substr(begin + from.size(), end - begin - from.size()), '\n');
}

/// Those of its parts, libraries and programs, as `-print-search-dirs` names them behind `=` and
/// `:`.
std::vector<std::string> searched_folders(const std::string& compiler) {
  std::vector<std::string> folders;
  for (const std::string& line : split(ask({compiler, "-print-search-dirs"}).out, '\n'))
    for (const std::string& side : split(line, '='))
      for (const std::string& folder : split(side, ':')) folders.push_back(folder);
  return folders;
}

bool is_within(const fs::path& inner, const fs::path& outer) {
  const auto [end, at] = std::ranges::mismatch(outer, inner);
  return end == outer.end();
}

}  // namespace

std::optional<fs::path> find_compiler() {
  const char* const path = std::getenv("PATH");
  std::vector<std::string> folders = split(path ? path : "", ':');
  folders.insert(folders.begin(), "/usr/bin");
  for (const std::string& folder : folders) {
    std::error_code none;
    const fs::path found = fs::canonical(fs::path(folder) / "g++", none);
    if (!none && !folder.empty()) return found;
  }
  return std::nullopt;
}

std::string identity_of(const fs::path& compiler) {
  std::error_code none;
  const auto saved = fs::last_write_time(compiler, none);
  const auto size = none ? 0 : fs::file_size(compiler, none);
  if (none) return "";
  return std::to_string(size) + "-" + std::to_string(saved.time_since_epoch().count());
}

std::vector<std::string> folders_of(const std::string& compiler) {
  std::vector<std::string> folders{"/usr/bin", "/usr/lib", "/usr/lib64",
                                   fs::path(compiler).parent_path()};
  for (const char* part : {"cc1plus", "collect2", "as", "ld"})
    folders.push_back(
        fs::path(trimmed(ask({compiler, std::string("-print-prog-name=") + part}).out))
            .parent_path());
  for (const auto& more : {searched_folders(compiler), header_folders(compiler)})
    folders.insert(folders.end(), more.begin(), more.end());
  std::vector<std::string> shown;
  for (const std::string& folder : folders) {
    std::error_code none;
    const fs::path there = fs::canonical(trimmed(folder), none);
    // `as` says no more than its name where it is in the PATH.
    if (!none && fs::path(trimmed(folder)).is_absolute() && fs::is_directory(there, none))
      shown.push_back(there);
  }
  std::ranges::sort(shown);
  std::vector<std::string> outermost;
  for (const std::string& folder : shown) {
    const bool inside = std::ranges::any_of(
        outermost, [&](const std::string& other) { return is_within(folder, other); });
    if (!inside) outermost.push_back(folder);
  }
  return outermost;
}

std::vector<std::string> libraries_of(const std::string& compiler,
                                      const std::vector<std::string>& flags,
                                      const fs::path& folder) {
  const fs::path program = folder / "empty", source = folder / "empty.cpp";
  write_whole(source, "int main() {}\n");
  std::vector<std::string> command{compiler, source, "-o", program};
  command.insert(command.end(), flags.begin(), flags.end());
  ask(command);
  const std::string said = ask({"ldd", program}).out;
  for (const fs::path& made : {program, source}) fs::remove(made);
  std::vector<std::string> libraries;
  const std::regex path("/[^ \n]+");
  for (std::sregex_iterator found(said.begin(), said.end(), path), end; found != end; ++found)
    libraries.push_back(found->str());
  return libraries;
}

}  // namespace grade
