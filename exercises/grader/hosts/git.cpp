// SPDX-License-Identifier: MIT-0
#include "hosts/git.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <system_error>

#include "command_line.h"
#include "csv.h"
#include "printable.h"

namespace grade {
namespace {

const cage::Limits git_limits{.wall = 600};

bool is_hash(const std::string& text) {
  return (text.size() == 40 || text.size() == 64) &&
         text.find_first_not_of("0123456789abcdef") == text.npos;
}

/// A file below the repository's own folder, no link followed.
std::optional<std::string> text_at(const Entry& folder, const std::filesystem::path& path) {
  constexpr std::size_t most = 1 << 20;
  const Entry* at = &folder;
  std::optional<Entry> below;
  for (const auto& name : path) {
    auto next = entry(at->file.get(), name.string());
    if (!next) return std::nullopt;
    below = std::move(next);
    at = &*below;
  }
  if (!at->is_regular()) return std::nullopt;
  return read(*at, most);
}

std::string first_word(const std::string& text) {
  return text.substr(0, text.find_first_of(" \t\r\n"));
}

/// The hash that a branch has, in a file of its own or in the list of all.
std::string branch(const Entry& repository, const std::string& name) {
  if (const auto own = text_at(repository, name)) return first_word(*own);
  const std::string all = text_at(repository, "packed-refs").value_or("");
  const std::size_t at = ("\n" + all).find(" " + name + "\n");
  if (at == std::string::npos) return "";
  const std::size_t begin = all.rfind('\n', at - 1);
  return all.substr(begin + 1, at - 1 - (begin + 1));
}

/// What HEAD names: a branch, or a commit.
std::string head_of(const Entry& repository) {
  static const std::regex form("ref: (refs/heads/[^ \r\n]{1,200})\\s*");
  const std::string text = text_at(repository, "HEAD").value_or("");
  std::smatch parts;
  if (text.size() > 300 || !std::regex_match(text, parts, form)) return first_word(text);
  const std::filesystem::path name = parts[1].str();
  const bool climbs = std::ranges::find(name, "..") != name.end();
  return climbs ? "" : branch(repository, name.string());
}

std::filesystem::path fresh_repository(const std::string& shallow) {
  std::string name = (std::filesystem::temp_directory_path() / "git-XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw std::system_error(errno, std::generic_category(), "can't make the folder " + name);
  const std::filesystem::path own = name;
  for (const char* folder : {"objects", "refs"}) std::filesystem::create_directory(own / folder);
  std::ofstream(own / "HEAD") << "ref: refs/heads/none\n";
  if (!shallow.empty()) std::ofstream(own / "shallow") << shallow;
  return own;
}

}  // namespace

GitObjects::GitObjects(const Entry& folder) {
  auto inner = entry(folder.file.get(), ".git");
  if (inner && !inner->is_folder())
    throw Usage("its .git is no folder: clone it, and copy no worktree or submodule");
  const Entry& repository = inner ? *inner : folder;
  auto objects = entry(repository.file.get(), "objects");
  if (!objects || !objects->is_folder()) throw Usage("it is no git repository");
  head_ = head_of(repository);
  if (!is_hash(head_)) throw Usage("its branch has no commit yet");
  objects_ = std::move(objects->file);
  own_ = fresh_repository(text_at(repository, "shallow").value_or(""));
}

GitObjects::~GitObjects() {
  std::error_code left;
  if (!own_.empty()) std::filesystem::remove_all(own_, left);
}

std::string GitObjects::git(const std::vector<std::string>& words, std::size_t most) const {
  // The answer comes on descriptor 3. The objects that are read are those that are held, on 8.
  std::vector<std::string> command{"env",
                                   "GIT_DIR=" + own_.string(),
                                   "GIT_ALTERNATE_OBJECT_DIRECTORIES=/proc/self/fd/8",
                                   "GIT_CONFIG_NOSYSTEM=1",
                                   "GIT_CONFIG_GLOBAL=/dev/null",
                                   "GIT_NO_REPLACE_OBJECTS=1",
                                   "GIT_LITERAL_PATHSPECS=1",
                                   "GIT_NO_LAZY_FETCH=1",
                                   "GIT_ALLOW_PROTOCOL=none",
                                   "HOME=/nonexistent",
                                   "/bin/sh",
                                   "-c",
                                   "exec git --no-pager \"$@\" >&3",
                                   "git"};
  command.insert(command.end(), words.begin(), words.end());
  cage::Process process(command, {{objects_.get(), 8}}, git_limits);
  const std::string answer = process.receive_all(most);
  const cage::Ended ended = process.finish();
  if (ended.how == cage::Ended::How::exited && ended.code == 0) return answer;
  if (ended.code == 127) throw Usage("git is not installed: apt-get install git");
  throw Usage("git can't read it: " + printable(ended.err.substr(0, ended.err.find('\n')), 200));
}

std::string GitObjects::commit(std::optional<Instant> until) const {
  std::vector<std::string> words{"rev-list", "-1"};
  if (until) words.push_back("--min-age=" + std::to_string(until->time_since_epoch().count()));
  words.insert(words.end(), {head_, "--"});
  return first_word(git(words));
}

Instant GitObjects::time_of(const std::string& commit) const {
  const std::string text = git({"show", "-s", "--no-show-signature", "--format=%ct", commit, "--"});
  return Instant(std::chrono::seconds(std::stoll(text)));
}

Instant GitObjects::changed(const std::string& commit, const std::string& path) const {
  const std::string last = first_word(git({"rev-list", "-1", commit, "--", path}));
  return time_of(last.empty() ? commit : last);
}

std::vector<GitEntry> GitObjects::entries(const std::string& commit,
                                          const std::string& folder) const {
  const std::string below = folder.empty() ? "" : folder + "/";
  std::vector<GitEntry> all;
  std::vector<std::string> words{"ls-tree", "-z", commit};
  if (!folder.empty()) words.insert(words.end(), {"--", below});
  const std::string list = git(words);
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find('\0', begin), list.size());
    const std::string line = list.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t tab = line.find('\t');
    const std::size_t hash = line.rfind(' ', tab);
    if (tab == line.npos || hash == line.npos || !line.substr(tab + 1).starts_with(below)) continue;
    all.push_back({line.substr(0, line.find(' ')), line.substr(hash + 1, tab - hash - 1),
                   line.substr(tab + 1 + below.size())});
  }
  return all;
}

std::optional<std::string> GitObjects::file(const std::string& hash, std::size_t most) const {
  if (std::stoull(git({"cat-file", "-s", hash})) > most) return std::nullopt;
  return git({"cat-file", "blob", hash}, most + 1);
}

std::string git_clone(const std::string& address, const std::filesystem::path& into) {
  std::vector<std::string> command{"env", "GIT_TERMINAL_PROMPT=0",
                                   "GIT_ALLOW_PROTOCOL=https:ssh:file"};
  for (const char* name : {"HOME", "SSH_AUTH_SOCK", "XDG_CONFIG_HOME"})
    if (const char* value = std::getenv(name)) command.push_back(std::string(name) + "=" + value);
  command.insert(command.end(),
                 {"git", "-c", "core.hooksPath=/dev/null", "clone", "--quiet", "--bare",
                  "--no-tags", "--single-branch", "--no-recurse-submodules",
                  "--template=", "--no-local", "--", address, into.string()});
  cage::Process process(command, {}, git_limits);
  const cage::Ended ended = process.finish();
  if (ended.how == cage::Ended::How::exited && ended.code == 0) return "";
  return printable(trimmed(ended.err.substr(0, ended.err.find('\n'))), 200);
}

}  // namespace grade
