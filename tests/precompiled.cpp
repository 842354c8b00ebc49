// SPDX-License-Identifier: MIT-0
// Nothing: CMake wants a source to precompile headers for.
