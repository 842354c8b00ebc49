// SPDX-License-Identifier: MIT-0
#include "cage.h"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "command.h"

namespace cage {

namespace {

namespace fs = std::filesystem;

File part(const fs::path& path) {
  File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) throw std::runtime_error("the grader's own " + path.string() + " cannot be read");
  return file;
}

std::string glue(const std::string& header, Build build) {
  const std::string both = "#include \"given.h\"\n#include \"" + header + "\"\n";
  return both +
         (build == Build::own ? "#include \"own.h\"\n" : "#include \"exercise/harness.h\"\n");
}

void write(const fs::path& path, std::string_view text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  if (!file.write(text.data(), static_cast<std::streamsize>(text.size())).flush())
    throw std::runtime_error("cannot write to " + path.parent_path().string());
}

fs::path fresh_folder() {
  std::string name = (fs::temp_directory_path() / "compile-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make the folder " + name);
  return name;
}

/// Returns whether the user that root becomes can get there; root's own home is often closed to
/// others.
bool reachable(const fs::path& folder) {
  if (!unprivileged() || !fs::exists(folder)) return true;
  for (fs::path at = fs::canonical(folder);; at = at.parent_path()) {
    if ((fs::status(at).permissions() & fs::perms::others_exec) == fs::perms::none) return false;
    if (at == at.root_path()) return true;
  }
}

/// The kit's harness as the cage shows it: mounted, or handed in file by file.
struct Harness {
  Words words;
  std::vector<File> files;
  std::vector<std::pair<int, int>> numbers;
};

Harness show(const fs::path& folder) {
  constexpr int first = 10;
  if (reachable(folder)) return {{"--ro-bind", fs::absolute(folder), "/job/harness"}, {}, {}};
  Harness shown;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory()) continue;
    const int number = first + static_cast<int>(shown.files.size());
    shown.files.push_back(part(entry.path()));
    shown.numbers.emplace_back(shown.files.back().get(), number);
    const std::string place = "/job/harness/" + fs::relative(entry.path(), folder).string();
    shown.words.insert(shown.words.end(),
                       {"--perms", "0444", "--ro-bind-data", std::to_string(number), place});
  }
  return shown;
}

/// Whatever root's umask is, and whoever may read the originals. The folder itself lets in one
/// user.
void let_others_read(const fs::path& folder) {
  constexpr auto to_read = fs::perms::group_read | fs::perms::others_read;
  constexpr auto to_enter = fs::perms::group_exec | fs::perms::others_exec;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_symlink()) continue;
    fs::permissions(entry.path(), entry.is_directory() ? to_read | to_enter : to_read,
                    fs::perm_options::add);
  }
}

/// Lays out in a folder what the cage shows at /job.
fs::path lay_out(const Kit& kit, std::string_view submission, const std::string& header,
                 std::string_view harness_header, Build build) {
  const fs::path folder = fresh_folder();
  write(folder / header, submission);
  write(folder / "exercise/harness.h", harness_header);
  write(folder / "glue.cpp", glue(header, build));
  if (reachable(kit.harness)) {
    fs::create_directory_symlink(fs::absolute(kit.harness), folder / "harness");
  } else {
    fs::copy(kit.harness, folder / "harness", fs::copy_options::recursive);
  }
  if (const auto user = unprivileged()) {
    let_others_read(folder);
    if (::chown(folder.c_str(), *user, *user) != 0)
      throw std::runtime_error("cannot hand over " + folder.string());
  }
  return folder;
}

}  // namespace

Process compile(Sandbox sandbox, const Kit& kit, std::string_view submission,
                const std::string& header, std::string_view harness_header, const Limits& limits,
                Build build) {
  if (sandbox == Sandbox::none) {
    const fs::path folder = lay_out(kit, submission, header, harness_header, build);
    return Process(compile_command(kit, folder.string(), limits, build), {}, limits, folder);
  }
  const File glued = sealed(glue(header, build)), harness = sealed(harness_header),
             text = sealed(submission), filter = part(fs::path(kit.filters) / "compile.bpf");
  Harness shown = show(kit.harness);
  std::vector<std::pair<int, int>> files = std::move(shown.numbers);
  files.insert(files.end(),
               {{glued.get(), 6}, {harness.get(), 7}, {text.get(), 8}, {filter.get(), 9}});
  return Process(compile_command(kit, shown.words, header, limits, build), files, limits);
}

Process run(Sandbox sandbox, const Kit& kit, const File& driver, const Limits& limits, Build build,
            const std::vector<std::string>& arguments) {
  const bool checked = build != Build::scored;
  Words command = checked ? check_command(sandbox, kit, limits) : run_command(sandbox, limits);
  command.insert(command.end(), arguments.begin(), arguments.end());
  if (sandbox != Sandbox::bubblewrap) return Process(command, {{driver.get(), 8}}, limits);
  const File filter = part(fs::path(kit.filters) / (checked ? "check.bpf" : "run.bpf"));
  std::vector<std::pair<int, int>> files = {{driver.get(), 8}, {filter.get(), 9}};
  const File limited = checked ? part(kit.limited) : File();
  if (checked) files.emplace_back(limited.get(), 10);
  return Process(command, files, limits);
}

}  // namespace cage
