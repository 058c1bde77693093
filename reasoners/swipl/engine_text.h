// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SWIPL_ENGINE_TEXT_H_
#define LATCHWORK_SWIPL_ENGINE_TEXT_H_

#include <string_view>

namespace latchwork::swipl {

/// The part of the Prolog program that is the same for every body: the search, closing, attachments
/// and arithmetic. `rule_writer.h` writes the other part.
std::string_view EngineText();

/// What the command line asks for: read clauses up to `end`, then answer.
inline constexpr std::string_view kBootGoal =
    "use_module(library(lists)),use_module(library(when)),set_prolog_flag(occurs_check,true),set_"
    "prolog_flag(unknown,fail),repeat,read(T),(T==end->!;"
    "assertz(T),fail),main";

}  // namespace latchwork::swipl

#endif  // LATCHWORK_SWIPL_ENGINE_TEXT_H_
