# SPDX-License-Identifier: MIT-0
# What the licences ask for of the libraries that are linked into the grader: their texts, the versions, and how to link it anew.
function(put_licences folder)
  execute_process(COMMAND ${GXX} -print-file-name=libstdc++.a OUTPUT_VARIABLE library
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  file(REAL_PATH ${library} library)
  execute_process(COMMAND dpkg-query -S ${library} OUTPUT_VARIABLE package COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE ":.*" "" package "${package}")
  set(list)
  foreach(package IN ITEMS libc6-dev ${package} catch2 libcli11-dev nlohmann-json3-dev libtomlplusplus-dev libeigen3-dev)
    configure_file(/usr/share/doc/${package}/copyright ${folder}/${package}.txt COPYONLY)
    execute_process(COMMAND dpkg-query -W -f "- \${source:Package} \${source:Version}, of which `${package}`: [${package}.txt](${package}.txt)\n"
      ${package} OUTPUT_VARIABLE line COMMAND_ERROR_IS_FATAL ANY)
    string(APPEND list "${line}")
  endforeach()
  file(GLOB texts /usr/share/common-licenses/LGPL-2.1 /usr/share/common-licenses/GPL-3)
  file(COPY ${texts} DESTINATION ${folder})
  file(WRITE ${folder}/README.md "# What is in these programs

`grade`, `canary` and `limited` are programs of *One Step at a Time*, whose own part is under MIT-0. They are linked statically, so that they run where these
libraries are missing or are others:

${list}
The names are those of Debian's source packages, and `apt-get source` brings the sources of just these versions. The GNU C Library is under
the LGPL 2.1, which lets you link these programs anew with a C library that you have changed: the book's repository has all the sources of the
programs, and builds them with `cmake --workflow --preset handout`.
")
endfunction()
