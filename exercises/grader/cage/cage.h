// SPDX-License-Identifier: MIT-0
/// @file
/// The cages: one to compile in, one to run in, which holds nothing but the program, and one to run
/// in under a checker of memory, which holds that program's libraries, too. See README.md.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cage/process.h"

namespace cage {

enum class Sandbox {
  bubblewrap,  ///< namespaces, system call filter, limits
  none,        ///< limits only: for a student's own code on the student's own machine
  trusted,     ///< nothing: for a driver of this project's own code, which limits itself
};

/// The files and folders that the grader brought along.
struct Kit {
  std::string harness;        ///< folder with the precompiled given.h, call.h and harness.o
  std::string filters;        ///< folder with run.bpf and compile.bpf
  std::string canary;         ///< the canary, a static program
  std::string limited;        ///< the program that starts a checked driver, static too
  std::string compiler = {};  ///< what the kit was compiled with, and submissions are
  std::vector<std::string> flags = {};          ///< for the compiler
  std::vector<std::string> checked_flags = {};  ///< the same, with a checker of memory
  std::vector<std::string> shown = {};          ///< the folders of its parts, headers and libraries
  std::vector<std::string> libraries = {};      ///< files that a checked program is linked with
};

/// The purpose of a driver: to be scored, or to be run once more under a checker of memory. That
/// needs the shared libraries of the system, and more address space than there is memory.
/// Or to be run by its own main, under the same checker, for whoever wrote it.
enum class Build { scored, checked, own };

/// Exit codes of a compilation that failed: in which step.
enum CompileExit { not_compiled = 10, not_linked = 11, has_bytecode = 12 };

/// Starts a compilation of `submission`, under the name `header`, with the glue of
/// `harness_header`; the driver comes on descriptor 3 behind the word READY. On its standard output
/// stands what the submission defines strongly, and main, as `nm -C` writes it. One with a main of
/// its own is not glued to anything.
Process compile(Sandbox sandbox, const Kit& kit, std::string_view submission,
                const std::string& header, std::string_view harness_header, const Limits& limits,
                Build build = Build::scored);

/// Starts a driver.
Process run(Sandbox sandbox, const Kit& kit, const File& driver, const Limits& limits,
            Build build = Build::scored, const std::vector<std::string>& arguments = {});

/// Runs the canary in the run cage. Nothing if everything that should be refused is refused; else
/// what is wrong and what to do about it.
std::optional<std::string> unsafe(const Kit& kit);

}  // namespace cage
