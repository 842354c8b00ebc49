# Compiles and runs the C++ that stands in the README, beside a copy of the one header it includes.
file(READ ${SOURCE}/README.md readme)
string(REGEX MATCH "```cpp\n#include \"([a-z_]+\\.h)\"\n([^`]*)```" found "${readme}")
if(NOT found)
  message(FATAL_ERROR "README.md has no C++ that starts with an #include")
endif()
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
file(COPY ${SOURCE}/code/integrate/${CMAKE_MATCH_1} DESTINATION ${SCRATCH})
file(WRITE ${SCRATCH}/readme.cpp "#include <glm/vec3.hpp>
#include \"${CMAKE_MATCH_1}\"
int main() {
  const double time = 0;
${CMAKE_MATCH_2}
  return x.x > 0 && v.x < 5 && v.y < 0 ? 0 : 1;
}
")
execute_process(COMMAND ${COMPILER} -std=c++20 -Wall -Wextra -Werror readme.cpp -o readme
                WORKING_DIRECTORY ${SCRATCH} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${SCRATCH}/readme COMMAND_ERROR_IS_FATAL ANY)
