// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/plugin/preload.h"

#include <dlfcn.h>

namespace latchwork::plugin {

std::string Preload(const std::filesystem::path& file) {
  return dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE) == nullptr ? dlerror() : "";
}

}  // namespace latchwork::plugin
