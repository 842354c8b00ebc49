#include "grade.h"
#include <cstdio>
int main(int n, char** a) { grade::Request r; r.exercise = *grade::exercise(a[1]); r.submission = a[2]; if (n>3) r.sandbox=cage::Sandbox::none; auto p = grade::grade_one(r);
 std::printf("%s %d/%d %s (%.2f s: compile %.2f run %.2f)\n", std::string(grade::name(p.verdict)).c_str(), p.score, p.points, p.why.c_str(), p.seconds,p.compile_seconds,p.run_seconds);
 for (auto& t : p.tests) { std::printf("%s %d/%d %s\n", t.held ? "ok" : "--", t.held ? t.points : 0, t.points, t.name.c_str()); if (!t.findings.empty() && !t.findings.back().held) { auto& f = t.findings.back(); std::printf("  asked %s\n  input %s\n  expected %s\n  got %s\n  error %s (tolerance %s, %s)\n  hint %s\n", f.asked.c_str(), f.input.c_str(), f.expected.c_str(), f.got.c_str(), f.error.c_str(), f.tolerance.c_str(), f.tolerance_from.c_str(), f.hint.c_str()); for (auto& d : f.diagnoses) std::printf("  * %s\n", d.c_str()); } } }
