// SPDX-License-Identifier: MIT-0
// say_unsafe KIT: prints what the grader says of the sandbox here, or "safe".
#include <iostream>
#include <string>

#include "cage/cage.h"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::string folder = arguments[1];
  const cage::Kit kit = {folder + "/harness", folder, folder + "/canary", folder + "/limited"};
  std::cout << cage::unsafe(kit).value_or("safe");
}
