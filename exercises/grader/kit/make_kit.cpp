// SPDX-License-Identifier: MIT-0
#include "kit/make_kit.h"

#include <unistd.h>

#include <sstream>
#include <system_error>

#include "home/state.h"
#include "installed.h"
#include "kit/ask.h"
#include "report/files.h"

namespace grade {
namespace {

namespace fs = std::filesystem;

constexpr const char* note = "compiler.txt";

void copy_headers(const fs::path& from, const fs::path& to) {
  fs::create_directories(to);
  for (const auto& header : fs::directory_iterator(from))
    if (header.path().extension() == ".h")
      write_whole(to / header.path().filename(), read_whole(header.path()).value());
}

/// Compiles in the folder of the kit, where it names the files as the cage does, and no folder of
/// this machine: a submission can read all of it.
void compile_into(const fs::path& folder, const std::string& compiler,
                  const std::vector<std::string>& flags, const std::vector<std::string>& what,
                  const std::string& out) {
  fs::create_directories((folder / out).parent_path());
  const std::string fresh = out + "." + std::to_string(getpid()) + ".new";
  std::vector<std::string> command{compiler, "-ffile-prefix-map=" + folder.string() + "=/job"};
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), what.begin(), what.end());
  command.insert(command.end(), {"-o", fresh});
  ask(command, folder);
  fs::rename(folder / fresh, folder / out);
}

std::string as_text(const Compiler& compiler) {
  std::string text = "path=" + compiler.path + "\nidentity=" + compiler.identity + "\n";
  for (const std::string& folder : compiler.shown) text += "shown+=" + folder + "\n";
  for (const std::string& library : compiler.libraries) text += "libraries+=" + library + "\n";
  return text;
}

/// Those that unpack an archive may forget what may be run.
void let_be_run(const fs::path& program) {
  std::error_code not_ours;
  fs::permissions(program, fs::perms(0111), fs::perm_options::add, not_ours);
}

}  // namespace

fs::path made_folder() {
  const fs::path kit = installed().kit;
  if (made_with(kit) || access(kit.c_str(), W_OK) == 0) return kit;
  return state_file("kit");
}

std::optional<Compiler> made_with(const fs::path& folder) {
  Compiler compiler;
  std::istringstream file(read_whole(folder / note).value_or(""));
  for (std::string word, value; std::getline(file, word, '=') && std::getline(file, value);) {
    if (word == "path") compiler.path = value;
    if (word == "identity") compiler.identity = value;
    if (word == "shown+") compiler.shown.push_back(value);
    if (word == "libraries+") compiler.libraries.push_back(value);
  }
  const bool same = !compiler.identity.empty() && identity_of(compiler.path) == compiler.identity;
  const bool whole = fs::exists(folder / "harness/harness.o");
  return same && whole ? std::optional(compiler) : std::nullopt;
}

void make_kit(const fs::path& folder, const fs::path& compiler) {
  const fs::path harness = fs::path(installed().exercises) / "grader/harness";
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const std::string path = compiler;
  copy_headers(harness, whole / "harness");
  const std::vector<std::string> given{"-DGRADING", "-x", "c++-header", "harness/given.h"};
  const std::string compiled_given = "harness/given.h.gch/";
  compile_into(whole, path, installed().student_flags, given, compiled_given + "STUDENT");
  compile_into(whole, path, installed().checked_flags, given, compiled_given + "CHECKED");
  const std::string source = fs::absolute(harness).lexically_normal();
  compile_into(whole, path, installed().student_flags,
               {"-ffile-prefix-map=" + source + "=harness", "-c", source + "/main.cpp"},
               "harness/harness.o");
  for (const char* program : {"canary", "limited"}) let_be_run(fs::path(installed().kit) / program);
  write_whole(whole / note, as_text({path, identity_of(compiler), folders_of(path),
                                     libraries_of(path, installed().checked_flags, whole)}));
}

}  // namespace grade
