// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_SWIPL_SETTING_H_
#define LATCHWORK_TESTS_REASONERS_SWIPL_SETTING_H_

#include "reasoners/swipl/swipl_reasoner.h"
#include "tests/reasoners/outside_program.h"

namespace latchwork::swipl {

struct Setting {
  using Reasoner = SwiplReasoner;
  static constexpr const char* kProgram = "swipl";
  static constexpr const char* kPackage = "swi-prolog-nox";
};
using Mind = pttp::MindOf<SwiplReasoner>;

}  // namespace latchwork::swipl

#endif  // LATCHWORK_TESTS_REASONERS_SWIPL_SETTING_H_
