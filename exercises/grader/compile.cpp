// SPDX-License-Identifier: MIT-0
#include "compile.h"

#include <algorithm>
#include <sstream>

#include "diagnostics.h"
#include "printable.h"

namespace grade {

namespace {

using How = cage::Ended::How;

constexpr std::size_t largest_driver = 64 << 20;  // [bytes]; the usual one has one million
constexpr std::size_t longest_message = 4000;     // [bytes]

/// The compiler's words for a limit of its own, or of ours, that it met.
constexpr std::pair<const char*, const char*> limits_met[] = {
    {"out of memory", "memory"},
    {"memory exhausted", "memory"},
    {"bad_alloc", "memory"},
    {"CPU time limit exceeded", "time"},
    {"Killed signal terminated", "time"},
    {"File size limit exceeded", "room for its output"},
    {"file too large", "room for its output"},
    {"File too large", "room for its output"},
    {"No space left", "room for its output"},
    {"loop iteration count exceeds limit", "steps of a computation at compile time"},
    {"operation count exceeds limit", "steps of a computation at compile time"},
    {"evaluation depth exceeds maximum", "depth of a computation at compile time"},
    {"instantiation depth exceeds maximum", "depth of templates"},
    {"macros nested too deeply", "depth of assembler macros"},
    {"nested depth", "depth of #include"}};

std::string what_ran_out(const std::vector<Diagnostic>& all) {
  for (const Diagnostic& found : all)
    for (const auto& [said, what] : limits_met)
      if (found.text.find(said) != found.text.npos) return what;
  return {};
}

std::string seconds(double value) {
  std::ostringstream text;
  text << value << " s";
  return text.str();
}

std::string limit_message(const cage::Ended& ended, const cage::Limits& limits) {
  if (ended.how == How::wall_limit)
    return "the compiler was not done after " + seconds(limits.wall);
  if (ended.how == How::processor_limit)
    return "the compiler used more than " + seconds(limits.processor) + " of processor time";
  return "the compiler's messages, or its program, had no end";
}

/// The symbols that `nm` lists: address, letter, name.
struct Symbols {
  bool main = false;
  std::vector<std::string> strong;   ///< of C++, so nobody else's
  std::vector<std::string> foreign;  ///< functions of C, such as write, that the library has, too
};

Symbols symbols(const std::string& listed) {
  constexpr std::string_view ours = "answer(harness::Call&)";
  Symbols found;
  std::istringstream list(listed);
  for (std::string address, line; list >> address && std::getline(list, line);) {
    const std::string name = line.size() > 3 ? line.substr(3) : "";
    const bool function_of_c = name.find('(') == name.npos && line.starts_with(" T");
    if (name == "main")
      found.main = true;
    else if (name != ours && !name.empty())
      (function_of_c ? found.foreign : found.strong).push_back(name);
  }
  return found;
}

/// It works in this program, whose one file includes the header once.
std::string lacks_inline(const std::vector<std::string>& names) {
  if (names.empty()) return "";
  const std::string& name = names.front();
  return name.substr(0, name.find('(')) +
         " lacks the word inline. Include the header in two files of one program, and the linker "
         "refuses. Write inline before each function, and before each variable that is not "
         "const.\n";
}

std::string of_c(const std::vector<std::string>& names) {
  return names.front() +
         " is a function of C with that name, and the library has one. Leave it out.";
}

const std::string remove_main =
    "remove main(), or put it between #ifndef GRADING and #endif: the grader brings its own";

const std::string bytecode =
    "it holds bytecode for the linker to compile (.gnu.lto_ or .llvmbc), which is not taken: write "
    "it in C++";

/// The names that the linker misses; all its other words name files of ours.
std::string link_message(const std::string& said) {
  constexpr std::string_view undefined = "undefined reference to `";
  if (said.find("undefined reference to `main'") != said.npos)
    return "there is no main() in it: write one, between #ifndef GRADING and #endif";
  std::string message;
  for (std::size_t at = said.find(undefined); at != said.npos; at = said.find(undefined, at)) {
    at += undefined.size();
    const std::string name = said.substr(at, said.find('\n', at) - at);
    const std::string line = name.substr(0, name.rfind('\'')) + " is declared, but never defined\n";
    if (message.find(line) == message.npos) message += line;
  }
  return message.empty() ? "the linker can make no program of it" : message;
}

Compiled failed(const cage::Ended& ended, Verdict verdict, std::string message) {
  while (message.ends_with('\n')) message.pop_back();
  return {{}, verdict, printable(message, longest_message), ended.processor};
}

Compiled not_compiled(const cage::Ended& ended, const std::string& header) {
  const std::vector<Diagnostic> all = diagnostics(ended.err);
  const bool bad_main = std::ranges::any_of(
      all, [](const Diagnostic& found) { return found.text.find("'::main'") != found.text.npos; });
  if (bad_main) return failed(ended, Verdict::rejected, remove_main);
  std::string message = errors(all, header);
  if (const std::string what = what_ran_out(all); !what.empty())
    return failed(ended, Verdict::compile_limit,
                  "the compiler ran out of " + what + "\n" + message);
  if (message.empty()) message = "the compiler refused it and did not say why";
  if (const std::string more = hint(all, header); !more.empty()) message += more + "\n";
  return failed(ended, Verdict::compile_error, message);
}

Compiled not_linked(const cage::Ended& ended) {
  if (const std::string what = what_ran_out(diagnostics(ended.err)); !what.empty())
    return failed(ended, Verdict::compile_limit, "the linker ran out of " + what);
  if (ended.err.find("relocation truncated") != std::string::npos)
    return failed(ended, Verdict::compile_limit, "the program is larger than two gigabytes");
  return failed(ended, Verdict::link_error, link_message(ended.err));
}

}  // namespace

Compiled compile(const std::string& text, const std::string& header, const std::string& harness,
                 cage::Sandbox sandbox, const cage::Kit& kit, const cage::Limits& limits,
                 cage::Build build) {
  constexpr std::string_view ready = "READY";
  cage::Process process = cage::compile(sandbox, kit, text, header, harness, limits, build);
  const std::string answer = process.receive_all(ready.size() + largest_driver);
  const cage::Ended ended = process.finish();

  if (!answer.starts_with(ready))
    return failed(ended, Verdict::grader_error, "the compiler cannot be started: " + ended.err);
  if (ended.how != How::exited)
    return failed(ended, Verdict::compile_limit, limit_message(ended, limits));
  if (ended.code == cage::not_compiled) return not_compiled(ended, header);
  // A program that runs by its own main meets no other file.
  const Symbols found = build == cage::Build::own ? Symbols() : symbols(ended.out);
  if (ended.code == cage::has_bytecode) return failed(ended, Verdict::rejected, bytecode);
  if (found.main) return failed(ended, Verdict::rejected, remove_main);
  if (!found.foreign.empty()) return failed(ended, Verdict::link_error, of_c(found.foreign));
  if (ended.code == cage::not_linked) return not_linked(ended);
  if (ended.code != 0)
    return failed(ended, Verdict::grader_error,
                  "the compiler ended with " + std::to_string(ended.code));
  const std::string warned = lacks_inline(found.strong) + warnings(diagnostics(ended.err), header);
  return {cage::sealed(std::string_view(answer).substr(ready.size())), std::nullopt,
          printable(warned, longest_message), ended.processor};
}

}  // namespace grade
