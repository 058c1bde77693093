// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_INTEGRATION_PAGE_EXAMPLES_H_
#define LATCHWORK_TESTS_INTEGRATION_PAGE_EXAMPLES_H_

#include <cstddef>
#include <filesystem>
#include <string>

namespace latchwork::testing {

/// Checks that the examples of docs/`page` come to what it prints: a block "```LANGUAGE NAME" is a
/// file of that name, and a block "```console" holds commands, each after "$ ", and their output.
/// Commands run in `folder`, where the files are written. At least `least` of them are expected.
void CheckPage(const std::string& page, const std::string& language,
               const std::filesystem::path& folder, std::size_t least);

}  // namespace latchwork::testing

#endif  // LATCHWORK_TESTS_INTEGRATION_PAGE_EXAMPLES_H_
