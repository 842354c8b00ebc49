# SPDX-License-Identifier: MIT-0
# Writes version.cpp: the version of the book, and one hash of the grader's own files with those of each exercise.
# cmake -DEXERCISES=folder -DNAMES=a;b -DVERSION=1.2.3 -DOUT=version.cpp -P versions.cmake
function(hash_of out)
  set(all)
  foreach(file IN LISTS ARGN)
    file(SHA256 ${file} hash)
    file(RELATIVE_PATH name ${EXERCISES} ${file})
    string(APPEND all "${name} ${hash}\n")
  endforeach()
  string(SHA256 hash "${all}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${out} ${hash} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE grader ${EXERCISES}/grader/*.h ${EXERCISES}/grader/*.cpp)
list(SORT grader)
set(lines)
foreach(name IN LISTS NAMES)
  # What the tests are made of: also headers that they share with others of the chapter; and what they know.
  cmake_path(GET name PARENT_PATH chapter)
  file(GLOB tests ${EXERCISES}/${chapter}/*.h ${EXERCISES}/${name}/*.h ${EXERCISES}/${name}/judge.cpp ${EXERCISES}/${name}/wrong/*)
  list(FILTER tests EXCLUDE REGEX "/starter\\.h$")
  list(SORT tests)
  hash_of(hash ${grader} ${tests})
  string(APPEND lines "    {\"${name}\", \"${VERSION}-${hash}\"},\n")
endforeach()
file(WRITE ${OUT} "#include \"version.h\"

namespace grade {

const std::vector<Version>& versions() {
  static const std::vector<Version> all{
${lines}  };
  return all;
}

}  // namespace grade
")
