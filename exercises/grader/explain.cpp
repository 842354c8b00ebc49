// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <initializer_list>

#include "diagnostics.h"
#include "signature.h"

namespace grade {

namespace {

enum class Owner { student, given, grader, library, outside, nobody };

bool among(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

Owner owner(const std::string& file, const std::string& header) {
  const std::string name = std::filesystem::path(file).filename().string();
  if (file.empty()) return Owner::nobody;
  if (file == header || file == "{standard input}") return Owner::student;
  if (name == "given.h") return Owner::given;
  if (among(name, {"glue.cpp", "harness.h", "call.h", "force.h", "steps.h", "wanted.h"}))
    return Owner::grader;
  if (file.find("/include/") != file.npos) return Owner::library;
  return Owner::outside;
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != text.npos;
}

/// `'step' was not declared in this scope` in our call of it.
std::string missing(const Diagnostic& found) {
  const std::string& text = found.text;
  if (!contains(text, "was not declared in this scope") || !text.starts_with('\'')) return {};
  std::string name = text.substr(1, text.find('\'', 1) - 1);
  const std::size_t guess = text.find("did you mean");
  return name + " is missing: the header has to define it, under just this name" +
         (guess == text.npos ? "" : "; " + text.substr(guess));
}

std::string in_our_words(const Diagnostic& found) {
  constexpr std::string_view assertion = "static assertion failed: ";
  if (found.text.starts_with(assertion)) return found.text.substr(assertion.size());
  const std::string lacking = missing(found), signature = wanted_and_found(found);
  return !lacking.empty() ? lacking : !signature.empty() ? signature : found.text;
}

std::string with_lines(const Diagnostic& found, const std::string& header,
                       const std::string& name) {
  std::string shown;
  for (const std::string& line : found.before)
    if (line.starts_with(header + ":")) shown += line + "\n";
  shown += name + ":" + found.place + ": " + found.kind + ": " + found.text + "\n";
  for (const std::string& line : found.excerpt) shown += line + "\n";
  return shown;
}

std::string shown(const Diagnostic& found, const std::string& header) {
  switch (owner(found.file, header)) {
    case Owner::student:
      return with_lines(found, header, header);
    case Owner::given:
      return with_lines(found, header, "given.h");
    case Owner::library:
      return with_lines(found, header, found.file);
    case Owner::grader:
      return found.kind == "note" ? "" : found.kind + ": " + in_our_words(found) + "\n";
    case Owner::outside:  // what stands in another file is not for the student to read here
      return found.is_error()
                 ? "error: " + header +
                       " includes a file that is no header, or names it by #line: " + found.file +
                       "\n"
                 : "";
    case Owner::nobody:
      break;
  }
  return found.kind + ": " + found.text + "\n";
}

using All = std::vector<Diagnostic>;

bool any(const auto& all, auto&& holds) {
  return std::ranges::any_of(all, holds);
}

/// Errors in our call of the student's code mean something only while theirs has none.
bool consequence(const Diagnostic& found, const All& all, const std::string& header) {
  if (owner(found.file, header) != Owner::grader) return false;
  const bool theirs = any(all, [&](const Diagnostic& other) {
    return other.is_error() && owner(other.file, header) != Owner::grader;
  });
  const bool lacking = any(all, [](const Diagnostic& other) { return !missing(other).empty(); });
  return theirs || (lacking && missing(found).empty());
}

bool misses_a_file_of_theirs(const Diagnostic& found, const std::string& header) {
  return found.file == header && contains(found.text, ": No such file") &&
         any(found.excerpt, [](const std::string& line) { return contains(line, "include \""); });
}

}  // namespace

std::string errors(const All& all, const std::string& header) {
  std::string text;
  bool keep = false;
  for (const Diagnostic& found : all) {
    if (found.kind != "note") keep = found.is_error() && !consequence(found, all, header);
    if (!keep) continue;
    const std::string next = shown(found, header);
    if (!contains(text, next)) text += next;
  }
  return text;
}

std::string warnings(const All& all, const std::string& header) {
  std::string text;
  bool keep = false;
  for (const Diagnostic& found : all) {
    if (found.kind != "note")
      keep = found.kind == "warning" && owner(found.file, header) == Owner::student;
    if (keep) text += shown(found, header);
    text += another_form(found);
  }
  return text;
}

std::string hint(const All& all, const std::string& header) {
  const auto said = [&](std::string_view part) {
    return any(all, [&](const Diagnostic& found) { return contains(found.text, part); });
  };
  for (const char* name : {"windows.h", "Windows.h", "stdafx.h", "pch.h", "conio.h", "direct.h"})
    if (said(std::string(name) + ": No such file"))
      return std::string(name) + " exists only on Windows. A step needs none of it: leave it out.";
  for (const char* name : {"print", "expected", "mdspan", "generator", "flat_map", "stacktrace"})
    if (said(std::string(name) + ": No such file"))
      return "<" + std::string(name) + "> came with C++23, and this is compiled as C++20.";
  for (const char* name : {"print", "println", "expected", "unexpected", "mdspan", "generator",
                           "flat_map", "flat_set", "stacktrace"})
    if (said("'" + std::string(name) + "' is not a member of 'std'"))
      return "std::" + std::string(name) + " came with C++23, and this is compiled as C++20.";
  if (any(all, [&](const Diagnostic& found) { return misses_a_file_of_theirs(found, header); }))
    return "Only this one header is compiled: what it includes of yours has to stand in it.";
  if (said("C++23") || said("-std=c++23") || said("-std=c++2b"))
    return "This is compiled as C++20.";
  return {};
}

}  // namespace grade
