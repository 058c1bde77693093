// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_COMPILER_H_
#define LATCHWORK_ICARUS_COMPILER_H_

#include <string>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/code.h"
#include "reasoners/icarus/machine/host.h"

namespace latchwork::icarus {

/// The call that a program is started with, `(CollideWithCar car54)`, read and resolved like a
/// clause of the program.
struct TopCall {
  SourceTree source;
  Skill query;  ///< Its :requires is the call.
};
TopCall ReadTop(const Program& program, std::string text, Findings& findings);

/// Compiles a program without errors. Functions that the host lacks are findings, and what they
/// stand in is not to be run. Constant lists live in `arena`.
CompiledProgram Compile(const Program& program, const Host& host, NamePool& names, Arena& arena,
                        Findings& findings);

/// Adds a top call, the :requires of `query`, to a compiled program; where it begins.
Address CompileTop(const Program& program, const Skill& query, const SourceTree& source,
                   const Host& host, CompiledProgram& code, NamePool& names, Arena& arena,
                   Findings& findings);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_COMPILER_H_
