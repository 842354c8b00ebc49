// SPDX-License-Identifier: MIT-0
#include "command_line.h"
#include "hosts/from.h"

namespace grade {

Haul from_git(const std::filesystem::path&, std::optional<Instant>) {
  throw Usage("not yet");
}

}  // namespace grade
