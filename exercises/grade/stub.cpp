#include "submission.h"
#include "compile.h"
#include "verdict.h"
#include <fstream>
#include <span>
#include <iterator>
namespace grade {
Compiled compile(const std::string& text, const std::string& header, const std::string& harness, cage::Sandbox sandbox, const cage::Kit& kit, const cage::Limits& l) {
  auto p = cage::compile(sandbox, kit, text, header, harness, l); std::string all = p.receive_all(64<<20); auto e = p.finish(); Compiled c; if (all.size() < 100) { c.failed = Verdict::compile_error; c.message = e.err + e.out; return c; } c.driver = cage::sealed(std::string_view(all).substr(5)); c.message=e.err; return c; }
}
