// SPDX-License-Identifier: MIT-0
#include "home/ready.h"

#include <cstdio>

#include "command_line.h"
#include "kit/make_kit.h"

namespace grade {

void make_ready() {
  const std::filesystem::path folder = made_folder();
  if (made_with(folder)) return;
  const auto compiler = find_compiler();
  if (!compiler) throw Usage("there is no g++ here; on Debian and Ubuntu: sudo apt install g++");
  std::fprintf(stderr, "Getting ready for %s, once: some seconds ...\n", compiler->c_str());
  make_kit(folder, *compiler);
}

}  // namespace grade
