// SPDX-License-Identifier: MIT-0
/// @file
/// Git repositories that others made, read without letting them do anything.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/local_time.h"
#include "untrusted_files.h"

namespace grade {

/// A thing in a commit.
struct GitEntry {
  std::string mode;  ///< `100644` is a file, `040000` a folder, `120000` a link
  std::string hash, name;
};

/// A repository's objects, read by a git that knows nothing else of it: not its configuration, its
/// hooks, its filters, nor whose it is. Nothing is checked out, and nothing fetched.
class GitObjects {
 public:
  /// @param repository  a clone, or a bare one; held
  /// @throws Usage  it is none, in one line
  explicit GitObjects(const Entry& repository);
  ~GitObjects();
  GitObjects(const GitObjects&) = delete;
  GitObjects& operator=(const GitObjects&) = delete;

  /// The commit that its HEAD names, or the last one before it that is not later than `until`, by
  /// the time of its committer; empty if there is none.
  std::string commit(std::optional<Instant> until) const;

  /// The committer's time.
  Instant time_of(const std::string& commit) const;

  /// That of the commit by which the file at this path became what it is in this one.
  Instant changed(const std::string& commit, const std::string& path) const;

  /// What lies in a folder of a commit; empty if there is no such folder.
  std::vector<GitEntry> entries(const std::string& commit, const std::string& folder) const;

  /// Nothing if it is longer than `most` bytes.
  std::optional<std::string> file(const std::string& hash, std::size_t most) const;

 private:
  std::string git(const std::vector<std::string>& words, std::size_t most = 1 << 20) const;

  std::filesystem::path own_;  ///< an empty repository of ours
  cage::File objects_;
  std::string head_;
};

/// Clones by an address, with the user's own ways to say who they are, into a folder that is not
/// there yet. Nothing is checked out, no submodule is fetched, no hook runs.
/// @returns why not; empty if it did
std::string git_clone(const std::string& address, const std::filesystem::path& into);

}  // namespace grade
