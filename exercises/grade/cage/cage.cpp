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

std::string glue(const std::string& header) {
  return "#include \"given.h\"\n#include \"" + header + "\"\n#include \"exercise/harness.h\"\n";
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

/// Lays out in a folder what the cage shows at /job.
fs::path lay_out(const Kit& kit, std::string_view submission, const std::string& header,
                 std::string_view harness_header) {
  const fs::path folder = fresh_folder();
  write(folder / header, submission);
  write(folder / "exercise/harness.h", harness_header);
  write(folder / "glue.cpp", glue(header));
  fs::create_directory_symlink(fs::absolute(kit.harness), folder / "harness");
  if (const auto user = unprivileged())
    if (::chown(folder.c_str(), *user, *user) != 0)
      throw std::runtime_error("cannot hand over " + folder.string());
  return folder;
}

}  // namespace

Process compile(Sandbox sandbox, const Kit& kit, std::string_view submission,
                const std::string& header, std::string_view harness_header, const Limits& limits) {
  if (sandbox == Sandbox::none) {
    const fs::path folder = lay_out(kit, submission, header, harness_header);
    return Process(compile_command(folder.string(), limits), {}, limits, folder);
  }
  const File glued = sealed(glue(header)), harness = sealed(harness_header),
             text = sealed(submission), filter = part(fs::path(kit.filters) / "compile.bpf");
  return Process(compile_command(kit, header, limits),
                 {{glued.get(), 6}, {harness.get(), 7}, {text.get(), 8}, {filter.get(), 9}},
                 limits);
}

Process run(Sandbox sandbox, const Kit& kit, const File& driver, const Limits& limits) {
  const Words command = run_command(sandbox, limits);
  if (sandbox == Sandbox::none) return Process(command, {{driver.get(), 8}}, limits);
  const File filter = part(fs::path(kit.filters) / "run.bpf");
  return Process(command, {{driver.get(), 8}, {filter.get(), 9}}, limits);
}

}  // namespace cage
